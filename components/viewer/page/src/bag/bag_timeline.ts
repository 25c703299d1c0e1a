// The messages of a bag by topic and time. What is asked for and not loaded comes soon after; memory stays bounded however long
// the bag is.

import type { Message, Pose2, Seconds, Timeline } from "../app";
import { Transforms, type TransformStamped } from "../source/transforms";
import type { BagIndex, Piece } from "./bag_index";
import { Decoder } from "./decoder";
import { PieceStore, type Messages } from "./piece_store";

export interface BagHooks {
  /** Messages arrived that were asked for. */
  changed(): void;
  say(level: "info" | "warning" | "error", text: string): void;
}

export interface Span {
  from: Seconds;
  to: Seconds;
}

const MEMORY = 128 * 2 ** 20; // [bytes] of opened pieces and decoded values
const AHEAD: Seconds = 3; // loaded before the cursor gets there
const STAND_IN: Seconds = 0.5; // so old may be what is shown while the right piece is loading
const TF_BEFORE: Seconds = 1; // a frame that nobody has told of for so long is not shown
const TF_AFTER: Seconds = 0.2; // poses are interpolated

/** How many of the sorted `values` are <= limit. */
export function countUpTo(values: readonly number[], limit: number): number {
  let low = 0;
  let high = values.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (values[middle] <= limit) low = middle + 1;
    else high = middle;
  }
  return low;
}

export class BagTimeline implements Timeline {
  readonly begin: Seconds;
  readonly end: Seconds;
  readonly #store: PieceStore;
  readonly #decoders = new Map<string, Decoder>();
  readonly #complained = new Set<string>();
  readonly #piecesOf = new Map<string, { numbers: number[]; starts: Seconds[]; latestEnd: Seconds[] }>();
  #frames: { time: Seconds; version: number; frames: Transforms } | undefined;
  #version = 0;
  #ahead = NaN;

