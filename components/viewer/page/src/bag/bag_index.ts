// What a bag holds, and where: from the summary of its files, or, where a file has none, from a walk over it.

import { McapIndexedReader } from "@mcap/core";

import type { Seconds } from "../app";
import { eachRecord, openChunk, Op, PREFIX, visit, type RawChannel, type RawMessage, type RawSchema } from "./chunk";
import { LARGEST_READ, type FileBytes } from "./file_bytes";

/** Without a summary so much of a file is looked at. */
export const LONGEST_WALK = 512 * 2 ** 20;

export const seconds = (ns: bigint): Seconds => Number(ns) / 1e9;

/** Messages that stand together in a file. */
export interface Piece {
  file: number;
  offset: number; // of a chunk record, or of the first of several records
  length: number; // with the prefix
  size: number; // when it is open
  isChunk: boolean;
  start: Seconds;
  end: Seconds;
  topics: Set<string> | undefined; // undefined: the file does not tell
}

export interface Topic {
  name: string;
  type: string;
  encoding: string;
  schemaEncoding: string;
  schema: string;
  isLatched: boolean;
}

export interface BagIndex {
  files: FileBytes[];
  pieces: Piece[]; // by start
  topics: Map<string, Topic>;
  channels: Map<number, string>[]; // of each file: topic by channel id
  metadata: Record<string, string>; // of the record `bandwagon`: version, clock, seed and more
  notes: string[]; // what is missing, and why
}

const MAGIC = [0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 0x0d, 0x0a];

async function checkMagic(file: FileBytes): Promise<void> {
  const head = file.size === 0 ? new Uint8Array(0) : await file.read(0, Math.min(file.size, 16));
  if (MAGIC.every((byte, i) => head[i] === byte)) return;
  if (file.name.endsWith(".db3") || new TextDecoder().decode(head.subarray(0, 15)) === "SQLite format 3")
    throw new Error(`${file.name} is a SQLite bag; make it an MCAP file first: bandwagon bag convert ${file.name} out.mcap`);
  throw new Error(`${file.name} is no MCAP file: ${file.size === 0 ? "it is empty" : "it does not begin as one"}`);
}

const TRANSIENT_LOCAL = /durability:\s*(1\b|transient_local)/;

function addTopic(index: BagIndex, file: number, channel: RawChannel, schema: RawSchema | undefined): void {
  index.channels[file].set(channel.id, channel.topic);
  const isLatched = channel.topic === "/tf_static" || TRANSIENT_LOCAL.test(channel.metadata.get("offered_qos_profiles") ?? "");
  const known = index.topics.get(channel.topic);
  if (known) {
    known.isLatched ||= isLatched;
    return;
  }
  index.topics.set(channel.topic, {
    name: channel.topic,
    type: schema?.name ?? "",
    encoding: channel.encoding,
    schemaEncoding: schema?.encoding ?? "",
    schema: schema?.text ?? "",
    isLatched,
  });
}

async function bySummary(index: BagIndex, number: number): Promise<boolean> {
  const file = index.files[number];
  const reader = await McapIndexedReader.Initialize({
    readable: {
      size: async () => BigInt(file.size),
      read: async (offset, length) => file.read(Number(offset), Number(length)),
    },
  });
  if (reader.chunkIndexes.length === 0 && reader.statistics?.messageCount !== 0n) return false;
  for (const channel of reader.channelsById.values()) {
    const schema = reader.schemasById.get(channel.schemaId);
    addTopic(
      index,
      number,
      { ...channel, encoding: channel.messageEncoding },
      schema && { id: schema.id, name: schema.name, encoding: schema.encoding, text: new TextDecoder().decode(schema.data) },
    );
  }
  for (const chunk of reader.chunkIndexes) {
    const ids = [...chunk.messageIndexOffsets.keys()];
    index.pieces.push({
      file: number,
      offset: Number(chunk.chunkStartOffset),
      length: Number(chunk.chunkLength),
      size: Number(chunk.uncompressedSize),
      isChunk: true,
      start: seconds(chunk.messageStartTime),
      end: seconds(chunk.messageEndTime),
      topics: ids.length === 0 ? undefined : new Set(ids.map((id) => reader.channelsById.get(id)?.topic ?? "")),
    });
  }
  for await (const { metadata } of reader.readMetadata({ name: "bandwagon" })) Object.assign(index.metadata, Object.fromEntries(metadata));
  return true;
}

/** Reads on in blocks, so that many small records are not many requests. */
class Window {
  #start = 0;
  #bytes = new Uint8Array(0);
  constructor(readonly file: FileBytes) {}
  async read(offset: number, length: number): Promise<Uint8Array> {
    if (offset < this.#start || offset + length > this.#start + this.#bytes.length) {
      const block = Math.min(Math.max(length, 4 * 2 ** 20), this.file.size - offset);
      this.#bytes = (await this.file.read(offset, block)) as Uint8Array<ArrayBuffer>;
      this.#start = offset;
    }
    return this.#bytes.subarray(offset - this.#start, offset - this.#start + length);
  }
}

