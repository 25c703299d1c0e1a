import type { Seconds } from "../../app";
import { Lines, type Point } from "../gl/lines";
import type { Layer, Legend, View } from "../layer";
import { withOpacity } from "../palette";

const LENGTH = 40; // [s]
const STEP = 0.2; // [s]
const LEAST_MOVE = 0.01; // [m] standing adds nothing

/** The way the robot came, paler the longer ago. */
export class TrailLayer implements Layer {
  readonly id = "trail";
  readonly name = "Trail";
  readonly legend: Legend = { shape: "line", colors: (palette) => [palette.trail], note: `the last ${LENGTH} s` };
  readonly isOnAtStart = true;
  readonly wants = [];
  private readonly lines = new Lines(32);
  private drawn = "";

  constructor(private readonly begin: () => Seconds) {}

  get object() {
    return this.lines.mesh;
  }

  update(view: View): boolean {
    const last = Math.floor(view.time / STEP);
    const key = `${last} ${view.base} ${view.root} ${view.palette.ground}`;
    if (key === this.drawn) return false;
    this.drawn = key;
    this.lines.clear();
    const first = Math.max(last - LENGTH / STEP, Math.ceil(this.begin() / STEP));
    let before: Point | undefined;
    for (let i = first; i <= last; ++i) {
      const pose = view.place(view.base, i * STEP);
      if (!pose) continue;
      const now: Point = [pose.x, pose.y];
      if (before && Math.hypot(now[0] - before[0], now[1] - before[1]) < LEAST_MOVE) continue;
      const color = withOpacity(view.palette.trail, 0.15 + (0.85 * (i - last + LENGTH / STEP)) / (LENGTH / STEP));
      if (before) this.lines.add(before, now, color, 0, 2.5);
      before = now;
    }
    this.lines.done();
    return true;
  }
}
