// What a report shows of its numbers.
import assert from "node:assert/strict";
import test from "node:test";

import { shownBy } from "../../src/report/chart";
import type { Chart } from "../../src/report/format";
import { figure } from "../../src/report/words";

test("three significant digits, none after a whole number of four", () => {
  const shown = [37.4074, 0.0218, 1234.5, -2, 0, null, Number.NaN].map((value) => figure(value));
  assert.deepEqual(shown, ["37.4", "0.0218", "1235", "-2.00", "0", "–", "–"]);
  assert.equal(figure(0.9711, 2), "0.97");
});

function floor(to: [number, number]): Chart {
  return { kind: "chart", title: "", x: { low: 0, high: to[0] }, y: { low: 0, high: to[1] }, floor: true };
}

test("a floor is neither very flat nor very steep", () => {
  const flat = shownBy(floor([10, 0.1]));
  assert.ok(Math.abs(flat.y.high - flat.y.low - 3) < 1e-9);
  const steep = shownBy(floor([10, 40]));
  assert.ok(Math.abs(steep.x.high - steep.x.low - 40) < 1e-9);
});

test("without ends an axis holds what there is", () => {
  const chart: Chart = { kind: "chart", title: "", x: {}, y: { low: 0 }, series: [{ color: "ink", strokes: [[0, 1, 10, 5], [20, 2]] }] };
  const { x, y } = shownBy(chart);
  assert.ok(x.low < 0 && x.low > -1 && x.high > 20 && x.high < 21);
  assert.ok(y.low === 0 && y.high > 5 && y.high < 5.5);
  const nothing = shownBy({ kind: "chart", title: "", x: {}, y: {} });
  assert.ok(nothing.x.high > nothing.x.low, "nothing to show is no error");
});
