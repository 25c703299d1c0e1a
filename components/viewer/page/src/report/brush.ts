// What pictures are drawn with: colours of the page's style, and the shapes that charts, columns and legends have in common.
import type { Color, Dash, Symbol } from "./format";

const DASHES: Record<Dash, number[]> = { none: [], dashes: [7, 3], dots: [2, 2.5], both: [9, 3, 2, 3] };

export function shade(color: Color | "muted" | "line" | "shade" | "wall"): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${color}`).trim();
}

/** A canvas in pixels of the screen, `ratio` of its own to each. */
export class Brush {
  constructor(
    readonly context: CanvasRenderingContext2D,
    readonly ratio: number,
  ) {}

  pen(color: string, width: number, dash: Dash = "none", opacity = 1): void {
    const { context, ratio } = this;
    context.strokeStyle = color;
    context.fillStyle = color;
    context.lineWidth = width * ratio;
    context.globalAlpha = opacity;
    context.lineJoin = "round";
    context.setLineDash(DASHES[dash].map((length) => length * ratio));
  }

  line(points: readonly [number, number][], isClosed = false): void {
    const { context } = this;
    context.beginPath();
    for (const [i, [x, y]] of points.entries()) i === 0 ? context.moveTo(x, y) : context.lineTo(x, y);
    if (isClosed) context.closePath();
    context.stroke();
  }

  disc([x, y]: [number, number], radius: number, opacity: number, hasRim: boolean): void {
    const { context } = this;
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.globalAlpha = opacity;
    context.fill();
    context.globalAlpha = 1;
    if (hasRim) context.stroke();
  }

  text(text: string, [x, y]: [number, number], align: CanvasTextAlign, size = 11): void {
    const { context, ratio } = this;
    context.font = `${size * ratio}px system-ui, sans-serif`;
    context.textAlign = align;
    context.textBaseline = "middle";
    context.globalAlpha = 1;
    context.fillText(text, x, y);
  }

  symbol(symbol: Symbol, [x, y]: [number, number], size = 5): void {
    const { context } = this;
    const r = size * this.ratio;
    context.setLineDash([]);
    if (symbol === "dot") return this.disc([x, y], 0.6 * r, 1, false);
    context.beginPath();
    if (symbol === "ring") context.arc(x, y, r, 0, 2 * Math.PI);
    else if (symbol === "square") context.rect(x - r, y - r, 2 * r, 2 * r);
    else if (symbol === "triangle") for (const [dx, dy] of [[0, -1.2], [1.1, 0.8], [-1.1, 0.8], [0, -1.2], [1.1, 0.8]] as const) context.lineTo(x + dx * r, y + dy * r);
    else
      for (const side of [-1, 1]) {
        context.moveTo(x - 0.6 * r, y - 0.6 * side * r);
        context.lineTo(x + 0.6 * r, y + 0.6 * side * r);
      }
    context.stroke();
  }

  diamond([x, y]: [number, number]): void {
    const r = 5 * this.ratio;
    this.line([[x, y - r], [x + r, y], [x, y + r], [x - r, y]], true);
  }

  arrow(from: [number, number], to: [number, number]): void {
    const angle = Math.atan2(to[1] - from[1], to[0] - from[0]);
    const side = (turn: number): [number, number] => [to[0] - 6 * this.ratio * Math.cos(angle + turn), to[1] - 6 * this.ratio * Math.sin(angle + turn)];
    this.line([from, to]);
    this.line([side(0.4), to, side(-0.4)]);
  }
}
