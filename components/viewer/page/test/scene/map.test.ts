import assert from "node:assert/strict";
import { test } from "node:test";
import { laidInto } from "../../src/scene/layers/map";

const header = { stamp: { sec: 0, nanosec: 0 }, frame_id: "map" };
const origin = { position: { x: 0, y: 0 }, orientation: { x: 0, y: 0, z: 0, w: 1 } };
const map = { header, info: { resolution: 1, width: 3, height: 2, origin }, data: new Int8Array([0, 0, 0, 0, 0, 0]) };

test("a part is laid into the map where it is, and the map before stays as it was", () => {
  const part = { header, x: 1, y: 0, width: 2, height: 2, data: new Int8Array([1, 2, 3, 4]) };
  assert.deepEqual([...laidInto(map, part)!.data], [0, 1, 2, 0, 3, 4]);
  assert.deepEqual([...map.data], [0, 0, 0, 0, 0, 0]);
});

test("a part of another map is none", () => {
  const data = new Int8Array([1, 2]);
  assert.equal(laidInto(map, { header, x: 2, y: 0, width: 2, height: 1, data }), undefined);
  assert.equal(laidInto(map, { header, x: -1, y: 0, width: 2, height: 1, data }), undefined);
  assert.equal(laidInto(map, { header, x: 0, y: 2, width: 2, height: 1, data }), undefined);
  assert.equal(laidInto(map, { header, x: 0, y: 0, width: 3, height: 1, data }), undefined);
  assert.equal(laidInto(map, { header: { frame_id: "odom" }, x: 0, y: 0, width: 2, height: 1, data }), undefined);
});
