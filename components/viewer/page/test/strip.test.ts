import assert from "node:assert/strict";
import test from "node:test";

import { rolesOf, StripData } from "../src/panels/strip_data";
import { splitsOf, textOfTime } from "../src/panels/strip_rows";

const message = (time: number, value: any) => ({ topic: "", type: "", time, value });
const channel = (topic: string, type: string) => ({ topic, type, schema: "", latched: false });

const odometry = (x: number, speed: number) => ({
  header: { frame_id: "odom" },
  pose: { pose: { position: { x, y: 0 } } },
  twist: { twist: { linear: { x: speed } } },
});
const cycle = (more: object) => ({
  duration_ms: 3,
  budget_ms: 40,
  iterations: 10,
  iteration_budget: 40,
  class_switched: false,
  chosen_label: "LR",
  ...more,
});

test("topics are those of the robot, and what a newer robot tells goes before what it was guessed from", () => {
  const channels = [
    channel("/robot1/odom", "nav_msgs/msg/Odometry"),
    channel("/robot2/odom", "nav_msgs/msg/Odometry"),
    channel("/robot1/tracks", "bandwagon_msgs/msg/Tracks"),
    channel("/robot1/cmd_vel", "geometry_msgs/msg/TwistStamped"),
  ];
  const roles = (more: ReturnType<typeof channel>[] = []) => [...rolesOf([...channels, ...more], "/robot1")].sort();
  const common = [
    ["/robot1/cmd_vel", "stampedCommand"],
    ["/robot1/odom", "odom"],
  ];
  assert.deepEqual(roles(), [...common, ["/robot1/tracks", "tracks"]]);
  assert.deepEqual(roles([channel("/robot1/comfort", "bandwagon_msgs/msg/Comfort")]), [
    common[0],
    ["/robot1/comfort", "comfort"],
    common[1],
  ]);
});

test("speeds, distance and index as they are told", () => {
  const data = new StripData();
  data.add("odom", message(1, odometry(0, 0.4)));
  data.add("command", message(1.1, { linear: { x: 0.5 } }));
  data.add("stampedCommand", message(1.2, { twist: { linear: { x: 0.6 } } }));
  data.add("comfort", message(1, { closest_person_m: 1.25, collision_index: 0.2, contacts: 0 }));
  data.add("comfort", message(1.1, { closest_person_m: Infinity, collision_index: 0, contacts: 0 }));
  assert.equal(data.valueAt("measured", 1.5), 0.4);
  assert.deepEqual(data.curves.commanded, { times: [1.1, 1.2], values: [0.5, 0.6] });
  assert.equal(data.valueAt("person", 1.05), 1.25);
  assert.ok(Number.isNaN(data.valueAt("person", 1.1))); // nobody near
  assert.equal(data.valueAt("index", 1.05), 0.2);
  assert.equal(data.valueAt("measured", 0.9), undefined);
  assert.equal(data.valueAt("measured", 2.5), undefined); // too old to be true still
});

test("distance and index from tracks, where nobody tells them", () => {
  const data = new StripData();
  const tracks = (frame: string) => ({ header: { frame_id: frame }, tracks: [{ position: { x: 4, y: 3 }, radius: 0.3 }] });
  data.add("tracks", message(0.9, tracks("odom"))); // it is not known where the robot is
  data.add("odom", message(1, odometry(4, 0)));
  data.add("tracks", message(1, tracks("map"))); // another frame
  data.add("tracks", message(1.1, tracks("odom")));
  assert.deepEqual(data.curves.person, { times: [1.1], values: [3 - 0.3] });
  // exp(-3^2 / (2 * 0.6^2)) = exp(-12.5)
  assert.ok(Math.abs(data.curves.index.values[0]! - 3.7266531720786e-6) < 1e-12);
  assert.ok(data.isFromCentre);
});

test("of tracks only people count: who may be furniture is nobody, who does not say is somebody", () => {
  const data = new StripData();
  const near = { position: { x: 1, y: 0 }, radius: 0.3 };
  data.add("odom", message(1, odometry(0, 0)));
  for (const [i, confidence] of [0.4, 0.5, NaN, undefined].entries())
    data.add("tracks", message(1 + 0.1 * i, { header: { frame_id: "odom" }, tracks: [{ ...near, confidence }] }));
  assert.deepEqual(data.curves.person.values, [NaN, 0.7, 0.7, 0.7]);
});

