// The same commands without a mouse: a pose in numbers.
import type { Pose2 } from "../../app";
import { create } from "../dom";

export type PoseCommand = (pose: Pose2) => void;

export function byNumbers(commands: Record<string, PoseCommand>): HTMLElement {
  const [x, y, degrees] = [field("x [m]"), field("y [m]"), field("heading [°]")];
  const pose = (): Pose2 | undefined => {
    const values = [x, y, degrees].map(({ input }) => input.valueAsNumber) as [number, number, number];
    if (!values.every(Number.isFinite)) return undefined;
    return { x: values[0], y: values[1], theta: (values[2] * Math.PI) / 180 };
  };
  const buttons = Object.entries(commands).map(([label, command]) =>
    create("button", { type: "button", "data-test": `numbers-${label.toLowerCase().replace(" ", "-")}`, onclick: () => {
      const wanted = pose();
      if (wanted === undefined) [x, y, degrees].find(({ input }) => !Number.isFinite(input.valueAsNumber))?.input.focus();
      else command(wanted);
    } }, label),
  );
  return create(
    "details",
    { class: "by-numbers" },
    create("summary", {}, "By numbers"),
    create("div", { class: "row" }, x.root, y.root, degrees.root),
    create("div", { class: "row" }, ...buttons),
  );
}

function field(label: string) {
  const input = create("input", { type: "number", step: "any", value: 0, "data-test": `numbers-${label[0]}` });
  return { input, root: create("label", {}, create("span", {}, label), input) };
}
