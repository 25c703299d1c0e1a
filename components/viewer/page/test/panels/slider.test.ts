import assert from "node:assert/strict";
import test from "node:test";

import { isUsable, PLACES, placeOf, valueAt, type Scale } from "../../src/panels/parameters/slider_scale";
import { Throttle } from "../../src/panels/parameters/throttle";

const metres: Scale = { from: 0, to: 10, isInteger: false };

test("a slider ends where the range ends, and stops at round values between", () => {
  assert.equal(valueAt(metres, 0), 0);
  assert.equal(valueAt(metres, PLACES), 10);
  assert.equal(valueAt(metres, 333), 3.35); // steps of 10 / 200 = 0.05
  assert.equal(valueAt({ from: 1, to: 7, isInteger: true }, 500), 4);
});

test("each value has its place, and comes back from it within a step", () => {
  for (const value of [0, 0.05, 3.35, 9.95, 10]) assert.equal(valueAt(metres, placeOf(metres, value)), value);
});

test("orders of magnitude have the same room each", () => {
  const wide: Scale = { from: 0.001, to: 1000, isInteger: false };
  assert.equal(placeOf(wide, 1), 500);
  assert.equal(valueAt(wide, 500), 1);
});

test("what is outside of the range is shown at its end", () => {
  assert.equal(placeOf(metres, 99), PLACES);
});

test("a slider over ten thousand from 0 on would jump over everything", () => {
  assert.ok(!isUsable({ from: 0, to: 10_000, isInteger: false }));
  assert.ok(isUsable({ from: 0.1, to: 10_000, isInteger: false }));
});

test("one request at a time, one per period, and the last value always", async () => {
  let now = 0;
  let due: { at: number; then: () => void } | undefined;
  const sent: [number, number][] = [];
  const answers: (() => void)[] = [];
  const throttle = new Throttle<number>(
    (value) => {
      sent.push([now, value]);
      return new Promise<void>((resolve) => answers.push(resolve));
    },
    100,
    { now: () => now, after: (ms, then) => void (due = { at: now + ms, then }) },
  );
  const answered = async () => {
    answers.shift()!();
    await new Promise((resolve) => setImmediate(resolve));
  };
  for (const value of [1, 2, 3]) throttle.give(value);
  assert.deepEqual(sent, [[0, 1]]);
  now = 20;
  await answered();
  assert.deepEqual(sent, [[0, 1]]);
  assert.equal(due!.at, 100);
  throttle.give(4);
  now = 100;
  due!.then();
  assert.deepEqual(sent, [[0, 1], [100, 4]]);
  await answered();
  now = 500;
  throttle.give(5);
  assert.deepEqual(sent.at(-1), [500, 5]);
});

test("after a refusal the next value goes out", async () => {
  const sent: number[] = [];
  const refused = new Throttle<number>(
    (value) => {
      sent.push(value);
      return Promise.reject(new Error("no"));
    },
    0,
    { now: () => 0, after: (_, then) => then() },
  );
  refused.give(1);
  await new Promise((resolve) => setImmediate(resolve));
  refused.give(2);
  assert.deepEqual(sent, [1, 2]);
});