test("the index reaches its limits where collision_index.hpp says", () => {
  const data = new StripData();
  const truth = (distance: number) => ({
    pose: { position: { x: 0, y: 0 } },
    people: [{ position: { x: distance, y: 0 }, radius: 0.3 }],
    contacts: 0,
  });
  for (const [i, distance] of [0.67, 1.19, 0.6].entries()) data.add("truth", message(i, truth(distance)));
  assert.deepEqual(
    data.curves.index.values.map((value) => Number(value.toFixed(2))),
    [0.54, 0.14, 0.61],
  );
});

test("the planner's cycle in milliseconds, in virtual time as a share of its iterations", () => {
  const data = new StripData();
  data.add("cycle", message(1, cycle({})));
  assert.deepEqual([data.cycleIs, data.valueAt("cycle", 1), data.valueAt("budget", 1)], ["ms", 3, 40]);
  const virtual = new StripData();
  virtual.add("cycle", message(1, cycle({ duration_ms: NaN })));
  assert.deepEqual([virtual.cycleIs, virtual.valueAt("cycle", 1), virtual.valueAt("budget", 1)], ["share", 25, 100]);
});

test("marks: goals, switches, contacts", () => {
  const data = new StripData();
  const status = (goal_id: bigint, number: number, reason = "") => ({
    goal_id,
    status: number,
    reason,
    navigation_time: { sec: 0, nanosec: goal_id === 1n ? 500_000_000 : 0 },
  });
  data.add("navigation", message(1.5, status(1n, 1))); // heard half a second after it began
  data.add("navigation", message(1.6, status(1n, 2)));
  data.add("comfort", message(2, { closest_person_m: 1, collision_index: 0, contacts: 3 })); // before we looked
  data.add("cycle", message(3, cycle({ class_switched: true })));
  data.add("comfort", message(4, { closest_person_m: 0, collision_index: 0.7, contacts: 4 }));
  data.add("navigation", message(5, status(1n, 4)));
  data.add("navigation", message(6, status(2n, 2)));
  data.add("navigation", message(7, status(2n, 6, "no path")));
  data.add("navigation", message(7.1, status(2n, 6, "no path")));
  assert.deepEqual(
    data.marks.map((mark) => [mark.time, mark.kind, mark.text]),
    [
      [1, "goal", "goal"],
      [3, "switch", "class LR"],
      [4, "contact", "contact"],
      [5, "reached", "reached"],
      [6, "goal", "goal"],
      [7, "ended", "aborted: no path"],
    ],
  );
  data.forgetBefore(5);
  assert.deepEqual(data.marks.map((mark) => mark.time), [5, 6, 7]);
});

test("of a long drive the curves stay bounded, and what is worst stays on them", () => {
  const data = new StripData();
  for (let i = 0; i < 450_000; ++i) {
    const isWorst = i === 123_457;
    data.add("comfort", message(0.1 * i, { closest_person_m: isWorst ? -0.1 : 2, collision_index: isWorst ? 0.9 : 0, contacts: 0 }));
  }
  assert.ok(data.curves.person.times.length <= 100_000);
  assert.equal(Math.min(...data.curves.person.values.slice(0, 50_000)), -0.1);
  assert.equal(data.curves.index.values.reduce((a, b) => Math.max(a, b)), 0.9);
  for (let i = 1; i < data.curves.person.times.length; ++i)
    assert.ok(data.curves.person.times[i - 1]! < data.curves.person.times[i]!);
});

test("times as a person reads them", () => {
  const texts: [number, number, string][] = [
    [0, 0, "0 s"],
    [-30, 0, "−30 s"],
    [-0.04, 1, "0.0 s"],
    [12.34, 1, "12.3 s"],
    [59.96, 1, "1:00.0"],
    [200, 0, "3:20"],
    [3661, 0, "1:01:01"],
  ];
  for (const [offset, digits, text] of texts) assert.equal(textOfTime(offset, digits), text);
});

test("marks of the axis stand at whole steps from its origin, 80 px apart at least", () => {
  const bag = splitsOf({ from: 1000.25, to: 1023.6, origin: 1000.25 }, 1000);
  assert.equal(bag.step, 2);
  assert.deepEqual(bag.at.slice(0, 3), [1000.25, 1002.25, 1004.25]);
  const live = splitsOf({ from: 40, to: 100, origin: 100 }, 600);
  assert.equal(live.step, 10);
  assert.deepEqual(live.at, [40, 50, 60, 70, 80, 90, 100]);
});
