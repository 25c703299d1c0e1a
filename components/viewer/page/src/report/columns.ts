// Columns side by side: every run, the mean with its spread, and what was published.
import { shade } from "./brush";
import type { Columns } from "./format";
import { type Frame, limits, rangeOf } from "./plot";

const ASIDE = 0.1; // measured to the right of the middle, published to the left
const SPREAD = 0.6; // of the runs over the column

export function columnsFrame(columns: Columns): Frame {
  const values = columns.columns.flatMap(({ runs = [], measured, published }) => [...runs, measured?.mean, measured?.low, measured?.high, published]);
  const y = rangeOf(columns.y, values.filter((value): value is number => typeof value === "number"));
  const x = { low: 0, high: Math.max(1, columns.columns.length) };
  const onAxis = (value: number) => Math.min(y.high, Math.max(y.low, value));
  return {
    title: columns.title,
    x,
    y,
    xAxis: {},
    yAxis: columns.y,
    names: columns.columns.map(({ label }) => label),
    draw(brush, at) {
      limits(brush, at, x, columns.limits);
      for (const [i, { color, runs = [], measured, published }] of columns.columns.entries()) {
        const middle = i + 0.5;
        brush.pen(shade(color), 1.6);
        for (const [run, value] of runs.entries())
          if (value !== null) brush.disc(at(middle + SPREAD * ((run + 0.5) / runs.length - 0.5), onAxis(value)), 2.2 * brush.ratio, 0.55, false);
        if (measured !== undefined && measured.mean !== null) {
          const place = middle + ASIDE;
          if (measured.low !== null && measured.high !== null) {
            const ends = [at(place, onAxis(measured.low)), at(place, onAxis(measured.high))] as const;
            brush.line([...ends]);
            for (const [px, py] of ends) brush.line([[px - 4 * brush.ratio, py], [px + 4 * brush.ratio, py]]);
          }
          brush.disc(at(place, onAxis(measured.mean)), 4 * brush.ratio, 1, false);
        }
        if (typeof published === "number") {
          brush.pen(shade("ink"), 1.6);
          brush.diamond(at(middle - ASIDE, onAxis(published)));
        }
      }
    },
  };
}
