import assert from "node:assert/strict";
import { test } from "node:test";
import { readBinary, writeMessage, writeServiceRequest } from "../../src/source/protocol";

// The layouts are those of the protocol's specification: opcode, then little-endian fields.
const buffer = (...bytes: number[]): ArrayBuffer => new Uint8Array(bytes).buffer;

test("message: subscription, time in nanoseconds, payload", () => {
  const read = readBinary(buffer(1, 7, 1, 0, 0, 0x00, 0xca, 0x9a, 0x3b, 0, 0, 0, 0, 0xaa, 0xbb)); // 1e9 ns
  assert.equal(read?.op, "message");
  assert.deepEqual(read, { op: "message", subscription: 263, time: 1, data: read.data });
  assert.deepEqual([...read.data], [0xaa, 0xbb]);
});

test("time: 2.5e9 ns are 2.5 s", () => {
  assert.deepEqual(readBinary(buffer(2, 0x00, 0xf9, 0x02, 0x95, 0, 0, 0, 0)), { op: "time", time: 2.5 });
});

test("service response: ids, encoding, payload", () => {
  const read = readBinary(buffer(3, 5, 0, 0, 0, 9, 0, 0, 0, 3, 0, 0, 0, 0x63, 0x64, 0x72, 1, 2));
  assert.equal(read?.op, "serviceResponse");
  assert.deepEqual([read.service, read.call, read.encoding, ...read.data], [5, 9, "cdr", 1, 2]);
});

test("what is too short is refused, what is unknown left alone", () => {
  for (const bytes of [[], [1, 0, 0], [2, 1], [3, 5, 0, 0, 0, 9, 0, 0, 0, 255, 255, 255, 255]]) assert.throws(() => readBinary(buffer(...bytes)));
  assert.equal(readBinary(buffer(99, 1, 2)), undefined);
});

test("what the page sends", () => {
  assert.deepEqual([...writeMessage(258, new Uint8Array([9]))], [1, 2, 1, 0, 0, 9]);
  const request = writeServiceRequest(5, 9, "cdr", new Uint8Array([1, 2]));
  assert.deepEqual([...request], [2, 5, 0, 0, 0, 9, 0, 0, 0, 3, 0, 0, 0, 0x63, 0x64, 0x72, 1, 2]);
});
