// The list of all parameters: a component opens to its sections. Rows are made when they are seen: a graph has a thousand of them.
import { arrange, create } from "../dom";
import { sectionOf } from "./descriptor";
import { Row, type RowActions } from "./row";
import type { Entry } from "./store";

/** More rows than this help nobody who searches. */
const MOST_FOUND = 200;

export class Sections {
  readonly root = create("div", { class: "sections" });
  private rows = new Map<Entry, Row>();
  private components = new Map<string, HTMLDetailsElement>();

  constructor(private readonly actions: RowActions) {}

  /** Everything, closed; of nodes that were there before only what is in `anew` is made again. */
  showAll(nodes: readonly string[], of: (node: string) => readonly Entry[], anew: ReadonlySet<string>): void {
    const before = this.components;
    for (const entry of this.rows.keys()) {
      const { node } = entry.parameter;
      if (!before.has(node) || anew.has(node)) this.rows.delete(entry);
    }
    this.components = new Map();
    for (const node of nodes) {
      const old = before.get(node);
      const component = old === undefined || anew.has(node) ? this.component(node, of(node)) : old;
      if (component === undefined) continue;
      component.open = old?.open ?? false;
      this.components.set(node, component);
    }
    arrange(this.root, [...this.components.values()]);
  }

  /** What was found before stays, with whoever is writing there. */
  showFound(nodes: readonly string[], of: (node: string) => readonly Entry[]): void {
    const before = this.components.size === 0 ? this.rows : new Map<Entry, Row>();
    const headings = new Map([...this.root.querySelectorAll(":scope > h3")].map((each) => [each.textContent!, each]));
    this.components = new Map();
    this.rows = new Map();
    const elements: Element[] = [];
    for (const node of nodes) {
      const entries = of(node).slice(0, MOST_FOUND - this.rows.size);
      if (entries.length === 0) continue;
      elements.push(headings.get(node) ?? create("h3", {}, node));
      for (const entry of entries) {
        const row = before.get(entry) ?? new Row(entry, this.actions, true);
        this.rows.set(entry, row);
        elements.push(row.root);
      }
    }
    const count = this.rows.size;
    const last = count === 0 ? "Nothing is called that" : count === MOST_FOUND ? `The first ${MOST_FOUND} are shown` : undefined;
    arrange(this.root, last === undefined ? elements : [...elements, create("p", { class: "hint" }, last)]);
  }

  show(entry: Entry): void {
    this.rows.get(entry)?.show();
  }

  showRows(): void {
    for (const row of this.rows.values()) row.show();
  }

  private component(node: string, entries: readonly Entry[]): HTMLDetailsElement | undefined {
    const own = entries.filter(({ parameter }) => parameter.name !== "use_sim_time");
    if (own.length === 0) return undefined;
    const changeable = own.filter(({ parameter }) => !parameter.isReadOnly).length;
    const count = create("span", { class: "count", title: `${changeable} of ${own.length} can be changed now` }, `${changeable} / ${own.length}`);
    const details = create("details", { class: "component", "data-node": node }, create("summary", {}, node.slice(1), count));
    details.addEventListener("toggle", () => details.childElementCount === 1 && details.append(...this.body(own)), { once: true });
    return details;
  }

  private body(entries: readonly Entry[]): HTMLElement[] {
    const elements: HTMLElement[] = [];
    let current = "";
    for (const entry of entries) {
      const { section } = sectionOf(entry.parameter.name);
      if (section !== current) elements.push(create("h3", {}, (current = section).replaceAll(".", " › ")));
      const row = new Row(entry, this.actions);
      this.rows.set(entry, row);
      elements.push(row.root);
    }
    return elements;
  }
}
