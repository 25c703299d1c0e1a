import assert from "node:assert/strict";
import test from "node:test";

import { outlineOf, partOfDiagonal } from "../../src/panels/hands/crop";
import { drawRequest, Stroke } from "../../src/panels/hands/keepout";

test("a stroke has points 3 cm apart, and the next press begins another", () => {
  const stroke = new Stroke();
  const press = { x: 0, y: 0 };
  for (const x of [0, 0.02, 0.04, 0.05, 0.08]) stroke.add(press, { x, y: 0 });
  assert.deepEqual(stroke.points.map(({ x }) => x), [0, 0.04, 0.08]);
  stroke.add({ x: 5, y: 5 }, { x: 6, y: 5 });
  assert.deepEqual(stroke.points, [{ x: 5, y: 5 }, { x: 6, y: 5 }]);
  assert.deepEqual(drawRequest("map", stroke.points, 100), {
    polygon: { header: { stamp: { sec: 0, nanosec: 0 }, frame_id: "map" }, polygon: { points: [{ x: 5, y: 5, z: 0 }, { x: 6, y: 5, z: 0 }] } },
    value: 100,
  });
});

const near = (a: number, b: number) => Math.abs(a - b) < 1e-12;

test("the part of a diagonal, whichever way it was dragged", () => {
  for (const [from, to] of [[{ x: 1, y: 5 }, { x: 4, y: 3 }], [{ x: 4, y: 5 }, { x: 1, y: 3 }]] as const) {
    const { corner, length, width } = partOfDiagonal(from, to, 0);
    assert.deepEqual([corner, length, width], [{ x: 1, y: 3, theta: 0 }, 3, 2]);
  }
});

// A quarter turn to the left: the lower side goes up along y from the lowest corner on the right, and the width goes to the left.
test("a part that is turned by a quarter", () => {
  const part = partOfDiagonal({ x: 1, y: 3 }, { x: 4, y: 5 }, Math.PI / 2);
  assert.ok(near(part.corner.x, 4) && near(part.corner.y, 3) && near(part.length, 2) && near(part.width, 3), JSON.stringify(part));
  const corners = [[4, 3], [4, 5], [1, 5], [1, 3], [4, 3]];
  outlineOf(part).forEach(({ x, y }, i) => assert.ok(near(x, corners[i]![0]!) && near(y, corners[i]![1]!), `${i}: ${x}, ${y}`));
});
