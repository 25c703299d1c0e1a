// Hears the log from the beginning, whether anybody looks at it or not: what was said before a panel is opened is what one opens it for.
import type { App } from "../../app";
import { Wants } from "../../page/wants";
import { Follower } from "../follower";
import { lineOf, LogBook, type WireLog } from "./log";

const TOPIC = "/rosout";
const KEPT = 5000;

export class LogRecorder {
  readonly book = new LogBook(KEPT);
  private follower = new Follower<WireLog>(TOPIC);
  private source: App["source"];

  constructor(private readonly app: App) {
    new Wants(app).set([TOPIC]);
    app.on("source", () => this.follow());
    app.on("message", () => this.hear());
  }

  /** A bag is all there is of it: up to the time that is looked at. */
  readBag(): void {
    const { source, timeline, cursor } = this.app;
    if (source?.kind !== "bag") return;
    this.book.clear();
    this.book.add(timeline.between<WireLog>(TOPIC, timeline.begin - 1, cursor.time).map(({ value }) => lineOf(value)));
  }

  /** Another source: another log. One that was gone for a while, and is back, goes on. */
  private follow(): void {
    if (this.app.source === this.source) return;
    this.source = this.app.source;
    this.book.clear();
    this.follower = new Follower(TOPIC);
  }

  private hear(): void {
    if (this.app.source?.kind !== "live") return;
    const { messages, again } = this.follower.take(this.app.timeline);
    if (again) this.book.clear();
    this.book.add(messages.map(({ value }) => lineOf(value)));
  }
}
