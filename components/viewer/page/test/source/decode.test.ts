import assert from "node:assert/strict";
import { test } from "node:test";
import { decode, encode } from "../../src/source/decode";
import { knownSchema } from "../../src/source/schemas";

test("stamps keep their names: sec and nanosec", () => {
  const schema = knownSchema("geometry_msgs/msg/PoseStamped")!;
  const sent = { header: { stamp: { sec: 7, nanosec: 500 }, frame_id: "map" }, pose: { position: { x: 1, y: 2 }, orientation: { w: 1 } } };
  const read = decode<any>(schema, encode(schema, sent));
  assert.deepEqual(read.header, sent.header);
  assert.deepEqual(read.pose, { position: { x: 1, y: 2, z: 0 }, orientation: { x: 0, y: 0, z: 0, w: 1 } });
});

test("a Twist is six doubles after four bytes of encapsulation", () => {
  const bytes = encode(knownSchema("geometry_msgs/msg/Twist")!, { linear: { x: 0.5 }, angular: { z: -1 } });
  assert.equal(bytes.length, 4 + 6 * 8);
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  assert.deepEqual([bytes[1], view.getFloat64(4, true), view.getFloat64(44, true)], [1, 0.5, -1]); // little endian
});

test("an empty message is one byte", () => {
  assert.equal(encode(knownSchema("std_msgs/msg/Empty")!, {}).length, 4 + 1);
  assert.deepEqual(decode(knownSchema("std_msgs/msg/Empty")!, new Uint8Array([0, 1, 0, 0, 0])), {});
});

test("a broken schema and bytes that are missing are refused", () => {
  assert.throws(() => decode("no such thing !", new Uint8Array(8)));
  assert.throws(() => decode("Missing/Type field\n", new Uint8Array(8)));
  assert.throws(() => decode(knownSchema("geometry_msgs/msg/Twist")!, new Uint8Array([0, 1, 0, 0, 1, 2])));
});

test("types that are not known have no schema", () => {
  assert.equal(knownSchema("my_msgs/msg/Mine"), undefined);
});
