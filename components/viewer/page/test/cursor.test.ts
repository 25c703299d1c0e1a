import assert from "node:assert/strict";
import test from "node:test";

import type { Timeline } from "../src/app";
import { TimeCursor } from "../src/page/cursor";

const timeline = { begin: 100, end: 110 } as Timeline;
const cursorOf = (kind: "live" | "bag") => {
  const cursor = new TimeCursor(() => timeline, () => kind, () => {});
  cursor.reset();
  return cursor;
};

test("a bag plays from its beginning at its rate, and stops at its end", () => {
  const cursor = cursorOf("bag");
  assert.deepEqual([cursor.time, cursor.isLive, cursor.isPlaying], [100, false, true]);
  cursor.tick(0.1);
  assert.ok(Math.abs(cursor.time - 100.1) < 1e-9);
  cursor.rate = 4;
  cursor.tick(0.1);
  assert.ok(Math.abs(cursor.time - 100.5) < 1e-9);
  for (let i = 0; i < 30; ++i) cursor.tick(0.1);
  assert.deepEqual([cursor.time, cursor.isPlaying], [110, false]);
  cursor.play(); // once more
  assert.equal(cursor.time, 100);
});

test("a browser that is slow plays slower: nothing is passed over", () => {
  const cursor = cursorOf("bag");
  cursor.tick(7);
  assert.equal(cursor.time, 100.25);
});

test("who looks back at a robot stands still, and is live again when playing has caught up", () => {
  const cursor = cursorOf("live");
  assert.deepEqual([cursor.time, cursor.isLive], [110, true]);
  cursor.seek(109.5);
  assert.deepEqual([cursor.time, cursor.isLive, cursor.isPlaying], [109.5, false, false]);
  cursor.step(-0.1);
  assert.ok(Math.abs(cursor.time - 109.4) < 1e-9);
  cursor.play();
  for (let i = 0; i < 4; ++i) cursor.tick(0.2);
  assert.deepEqual([cursor.time, cursor.isLive], [110, true]);
  cursor.seek(0); // before what is kept
  assert.equal(cursor.time, 100);
  cursor.goLive();
  assert.equal(cursor.isLive, true);
});
