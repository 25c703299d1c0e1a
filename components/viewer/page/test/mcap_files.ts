// MCAP files made for tests, by the writer of @mcap/core.
import { McapWriter } from "@mcap/core";

import { bytesInMemory, type FileBytes } from "../src/bag/file_bytes";

class Sink {
  bytes = new Uint8Array(0);
  position(): bigint {
    return BigInt(this.bytes.length);
  }
  async write(more: Uint8Array): Promise<void> {
    const grown = new Uint8Array(this.bytes.length + more.length);
    grown.set(this.bytes);
    grown.set(more, this.bytes.length);
    this.bytes = grown;
  }
}

export interface Line {
  topic: string;
  seconds: number;
  value: number;
}

export interface Making {
  schema?: (topic: string) => string;
  latched?: string[];
  useChunks?: boolean;
  chunkSize?: number;
}

/** CDR of std_msgs/msg/Float64. */
export function float64(value: number): Uint8Array {
  const bytes = new Uint8Array(12);
  bytes[1] = 1; // little endian
  new DataView(bytes.buffer).setFloat64(4, value, true);
  return bytes;
}

export async function mcapOf(lines: readonly Line[], making: Making = {}): Promise<Uint8Array> {
  const sink = new Sink();
  const writer = new McapWriter({ writable: sink, useChunks: making.useChunks ?? true, chunkSize: making.chunkSize ?? 256 });
  await writer.start({ profile: "ros2", library: "test" });
  const channels = new Map<string, number>();
  for (const line of lines) {
    let channelId = channels.get(line.topic);
    if (channelId === undefined) {
      const text = making.schema?.(line.topic) ?? "float64 data";
      const schemaId = await writer.registerSchema({
        name: "std_msgs/msg/Float64",
        encoding: "ros2msg",
        data: new TextEncoder().encode(text),
      });
      const qos = making.latched?.includes(line.topic) ? "- durability: 1\n" : "";
      channelId = await writer.registerChannel({
        schemaId,
        topic: line.topic,
        messageEncoding: "cdr",
        metadata: new Map([["offered_qos_profiles", qos]]),
      });
      channels.set(line.topic, channelId);
    }
    const time = BigInt(Math.round(line.seconds * 1e9));
    await writer.addMessage({ channelId, sequence: 0, logTime: time, publishTime: time, data: float64(line.value) });
  }
  await writer.end();
  return sink.bytes;
}

/** Counts what is read. */
export function counted(name: string, bytes: Uint8Array): FileBytes & { readBytes: number } {
  const file = bytesInMemory(name, bytes);
  const counting = {
    name,
    size: file.size,
    readBytes: 0,
    read(offset: number, length: number) {
      counting.readBytes += length;
      return file.read(offset, length);
    },
  };
  return counting;
}
