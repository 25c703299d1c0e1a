// The log with its filters. Follows its end as long as that is in sight.
import type { App } from "../../app";
import { create } from "../dom";
import { Follower } from "../follower";
import { levelName, lineOf, LOG_LEVELS, LogBook, type Line, type WireLog } from "./log";

export const LOG_TOPIC = "/rosout";
const KEPT = 5000;
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
  private readonly book = new LogBook(KEPT);
  private follower = new Follower<WireLog>(LOG_TOPIC);
  private shown = "";

  constructor(private readonly app: App) {
    this.level.append(...LOG_LEVELS.map(([value, name]) => create("option", { value, selected: value === 20 }, name)));
    this.node.append(create("option", { value: "" }, "all nodes"));
  }

  /** Another source: another log. */
  reset(): void {
    this.book.clear();
    this.follower = new Follower(LOG_TOPIC);
  }

  /** Cheap; with every message. */
  hear(): void {
    if (this.app.source?.kind === "bag") return;
    const { messages, again } = this.follower.take(this.app.timeline);
    if (again) this.book.clear();
    this.book.add(messages.map(({ value }) => lineOf(value)));
  }

  show(): void {
    if (this.app.source?.kind === "bag") this.readBag();
    this.offerNodes();
    const filter = { level: Number(this.level.value), node: this.node.value, words: this.words.value.trim() };
    const until = this.app.cursor.isLive ? Infinity : this.app.cursor.time + SLACK;
    const lines = this.book.find(filter, until, SHOWN);
    const now = `${lines.length} ${lines[0]?.time} ${lines.at(-1)?.time} ${JSON.stringify(filter)}`;
    if (now === this.shown) return;
    this.shown = now;
    const isAtEnd = this.list.scrollHeight - this.list.scrollTop - this.list.clientHeight < 30;
    this.list.replaceChildren(...(lines.length === 0 ? [create("p", { class: "hint" }, "Nothing was said")] : lines.map(lineElement)));
    if (isAtEnd) this.list.scrollTop = this.list.scrollHeight;
  }

  /** A bag is all there is of it: up to the time that is looked at. */
  private readBag(): void {
    const { timeline, cursor } = this.app;
    this.book.clear();
    this.book.add(timeline.between<WireLog>(LOG_TOPIC, timeline.begin - 1, cursor.time).map(({ value }) => lineOf(value)));
  }

  private offerNodes(): void {
    const nodes = this.book.nodes();
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
