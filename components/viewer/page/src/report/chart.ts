// Lines over an axis, or ways on a floor in one scale.
import type { Brush } from "./brush";
import { shade } from "./brush";
import type { Area, Body, Chart, Mark, Series } from "./format";
import { type At, type Frame, limits, rangeOf, type Range } from "./plot";

const FLATTEST = 0.3; // height over width of a floor
const STEEPEST = 1.0;
const ROOM_FOR_LABEL = 7; // [px] radius of a body

function pairs(flat: number[]): [number, number][] {
  const points: [number, number][] = [];
  for (let i = 0; i + 1 < flat.length; i += 2) points.push([flat[i]!, flat[i + 1]!]);
  return points;
}

function widened({ low, high }: Range, size: number): Range {
  const missing = Math.max(0, size - (high - low));
  return { low: low - missing / 2, high: high + missing / 2 };
}

/** What is shown: of a floor neither very flat nor very steep. */
export function shownBy(chart: Chart): { x: Range; y: Range } {
  const places = [
    ...(chart.series ?? []).flatMap(({ strokes }) => strokes.flatMap(pairs)),
    ...(chart.bodies ?? []).flatMap(({ at: [x, y], radius: r }): [number, number][] => (chart.floor ? [[x - r, y - r], [x + r, y + r]] : [[x, y]])),
    ...(chart.marks ?? []).map(({ at }) => at),
    ...(chart.areas ?? []).flatMap(({ outline }) => pairs(outline)),
  ];
  let x = rangeOf(chart.x, places.map((place) => place[0]));
  let y = rangeOf(chart.y, places.map((place) => place[1]));
  if (chart.floor) {
    y = widened(y, (x.high - x.low) * FLATTEST);
    x = widened(x, (y.high - y.low) / STEEPEST);
  }
  return { x, y };
}

function drawSeries(brush: Brush, at: At, series: Series): void {
  for (const stroke of series.strokes) {
    const points = pairs(stroke).map(([x, y]) => at(x, y));
    brush.pen(shade(series.color), series.width ?? 1.8, series.dash, series.opacity ?? 1);
    if (series.dots || points.length === 1) for (const point of points) brush.disc(point, 1.6 * brush.ratio, series.opacity ?? 1, false);
    else brush.line(points);
  }
}

function drawBody(brush: Brush, at: At, { at: [x, y], radius, color, label, arrow }: Body): void {
  const center = at(x, y);
  const r = Math.abs(at(x + radius, y)[0] - center[0]);
  brush.pen(shade(color), 1.2);
  brush.disc(center, r, 0.15, true);
  if (arrow !== undefined) brush.arrow(center, at(x + arrow[0], y + arrow[1]));
  if (label === undefined) return;
  brush.pen(shade("ink"), 1);
  const hasRoom = r >= ROOM_FOR_LABEL * brush.ratio;
  brush.text(label, hasRoom ? center : [center[0], center[1] - r - 6 * brush.ratio], "center", 10);
}

function drawMark(brush: Brush, at: At, { at: [x, y], symbol, color, label }: Mark): void {
  const place = at(x, y);
  brush.pen(shade(color), 1.5);
  brush.symbol(symbol, place);
  if (label !== undefined) brush.text(label, [place[0] + 7 * brush.ratio, place[1] - 6 * brush.ratio], "left", 10);
}

function drawArea(brush: Brush, at: At, { outline, color, dash, shade: isShade }: Area): void {
  const points = pairs(outline).map(([x, y]) => at(x, y));
  brush.pen(isShade ? shade("shade") : shade(color), 2, dash);
  const { context } = brush;
  context.beginPath();
  for (const [x, y] of points) context.lineTo(x, y);
  context.closePath();
  context.globalAlpha = isShade ? 1 : 0.1;
  context.fill();
  context.globalAlpha = 1;
  if (!isShade) context.stroke();
}

function drawPlace(brush: Brush, at: At, chart: Chart, { x, y }: { x: Range; y: Range }): void {
  for (const { from, to, label } of chart.spans ?? []) {
    const [left, bottom] = at(from, y.low);
    const [right, top] = at(to, y.high);
    brush.context.globalAlpha = 1;
    brush.context.fillStyle = shade("shade");
    brush.context.fillRect(left, top, right - left, bottom - top);
    brush.context.fillStyle = shade("muted");
    brush.text(label, [(left + right) / 2, top + 10 * brush.ratio], "center");
  }
  for (const area of chart.areas ?? []) if (area.shade) drawArea(brush, at, area);
  brush.pen(shade("wall"), 2.5);
  for (const block of chart.blocks ?? []) {
    const [[left, bottom], [right, top]] = pairs(block).map(([px, py]) => at(px, py)) as [[number, number], [number, number]];
    brush.context.fillRect(left, top, right - left, bottom - top);
  }
  for (const wall of chart.walls ?? []) brush.line(pairs(wall).map(([px, py]) => at(px, py)));
  limits(brush, at, x, chart.limits);
}

export function chartFrame(chart: Chart): Frame {
  const shown = shownBy(chart);
  return {
    title: chart.title,
    ...shown,
    xAxis: chart.x,
    yAxis: chart.y,
    ...(chart.height ? { height: chart.height } : {}),
    ...(chart.floor ? { steepness: (shown.y.high - shown.y.low) / (shown.x.high - shown.x.low) } : {}),
    draw(brush, at) {
      drawPlace(brush, at, chart, shown);
      for (const series of chart.series ?? []) drawSeries(brush, at, series);
      for (const area of chart.areas ?? []) if (!area.shade) drawArea(brush, at, area);
      for (const body of chart.bodies ?? []) drawBody(brush, at, body);
      for (const mark of chart.marks ?? []) drawMark(brush, at, mark);
    },
  };
}
