// The lane of the strip that says what happened: goals, switches between classes, contacts.
import { make } from "../page/dom";
import type { Kind, Mark } from "./strip_data";
import { LEFT, RIGHT, type ColorOf, type View } from "./strip_rows";

export const LANE_HEIGHT = 18; // [px]
const COLORS: Record<Kind, string> = {
  goal: "--accent",
  reached: "--ok",
  ended: "--warn",
  switch: "--strip-switch",
  contact: "--error",
};
const HAS_TEXT: ReadonlySet<Kind> = new Set<Kind>(["goal", "reached", "ended", "contact"]);

export function pixelOf(view: View, width: number, time: number): number {
  return LEFT + ((time - view.from) / (view.to - view.from)) * (width - LEFT - RIGHT);
}

function drawSign(ctx: CanvasRenderingContext2D, kind: Kind, x: number): void {
  const y = LANE_HEIGHT / 2;
  ctx.beginPath();
  if (kind === "switch") {
    ctx.rect(x - 1, y - 5, 2, 10);
  } else if (kind === "contact") {
    ctx.moveTo(x, y - 6);
    ctx.lineTo(x + 6, y + 5);
    ctx.lineTo(x - 6, y + 5);
  } else if (kind === "ended") {
    ctx.rect(x - 4, y - 4, 8, 8);
  } else {
    ctx.arc(x, y, 4.5, 0, 2 * Math.PI);
  }
  if (kind !== "goal") return ctx.fill();
  ctx.lineWidth = 2;
  ctx.stroke();
}

export class MarkLane {
  readonly canvas = make("canvas", { className: "strip-marks" });

  draw(marks: readonly Mark[], view: View, color: ColorOf): void {
    const { canvas } = this;
    const width = canvas.clientWidth;
    const scale = devicePixelRatio;
    if (canvas.width !== Math.round(width * scale)) canvas.width = Math.round(width * scale);
    if (canvas.height !== Math.round(LANE_HEIGHT * scale)) canvas.height = Math.round(LANE_HEIGHT * scale);
    const ctx = canvas.getContext("2d");
    if (!ctx) return;
    ctx.setTransform(scale, 0, 0, scale, 0, 0);
    ctx.clearRect(0, 0, width, LANE_HEIGHT);
    ctx.font = "11px system-ui, sans-serif";
    ctx.textBaseline = "middle";
    let free = 0; // text begins behind the one before
    for (const { time, kind, text } of marks) {
      if (time < view.from || time > view.to) continue;
      const x = pixelOf(view, width, time);
      ctx.fillStyle = ctx.strokeStyle = color(COLORS[kind]);
      drawSign(ctx, kind, x);
      if (!HAS_TEXT.has(kind) || x < free) continue;
      const length = ctx.measureText(text).width;
      const isRoom = x + 9 + length < width;
      ctx.fillStyle = color("--muted");
      ctx.fillText(text, isRoom ? x + 9 : x - 9 - length, LANE_HEIGHT / 2 + 1);
      free = x + 14 + (isRoom ? length : 0);
    }
  }
}
