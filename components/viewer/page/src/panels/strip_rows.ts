// The rows of the strip: what each draws, and its plot.
import uPlot from "uplot";

import type { Seconds } from "../app";
import type { CurveName, StripData } from "./strip_data";

export interface View {
  from: Seconds;
  to: Seconds;
  /** Where the axis says 0. */
  origin: Seconds;
}

interface Line {
  curve: CurveName;
  label: string;
  color: string; // a variable of style/strip.css
  width?: number;
  isFilled?: boolean;
}

interface Level {
  at: number;
  color: string;
}

export interface RowKind {
  title: string;
  unit: (data: StripData) => string;
  digits: number;
  height: number;
  lines: Line[];
  levels?: Level[];
  /** The least and greatest value that is always in sight. */
  least: number;
  most: (data: StripData) => number;
}

/** Limits of comfort and of the body: evaluation/theory.md 7.7, components/evaluation/collision_index.hpp. */
export const COMFORT_LIMIT = 0.14;
export const PHYSICAL_LIMIT = 0.54;

export const ROWS: RowKind[] = [
  {
    title: "Speed",
    unit: () => "m/s",
    digits: 2,
    height: 46,
    lines: [
      { curve: "commanded", label: "asked", color: "--strip-command", width: 1 },
      { curve: "measured", label: "driven", color: "--strip-speed", width: 1.8 },
    ],
    least: 0,
    most: () => 0.6,
  },
  {
    title: "Closest person",
    unit: (data) => (data.isFromCentre ? "m (from centre)" : "m"),
    digits: 2,
    height: 40,
    lines: [{ curve: "person", label: "", color: "--strip-person", width: 1.8 }],
    least: 0,
    most: () => 3,
  },
  {
    title: "Collision index",
    unit: () => "",
    digits: 2,
    height: 46,
    lines: [{ curve: "index", label: "", color: "--strip-index", width: 1.8, isFilled: true }],
    levels: [
      { at: COMFORT_LIMIT, color: "--warn" },
      { at: PHYSICAL_LIMIT, color: "--error" },
    ],
    least: 0,
    most: () => 0.6,
  },
  {
    title: "Planner cycle",
    unit: (data) => (data.cycleIs === "ms" ? "ms" : "% of budget"),
    digits: 1,
    height: 40,
    lines: [
      { curve: "budget", label: "budget", color: "--warn", width: 1 },
      { curve: "cycle", label: "", color: "--strip-cycle", width: 1.4 },
    ],
    least: 0,
    most: (data) => (data.cycleIs === "ms" ? 1 : 100),
  },
];

export const LEFT = 38; // of the plot, behind the numbers of its axis [px]
export const RIGHT = 14;
const AXIS_HEIGHT = 22;

const STEPS = [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 1200, 1800, 3600, 7200];

/** Whole steps from the origin; at most one in 80 px. */
export function splitsOf(view: View, width: number): { at: Seconds[]; step: Seconds } {
  const span = view.to - view.from;
  const step = STEPS.find((s) => (s / span) * width >= 80) ?? 14400;
  const at: Seconds[] = [];
  for (let k = Math.ceil((view.from - view.origin) / step - 1e-9); view.origin + k * step <= view.to + 1e-9; ++k)
    at.push(view.origin + k * step);
  return { at, step };
}

/** Seconds from the origin as a person reads them: -30 s, 12.5 s, 3:20. */
export function textOfTime(offset: Seconds, digits = 0): string {
  const rounded = Number(offset.toFixed(digits));
  const sign = rounded < 0 ? "−" : "";
  const size = Math.abs(rounded);
  if (size < 60) return `${sign}${size.toFixed(digits)} s`;
  const minutes = Math.floor(size / 60);
  const rest = (size - 60 * minutes).toFixed(digits).padStart(digits > 0 ? 3 + digits : 2, "0");
  return minutes < 60
    ? `${sign}${minutes}:${rest}`
    : `${sign}${Math.floor(minutes / 60)}:${String(minutes % 60).padStart(2, "0")}:${rest}`;
}

/** Of several curves with times of their own: one column of times, and each curve's values or undefined at them. */
export function columns(data: StripData, row: RowKind): uPlot.AlignedData {
  const tables = row.lines.map(({ curve }) => {
    const { times, values } = data.curves[curve];
    return [times, values.map((v) => (Number.isNaN(v) ? null : v))] as unknown as uPlot.AlignedData;
  });
  return tables.length === 1 ? tables[0]! : uPlot.join(tables, tables.map(() => [1]));
}

export type ColorOf = (variable: string) => string;

function levelsPlugin(row: RowKind, color: ColorOf): uPlot.Plugin {
  const draw = (plot: uPlot) => {
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.lineWidth = devicePixelRatio;
    for (const level of row.levels ?? []) {
      const y = Math.round(plot.valToPos(level.at, "y", true)) + 0.5;
      ctx.strokeStyle = color(level.color);
      ctx.setLineDash([4 * devicePixelRatio, 3 * devicePixelRatio]);
      ctx.beginPath();
      ctx.moveTo(bbox.left, y);
      ctx.lineTo(bbox.left + bbox.width, y);
      ctx.stroke();
    }
    ctx.restore();
  };
  return { hooks: { drawAxes: draw } };
}

export function makePlot(row: RowKind, isLast: boolean, view: () => View, data: () => StripData, color: ColorOf): uPlot {
  const height = row.height + (isLast ? AXIS_HEIGHT : 0);
  const lines = row.lines.map((line) => ({
    stroke: () => color(line.color),
    fill: line.isFilled ? () => `color-mix(in srgb, ${color(line.color)} 22%, transparent)` : undefined,
    width: line.width ?? 1.5,
    dash: line.curve === "budget" ? [4, 3] : undefined,
    spanGaps: row.lines.length > 1,
    points: { show: false },
  }));
  const grid = { stroke: () => color("--line"), width: 1 };
  const options: uPlot.Options = {
    width: 400,
    height,
    padding: [4, RIGHT, isLast ? 0 : 4, 0],
    legend: { show: false },
    cursor: { show: false },
    select: { show: false, left: 0, top: 0, width: 0, height: 0 },
    scales: {
      x: { time: false, range: () => [view().from, view().to] },
      y: { range: (_, __, most) => [row.least, 1.05 * Math.max(most ?? 0, row.most(data()))] },
    },
    axes: [
      {
        show: true,
        size: isLast ? AXIS_HEIGHT : 0,
        stroke: () => color("--muted"),
        font: "11px system-ui, sans-serif",
        gap: 6,
        grid,
        ticks: { show: false },
        splits: (plot) => splitsOf(view(), plot.bbox.width / devicePixelRatio).at,
        values: (plot, splits) => {
          if (!isLast) return splits.map(() => "");
          const { step } = splitsOf(view(), plot.bbox.width / devicePixelRatio);
          return splits.map((at) => textOfTime(at - view().origin, step < 1 ? 1 : 0));
        },
      },
      {
        size: LEFT,
        stroke: () => color("--muted"),
        font: "10px system-ui, sans-serif",
        gap: 3,
        grid: { ...grid, show: row.levels === undefined },
        ticks: { show: false },
        splits: row.levels ? () => row.levels!.map((level) => level.at) : undefined,
        space: 16,
      },
    ],
    series: [{}, ...lines],
    plugins: [levelsPlugin(row, color)],
  };
  return new uPlot(options, [[]], undefined as never);
}
