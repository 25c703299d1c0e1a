// What is different from when the page saw it first: listed, taken back, and as YAML for the graph.
import { create, setText } from "../dom";
import type { Entry } from "./store";
import { textOf } from "./values";

export interface ChangesActions {
  undo(entries: readonly Entry[]): void;
  yaml(): string;
  say(text: string): void;
}

export class Changes {
  private readonly title = create("h3", {});
  private readonly list = create("ul", {});
  private readonly text = create("pre", { class: "yaml", tabindex: 0, "aria-label": "Changes as YAML", "data-test": "yaml" });
  private entries: readonly Entry[] = [];
  private readonly buttons = create(
    "div",
    { class: "row" },
    this.button("Undo all", "undo-all", () => this.actions.undo(this.entries)),
    this.button("Copy YAML", "copy-yaml", () => void this.copy()),
    this.button("Download", "download-yaml", () => this.download()),
  );
  readonly root = create("section", { class: "changes", "aria-label": "Changed parameters" }, this.title, this.list, this.buttons, this.text);

  constructor(private readonly actions: ChangesActions) {
    this.root.hidden = true;
  }

  show(entries: readonly Entry[]): void {
    this.entries = entries;
    this.root.hidden = entries.length === 0;
    setText(this.title, entries.length === 1 ? "1 changed" : `${entries.length} changed`);
    this.list.replaceChildren(...entries.map((entry) => this.item(entry)));
    setText(this.text, this.actions.yaml());
  }

  enable(canCommand: boolean): void {
    for (const button of this.root.querySelectorAll<HTMLButtonElement>("button[data-command], .undo")) button.disabled = !canCommand;
  }

  private item(entry: Entry): HTMLElement {
    const { parameter, first, value } = entry;
    return create(
      "li",
      {},
      create("span", { class: "name", title: parameter.node }, `${parameter.node.slice(1)} ${parameter.name}`),
      create("span", { class: "values" }, `${textOf(first)} → ${textOf(value)} ${parameter.unit}`),
      create("button", { type: "button", class: "undo", title: "Undo", "aria-label": `Undo ${parameter.name}`, onclick: () => this.actions.undo([entry]) }, "↶"),
    );
  }

  /** The clipboard's own interface is there on loopback and with https alone. */
  private async copy(): Promise<void> {
    try {
      await navigator.clipboard.writeText(this.actions.yaml());
      this.actions.say("Copied");
    } catch {
      getSelection()?.selectAllChildren(this.text);
      this.actions.say(document.execCommand("copy") ? "Copied" : "Selected: copy it with the keyboard");
    }
  }

  private download(): void {
    const url = URL.createObjectURL(new Blob([this.actions.yaml()], { type: "application/yaml" }));
    create("a", { href: url, download: "parameters.yaml" }).click();
    setTimeout(() => URL.revokeObjectURL(url), 1000);
  }

  private button(label: string, test: string, onclick: () => void): HTMLButtonElement {
    return create("button", { type: "button", "data-test": test, "data-command": test === "undo-all", onclick }, label);
  }
}
