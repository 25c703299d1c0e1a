import assert from "node:assert/strict";
import test from "node:test";

import { arrowPath } from "../../src/panels/health/arrow";
import { componentOf, missed, oldest, slowest, statusesAt, type Component } from "../../src/panels/health/diagnostics";
import { layoutOf, BOX, type Rectangle } from "../../src/panels/health/layout";
import { componentNames, linksOf } from "../../src/panels/health/links";
import { levelName, LogBook, lineOf } from "../../src/panels/health/log";

const PLANNER = {
  level: 0,
  name: "local_planner",
  message: "following",
  values: [
    { key: "process", value: "planning" },
    { key: "lane", value: "local" },
    { key: "age /odom", value: "12.3 ms of 500 ms" },
    { key: "age /tracks", value: "90 ms of 1000 ms" },
    { key: "age /plan", value: "40.1 ms" },
    { key: "age /speed_limit", value: "never" },
    { key: "rate /odom", value: "49.8 Hz" },
    { key: "overruns", value: "2" },
    { key: "control_cycle", value: "calls 110 missed 3 run p50 1.135 p99 4.539 max 5.946 ms wait p50 0.121 p99 4.031 max 5.202 ms" },
    { key: "follow_request", value: "calls 8 missed 0 run p50 0.026 p99 0.045 max 0.045 ms wait p50 0.068 p99 11.894 max 11.894 ms" },
  ],
};

test("a status as the runtime writes it", () => {
  const component = componentOf(PLANNER);
  assert.deepEqual([component.process, component.lane], ["planning", "local"]);
  assert.deepEqual(component.values, [{ key: "overruns", value: "2" }]);
  assert.deepEqual(component.callbacks[0], {
    name: "control_cycle", calls: 110, missed: 3,
    run: { p50: 1.135, p99: 4.539, max: 5.946 }, wait: { p50: 0.121, p99: 4.031, max: 5.202 },
  });
  assert.equal(slowest(component)?.name, "control_cycle");
  assert.equal(missed(component), 3);
  assert.deepEqual(component.inputs.map(({ topic, share, rate }) => [topic, share, rate]), [
    ["/odom", 12.3 / 500, "49.8 Hz"], ["/tracks", 0.09, ""], ["/plan", undefined, ""], ["/speed_limit", undefined, ""],
  ]);
  assert.equal(oldest(component)?.topic, "/tracks");
});

test("each process has a message of its own: the newest of each name, until it is silent", () => {
  const message = (time: number, name: string, text: string) => ({
    topic: "/diagnostics", type: "", time, value: { status: [{ level: 0, name, message: text, values: [] }] },
  });
  const messages = [message(1, "people", "old"), message(9, "people", "looking"), message(2, "world", "ok")];
  assert.deepEqual(statusesAt(messages, 10).map(({ name, level, message: text }) => [name, level, text]), [
    ["people", 0, "looking"], ["world", 3, "silent for 8 s"],
  ]);
});

test("nodes are the components of their names, robots and namespaces of their own included", () => {
  const nameOf = componentNames(["people", "global_costmap", "robot1/people", "robot1/global_costmap"]);
  assert.equal(nameOf("/people"), "people");
  assert.equal(nameOf("/robot1/people"), "robot1/people");
  assert.equal(nameOf("/global_costmap/global_costmap"), "global_costmap");
  assert.equal(nameOf("/robot1/global_costmap/global_costmap"), "robot1/global_costmap");
  assert.equal(nameOf("/rviz"), undefined);
});

test("arrows by topic between components; what everybody hears has none", () => {
  const graph = {
    published: { "/scan": ["/world"], "/odom": ["/base"], "/imu": ["/base"], "/rosout": ["/base"], "/tf": ["/base"], "/a/_action/status": ["/base"] },
    subscribed: { "/scan": ["/people", "/rviz"], "/odom": ["/people"], "/imu": ["/people"], "/rosout": ["/people"], "/tf": ["/people"], "/a/_action/status": ["/people"] },
    services: {},
  };
  assert.deepEqual(linksOf(graph, ["world", "base", "people"]), [
    { from: "base", to: "people", topics: ["/imu", "/odom"] },
    { from: "world", to: "people", topics: ["/scan"] },
  ]);
});

