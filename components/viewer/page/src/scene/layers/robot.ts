// The robots: where the transforms have them. The one that is looked at has its own outline, as far as somebody tells it.
import { Group } from "three";
import type { Message, Pose2 } from "../../app";
import { framePrefix } from "../../page/robots";
import { compose, invert } from "../../source/transforms";
import { Labels } from "../gl/labels";
import { Lines } from "../gl/lines";
import { Triangles } from "../gl/triangles";
import { put, secondsOf, type Header, type Layer, type Legend, type View, type Wanted } from "../layer";
import { mix, type Palette, type Rgba } from "../palette";
import { extrude } from "./body";

interface PolygonStamped {
  header: Header;
  polygon: { points: { x: number; y: number }[] };
}

type Corner = readonly [number, number];

const FOOTPRINT: Wanted = ["/global_costmap/published_footprint", "geometry_msgs/msg/PolygonStamped"];
const LOCAL_FOOTPRINT: Wanted = ["/local_costmap/published_footprint", "geometry_msgs/msg/PolygonStamped"];
const HEIGHT = 0.35; // [m]
const USUAL_RADIUS = 0.3; // [m] of a robot that tells no outline

class Body {
  readonly object = new Group();
  private readonly body = new Triangles(53, { hasDepth: true, areBodies: true });
  private readonly nose = new Lines(54);
  private readonly label = new Labels(94);
  private drawn = "";

  constructor() {
    for (const part of [this.body, this.nose, this.label]) this.object.add(part.mesh);
  }

  draw(outline: readonly Corner[], color: Rgba, name: string, palette: Palette): boolean {
    const key = JSON.stringify([outline, color, name]);
    if (key === this.drawn) return false;
    this.drawn = key;
    for (const part of [this.body, this.nose, this.label]) part.clear();
    const front = Math.max(...outline.map(([x]) => x));
    extrude(this.body, outline, [0, 0], HEIGHT, color, mix(color, [0, 0, 0, 1], 0.32));
    const ink = mix(color, palette.halo, 0.85);
    this.nose.strip([[front * 0.15, front * 0.5], [front * 0.75, 0], [front * 0.15, -front * 0.5]], ink, 0.07, 1.5);
    if (name) this.label.add([0, 0, HEIGHT], name, palette.text, palette.halo, 26);
    for (const part of [this.body, this.nose, this.label]) part.done();
    return true;
  }
}

export class RobotLayer implements Layer {
  readonly id = "robot";
  readonly name = "Robot";
  readonly legend: Legend = { shape: "disc", colors: (palette) => [palette.robot] };
  readonly isOnAtStart = true;
  readonly object = new Group();
  readonly wants = [FOOTPRINT, LOCAL_FOOTPRINT];
  pose: Pose2 | undefined;
  private readonly bodies = new Map<string, Body>();
  private readonly outlines = new Map<string, readonly Corner[]>();
  private seen: Message<PolygonStamped> | undefined;

  constructor(private readonly robots: () => readonly string[]) {}

  /** Of a robot whose radius its parameters tell. */
  setRadius(robot: string, radius: number): void {
    if (!this.outlines.has(robot)) this.outlines.set(robot, circle(radius));
  }

  update(view: View): boolean {
    let hasChanged = false;
    this.hear(view);
    this.pose = view.place(view.base, view.time);
    const robots = new Set([...this.robots(), view.robot]);
    for (const [name, body] of this.bodies) if (!robots.has(name)) hasChanged = put(body.object, undefined) || hasChanged;
    for (const name of robots) {
      const isOurs = name === view.robot;
      const pose = isOurs ? this.pose : view.place(`${framePrefix(name)}base_link`, view.time);
      let body = this.bodies.get(name);
      if (!body) {
        this.bodies.set(name, (body = new Body()));
        this.object.add(body.object);
      }
      const { palette } = view;
      const color = isOurs ? palette.robot : palette.otherRobot;
      const label = robots.size > 1 ? name.slice(1) : "";
      hasChanged = body.draw(this.outlines.get(name) ?? circle(USUAL_RADIUS), color, label, palette) || hasChanged;
      hasChanged = put(body.object, pose) || hasChanged;
    }
    return hasChanged;
  }

  /** The outline comes in a fixed frame, at the robot's pose of then. */
  private hear(view: View): void {
    const message = view.message<PolygonStamped>(...FOOTPRINT) ?? view.message<PolygonStamped>(...LOCAL_FOOTPRINT);
    if (!message || message === this.seen || !message.topic.startsWith(`${view.robot}/`)) return;
    const { header, polygon } = message.value;
    const stamp = secondsOf(header.stamp);
    const frame = view.place(header.frame_id, stamp);
    const robot = view.place(view.base, stamp);
    if (!frame || !robot || polygon.points.length < 3) return;
    this.seen = message;
    const inRobot = compose(invert(robot), frame);
    const corners = polygon.points.map(({ x, y }): Corner => {
      const at = compose(inRobot, { x, y, theta: 0 });
      return [at.x, at.y];
    });
    this.outlines.set(view.robot, isRound(corners) ? circle(meanRadius(corners)) : [...corners, corners[0]!]);
  }
}

/** Measured around the pose of the stamp, a disc is off its middle by what the pose was late. */
function isRound(corners: readonly Corner[]): boolean {
  if (corners.length < 12) return false;
  const mean = meanRadius(corners);
  const [x, y] = middleOf(corners);
  return corners.every((corner) => Math.abs(Math.hypot(corner[0] - x, corner[1] - y) - mean) < 0.05 * mean);
}

function middleOf(corners: readonly Corner[]): Corner {
  const sum = corners.reduce(([x, y], corner): Corner => [x + corner[0], y + corner[1]], [0, 0] as Corner);
  return [sum[0] / corners.length, sum[1] / corners.length];
}

function meanRadius(corners: readonly Corner[]): number {
  const [x, y] = middleOf(corners);
  return corners.reduce((sum, corner) => sum + Math.hypot(corner[0] - x, corner[1] - y), 0) / corners.length;
}

function circle(radius: number): Corner[] {
  return Array.from({ length: 33 }, (_, i): Corner => {
    const angle = (i / 32) * 2 * Math.PI;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });
}