/** Messages outside of chunks are taken together up to this. */
const LOOSE = { bytes: 2 ** 20, duration: 1.0 };

class Walk {
  readonly #schemas = new Map<number, RawSchema>();
  #loose: Piece | undefined;
  constructor(
    readonly index: BagIndex,
    readonly number: number,
  ) {}

  chunk(offset: number, content: Uint8Array): void {
    const chunk = openChunk(content);
    const topics = new Set<string>();
    let start = Infinity;
    let end = -Infinity;
    eachRecord(chunk.records, {
      ...this.#declarations(),
      message: (m) => {
        topics.add(this.#topicOf(m));
        start = Math.min(start, seconds(m.logTime));
        end = Math.max(end, seconds(m.logTime));
      },
    });
    if (topics.size === 0) return;
    this.index.pieces.push({
      file: this.number,
      offset,
      length: content.length + PREFIX,
      size: chunk.records.length,
      isChunk: true,
      start,
      end,
      topics,
    });
  }

  record(opcode: number, offset: number, content: Uint8Array): void {
    visit(opcode, content, { ...this.#declarations(), message: (m) => this.#addLoose(offset, content.length + PREFIX, m) });
  }

  #declarations() {
    return {
      schema: (schema: RawSchema) => void this.#schemas.set(schema.id, schema),
      channel: (channel: RawChannel) => addTopic(this.index, this.number, channel, this.#schemas.get(channel.schemaId)),
    };
  }

  #topicOf(message: RawMessage): string {
    return this.index.channels[this.number].get(message.channelId) ?? "";
  }

  #addLoose(offset: number, length: number, message: RawMessage): void {
    const time = seconds(message.logTime);
    let piece = this.#loose;
    if (!piece || offset + length - piece.offset > LOOSE.bytes || Math.abs(time - piece.start) > LOOSE.duration) {
      piece = { file: this.number, offset, length: 0, size: 0, isChunk: false, start: time, end: time, topics: new Set() };
      this.index.pieces.push(piece);
      this.#loose = piece;
    }
    piece.length = piece.size = offset + length - piece.offset;
    piece.start = Math.min(piece.start, time);
    piece.end = Math.max(piece.end, time);
    piece.topics?.add(this.#topicOf(message));
  }
}

async function byWalk(index: BagIndex, number: number, why: string): Promise<void> {
  const file = index.files[number];
  const note = (text: string) => index.notes.push(`${file.name}: ${text}`);
  note(`no summary (${why}), so it was read from its beginning`);
  const window = new Window(file);
  const walk = new Walk(index, number);
  for (let at = MAGIC.length; ; ) {
    if (at + PREFIX > file.size) return void note(`ends at byte ${file.size} without having been closed`);
    if (at > LONGEST_WALK) return void note(`only its first ${LONGEST_WALK / 2 ** 20} MB are shown`);
    const prefix = await window.read(at, PREFIX);
    const opcode = prefix[0];
    const length = Number(new DataView(prefix.buffer, prefix.byteOffset).getBigUint64(1, true));
    if (opcode === Op.footer || opcode === Op.dataEnd) return;
    if (opcode === 0 || length > LARGEST_READ) return void note(`broken at byte ${at}; what is before that is shown`);
    if (at + PREFIX + length > file.size) return void note(`cut within the record at byte ${at}; what is before that is shown`);
    const isRead = opcode === Op.chunk || opcode === Op.schema || opcode === Op.channel || opcode === Op.message;
    try {
      if (isRead) {
        const content = await window.read(at + PREFIX, length);
        if (opcode === Op.chunk) walk.chunk(at, content);
        else walk.record(opcode, at, content);
      }
    } catch (error) {
      note(`byte ${at}: ${(error as Error).message}; it is left out`);
    }
    at += PREFIX + length;
  }
}

/** The files of one bag. Throws with the reason for what is no bag, or holds no message. */
export async function indexBag(files: FileBytes[]): Promise<BagIndex> {
  const index: BagIndex = { files, pieces: [], topics: new Map(), channels: files.map(() => new Map()), metadata: {}, notes: [] };
  for (let number = 0; number < files.length; ++number) {
    await checkMagic(files[number]);
    const before = index.pieces.length;
    try {
      if (await bySummary(index, number)) continue;
      await byWalk(index, number, "its messages are not indexed");
    } catch (error) {
      index.pieces.length = before;
      await byWalk(index, number, (error as Error).message);
    }
  }
  index.pieces.sort((a, b) => a.start - b.start);
  const names = files.map((file) => file.name).join(", ");
  if (index.pieces.length === 0) throw new Error([`${names} holds no message that can be read`, ...index.notes].join("; "));
  return index;
}