  constructor(
    readonly index: BagIndex,
    readonly hooks: BagHooks,
    memory = MEMORY,
  ) {
    const changed = () => {
      ++this.#version;
      hooks.changed();
    };
    this.#store = new PieceStore(index, memory, changed, (reason) => hooks.say("error", reason));
    this.begin = index.pieces[0].start;
    this.end = index.pieces.reduce((end, piece) => Math.max(end, piece.end), -Infinity);
    for (const topic of index.topics.values()) {
      const decoder = new Decoder(topic);
      this.#decoders.set(topic.name, decoder);
      if (decoder.reason) hooks.say("warning", `${topic.name} is not shown: ${decoder.reason}`);
    }
    index.pieces.forEach((piece, number) => this.#place(piece, number));
  }

  /** Opened pieces and decoded values [bytes]. */
  get memory(): number {
    return this.#store.size;
  }

  at<T = any>(topic: string, time: Seconds): Message<T> | undefined {
    const places = this.#piecesOf.get(topic);
    if (!places || !this.#canDecode(topic)) return undefined;
    this.#prefetch(time);
    let best: { number: number; messages: Messages; i: number } | undefined;
    let isMissing = false;
    for (let k = countUpTo(places.starts, time) - 1; k >= 0; --k) {
      if (best && places.latestEnd[k] < best.messages.times[best.i]) break;
      if (!best && isMissing && places.latestEnd[k] < time - STAND_IN) break;
      const pieces = this.#store.get(places.numbers[k]);
      if (!pieces) {
        isMissing = true;
        continue;
      }
      const messages = pieces.get(topic);
      const i = messages ? countUpTo(messages.times, time) - 1 : -1;
      if (i >= 0 && messages && (!best || messages.times[i] > best.messages.times[best.i]))
        best = { number: places.numbers[k], messages, i };
    }
    if (isMissing && best && best.messages.times[best.i] < time - STAND_IN) return undefined;
    if (best) return this.#message<T>(topic, best.number, best.messages, best.i);
    return isMissing || !this.index.topics.get(topic)?.isLatched ? undefined : this.#first<T>(topic);
  }

  between<T = any>(topic: string, from: Seconds, to: Seconds): Message<T>[] {
    const places = this.#piecesOf.get(topic);
    if (!places || !this.#canDecode(topic)) return [];
    const last = countUpTo(places.starts, to) - 1;
    const numbers: number[] = [];
    let size = 0;
    for (let k = last; k >= 0 && places.latestEnd[k] > from; --k) {
      numbers.unshift(places.numbers[k]);
      size += this.index.pieces[places.numbers[k]].size;
    }
    // More than fits is not loaded for this: what is here is given.
    const isWanted = size <= this.#store.limit / 2;
    const found: Message<T>[] = [];
    for (const number of numbers) {
      const messages = this.#store.get(number, isWanted)?.get(topic);
      if (!messages) continue;
      const end = countUpTo(messages.times, to);
      for (let i = countUpTo(messages.times, from); i < end; ++i) {
        const message = this.#message<T>(topic, number, messages, i);
        if (message) found.push(message);
      }
    }
    return numbers.length > 1 ? found.sort((a, b) => a.time - b.time) : found;
  }

  transform(target: string, source: string, time: Seconds): Pose2 | undefined {
    return target === source ? { x: 0, y: 0, theta: 0 } : this.#framesAt(time).lookup(target, source, time);
  }

  root(time: Seconds): string | undefined {
    return this.#framesAt(time).root();
  }

  /** Messages of these topics in the order of their times, one piece in memory at a time. */
  async walk(topics: readonly string[], span: Span, each: (message: Message) => void, isOver: () => boolean): Promise<void> {
    const shown = topics.filter((topic) => this.#canDecode(topic));
    for (const [number, piece] of this.index.pieces.entries()) {
      if (piece.end < span.from || piece.start > span.to) continue;
      if (piece.topics && !shown.some((topic) => piece.topics!.has(topic))) continue;
      const pieces = await this.#store.read(number).catch(() => undefined);
      if (isOver()) return;
      const found: Message[] = [];
      for (const topic of shown) {
        const messages = pieces?.get(topic);
        for (let i = 0; messages && i < messages.times.length; ++i) {
          const value = messages.values[i] ?? this.#decode(topic, messages.bytes[i]!);
          if (value !== undefined) found.push({ topic, type: this.#typeOf(topic), time: messages.times[i]!, value });
        }
      }
      found.sort((a, b) => a.time - b.time).forEach(each);
      // A long walk leaves the page time to draw.
      await new Promise((resolve) => setTimeout(resolve, 0));
    }
  }

  #place(piece: Piece, number: number): void {
    for (const topic of piece.topics ?? this.index.topics.keys()) {
      let places = this.#piecesOf.get(topic);
      if (!places) this.#piecesOf.set(topic, (places = { numbers: [], starts: [], latestEnd: [] }));
      places.numbers.push(number);
      places.starts.push(piece.start);
      places.latestEnd.push(Math.max(piece.end, places.latestEnd.at(-1) ?? -Infinity));
    }
  }

  #canDecode(topic: string): boolean {
    return this.#decoders.get(topic)?.reason === "";
  }

  #typeOf(topic: string): string {
    return this.index.topics.get(topic)?.type ?? "";
  }

  #decode(topic: string, bytes: Uint8Array): unknown {
    try {
      return this.#decoders.get(topic)?.decode(bytes);
    } catch (error) {
      if (!this.#complained.has(topic))
        this.hooks.say("warning", `${topic}: a message of it is no ${this.#typeOf(topic)}: ${(error as Error).message}`);
      this.#complained.add(topic);
      return undefined;
    }
  }

  #message<T>(topic: string, number: number, messages: Messages, i: number): Message<T> | undefined {
    let value = messages.values[i];
    if (value === undefined) {
      value = this.#decode(topic, messages.bytes[i]);
      messages.values[i] = value;
      this.#store.count(number, messages.bytes[i].length);
    }
    return value === undefined ? undefined : { topic, type: this.#typeOf(topic), time: messages.times[i], value: value as T };
  }

  /** What was latched is there from the beginning, also when its writer came a moment later. */
  #first<T>(topic: string): Message<T> | undefined {
    const number = this.#piecesOf.get(topic)?.numbers[0];
    const messages = number === undefined ? undefined : this.#store.get(number)?.get(topic);
    return number === undefined || !messages ? undefined : this.#message<T>(topic, number, messages, 0);
  }

  #prefetch(time: Seconds): void {
    if (Math.abs(time - this.#ahead) < 0.2) return;
    this.#ahead = time;
    const { pieces } = this.index;
    let low = 0;
    let high = pieces.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (pieces[middle].start <= time) low = middle + 1;
      else high = middle;
    }
    for (let k = low; k < pieces.length && k < low + 8 && pieces[k].start < time + AHEAD; ++k) this.#store.prefetch(k);
  }

  #framesAt(time: Seconds): Transforms {
    if (this.#frames && this.#frames.time === time && this.#frames.version === this.#version) return this.#frames.frames;
    const frames = new Transforms();
    type Message = { transforms: TransformStamped[] };
    for (const m of this.between<Message>("/tf_static", -Infinity, Infinity)) frames.add(m.value.transforms, true);
    for (const m of this.between<Message>("/tf", time - TF_BEFORE, time + TF_AFTER)) frames.add(m.value.transforms, false);
    this.#frames = { time, version: this.#version, frames };
    return frames;
  }
}
