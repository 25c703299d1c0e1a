import assert from "node:assert/strict";
import test from "node:test";

import { initialPose, nearest, poseOfDrag, poseStamped, stampOf, velocityOfDrag } from "../../src/panels/hands/poses";
import { newGoalId } from "../../src/panels/hands/goal_id";

const close = (actual: number, expected: number) => assert.ok(Math.abs(actual - expected) < 1e-12, `${actual} is not ${expected}`);

test("a goal stands at the press and looks along the drag", () => {
  const pose = poseOfDrag({ x: 1, y: 2 }, { x: 1, y: 5 });
  assert.deepEqual([pose.x, pose.y], [1, 2]);
  close(pose.theta, Math.PI / 2);
});

test("a click looks away from the robot; without a robot to the east", () => {
  close(poseOfDrag({ x: 2, y: 2 }, { x: 2.05, y: 2 }, { x: 2, y: 0 }).theta, Math.PI / 2);
  assert.equal(poseOfDrag({ x: 2, y: 2 }, { x: 2.05, y: 2 }).theta, 0);
});

test("a heading becomes the quaternion about z: half the angle", () => {
  const message = poseStamped("map", { x: 1, y: 2, theta: Math.PI / 2 });
  assert.equal(message.header.frame_id, "map");
  assert.deepEqual(message.header.stamp, { sec: 0, nanosec: 0 });
  close(message.pose.orientation.z, Math.SQRT1_2);
  close(message.pose.orientation.w, Math.SQRT1_2);
});

test("an initial pose has the variances of rviz2's button: 0.25 m^2, 0.25 m^2, (pi/12)^2 rad^2", () => {
  const { header, pose } = initialPose("map", { x: 0, y: 0, theta: 0 }, 12.5);
  assert.deepEqual(header.stamp, { sec: 12, nanosec: 500_000_000 });
  assert.equal(pose.covariance.length, 36);
  assert.deepEqual(pose.covariance.flatMap((value, i) => (value === 0 ? [] : [i])), [0, 7, 35]);
  assert.equal(pose.covariance[0], 0.25);
  assert.equal(pose.covariance[7], 0.25);
  close(pose.covariance[35]!, 0.06853891945200943);
});

test("nanoseconds never reach a whole second", () => {
  assert.deepEqual(stampOf(1.9999999999), { sec: 1, nanosec: 999_999_999 });
});

test("people walk a metre a second for each metre of the drag, 2 m/s at most; a click stands", () => {
  assert.deepEqual(velocityOfDrag({ x: 0, y: 0 }, { x: 0, y: -1.5 }), { x: 0, y: -1.5, z: 0 });
  assert.deepEqual(velocityOfDrag({ x: 0, y: 0 }, { x: 10, y: 0 }), { x: 2, y: 0, z: 0 });
  assert.deepEqual(velocityOfDrag({ x: 1, y: 1 }, { x: 1.1, y: 1 }), { x: 0, y: 0, z: 0 });
});

test("the nearest person within reach is pushed", () => {
  const people = [
    { id: 1, position: { x: 0, y: 0 } },
    { id: 2, position: { x: 1, y: 0 } },
  ];
  assert.equal(nearest(people, { x: 0.7, y: 0 })?.id, 2);
  assert.equal(nearest(people, { x: 1.9, y: 0 }), undefined);
});

test("ids of goals are version 4 and differ", () => {
  const id = newGoalId();
  assert.equal(id.length, 16);
  assert.equal(id[6]! >> 4, 4);
  assert.equal(id[8]! >> 6, 2);
  assert.notDeepEqual(newGoalId(), id);
});
