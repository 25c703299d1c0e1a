// The graph as a drawing: boxes of components in their lanes and processes, arrows by topic. A box that is chosen shows its own arrows.
import { create, svg } from "../dom";
import { arrowPath } from "./arrow";
import { LEVEL_NAMES, missed, oldest, slowest, type Component } from "./diagnostics";
import { layoutOf, type Group, type Layout, type Rectangle } from "./layout";
import type { Link } from "./links";

export class GraphView {
  readonly root = create("div", { class: "graph-view" });
  private drawn = "";

  constructor(private readonly choose: (name: string | undefined) => void) {}

  show(components: readonly Component[], links: readonly Link[], chosen: string | undefined): void {
    const width = Math.max(320, Math.floor(this.root.clientWidth));
    const now = JSON.stringify([width, chosen, components.map((each) => [each.name, each.level, each.process, each.lane, ...linesOf(each)]), links]);
    if (now === this.drawn) return;
    this.drawn = now;
    const focused = (document.activeElement as Element | null)?.closest<SVGElement>("g.box")?.dataset.component;
    const layout = layoutOf(components, width);
    const drawing = svg(
      "svg",
      { viewBox: `0 0 ${width} ${layout.height + 2}`, width, height: layout.height + 2, role: "group", "aria-label": "Components and topics" },
      arrowHeads(),
      ...layout.groups.map(groupOf),
      svg("g", { class: chosen === undefined ? "links" : "links some" }, ...links.map((link) => arrow(link, layout, chosen))),
      ...components.map((component) => this.box(component, layout.boxes.get(component.name)!, component.name === chosen)),
    );
    this.root.replaceChildren(drawing);
    if (focused !== undefined) drawing.querySelector<SVGElement>(`g.box[data-component="${CSS.escape(focused)}"]`)?.focus();
  }

  private box(component: Component, { x, y, width, height }: Rectangle, isChosen: boolean): SVGElement {
    const level = LEVEL_NAMES[component.level];
    const toggle = () => this.choose(isChosen ? undefined : component.name);
    const lines = linesOf(component);
    return svg(
      "g",
      {
        class: `box ${level}`,
        transform: `translate(${x} ${y})`,
        tabindex: 0,
        role: "button",
        "aria-pressed": String(isChosen),
        "aria-label": `${component.name}: ${level}, ${component.message}`,
        "data-component": component.name,
        onclick: toggle,
        onkeydown: (event: KeyboardEvent) => {
          if (event.key !== "Enter" && event.key !== " ") return;
          event.preventDefault();
          toggle();
        },
      },
      svg("title", {}, `${component.name}: ${component.message}`),
      svg("rect", { width, height, rx: 5, class: "back" }),
      svg("rect", { width: 4, height, rx: 2, class: "level" }),
      svg("text", { x: 12, y: 17, class: "name" }, shortened(component.name, 21)),
      ...lines.map((line, i) => svg("text", { x: 12, y: 31 + 13 * i, class: "fact" }, shortened(line, 24))),
    );
  }
}

/** What a box says below its name: what it does, what takes long, and what is old. */
export function linesOf(component: Component): string[] {
  const lines = [component.message];
  const slow = slowest(component);
  const late = missed(component);
  const overruns = Number(component.values.find(({ key }) => key === "overruns")?.value ?? 0);
  if (slow !== undefined) lines.push([`p99 ${slow.run.p99.toFixed(1)} ms`, overruns > 0 ? `${overruns} over` : late > 0 ? `${late} missed` : ""].filter(Boolean).join(" · "));
  const old = oldest(component);
  if (old !== undefined) lines.push(`${old.topic.split("/").at(-1)} ${old.age}`);
  return lines;
}

function groupOf({ x, y, width, height, name, kind }: Group): SVGElement {
  const label = kind === "process" ? { x: x + 8, y: y + 14 } : { x: x + 1, y: y + 11 };
  return svg(
    "g",
    { class: kind },
    kind === "process" ? svg("rect", { x: x + 0.5, y: y + 0.5, width: width - 1, height, rx: 7 }) : undefined,
    svg("text", label, kind === "lane" && name !== "" ? `lane ${name}` : name),
  );
}

function arrow(link: Link, layout: Layout, chosen: string | undefined): SVGElement | undefined {
  const [from, to] = [layout.boxes.get(link.from), layout.boxes.get(link.to)];
  if (from === undefined || to === undefined) return undefined;
  const side = link.from === chosen ? "out" : link.to === chosen ? "in" : "";
  return svg(
    "g",
    { class: `link ${side}` },
    svg("title", {}, `${link.from} → ${link.to}\n${link.topics.join("\n")}`),
    svg("path", { d: arrowPath(from, to), class: "grip" }),
    svg("path", { d: arrowPath(from, to), class: "line", "marker-end": `url(#head${side && `-${side}`})` }),
  );
}

function arrowHeads(): SVGElement {
  const head = (side: string) =>
    svg(
      "marker",
      { id: `head${side}`, class: `head${side}`, viewBox: "0 0 8 8", refX: 7, refY: 4, markerWidth: 6, markerHeight: 6, orient: "auto" },
      svg("path", { d: "M0,0.5 L8,4 L0,7.5 z" }),
    );
  return svg("defs", {}, head(""), head("-in"), head("-out"));
}

function shortened(text: string, most: number): string {
  return text.length <= most ? text : `${text.slice(0, most - 1)}…`;
}
