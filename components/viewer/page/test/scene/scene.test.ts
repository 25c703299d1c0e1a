import assert from "node:assert/strict";
import { test } from "node:test";
import { smaller } from "../../src/scene/gl/grid";
import { ellipseOf } from "../../src/scene/gl/discs";
import { timedPoints } from "../../src/scene/layers/band";
import { classColor } from "../../src/scene/layers/candidates";
import { roundStep } from "../../src/scene/layers/ground";
import { expectedOf } from "../../src/scene/layers/predictions";
import { along, hex, paletteFor, toHex } from "../../src/scene/palette";

test("from afar the highest cost of four cells counts, and unknown only where all are", () => {
  const levels = smaller(new Uint8Array([0, 100, 255, 255, 0, 0, 255, 255, 255, 7, 0, 0]), 4, 3);
  assert.deepEqual(levels.map(({ width, height, data }) => [width, height, ...data]), [
    [4, 3, 0, 100, 255, 255, 0, 0, 255, 255, 255, 7, 0, 0],
    [2, 1, 100, 0],
    [1, 1, 100],
  ]);
});

function pathOf(points: [x: number, seconds: number][]) {
  const header = (seconds: number) => ({ stamp: { sec: 100 + Math.floor(seconds), nanosec: Math.round((seconds % 1) * 1e9) }, frame_id: "odom" });
  return { header: header(0), poses: points.map(([x, seconds]) => ({ header: header(seconds), pose: { position: { x, y: 0, z: 0 } } })) };
}

test("speed of the band: 0.5 m in 0.5 s, then 0.2 m in 0.4 s; the last point goes on like that", () => {
  const points = timedPoints(pathOf([[0, 0], [0.5, 0.5], [0.7, 0.9]]));
  const speeds = points.map(({ speed }) => Math.round(speed * 1e6) / 1e6);
  assert.deepEqual(speeds, [1, 0.5, 0.5]);
  assert.ok(Math.abs(points[2]!.time - 0.9) < 1e-6);
});

test("poses of one time have no speed", () => {
  assert.ok(timedPoints(pathOf([[0, 0], [1, 0]])).every(({ speed }) => Number.isNaN(speed)));
  assert.deepEqual(timedPoints(pathOf([])), []);
});

test("two standard deviations of variances 4 and 1 are 4 and 2; turned by 45 degrees where they are mixed", () => {
  assert.deepEqual(ellipseOf(4, 0, 1, 2), { a: 4, b: 2, angle: 0 });
  const mixed = ellipseOf(2.5, 1.5, 2.5, 2)!;
  assert.ok(Math.abs(mixed.a - 4) < 1e-12 && Math.abs(mixed.b - 2) < 1e-12 && Math.abs(mixed.angle - Math.PI / 4) < 1e-12);
  for (const [xx, xy, yy] of [[NaN, 0, 1], [0, 0, 0], [-1, 0, -1]] as const) assert.equal(ellipseOf(xx, xy, yy, 2), undefined);
});

const TRACK = { id: 1, position: { x: 1, y: 0 }, velocity: { x: 1, y: 0.5 }, covariance: new Float64Array(16), radius: 0.3, predictions: [] };

test("who comes without predictions keeps the velocity: six places, each half second", () => {
  const expected = expectedOf(TRACK);
  assert.equal(expected.length, 6);
  assert.deepEqual({ ...expected[5]!, ellipse: null }, { time: 3, x: 4, y: 1.5, ellipse: null });
});

test("of predictions each 0.1 s those each half second are shown, to 3 s", () => {
  const predictions = Array.from({ length: 50 }, (_, i) => {
    const tenths = i + 1;
    return { time_from_start: { sec: Math.floor(tenths / 10), nanosec: (tenths % 10) * 1e8 }, x: tenths, y: 0, cov_xx: 1, cov_xy: 0, cov_yy: 1 };
  });
  assert.deepEqual(expectedOf({ ...TRACK, predictions }).map(({ x }) => x), [5, 10, 15, 20, 25, 30]);
});

test("along a scale: its ends, its middle, and no further", () => {
  const scale = [hex("#000000"), hex("#808080"), hex("#ffffff")];
  assert.deepEqual([-1, 0, 0.5, 1, 2, NaN].map((share) => toHex(along(scale, share))), ["#000000", "#000000", "#808080", "#ffffff", "#ffffff", "#000000"]);
});

/** Lightness by CIE's weights of linear light. */
function lightness(text: string): number {
  const [r, g, b] = hex(text).map((part) => part ** 2.2) as [number, number, number, number];
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

test("speed can be told by lightness alone: the scale only gets lighter, in both palettes", () => {
  for (const isDark of [true, false]) {
    const steps = [0, 0.25, 0.5, 0.75, 1].map((share) => lightness(toHex(along(paletteFor(isDark).speed, share))));
    for (let i = 1; i < steps.length; ++i) assert.ok(steps[i]! > steps[i - 1]!, `${steps}`);
  }
});

test("a class has the same colour whatever its cost", () => {
  const palette = paletteFor(true);
  assert.deepEqual(classColor("LR 1.20", palette), classColor("LR 33.00", palette));
});

test("round steps: 1, 2 or 5 times a power of ten", () => {
  assert.deepEqual([0.03, 0.9, 1.1, 3, 6, 130].map(roundStep).map((step) => Number(step.toPrecision(6))), [0.05, 1, 2, 5, 10, 200]);
});
