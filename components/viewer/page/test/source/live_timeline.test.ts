import assert from "node:assert/strict";
import { test } from "node:test";
import { encode } from "../../src/source/decode";
import { KEPT, LiveTimeline } from "../../src/source/live_timeline";

const FLOAT = { topic: "/speed", type: "std_msgs/msg/Float64", schema: "float64 data\n", latched: false };
const STATE = { ...FLOAT, topic: "/state", latched: true };
const LARGE = { topic: "/large", type: "my_msgs/msg/Large", schema: "uint8[] data\n", latched: false };

function made(): { timeline: LiveTimeline; broken: string[] } {
  const broken: string[] = [];
  return { timeline: new LiveTimeline((topic) => broken.push(topic)), broken };
}

const float = (data: number) => encode(FLOAT.schema, { data });

test("the newest at or before a time", () => {
  const { timeline } = made();
  for (const time of [1, 2, 3]) timeline.add(FLOAT, time, float(time * 10));
  assert.equal(timeline.at("/speed", 0.5), undefined);
  assert.equal(timeline.at("/speed", 2)?.value.data, 20);
  assert.equal(timeline.at("/speed", 2.9)?.value.data, 20);
  assert.deepEqual(timeline.between("/speed", 1, 3).map(({ value }) => value.data), [20, 30]);
  assert.equal(timeline.at("/speed", 2), timeline.at("/speed", 2.9), "the same message is the same object");
});

test("60 s are kept, and the newest of what is older", () => {
  const { timeline } = made();
  timeline.add({ ...FLOAT, topic: "/rare" }, 1, float(5));
  for (let time = 1; time <= 200; ++time) timeline.add(FLOAT, time, float(time));
  assert.deepEqual([timeline.begin, timeline.end], [200 - KEPT, 200]);
  assert.ok(timeline.between("/speed", 0, 200).length <= KEPT + 2);
  assert.equal(timeline.at("/rare", 200)?.value.data, 5);
});

test("what is latched is there before it was heard", () => {
  const { timeline } = made();
  timeline.setClock(100);
  timeline.add(STATE, 100, float(1));
  timeline.add(FLOAT, 100, float(2));
  assert.equal(timeline.at("/state", 90)?.value.data, 1);
  assert.equal(timeline.at("/speed", 90), undefined);
});

test("a clock that goes back begins anew, and what is latched holds", () => {
  const { timeline } = made();
  timeline.setClock(100);
  timeline.add(STATE, 100, float(1));
  timeline.add(FLOAT, 100, float(2));
  timeline.setClock(99.9); // the network's disorder
  assert.equal(timeline.end, 100);
  timeline.setClock(10);
  assert.deepEqual([timeline.begin, timeline.end], [10, 10]);
  assert.equal(timeline.at("/speed", 200), undefined);
  assert.equal(timeline.at("/state", 10)?.value.data, 1);
});

test("a late message is put where it belongs", () => {
  const { timeline } = made();
  timeline.setClock(100);
  for (const time of [99, 100, 97, 98]) timeline.add(FLOAT, time, float(time));
  assert.deepEqual(timeline.between("/speed", 0, 100).map(({ value }) => value.data), [97, 98, 99, 100]);
  assert.equal(timeline.end, 100);
});

test("without a clock messages tell the time, also that it went back", () => {
  const { timeline } = made();
  timeline.add(FLOAT, 100, float(1));
  timeline.add(FLOAT, 10, float(2));
  assert.deepEqual(timeline.between("/speed", 0, 200).map(({ value }) => value.data), [2]);
});

test("memory has a bound: of 60 s at 10 MB/s not more than 96 MB stay", () => {
  const { timeline } = made();
  const bytes = encode(LARGE.schema, { data: new Uint8Array(1e6) });
  for (let i = 0; i < 600; ++i) timeline.add(LARGE, i / 10, bytes.slice());
  assert.ok(timeline.between("/large", 0, 60).length <= 97 + 10); // what came in the second since it was looked at last
  assert.ok(timeline.at("/large", 60), "the newest is there");
});

test("a topic that cannot be read is told once", () => {
  const { timeline, broken } = made();
  for (const time of [1, 2, 3]) timeline.add(FLOAT, time, new Uint8Array([0, 1, 0, 0]));
  for (const time of [1, 2, 3]) assert.equal(timeline.at("/speed", time), undefined);
  assert.deepEqual(broken, ["/speed"]);
});
