import assert from "node:assert/strict";
import test from "node:test";

import { equal, fromWire, parse, textOf, toWire, Type } from "../../src/panels/parameters/values";

test("every type goes to the wire and back", () => {
  const values: [number, any][] = [
    [Type.boolean, true],
    [Type.integer, 42],
    [Type.integer, 2n ** 60n],
    [Type.double, 0.4],
    [Type.string, "eteb"],
    [Type.bytes, [1, 255]],
    [Type.booleans, [true, false]],
    [Type.integers, [1, -2]],
    [Type.doubles, [0.1, Infinity]],
    [Type.strings, ["a", "b"]],
    [Type.notSet, undefined],
  ];
  for (const [type, value] of values) assert.deepEqual(fromWire(toWire(type, value) as any), value);
});

test("integers are 64 bits wide on the wire", () => {
  assert.deepEqual(toWire(Type.integer, 5), { type: 2, integer_value: 5n });
  assert.deepEqual(toWire(Type.integers, [5]), { type: 7, integer_array_value: [5n] });
});

test("typed arrays of the decoder become lists", () => {
  assert.deepEqual(fromWire({ type: 8, double_array_value: new Float64Array([0.5, 1]) }), [0.5, 1]);
  assert.deepEqual(fromWire({ type: 7, integer_array_value: new BigInt64Array([7n]) }), [7]);
});

test("what people write", () => {
  assert.equal(parse(Type.double, " 1e-3 "), 0.001);
  assert.equal(parse(Type.double, "-.inf"), -Infinity);
  assert.equal(parse(Type.integer, "-3"), -3);
  assert.equal(parse(Type.integer, "9007199254740993"), 9007199254740993n);
  assert.deepEqual(parse(Type.doubles, "[1, 2.5]"), [1, 2.5]);
  assert.deepEqual(parse(Type.strings, "cmd_vel, scan"), ["cmd_vel", "scan"]);
  assert.deepEqual(parse(Type.integers, "[]"), []);
});

test("what is no value says so", () => {
  assert.match(String(parse(Type.integer, "1.5")), /must be a whole number/);
  assert.match(String(parse(Type.double, "")), /must be a number/);
  assert.match(String(parse(Type.double, "1,5")), /must be a number/);
  assert.match(String(parse(Type.doubles, "1, x")), /x: must be a number/);
  assert.match(String(parse(Type.boolean, "yes")), /must be true or false/);
});

test("numbers are shown as they were meant", () => {
  assert.equal(textOf(0.1 + 0.2), "0.3");
  assert.equal(textOf([1, 2.5]), "[1, 2.5]");
  assert.equal(textOf(undefined), "not set");
});

test("lists are equal by their elements", () => {
  assert.ok(equal([1, 2], [1, 2]));
  assert.ok(!equal([1, 2], [1]));
  assert.ok(!equal([1], 1));
});
