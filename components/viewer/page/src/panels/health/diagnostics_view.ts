// Diagnostics as a list, the worst first, with a filter by level.
import { create, setText } from "../dom";
import { LEVEL_NAMES, type Component } from "./diagnostics";

export class DiagnosticsView {
  private readonly least = create(
    "select",
    { "aria-label": "Least level", "data-test": "diagnostics-level", onchange: () => this.again() },
    create("option", { value: 0 }, "all"),
    create("option", { value: 1 }, "warnings and errors"),
    create("option", { value: 2 }, "errors"),
  );
  private readonly list = create("ul", { "data-test": "diagnostics" });
  readonly root = create("section", { class: "diagnostics" }, create("div", { class: "row" }, create("h2", {}, "Diagnostics"), this.least), this.list);
  private components: readonly Component[] = [];
  private shown = "";

  constructor(private readonly choose: (name: string) => void) {}

  show(components: readonly Component[]): void {
    this.components = components;
    this.again();
  }

  private again(): void {
    const least = Number(this.least.value);
    // Stale is worse than a warning and better than an error that is certain.
    const rank = ({ level }: Component) => [0, 1, 3, 2][level]!;
    const listed = this.components.filter(({ level }) => level >= least).sort((a, b) => rank(b) - rank(a));
    const now = listed.map(({ name }) => name).join("\n");
    if (now !== this.shown || listed.length === 0) this.list.replaceChildren(...this.items(listed));
    this.shown = now;
    listed.forEach(({ level, message }, i) => {
      const [dot, , text] = this.list.children[i]!.firstElementChild!.children as unknown as [Element, Element, Element];
      dot.className = `dot ${LEVEL_NAMES[level]}`;
      dot.setAttribute("title", LEVEL_NAMES[level]);
      setText(text, message);
    });
  }

  private items(listed: readonly Component[]): HTMLElement[] {
    const nothing = this.components.length === 0 ? "Nothing has been heard" : "Nothing of that level";
    if (listed.length === 0) return [create("li", { class: "hint" }, nothing)];
    return listed.map(({ name }) =>
      create(
        "li",
        {},
        create(
          "button",
          { type: "button", class: "plain", onclick: () => this.choose(name) },
          create("span", {}),
          create("span", { class: "name" }, name),
          create("span", { class: "message" }),
        ),
      ),
    );
  }
}
