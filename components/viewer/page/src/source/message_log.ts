// The messages of one topic, oldest first, decoded when somebody looks at them.
import type { Message, Seconds } from "../app";
import { lastAtOrBefore } from "./transforms";

interface Entry {
  time: Seconds;
  /** Undefined once a small message is decoded: then its value is kept instead. */
  bytes: Uint8Array | undefined;
  value: Message | undefined;
}

const SMALL = 4096; // [bytes] a decoded message of this size is kept as long as its bytes would be
const MOST_LARGE = 6; // decoded large messages that are kept

export class MessageLog {
  private entries: Entry[] = [];
  private large: Entry[] = [];
  /** Of the bytes that came, decoded since or not. */
  bytes = 0;
  private isBroken = false;

  constructor(
    readonly topic: string,
    readonly type: string,
    readonly isLatched: boolean,
    private readonly decode: (bytes: Uint8Array) => unknown,
    private readonly onBroken: (reason: string) => void,
  ) {}

  get oldest(): Seconds | undefined {
    return this.entries[0]?.time;
  }

  add(time: Seconds, bytes: Uint8Array): void {
    const last = this.entries.at(-1);
    const entry: Entry = { time, bytes, value: undefined };
    this.bytes += bytes.length;
    if (!last || last.time <= time) this.entries.push(entry);
    else if (this.isLatched && last.time - time > 1) this.entries = [entry]; // of a clock that went back
    else this.entries.splice(lastAtOrBefore(this.entries, time) + 1, 0, entry);
  }

  at(time: Seconds): Message | undefined {
    const last = lastAtOrBefore(this.entries, time);
    const entry = this.entries[last < 0 && this.isLatched ? 0 : last];
    return entry && this.valueOf(entry);
  }

  between(from: Seconds, to: Seconds): Message[] {
    const messages: Message[] = [];
    const end = lastAtOrBefore(this.entries, to);
    for (let i = lastAtOrBefore(this.entries, from) + 1; i <= end; ++i) {
      const message = this.valueOf(this.entries[i]!);
      if (message) messages.push(message);
    }
    return messages;
  }

  /** Forgets what is older, except the newest of it: it still holds. */
  forgetBefore(time: Seconds): void {
    this.forget(lastAtOrBefore(this.entries, time));
  }

  /** Forgets the older half; false when there is nothing to forget. */
  halve(): boolean {
    const count = this.entries.length >> 1;
    this.forget(count);
    return count > 0;
  }

  private forget(count: number): void {
    if (count <= 0) return;
    const gone = this.entries.splice(0, count);
    for (const entry of gone) this.bytes -= entry.bytes?.length ?? SMALL_KEPT;
    this.large = this.large.filter((entry) => !gone.includes(entry));
  }

  private valueOf(entry: Entry): Message | undefined {
    if (entry.value || !entry.bytes || this.isBroken) return entry.value;
    try {
      entry.value = { topic: this.topic, type: this.type, time: entry.time, value: this.decode(entry.bytes) };
    } catch (error) {
      this.isBroken = true; // the next one would be no better, and once is enough to be told
      this.onBroken(String(error instanceof Error ? error.message : error));
      return undefined;
    }
    if (entry.bytes.length <= SMALL) {
      this.bytes += SMALL_KEPT - entry.bytes.length;
      entry.bytes = undefined;
    } else {
      this.large.push(entry);
      if (this.large.length > MOST_LARGE) this.large.shift()!.value = undefined;
    }
    return entry.value;
  }
}

const SMALL_KEPT = 512; // [bytes] about what the objects of a small message take
