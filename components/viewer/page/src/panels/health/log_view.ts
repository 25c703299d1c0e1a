// The log with its filters. Follows its end as long as that is in sight.
import type { App } from "../../app";
import { create } from "../dom";
import { levelName, LOG_LEVELS, type Line } from "./log";
import type { LogRecorder } from "./log_recorder";

const SHOWN = 400;
/** Stamps are the robot's: what was said within this of the time that is looked at belongs to it. */
const SLACK = 0.05;

export class LogView {
  private readonly level = create("select", { "aria-label": "Least level", "data-test": "log-level", onchange: () => this.show() });
  private readonly node = create("select", { "aria-label": "Node", "data-test": "log-node", onchange: () => this.show() });
  private readonly words = create("input", { type: "search", placeholder: "Words", "aria-label": "Words in the log", "data-test": "log-words", oninput: () => this.show() });
  private readonly list = create("div", { class: "log-lines", tabindex: 0, role: "log", "aria-label": "Log", "data-test": "log" });
  readonly root = create(
    "section",
    { class: "log" },
    create("h2", {}, "Log"),
    create("div", { class: "row" }, this.level, this.node, this.words),
    this.list,
  );
  private shown = "";

  constructor(
    private readonly app: App,
    private readonly recorder: LogRecorder,
  ) {
    this.level.append(...LOG_LEVELS.map(([value, name]) => create("option", { value, selected: value === 20 }, name)));
    this.node.append(create("option", { value: "" }, "all nodes"));
  }

  show(): void {
    this.recorder.readBag();
    this.offerNodes();
    const filter = { level: Number(this.level.value), node: this.node.value, words: this.words.value.trim() };
    const until = this.app.cursor.isLive ? Infinity : this.app.cursor.time + SLACK;
    const lines = this.recorder.book.find(filter, until, SHOWN);
    const now = `${lines.length} ${lines[0]?.time} ${lines.at(-1)?.time} ${JSON.stringify(filter)}`;
    if (now === this.shown) return;
    this.shown = now;
    const isAtEnd = this.list.scrollHeight - this.list.scrollTop - this.list.clientHeight < 30;
    this.list.replaceChildren(...(lines.length === 0 ? [create("p", { class: "hint" }, "Nothing was said")] : lines.map(lineElement)));
    if (isAtEnd) this.list.scrollTop = this.list.scrollHeight;
  }

  private offerNodes(): void {
    const nodes = this.recorder.book.nodes();
    if (nodes.length === this.node.options.length - 1) return;
    const chosen = this.node.value;
    this.node.replaceChildren(create("option", { value: "" }, "all nodes"), ...nodes.map((name) => create("option", { value: name }, name)));
    this.node.value = nodes.includes(chosen) ? chosen : "";
  }
}

function lineElement({ time, level, node, text }: Line): HTMLElement {
  return create(
    "p",
    { class: `log-line ${levelName(level)}` },
    create("time", {}, clockText(time)),
    create("span", { class: "node" }, node),
    create("span", { class: "text" }, text),
  );
}

function clockText(time: number): string {
  return new Date(time * 1000).toISOString().slice(11, 23);
}
