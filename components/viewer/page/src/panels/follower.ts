// Takes what is new on a topic of a live source, each message once: in lock-step many have the same time, what is latched is older than its
// arrival, and after a restart time goes back.
import type { Message, Seconds, Timeline } from "../app";

export class Follower<T = any> {
  private end: Seconds = -Infinity;
  private taken = new WeakSet<Message<T>>();

  constructor(private readonly topic: string) {}

  /** Messages that were not taken before, oldest first; `again` says that time went back and what was taken is of another run. */
  take(timeline: Timeline): { messages: Message<T>[]; again: boolean } {
    const again = timeline.end < this.end;
    this.end = timeline.end;
    const messages = timeline.between<T>(this.topic, -Infinity, timeline.end).filter((message) => !this.taken.has(message));
    for (const message of messages) this.taken.add(message);
    return { messages, again };
  }
}
