// One parameter: its name, what it is, what it is changed with, and why it was not.
import { create, setText } from "../dom";
import { controlOf } from "./control";
import { sectionOf } from "./descriptor";
import type { Entry } from "./store";
import { Throttle, type Timer } from "./throttle";
import { equal, textOf, type Value } from "./values";

/** Sliders say at most ten values a second. */
const PERIOD_MS = 100;

export interface RowActions {
  canCommand(): boolean;
  set(entry: Entry, value: Value): Promise<void>;
}

export const browserTimer: Timer = { now: () => performance.now(), after: (ms, then) => void setTimeout(then, ms) };

export class Row {
  readonly root: HTMLElement;
  private readonly control;
  private readonly error = create("p", { class: "refused", role: "alert" });
  private readonly undo: HTMLButtonElement;
  private readonly throttle: Throttle<Value>;

  constructor(
    readonly entry: Entry,
    private readonly actions: RowActions,
    isFullName = false,
  ) {
    const { parameter, first } = entry;
    this.throttle = new Throttle((value) => this.ask(value), PERIOD_MS, browserTimer);
    const give = (value: Value) => this.throttle.give(value);
    this.control = controlOf(parameter, { slide: give, set: give, refuse: (reason) => this.refuse(reason) });
    this.undo = create(
      "button",
      { type: "button", class: "undo", title: `Back to ${textOf(first)}`, "aria-label": `${parameter.name}: back to ${textOf(first)}`, onclick: () => give(first) },
      `↶ ${textOf(first)}`,
    );
    this.error.hidden = true;
    const name = isFullName ? parameter.name : sectionOf(parameter.name).leaf;
    this.root = create(
      "div",
      { class: parameter.isReadOnly ? "parameter fixed" : "parameter" },
      create("span", { class: "name", title: parameter.name }, ...breakable(name)),
      create("span", { class: "control" }, this.control.root, create("span", { class: "unit", title: parameter.unit }, parameter.unit)),
      create("p", { class: "doc" }, create("span", {}, parameter.doc), ...this.facts(), this.undo),
      this.error,
    );
    this.show();
  }

  /** After the value changed, here or elsewhere, or who may command. */
  show(): void {
    const { value, first, parameter } = this.entry;
    this.control.show(value);
    const isChanged = !equal(value, first);
    this.root.classList.toggle("changed", isChanged);
    this.undo.hidden = !isChanged;
    const isOff = parameter.isReadOnly || !this.actions.canCommand();
    for (const input of this.root.querySelectorAll("input, select, button")) (input as HTMLInputElement).disabled = isOff;
  }

  private async ask(value: Value): Promise<void> {
    try {
      await this.actions.set(this.entry, value);
      this.error.hidden = true;
    } catch (reason) {
      this.refuse(reason instanceof Error ? reason.message : String(reason));
    }
    this.show();
  }

  private refuse(reason: string): void {
    setText(this.error, reason);
    this.error.hidden = false;
    this.control.show(this.entry.value);
  }

  private facts(): HTMLElement[] {
    const { range, rule, defaultValue, isReadOnly } = this.entry.parameter;
    const facts: string[] = [];
    if (range !== undefined) facts.push(`${textOf(range.from)} to ${textOf(range.to)}`);
    if (rule !== "") facts.push(rule);
    if (defaultValue !== undefined) facts.push(`default ${textOf(defaultValue)}`);
    if (isReadOnly) facts.push("fixed while the component is active");
    return facts.map((fact) => create("span", { class: "fact" }, fact));
  }
}

/** Long names break between their words. */
function breakable(name: string): (string | Node)[] {
  return name.split(/(?<=_)/).flatMap((word, i) => (i === 0 ? [word] : [create("wbr"), word]));
}
