import assert from "node:assert/strict";
import { test } from "node:test";
import type { Timeline } from "../../src/app";
import { TimeCursor } from "../../src/page/cursor";
import { framePrefix, robotsAmong, topicOf } from "../../src/page/robots";

const channel = (topic: string, type: string) => ({ topic, type, schema: "", latched: false });
const ODOMETRY = "nav_msgs/msg/Odometry";

test("robots are the namespaces of what every robot has", () => {
  const channels = [
    channel("/robot2/odom", ODOMETRY),
    channel("/robot1/odom", ODOMETRY),
    channel("/robot1/scan", "sensor_msgs/msg/LaserScan"),
    channel("/robot3/odom", "std_msgs/msg/String"),
    channel("/sim/ground_truth", "bandwagon_msgs/msg/GroundTruth"),
  ];
  assert.deepEqual(robotsAmong(channels), ["/robot1", "/robot2"]);
  assert.deepEqual(robotsAmong([channel("/odom", ODOMETRY)]), [""]);
});

test("a topic is the robot's own, else that which all share, and of the right type", () => {
  const channels = [channel("/map", "nav_msgs/msg/OccupancyGrid"), channel("/robot1/odom", ODOMETRY)];
  assert.equal(topicOf(channels, "/robot1", "/odom", ODOMETRY), "/robot1/odom");
  assert.equal(topicOf(channels, "/robot1", "/map", "nav_msgs/msg/OccupancyGrid"), "/map");
  assert.equal(topicOf(channels, "/robot2", "/odom", ODOMETRY), undefined);
  assert.equal(topicOf(channels, "/robot1", "/odom", "nav_msgs/msg/Path"), undefined);
  assert.deepEqual([framePrefix(""), framePrefix("/robot1")], ["", "robot1/"]);
});

/** Frames of a screen, 0.1 s each. */
function pass(cursor: TimeCursor, seconds: number): void {
  for (let i = 0; i < Math.round(seconds * 10); ++i) cursor.tick(0.1);
}

function cursorOn(kind: "live" | "bag") {
  const timeline = { begin: 10, end: 20 } as Timeline & { end: number };
  const cursor = new TimeCursor(() => timeline, () => kind, () => {});
  cursor.reset();
  return { cursor, timeline };
}

test("a live source is followed, until a person looks back; play comes back to now by itself", () => {
  const { cursor, timeline } = cursorOn("live");
  timeline.end = 21;
  assert.equal(cursor.time, 21);
  cursor.seek(15);
  assert.deepEqual([cursor.time, cursor.isLive, cursor.isPlaying], [15, false, false]);
  cursor.rate = 2;
  cursor.play();
  pass(cursor, 1);
  assert.ok(Math.abs(cursor.time - 17) < 1e-9);
  pass(cursor, 5);
  assert.deepEqual([cursor.time, cursor.isLive], [21, true]);
});

test("a time outside of what there is is held at its ends", () => {
  const { cursor } = cursorOn("live");
  cursor.seek(1);
  assert.equal(cursor.time, 10);
  cursor.step(100);
  assert.equal(cursor.time, 20);
});

test("a bag plays to its end, stops there, and from there begins again", () => {
  const { cursor } = cursorOn("bag");
  assert.equal(cursor.time, 10);
  cursor.play();
  pass(cursor, 30);
  assert.deepEqual([cursor.time, cursor.isPlaying], [20, false]);
  cursor.play();
  assert.equal(cursor.time, 10);
});
