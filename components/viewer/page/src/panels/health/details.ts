// All that is known of one component.
import { create } from "../dom";
import { LEVEL_NAMES, type Component } from "./diagnostics";
import type { Link } from "./links";

export function detailsOf(component: Component, links: readonly Link[]): HTMLElement {
  const place = [component.process && `process ${component.process}`, component.lane && `lane ${component.lane}`].filter(Boolean).join(", ");
  const { callbacks, inputs, values } = component;
  return create(
    "section",
    { class: "component-details", "aria-label": component.name, "data-test": "component-details" },
    create("h3", {}, create("span", { class: `dot ${LEVEL_NAMES[component.level]}` }), component.name),
    create("p", { class: "hint" }, [component.message, place].filter(Boolean).join(" · ")),
    callbacks.length === 0
      ? undefined
      : table(
          ["callback", "calls", "missed", "p50 ms", "p99", "max"],
          callbacks.map(({ name, calls, missed, run }) => [name, String(calls), String(missed), run.p50.toFixed(2), run.p99.toFixed(2), run.max.toFixed(2)]),
        ),
    inputs.length === 0 ? undefined : table(["input", "age", "rate"], inputs.map(({ topic, age, rate }) => [topic, age, rate])),
    values.length === 0 ? undefined : table(["says", ""], values.map(({ key, value }) => [key, value])),
    arrows("sends", links.filter(({ from }) => from === component.name), ({ to }) => to),
    arrows("hears", links.filter(({ to }) => to === component.name), ({ from }) => from),
  );
}

function arrows(title: string, links: readonly Link[], other: (link: Link) => string): HTMLElement | undefined {
  if (links.length === 0) return undefined;
  const byTopic = new Map<string, string[]>();
  for (const link of links) for (const topic of link.topics) byTopic.set(topic, [...(byTopic.get(topic) ?? []), other(link)]);
  return table([title, title === "sends" ? "to" : "from"], [...byTopic].sort().map(([topic, names]) => [topic, names.join(", ")]));
}

function table(heads: string[], rows: string[][]): HTMLElement {
  return create(
    "table",
    {},
    create("thead", {}, create("tr", {}, ...heads.map((head) => create("th", { scope: "col" }, head)))),
    create("tbody", {}, ...rows.map((cells) => create("tr", {}, ...cells.map((cell) => create("td", {}, cell))))),
  );
}
