// Frames of /tf and /tf_static in the plane: a tree whose edges have a history.
import type { Pose2, Seconds } from "../app";

export interface TransformStamped {
  header: { stamp: { sec: number; nanosec: number }; frame_id: string };
  child_frame_id: string;
  transform: {
    translation: { x: number; y: number; z: number };
    rotation: Quaternion;
  };
}

export interface Quaternion {
  x: number;
  y: number;
  z: number;
  w: number;
}

export function yawOf(q: Quaternion): number {
  return Math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));
}

/** Pose of c in a, from that of b in a and that of c in b. */
export function compose(ab: Pose2, bc: Pose2): Pose2 {
  const c = Math.cos(ab.theta);
  const s = Math.sin(ab.theta);
  return { x: ab.x + c * bc.x - s * bc.y, y: ab.y + s * bc.x + c * bc.y, theta: ab.theta + bc.theta };
}

export function invert(pose: Pose2): Pose2 {
  const c = Math.cos(pose.theta);
  const s = Math.sin(pose.theta);
  return { x: -(c * pose.x + s * pose.y), y: -(-s * pose.x + c * pose.y), theta: -pose.theta };
}

/** Between two poses; the angle goes the shorter way round. */
export function interpolate(a: Pose2, b: Pose2, share: number): Pose2 {
  const turn = Math.atan2(Math.sin(b.theta - a.theta), Math.cos(b.theta - a.theta));
  return { x: a.x + share * (b.x - a.x), y: a.y + share * (b.y - a.y), theta: a.theta + share * turn };
}

/** Index of the last entry with time <= `time`, -1 when there is none. */
export function lastAtOrBefore(entries: readonly { time: Seconds }[], time: Seconds): number {
  let low = 0;
  let high = entries.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (entries[middle]!.time <= time) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

interface Edge {
  parent: string;
  isStatic: boolean;
  poses: { time: Seconds; pose: Pose2 }[];
}

const MOST_LINKS = 64; // of a chain; more is a loop

export class Transforms {
  private readonly edges = new Map<string, Edge>();

  /** By the stamps of the transforms; those of a source that goes back in time replace what came after. */
  add(transforms: readonly TransformStamped[], isStatic: boolean): void {
    for (const { header, child_frame_id, transform } of transforms) {
      const time = header.stamp.sec + header.stamp.nanosec / 1e9;
      const pose = { x: transform.translation.x, y: transform.translation.y, theta: yawOf(transform.rotation) };
      if (!Number.isFinite(pose.x + pose.y + pose.theta)) continue;
      const child = bare(child_frame_id);
      const parent = bare(header.frame_id);
      const edge = this.edges.get(child);
      if (!edge || isStatic || edge.parent !== parent) {
        this.edges.set(child, { parent, isStatic, poses: [{ time, pose }] });
        continue;
      }
      const last = lastAtOrBefore(edge.poses, time);
      if (last >= 0 && edge.poses[last]!.time === time) edge.poses[last] = { time, pose };
      else edge.poses.splice(last + 1, 0, { time, pose });
    }
  }

  /** Forgets what is older; the last pose before stays, so that every frame stays where it is. */
  forgetBefore(time: Seconds): void {
    for (const edge of this.edges.values()) {
      const last = lastAtOrBefore(edge.poses, time);
      if (last > 0) edge.poses.splice(0, last);
    }
  }

  forgetMoving(): void {
    for (const [child, edge] of this.edges) if (!edge.isStatic) this.edges.delete(child);
  }

  clear(): void {
    this.edges.clear();
  }

  frames(): string[] {
    const names = new Set(this.edges.keys());
    for (const edge of this.edges.values()) names.add(edge.parent);
    return [...names];
  }

  lookup(target: string, source: string, time: Seconds): Pose2 | undefined {
    const up = this.toRoot(bare(source), time);
    const down = this.toRoot(bare(target), time);
    if (!up || !down || up.root !== down.root) return undefined;
    return compose(invert(down.pose), up.pose);
  }

  /** The frame `map` where there is one, else the root of the tree with the most frames below it. */
  root(): string | undefined {
    const counts = new Map<string, number>();
    for (const name of this.frames()) {
      const root = this.toRoot(name, Infinity)?.root;
      if (root === undefined) continue;
      if (root === "map") return root;
      counts.set(root, (counts.get(root) ?? 0) + 1);
    }
    return [...counts].sort((a, b) => b[1] - a[1])[0]?.[0];
  }

  private toRoot(frame: string, time: Seconds): { root: string; pose: Pose2 } | undefined {
    let pose: Pose2 = { x: 0, y: 0, theta: 0 };
    for (let links = 0; links < MOST_LINKS; ++links) {
      const edge = this.edges.get(frame);
      if (!edge) return { root: frame, pose };
      pose = compose(poseOf(edge, time), pose);
      frame = edge.parent;
    }
    return undefined;
  }
}

/** Interpolated; before the first and after the last pose that one. */
function poseOf(edge: Edge, time: Seconds): Pose2 {
  const { poses } = edge;
  const last = lastAtOrBefore(poses, time);
  const before = poses[Math.max(last, 0)]!;
  const after = poses[last + 1];
  if (last < 0 || !after) return before.pose;
  return interpolate(before.pose, after.pose, (time - before.time) / (after.time - before.time));
}

/** tf2 knows no leading slash, older bags do. */
function bare(frame: string): string {
  return frame.startsWith("/") ? frame.slice(1) : frame;
}
