// A slider's places 0 to 1000 and the values they stand for: round ones, and by orders of magnitude where the range has several.
import { numberText } from "./values";

export const PLACES = 1000;

export interface Scale {
  from: number;
  to: number;
  isInteger: boolean;
}

/** Where the range is too wide for even steps a slider would jump over what is wanted: then only from a lower end above 0. */
export function isUsable({ from, to }: Scale): boolean {
  return to - from <= 1000 || from > 0;
}

export function valueAt(scale: Scale, place: number): number {
  const { from, to, isInteger } = scale;
  if (place <= 0) return from;
  if (place >= PLACES) return to;
  const share = place / PLACES;
  const value = isLogarithmic(scale) ? from * (to / from) ** share : from + (to - from) * share;
  const step = isInteger ? 1 : roundStep(isLogarithmic(scale) ? value / 50 : (to - from) / 200);
  return Math.min(to, Math.max(from, Number(numberText(Math.round(value / step) * step))));
}

export function placeOf(scale: Scale, value: number): number {
  const { from, to } = scale;
  const inside = Math.min(to, Math.max(from, value));
  const share = isLogarithmic(scale) ? Math.log(inside / from) / Math.log(to / from) : (inside - from) / (to - from);
  return Math.round(share * PLACES);
}

function isLogarithmic({ from, to }: Scale): boolean {
  return from > 0 && to / from >= 1000;
}

/** 1, 2 or 5 of the order of `step`, not above it. */
function roundStep(step: number): number {
  const order = 10 ** Math.floor(Math.log10(step));
  return order * [5, 2, 1].find((factor) => factor * order <= step * (1 + 1e-9))!;
}
