// One MCAP file through both readers of @mcap/core: by its indexes, and as a stream from the first byte on.
import { readFileSync } from "node:fs";
import assert from "node:assert/strict";

/** What both readers ask for: any range of the bytes. */
class InMemory {
  constructor(bytes) {
    this.bytes = bytes;
  }
  async size() {
    return BigInt(this.bytes.length);
  }
  async read(offset, size) {
    return this.bytes.subarray(Number(offset), Number(offset + size));
  }
}

export class BagFile {
  /** @param modules the packages: mcap, zstd, lz4, crc */
  constructor(modules, path, bytes = new Uint8Array(readFileSync(path))) {
    this.modules = modules;
    this.bytes = bytes;
    this.decompressHandlers = {
      zstd: (data, size) => modules.zstd.decompress(data, new Uint8Array(Number(size))),
      lz4: (data, size) => modules.lz4.decompress(data, Number(size)),
    };
  }

  /** By the indexes: summary, messages in the order of their log times, attachments, metadata. Checks every CRC. */
  async readIndexed() {
    const reader = await this.modules.mcap.McapIndexedReader.Initialize({
      readable: new InMemory(this.bytes),
      decompressHandlers: this.decompressHandlers,
    });
    const messages = [];
    for await (const message of reader.readMessages({ validateCrcs: true })) messages.push(message);
    const attachments = [];
    for await (const attachment of reader.readAttachments({ validateCrcs: true })) attachments.push(attachment);
    const metadata = [];
    for await (const record of reader.readMetadata()) metadata.push(record);
    assert.notEqual(reader.dataSectionCrc, undefined, "the data section has no CRC");
    const data = this.bytes.subarray(0, Number(reader.dataEndOffset));
    assert.equal(this.modules.crc.crc32(data), reader.dataSectionCrc, "CRC of the data section");
    return { reader, messages, attachments, metadata };
  }

  /** Every record from the first byte on, with what lies in chunks. */
  readStream() {
    const reader = new this.modules.mcap.McapStreamReader({
      decompressHandlers: this.decompressHandlers,
      includeChunks: true,
      validateCrcs: true,
    });
    const records = [];
    reader.append(this.bytes);
    for (let record = reader.nextRecord(); record != undefined; record = reader.nextRecord()) records.push(record);
    assert.equal(reader.done(), true, "the stream does not end");
    return records;
  }
}
