// The frame of a picture: uPlot draws axes and grid, and asks for what is within them.
import uPlot from "uplot";
import { Brush, shade } from "./brush";
import type { Axis, Limit } from "./format";

export interface Range {
  low: number;
  high: number;
}

/** Where a place of the axes is on the canvas. */
export type At = (x: number, y: number) => [number, number];

export interface Frame {
  title: string;
  x: Range;
  y: Range;
  xAxis: Axis;
  yAxis: Axis;
  /** Height over width of what the axes enclose; without, it is as high as most pictures. */
  steepness?: number;
  /** Of what they enclose [px], where that is not as high as in most pictures. */
  height?: number;
  /** Names at 0.5, 1.5, ... in place of numbers. */
  names?: string[];
  draw(brush: Brush, at: At, plot: uPlot): void;
}

const LEFT = 52; // [px] of the numbers and the name of the y axis
const BOTTOM = 40;
const HEIGHT = 190; // [px] of what the axes enclose

/** The ends of an axis: those that are told, else of what there is, with a little room. */
export function rangeOf(axis: Axis, values: number[]): Range {
  const least = Math.min(...values);
  const most = Math.max(...values);
  const room = Number.isFinite(least) ? 0.03 * (most - least || 1) : 0;
  const low = axis.low ?? (Number.isFinite(least) ? least - room : 0);
  const high = axis.high ?? (Number.isFinite(most) ? most + room : 1);
  return { low, high: high > low ? high : low + 1 };
}

export function limits(brush: Brush, at: At, frame: Range, all: Limit[] = []): void {
  for (const { value, label } of all) {
    brush.pen(shade("ink"), 1.2, "dashes");
    const [right, y] = at(frame.high, value);
    brush.line([at(frame.low, value), [right, y]]);
    brush.text(label, [right - 3 * brush.ratio, y - 7 * brush.ratio], "right");
  }
}

function axes(frame: Frame): uPlot.Axis[] {
  const common = { stroke: () => shade("muted"), font: "11px system-ui, sans-serif", labelFont: "11px system-ui, sans-serif", labelSize: 16, ticks: { show: false } };
  const grid = { stroke: () => shade("line"), width: 1 };
  const named: Partial<uPlot.Axis> =
    frame.names === undefined ? { grid } : { grid: { show: false }, splits: () => frame.names!.map((_, i) => i + 0.5), values: () => frame.names! };
  return [
    { ...common, size: 24, label: frame.xAxis.label ?? "", space: 44, ...named },
    {
      ...common,
      size: LEFT - 16,
      label: frame.yAxis.label ?? "",
      space: 26,
      grid,
      ...(frame.yAxis.label === undefined ? { values: (_: uPlot, splits: number[]) => splits.map(() => "") } : {}),
    },
  ];
}

/** Draws the picture into `root`, as wide as that is. */
export function draw(root: HTMLElement, frame: Frame): uPlot {
  const width = Math.max(160, root.clientWidth);
  const inner = frame.steepness === undefined ? (frame.height ?? HEIGHT) : frame.steepness * (width - LEFT - 12);
  const scale = ({ low, high }: Range, axis: Axis): uPlot.Scale => ({ time: false, distr: axis.log ? 3 : 1, range: () => [low, high] });
  const isZoomed = frame.steepness === undefined && frame.names === undefined;
  const options: uPlot.Options = {
    width,
    height: inner + BOTTOM + 8,
    padding: [8, 12, 0, 0],
    legend: { show: false },
    cursor: { show: isZoomed, points: { show: false }, drag: { x: isZoomed, y: false } },
    scales: { x: scale(frame.x, frame.xAxis), y: scale(frame.y, frame.yAxis) },
    axes: axes(frame),
    series: [{}, { show: true, paths: () => null, points: { show: false } }],
    hooks: {
      draw: [
        (plot) => {
          const { context, ratio } = { context: plot.ctx, ratio: uPlot.pxRatio };
          const { left, top, width, height } = plot.bbox;
          context.save();
          context.beginPath();
          context.rect(left, top, width, height);
          context.clip();
          const lowest = plot.scales.y!.min!;
          const onAxis = (y: number) => (frame.yAxis.log ? Math.max(y, lowest) : y);
          frame.draw(new Brush(context, ratio), (x, y) => [plot.valToPos(x, "x", true), plot.valToPos(onAxis(y), "y", true)], plot);
          context.restore();
        },
      ],
    },
  };
  const plot = new uPlot(options, [[frame.x.low, frame.x.high], [frame.y.low, frame.y.high]], root);
  plot.root.setAttribute("role", "img");
  plot.root.setAttribute("aria-label", frame.title);
  return plot;
}
