// From a drag on the ground to the messages that ROS 2's tools send. Metres and radians in the frame the scene is drawn in.
import type { Pose2, Seconds } from "../../app";

export interface Point {
  x: number;
  y: number;
}

/** A drag shorter than this is a click: it has no direction [m]. */
export const CLICK = 0.15;

export function length(from: Point, to: Point): number {
  return Math.hypot(to.x - from.x, to.y - from.y);
}

/** Stands at the press and looks along the drag. After a click it looks away from `viewer`, so that who drives there need not turn. */
export function poseOfDrag(from: Point, to: Point, viewer?: Point): Pose2 {
  if (length(from, to) >= CLICK) return { ...from, theta: Math.atan2(to.y - from.y, to.x - from.x) };
  if (viewer === undefined || length(viewer, from) < CLICK) return { ...from, theta: 0 };
  return { ...from, theta: Math.atan2(from.y - viewer.y, from.x - viewer.x) };
}

/** The longer the drag the faster: 1 m is 1 m/s, at most `most`; a click stands still. */
export function velocityOfDrag(from: Point, to: Point, most = 2): { x: number; y: number; z: number } {
  const drag = length(from, to);
  if (drag < CLICK) return { x: 0, y: 0, z: 0 };
  const scale = Math.min(drag, most) / drag;
  return { x: (to.x - from.x) * scale, y: (to.y - from.y) * scale, z: 0 };
}

export function stampOf(time: Seconds): { sec: number; nanosec: number } {
  const sec = Math.floor(time);
  return { sec, nanosec: Math.min(999_999_999, Math.round((time - sec) * 1e9)) };
}

function poseMessage(pose: Pose2) {
  return {
    position: { x: pose.x, y: pose.y, z: 0 },
    orientation: { x: 0, y: 0, z: Math.sin(pose.theta / 2), w: Math.cos(pose.theta / 2) },
  };
}

/** geometry_msgs/msg/PoseStamped. Without a stamp: as the frame is when the message comes. */
export function poseStamped(frame: string, pose: Pose2) {
  return { header: { stamp: { sec: 0, nanosec: 0 }, frame_id: frame }, pose: poseMessage(pose) };
}

/** geometry_msgs/msg/PoseWithCovarianceStamped with the deviations of rviz2's button: 0.5 m, 0.5 m, 15 degrees. */
export function initialPose(frame: string, pose: Pose2, time: Seconds) {
  const covariance = new Array<number>(36).fill(0);
  covariance[0] = covariance[7] = 0.5 ** 2;
  covariance[35] = (Math.PI / 12) ** 2;
  return { header: { stamp: stampOf(time), frame_id: frame }, pose: { pose: poseMessage(pose), covariance } };
}

/** The one of `people` whose middle is nearest to `point`, within `reach` [m]. */
export function nearest<T extends { position: Point }>(people: readonly T[], point: Point, reach = 0.8): T | undefined {
  let best: T | undefined;
  for (const person of people) {
    const distance = length(person.position, point);
    if (distance <= (best === undefined ? reach : length(best.position, point))) best = person;
  }
  return best;
}
