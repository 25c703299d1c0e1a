// What a panel wants to hear: asked for anew when there is another source.
import type { App, Source } from "../app";

export class Wants {
  private topics = new Set<string>();
  private source: Source | undefined;

  constructor(private readonly app: App) {
    app.on("source", () => this.set(this.topics));
  }

  set(topics: Iterable<string>): void {
    const next = new Set(topics);
    const before = this.source === this.app.source ? this.topics : new Set<string>();
    this.source = this.app.source;
    this.topics = next;
    for (const topic of next) if (!before.has(topic)) this.source?.want(topic);
    for (const topic of before) if (!next.has(topic)) this.source?.unwant(topic);
  }
}
