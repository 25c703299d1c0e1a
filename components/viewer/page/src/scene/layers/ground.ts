import { Lines } from "../gl/lines";
import type { Palette } from "../palette";

const LEAST_PIXELS = 36; // between two lines
const MOST_LINES = 80;

/** A grid of round metres below everything, as far as one sees. */
export class Ground {
  private readonly lines = new Lines(-10);
  private drawn = "";

  get mesh() {
    return this.lines.mesh;
  }

  /** `metresPerPixel` at the middle; returns the distance of its lines [m]. */
  update(middle: { x: number; y: number }, metresPerPixel: number, reach: number, palette: Palette): number {
    const step = roundStep(metresPerPixel * LEAST_PIXELS);
    const count = Math.min(Math.ceil(reach / step), MOST_LINES);
    const x = Math.round(middle.x / step);
    const y = Math.round(middle.y / step);
    const key = [x, y, step, count, palette.grid].join();
    if (key === this.drawn) return step;
    this.drawn = key;
    this.lines.clear();
    for (let i = -count; i <= count; ++i) {
      const [x0, x1, y0, y1] = [(x - count) * step, (x + count) * step, (y - count) * step, (y + count) * step];
      this.lines.add([(x + i) * step, y0], [(x + i) * step, y1], palette.grid, 0, 1);
      this.lines.add([x0, (y + i) * step], [x1, (y + i) * step], palette.grid, 0, 1);
    }
    this.lines.done();
    return step;
  }
}

/** 1, 2 or 5 times a power of ten, not less than `least`. */
export function roundStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  for (const factor of [1, 2, 5]) if (factor * power >= least) return factor * power;
  return 10 * power;
}