const made = (name: string, process: string, lane: string): Component => ({ ...componentOf({ ...PLANNER, name }), process, lane });
const MANY = [
  made("world", "world+base", "world"),
  ...["robot_base", "twist_mux", "collision_monitor", "motor_control"].map((name) => made(name, "world+base", "base")),
  ...["localization", "people", "local_costmap", "navigator", "evaluation"].map((name) => made(name, "rest", "main")),
  made("global_planner", "planning", "global"),
  made("local_planner", "planning", "local"),
];

const overlap = (a: Rectangle, b: Rectangle) => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

for (const width of [320, 348, 700, 1244, 1900]) {
  test(`${width} pixels: every box within its width, none over another, each in its lane and process`, () => {
    const layout = layoutOf(MANY, width);
    const boxes = [...layout.boxes.values()];
    assert.equal(boxes.length, MANY.length);
    for (const [i, box] of boxes.entries()) {
      assert.ok(box.x >= 0 && box.x + BOX.width <= width, `${box.x}`);
      assert.ok(box.y + BOX.height <= layout.height);
      for (const other of boxes.slice(i + 1)) assert.ok(!overlap(box, other));
    }
    const processes = layout.groups.filter(({ kind }) => kind === "process");
    assert.deepEqual(processes.map(({ name }) => name), ["world+base", "rest", "planning"]);
    for (const [i, process] of processes.entries()) for (const other of processes.slice(i + 1)) assert.ok(!overlap(process, other));
    const rest = processes[1]!;
    const people = layout.boxes.get("people")!;
    assert.ok(people.x >= rest.x && people.x + people.width <= rest.x + rest.width && people.y + people.height <= rest.y + rest.height);
  });
}

test("processes are side by side where there is room", () => {
  const tops = (width: number) => new Set(layoutOf(MANY, width).groups.filter(({ kind }) => kind === "process").map(({ y }) => y)).size;
  assert.equal(tops(1244), 1);
  assert.equal(tops(348), 3);
});

test("an arrow leaves the side that faces the other box", () => {
  const box = (x: number, y: number): Rectangle => ({ x, y, width: 100, height: 50 });
  assert.match(arrowPath(box(0, 0), box(300, 0)), /^M100,25 C.* 300,25$/);
  assert.match(arrowPath(box(300, 0), box(0, 0)), /^M300,25 C.* 100,25$/);
  assert.match(arrowPath(box(0, 0), box(0, 60)), /^M50,50 C.* 50,60$/);
});

const log = (sec: number, level: number, name: string, msg: string) => lineOf({ stamp: { sec, nanosec: 0 }, level, name, msg });

test("the log is in the order of its stamps, and bounded: the oldest go", () => {
  const book = new LogBook(3);
  book.add([log(2, 20, "a", "two"), log(4, 20, "a", "four")]);
  book.add([log(3, 20, "b", "three"), log(1, 20, "b", "one")]);
  const all = { level: 10, node: "", words: "" };
  assert.deepEqual(book.find(all, Infinity, 10).map(({ text }) => text), ["two", "three", "four"]);
  assert.deepEqual(book.find(all, 3, 1).map(({ text }) => text), ["three"]);
  assert.deepEqual(book.nodes(), ["a", "b"]);
});

test("level, node and words filter together", () => {
  const book = new LogBook(10);
  book.add([log(1, 20, "planner", "Blocked"), log(2, 30, "planner", "blocked for 5 s"), log(3, 40, "base", "blocked wheel"), log(4, 30, "planner", "late")]);
  assert.deepEqual(book.find({ level: 30, node: "planner", words: "BLOCK" }, Infinity, 10).map(({ time }) => time), [2]);
  assert.equal(levelName(30), "warn");
  assert.equal(levelName(35), "warn");
});
