// The same commands without a mouse: a pose in numbers.
import type { Pose2 } from "../../app";
import { element } from "../dom";

export type PoseCommand = (pose: Pose2) => void;

export function byNumbers(commands: Record<string, PoseCommand>): HTMLElement {
  const [x, y, degrees] = [field("x [m]"), field("y [m]"), field("heading [°]")];
  const pose = (): Pose2 | undefined => {
    const values = [x, y, degrees].map(({ input }) => input.valueAsNumber) as [number, number, number];
    if (!values.every(Number.isFinite)) return undefined;
    return { x: values[0], y: values[1], theta: (values[2] * Math.PI) / 180 };
  };
  const buttons = Object.entries(commands).map(([label, command]) =>
    element("button", { type: "button", "data-test": `numbers-${label.toLowerCase().replace(" ", "-")}`, onclick: () => {
      const wanted = pose();
      if (wanted === undefined) [x, y, degrees].find(({ input }) => !Number.isFinite(input.valueAsNumber))?.input.focus();
      else command(wanted);
    } }, label),
  );
  return element(
    "details",
    { class: "by-numbers" },
    element("summary", {}, "By numbers"),
    element("div", { class: "row" }, x.root, y.root, degrees.root),
    element("div", { class: "row" }, ...buttons),
  );
}

function field(label: string) {
  const input = element("input", { type: "number", step: "any", value: 0, "data-test": `numbers-${label[0]}` });
  return { input, root: element("label", {}, element("span", {}, label), input) };
}
