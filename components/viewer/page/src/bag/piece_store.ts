// Pieces of a bag, loaded when somebody looks at them and forgotten when memory is short: those that were looked at last stay.

import type { Seconds } from "../app";
import { eachRecord, openChunk, PREFIX } from "./chunk";
import { seconds, type BagIndex } from "./bag_index";

/** Messages of one topic in a piece, by time. `values` are filled when they are first looked at. */
export interface Messages {
  times: Seconds[];
  bytes: Uint8Array[];
  values: unknown[];
}

interface Loaded {
  topics: Map<string, Messages>;
  size: number;
  used: number;
}

/** A decoded value takes about so many times its bytes. */
const VALUE_FACTOR = 4;

export class PieceStore {
  readonly #loaded = new Map<number, Loaded>();
  readonly #failed = new Set<number>();
  readonly #waiting: number[] = []; // the last is loaded first
  readonly #underWay = new Set<number>();
  #clock = 0;
  #size = 0;

  /** `limit` [bytes] of opened pieces; `changed` when one came; `failed` with the reason when one cannot be had. */
  constructor(
    readonly index: BagIndex,
    readonly limit: number,
    readonly changed: () => void,
    readonly failed: (reason: string) => void,
  ) {}

  get size(): number {
    return this.#size;
  }

  /** Undefined when it is not here (yet). */
  get(piece: number, isWanted = true): ReadonlyMap<string, Messages> | undefined {
    const loaded = this.#loaded.get(piece);
    if (loaded) {
      loaded.used = ++this.#clock;
      return loaded.topics;
    }
    if (this.#failed.has(piece)) return new Map();
    if (isWanted) this.#ask(piece, true);
    return undefined;
  }

  /** Soon to be looked at. */
  prefetch(piece: number): void {
    if (!this.#loaded.has(piece) && !this.#failed.has(piece)) this.#ask(piece, false);
  }

  /** Of a message of `piece` was decoded `bytes`. */
  count(piece: number, bytes: number): void {
    const loaded = this.#loaded.get(piece);
    if (!loaded) return;
    loaded.size += bytes * VALUE_FACTOR;
    this.#size += bytes * VALUE_FACTOR;
  }

  /** Without keeping it. */
  async read(piece: number): Promise<ReadonlyMap<string, Messages>> {
    return this.#loaded.get(piece)?.topics ?? (await this.#open(piece));
  }

  #ask(piece: number, isUrgent: boolean): void {
    if (this.#underWay.has(piece)) return;
    const place = this.#waiting.indexOf(piece);
    if (place >= 0) {
      if (!isUrgent) return;
      this.#waiting.splice(place, 1);
    }
    if (isUrgent) this.#waiting.push(piece);
    else this.#waiting.unshift(piece);
    // Who scrubs leaves wishes behind that nobody has any more.
    if (this.#waiting.length > 64) this.#waiting.shift();
    this.#pump();
  }

  #pump(): void {
    while (this.#underWay.size < 2 && this.#waiting.length > 0) {
      const piece = this.#waiting.pop()!;
      this.#underWay.add(piece);
      this.#open(piece)
        .then(
          (topics) => this.#keep(piece, topics),
          (error: Error) => {
            this.#failed.add(piece);
            this.failed(error.message);
          },
        )
        .finally(() => {
          this.#underWay.delete(piece);
          this.#pump();
          this.changed();
        });
    }
  }

  #keep(piece: number, topics: Map<string, Messages>): void {
    const size = this.index.pieces[piece].size;
    this.#loaded.set(piece, { topics, size, used: ++this.#clock });
    this.#size += size;
    const oldest = [...this.#loaded].sort((a, b) => a[1].used - b[1].used);
    for (const [other, loaded] of oldest) {
      if (this.#size <= this.limit || other === piece) break;
      this.#loaded.delete(other);
      this.#size -= loaded.size;
    }
  }

  async #open(number: number): Promise<Map<string, Messages>> {
    const piece = this.index.pieces[number];
    const file = this.index.files[piece.file];
    const record = await file.read(piece.offset, piece.length);
    const topics = new Map<string, Messages>();
    try {
      const records = piece.isChunk ? openChunk(record.subarray(PREFIX)).records : record;
      eachRecord(records, {
        message: (m) => {
          const topic = this.index.channels[piece.file].get(m.channelId);
          if (topic === undefined) return;
          let messages = topics.get(topic);
          if (!messages) topics.set(topic, (messages = { times: [], bytes: [], values: [] }));
          messages.times.push(seconds(m.logTime));
          messages.bytes.push(m.data);
        },
      });
    } catch (error) {
      throw new Error(`${file.name}, byte ${piece.offset}: ${(error as Error).message}; it is left out`);
    }
    for (const messages of topics.values()) sortByTime(messages);
    return topics;
  }
}

function sortByTime(messages: Messages): void {
  const { times, bytes } = messages;
  if (times.every((t, i) => i === 0 || times[i - 1] <= t)) return;
  const order = times.map((_, i) => i).sort((a, b) => times[a] - times[b] || a - b);
  messages.times = order.map((i) => times[i]);
  messages.bytes = order.map((i) => bytes[i]);
}
