// Takes what is new on a topic, each message once: in lock-step many have the same time, and after a restart time goes back.
import type { Message, Seconds, Timeline } from "../app";

export class Follower<T = any> {
  private last: Seconds = -Infinity;
  private atLast = new Set<Message<T>>();

  constructor(private readonly topic: string) {}

  /** Messages up to `timeline.end` that were not taken before, oldest first; `again` says that time went back. */
  take(timeline: Timeline): { messages: Message<T>[]; again: boolean } {
    const again = timeline.end < this.last;
    if (again) this.forget();
    // The last time is asked for once more: others may have come since with the same one.
    const from = this.last === -Infinity ? timeline.begin - 1 : this.last - 1e-6;
    const messages = timeline
      .between<T>(this.topic, from, timeline.end)
      .filter((message) => message.time >= this.last && !this.atLast.has(message));
    const newest = messages.at(-1);
    if (newest !== undefined) {
      if (newest.time > this.last) this.atLast.clear();
      this.last = newest.time;
      for (const message of messages) if (message.time === this.last) this.atLast.add(message);
    }
    return { messages, again };
  }

  forget(): void {
    this.last = -Infinity;
    this.atLast.clear();
  }
}
