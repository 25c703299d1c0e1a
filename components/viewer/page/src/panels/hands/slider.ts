// A slider with its value and unit beside its name.
import { create, setText } from "../dom";

export function slider(name: string, unit: string, min: number, max: number, initial: number) {
  const input = create("input", { type: "range", min, max, step: 0.05, value: initial, "aria-label": `${name} [${unit}]` });
  const output = create("output", {}, `${initial} ${unit}`);
  input.addEventListener("input", () => setText(output, `${input.value} ${unit}`));
  return { root: create("label", {}, create("span", {}, name), input, output), value: () => Number(input.value) };
}
