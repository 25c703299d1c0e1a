// The graph as a drawing: boxes of components in their lanes and processes, arrows by topic. A box that is chosen shows its own arrows.
import { create, setText, svg } from "../dom";
import { arrowPath } from "./arrow";
import { LEVEL_NAMES, missed, oldest, slowest, type Component } from "./diagnostics";
import { BOX, layoutOf, type Group, type Layout, type Rectangle } from "./layout";
import type { Link } from "./links";

export class GraphView {
  readonly root = create("div", { class: "graph-view" });
  private layout: Layout = { width: 0, height: 0, groups: [], boxes: new Map() };
  private boxes = new Map<string, Box>();
  private links = svg("g", {});
  private placed = "";
  private linked = "";

  constructor(private readonly choose: (name: string) => void) {}

  show(components: readonly Component[], links: readonly Link[], chosen: string | undefined): void {
    const width = Math.max(320, Math.floor(this.root.clientWidth));
    const places = JSON.stringify([width, components.map(({ name, process, lane }) => [name, process, lane])]);
    if (places !== this.placed) this.place(components, width);
    const arrows = JSON.stringify([places, chosen, links]);
    if (arrows !== this.linked) {
      this.links.replaceChildren(...links.map((link) => arrow(link, this.layout, chosen)).filter((each) => each !== undefined));
      this.links.setAttribute("class", chosen === undefined ? "links" : "links some");
    }
    for (const component of components) this.boxes.get(component.name)!.show(component, component.name === chosen);
    this.placed = places;
    this.linked = arrows;
  }

  private place(components: readonly Component[], width: number): void {
    const layout = layoutOf(components, width);
    this.layout = layout;
    this.links = svg("g", {});
    this.boxes = new Map(components.map(({ name }) => [name, new Box(name, layout.boxes.get(name)!, () => this.choose(name))]));
    const height = layout.height + 2;
    this.root.replaceChildren(
      svg(
        "svg",
        { viewBox: `0 0 ${width} ${height}`, width, height, role: "group", "aria-label": "Components and topics" },
        definitions(),
        ...layout.groups.map(groupOf),
        this.links,
        ...[...this.boxes.values()].map(({ root }) => root),
      ),
    );
  }
}

/** Stays while its texts change: what is focused stays focused. */
class Box {
  readonly root: SVGElement;
  private readonly title = svg("title", {});
  private readonly facts = [0, 1, 2].map((i) => svg("text", { x: 12, y: 31 + 13 * i, class: "fact", "clip-path": "url(#inside)" }));

  constructor(name: string, { x, y, width, height }: Rectangle, choose: () => void) {
    const onkeydown = (event: KeyboardEvent) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      choose();
    };
    this.root = svg(
      "g",
      { transform: `translate(${x} ${y})`, tabindex: 0, role: "button", "data-component": name, onclick: choose, onkeydown },
      this.title,
      svg("rect", { width, height, rx: 5, class: "back" }),
      svg("rect", { width: 4, height, rx: 2, class: "level" }),
      svg("text", { x: 12, y: 17, class: "name", "clip-path": "url(#inside)" }, name),
      ...this.facts,
    );
  }

  show(component: Component, isChosen: boolean): void {
    const level = LEVEL_NAMES[component.level];
    this.root.setAttribute("class", `box ${level}`);
    this.root.setAttribute("aria-pressed", String(isChosen));
    this.root.setAttribute("aria-label", `${component.name}: ${level}, ${component.message}`);
    setText(this.title, `${component.name}: ${component.message}`);
    const lines = linesOf(component);
    this.facts.forEach((fact, i) => setText(fact, lines[i] ?? ""));
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

/** Heads of arrows, and what of a text is within its box. */
function definitions(): SVGElement {
  const head = (side: string) =>
    svg(
      "marker",
      { id: `head${side}`, class: `head${side}`, viewBox: "0 0 8 8", refX: 7, refY: 4, markerWidth: 6, markerHeight: 6, orient: "auto" },
      svg("path", { d: "M0,0.5 L8,4 L0,7.5 z" }),
    );
  const inside = svg("clipPath", { id: "inside" }, svg("rect", { width: BOX.width - 5, height: BOX.height }));
  return svg("defs", {}, inside, head(""), head("-in"), head("-out"));
}
