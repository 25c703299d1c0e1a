// One chunk of an MCAP file: its record opened, and the records in it.

import { crc32 } from "@foxglove/crc";
import { decompress as zstd } from "fzstd";

import { lz4 } from "./lz4";

/** As `runtime/recording/bag` reads them: no more than this is made of one chunk, whatever it claims. */
export const LARGEST_CHUNK = 256 * 2 ** 20;

export const PREFIX = 9; // opcode and length
export const enum Op {
  header = 1,
  footer = 2,
  schema = 3,
  channel = 4,
  message = 5,
  chunk = 6,
  dataEnd = 15,
}

export interface RawSchema {
  id: number;
  name: string;
  encoding: string;
  text: string;
}
export interface RawChannel {
  id: number;
  schemaId: number;
  topic: string;
  encoding: string;
  metadata: Map<string, string>;
}
export interface RawMessage {
  channelId: number;
  logTime: bigint;
  data: Uint8Array;
}
export interface RecordVisitor {
  schema?(schema: RawSchema): void;
  channel?(channel: RawChannel): void;
  message?(message: RawMessage): void;
}

function viewOf(bytes: Uint8Array): DataView {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}

/** Reads fields in their order; what would lie beyond the end throws. */
class Fields {
  #at = 0;
  readonly #view: DataView;
  readonly #bytes: Uint8Array;
  constructor(bytes: Uint8Array) {
    this.#bytes = bytes;
    this.#view = viewOf(bytes);
  }
  u16(): number {
    this.#at += 2;
    return this.#view.getUint16(this.#at - 2, true);
  }
  u32(): number {
    this.#at += 4;
    return this.#view.getUint32(this.#at - 4, true);
  }
  u64(): bigint {
    this.#at += 8;
    return this.#view.getBigUint64(this.#at - 8, true);
  }
  bytes(length: number): Uint8Array {
    if (this.#at + length > this.#bytes.length) throw new RangeError("a record is shorter than what it holds");
    this.#at += length;
    return this.#bytes.subarray(this.#at - length, this.#at);
  }
  text(): string {
    return new TextDecoder().decode(this.bytes(this.u32()));
  }
  map(): Map<string, string> {
    const entries = new Fields(this.bytes(this.u32()));
    const map = new Map<string, string>();
    while (entries.#at < entries.#bytes.length) map.set(entries.text(), entries.text());
    return map;
  }
  rest(): Uint8Array {
    return this.#bytes.subarray(this.#at);
  }
}

export interface Chunk {
  start: bigint;
  end: bigint;
  records: Uint8Array;
}

function decompress(compression: string, bytes: Uint8Array, size: number): Uint8Array {
  if (compression === "") return bytes;
  if (compression === "lz4") return lz4(bytes, size);
  if (compression !== "zstd") throw new Error(`unknown compression ${JSON.stringify(compression)}`);
  return zstd(bytes, new Uint8Array(size));
}

/** The content of a chunk record, its prefix apart. Throws with the reason; checksums count where there are any. */
export function openChunk(content: Uint8Array): Chunk {
  const fields = new Fields(content);
  const start = fields.u64();
  const end = fields.u64();
  const size = Number(fields.u64());
  if (size > LARGEST_CHUNK) throw new Error(`a chunk claims ${size} bytes, more than ${LARGEST_CHUNK}`);
  const crc = fields.u32();
  const compression = fields.text();
  const records = decompress(compression, fields.bytes(Number(fields.u64())), size);
  if (records.byteLength !== size) throw new Error(`a chunk of ${records.byteLength} bytes says ${size}`);
  if (crc !== 0 && crc32(records) !== crc) throw new Error("a chunk has a wrong checksum");
  return { start, end, records };
}

/** Calls the visitor for each record; others are passed over. Throws where a record is cut. */
export function eachRecord(records: Uint8Array, visitor: RecordVisitor): void {
  const view = viewOf(records);
  for (let at = 0; at < records.length; ) {
    if (at + PREFIX > records.length) throw new RangeError("a record is cut");
    const opcode = records[at];
    const length = Number(view.getBigUint64(at + 1, true));
    at += PREFIX;
    if (at + length > records.length) throw new RangeError("a record is cut");
    visit(opcode, records.subarray(at, at + length), visitor);
    at += length;
  }
}

export function visit(opcode: number, content: Uint8Array, visitor: RecordVisitor): void {
  if (opcode === Op.message && visitor.message) {
    const f = new Fields(content);
    const channelId = f.u16();
    f.u32();
    const logTime = f.u64();
    f.u64();
    visitor.message({ channelId, logTime, data: f.rest() });
  } else if (opcode === Op.schema && visitor.schema) {
    const f = new Fields(content);
    visitor.schema({ id: f.u16(), name: f.text(), encoding: f.text(), text: new TextDecoder().decode(f.bytes(f.u32())) });
  } else if (opcode === Op.channel && visitor.channel) {
    const f = new Fields(content);
    visitor.channel({ id: f.u16(), schemaId: f.u16(), topic: f.text(), encoding: f.text(), metadata: f.map() });
  }
}
