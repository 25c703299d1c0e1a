import assert from "node:assert/strict";
import { test } from "node:test";
import { Transforms, compose, interpolate, invert, yawOf, type TransformStamped } from "../../src/source/transforms";

function transform(parent: string, child: string, sec: number, x: number, y: number, yaw: number): TransformStamped {
  const rotation = { x: 0, y: 0, z: Math.sin(yaw / 2), w: Math.cos(yaw / 2) };
  return { header: { stamp: { sec, nanosec: 0 }, frame_id: parent }, child_frame_id: child, transform: { translation: { x, y, z: 0 }, rotation } };
}

function near(actual: { x: number; y: number; theta: number } | undefined, x: number, y: number, theta: number): void {
  assert.ok(actual);
  for (const [a, b] of [[actual.x, x], [actual.y, y], [actual.theta, theta]] as const) assert.ok(Math.abs(a - b) < 1e-12, `${a} is not ${b}`);
}

test("a frame two links away: robot at (2, 1) looking up, laser 0.5 m before it, lies at (2, 1.5)", () => {
  const frames = new Transforms();
  frames.add([transform("map", "odom", 0, 1, 1, 0), transform("odom", "base_link", 0, 1, 0, Math.PI / 2)], false);
  frames.add([transform("base_link", "laser", 0, 0.5, 0, 0)], true);
  near(frames.lookup("map", "laser", 0), 2, 1.5, Math.PI / 2);
  near(frames.lookup("laser", "map", 0), -1.5, 2, -Math.PI / 2);
});

test("between two stamps poses are interpolated, outside of them held", () => {
  const frames = new Transforms();
  frames.add([transform("odom", "base_link", 10, 0, 0, 0), transform("odom", "base_link", 12, 4, 0, 1)], false);
  near(frames.lookup("odom", "base_link", 10.5), 1, 0, 0.25);
  near(frames.lookup("odom", "base_link", 9), 0, 0, 0);
  near(frames.lookup("odom", "base_link", 20), 4, 0, 1);
});

test("angles go the shorter way round", () => {
  near(interpolate({ x: 0, y: 0, theta: 3 }, { x: 0, y: 0, theta: -3 }, 0.5), 0, 0, Math.PI);
});

test("what is forgotten leaves the last pose before it", () => {
  const frames = new Transforms();
  for (let sec = 0; sec < 100; ++sec) frames.add([transform("odom", "base_link", sec, sec, 0, 0)], false);
  frames.forgetBefore(90.5);
  near(frames.lookup("odom", "base_link", 0), 90, 0, 0);
  near(frames.lookup("odom", "base_link", 95), 95, 0, 0);
});

test("frames that are not connected have no pose, and a loop ends", () => {
  const frames = new Transforms();
  frames.add([transform("a", "b", 0, 1, 0, 0), transform("c", "d", 0, 1, 0, 0)], false);
  assert.equal(frames.lookup("a", "d", 0), undefined);
  frames.add([transform("b", "a", 0, 1, 0, 0)], false);
  assert.equal(frames.lookup("a", "b", 0), undefined);
});

test("the root is map where there is one, else that of most frames", () => {
  const frames = new Transforms();
  assert.equal(frames.root(), undefined);
  frames.add([transform("odom", "base_link", 0, 0, 0, 0), transform("base_link", "laser", 0, 0, 0, 0), transform("x", "y", 0, 0, 0, 0)], false);
  assert.equal(frames.root(), "odom");
  frames.add([transform("map", "robot2/odom", 0, 0, 0, 0)], false);
  assert.equal(frames.root(), "map");
});

test("a transform that is no number is left out, and a leading slash means nothing", () => {
  const frames = new Transforms();
  frames.add([transform("/map", "/odom", 0, 1, 2, 0)], false);
  frames.add([transform("map", "odom", 1, NaN, 0, 0)], false);
  near(frames.lookup("map", "odom", 5), 1, 2, 0);
});

test("a pose and its inverse cancel; yaw is that of the quaternion", () => {
  const pose = { x: 1.5, y: -2, theta: 0.7 };
  near(compose(pose, invert(pose)), 0, 0, 0);
  assert.ok(Math.abs(yawOf({ x: 0, y: 0, z: Math.sin(0.6), w: Math.cos(0.6) }) - 1.2) < 1e-12);
});
