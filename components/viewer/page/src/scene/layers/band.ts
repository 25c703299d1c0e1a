// The band the robot drives: a tube whose colour is the speed, with a dot for each second ahead.
import { compose } from "../../source/transforms";
import { Discs } from "../gl/discs";
import { Labels } from "../gl/labels";
import { Triangles } from "../gl/triangles";
import type { Point } from "../gl/lines";
import { secondsOf, TopicLayer, type Legend, type View } from "../layer";
import { along, mix, type Palette, type Rgba } from "../palette";
import { PATH, type Path } from "./plan";

/** Faster is drawn like this [m/s]. */
export const FULL_SPEED = 1.2;
const RADIUS = 0.1; // [m] of the tube
const SIDES = 10;
const MOST_POINTS = 400;

export interface TimedPoint {
  x: number;
  y: number;
  /** Ahead of the first [s]. */
  time: number;
  /** Towards the next point [m/s]; NaN where the stamps tell no time. */
  speed: number;
}

/** Speed from the distance between stamped poses; poses of one and the same time have none. */
export function timedPoints(path: Path): TimedPoint[] {
  const begin = path.poses[0] ? secondsOf(path.poses[0].header.stamp) : 0;
  const points = path.poses.map(({ header, pose }) => ({
    x: pose.position.x,
    y: pose.position.y,
    time: secondsOf(header.stamp) - begin,
    speed: NaN,
  }));
  for (let i = 0; i + 1 < points.length; ++i) {
    const [a, b] = [points[i]!, points[i + 1]!];
    if (b.time > a.time) a.speed = Math.hypot(b.x - a.x, b.y - a.y) / (b.time - a.time);
  }
  const last = points.at(-1);
  if (last && points.length > 1) last.speed = points.at(-2)!.speed;
  return points;
}

export class BandLayer extends TopicLayer<Path> {
  readonly id = "band";
  readonly name = "Band";
  readonly legend: Legend = { shape: "scale", colors: (palette) => palette.speed, note: `0 to ${FULL_SPEED} m/s; dots each second` };
  protected override readonly holdsFor = 0.6;
  private readonly tube = new Triangles(45, { hasDepth: true });
  private readonly dots = new Discs(46);
  private readonly labels = new Labels(90);

  constructor() {
    super(["/local_plan", PATH]);
    this.object.add(this.tube.mesh, this.dots.mesh, this.labels.mesh);
  }

  private shown: readonly TimedPoint[] = [];

  /** Of its points, in the root frame. */
  positions(): { x: number; y: number }[] {
    const { position, rotation } = this.object;
    const frame = { x: position.x, y: position.y, theta: rotation.z };
    return this.shown.map(({ x, y }) => {
      const at = compose(frame, { x, y, theta: 0 });
      return { x: at.x, y: at.y };
    });
  }

  protected draw(path: Path, { palette, lift }: View): void {
    for (const part of [this.tube, this.dots, this.labels]) part.clear();
    const points = timedPoints(path).slice(0, MOST_POINTS);
    this.shown = points;
    this.drawTube(points, palette, lift);
    this.drawSeconds(points, palette, lift);
    for (const part of [this.tube, this.dots, this.labels]) part.done();
  }

  private drawTube(points: readonly TimedPoint[], palette: Palette, lift: number): void {
    let before: { ring: Point[]; colors: Rgba[] } | undefined;
    points.forEach((point, i) => {
      const next = points[i + 1] ?? point;
      const previous = points[i - 1] ?? point;
      const angle = Math.atan2(next.y - previous.y, next.x - previous.x);
      const color = Number.isNaN(point.speed) ? palette.robot : along(palette.speed, point.speed / FULL_SPEED);
      const now = ringAt(point, angle, RADIUS + lift * point.time, color, palette);
      if (before)
        for (let side = 0; side < SIDES; ++side) {
          const [a, b, c, d] = [before.ring[side]!, before.ring[side + 1]!, now.ring[side + 1]!, now.ring[side]!];
          this.tube.add(a, b, c, before.colors[side], before.colors[side + 1], now.colors[side + 1]);
          this.tube.add(a, c, d, before.colors[side], now.colors[side + 1], now.colors[side]);
        }
      before = now;
    });
  }

  private drawSeconds(points: readonly TimedPoint[], palette: Palette, lift: number): void {
    for (let i = 0, second = 1; i + 1 < points.length; ++i) {
      const [a, b] = [points[i]!, points[i + 1]!];
      for (; second <= b.time; ++second) {
        const share = (second - a.time) / (b.time - a.time);
        const at: Point = [a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), 2 * RADIUS + lift * second];
        this.dots.add({ x: at[0], y: at[1], z: at[2] ?? 0, a: 0.06, b: 0.06 }, palette.ground, palette.text, 1, 5);
        if (lift > 0) this.labels.add(at, `${second} s`, palette.text, palette.halo, 14);
      }
    }
  }
}

/** Lit from above: the crown has the colour of the scale, the sides are darker. */
function ringAt({ x, y }: TimedPoint, angle: number, z: number, color: Rgba, palette: Palette): { ring: Point[]; colors: Rgba[] } {
  const ring: Point[] = [];
  const colors: Rgba[] = [];
  const shade: Rgba = mix(color, [0, 0, 0, 1], palette.ground[0] > 0.5 ? 0.35 : 0.55);
  for (let side = 0; side <= SIDES; ++side) {
    const turn = (side / SIDES) * 2 * Math.PI;
    const aside = RADIUS * Math.cos(turn);
    const up = RADIUS * Math.sin(turn);
    ring.push([x - Math.sin(angle) * aside, y + Math.cos(angle) * aside, z + up]);
    colors.push(mix(shade, color, Math.min(Math.max(Math.sin(turn) * 1.6 - 0.2, 0), 1)));
  }
  return { ring, colors };
}
