// Bytes of a topic to values. A topic whose schema cannot be understood says why, and the others go on.

import { MessageReader } from "@foxglove/rosmsg2-serialization";

import { parseSchema } from "../source/decode";

export interface Layout {
  type: string;
  encoding: string; // of its messages
  schemaEncoding: string;
  schema: string;
}

export class Decoder {
  readonly #reader: MessageReader | undefined;
  /** Why nothing of this topic is shown; empty when it can be. */
  readonly reason: string;

  constructor(layout: Layout) {
    try {
      if (layout.encoding !== "cdr") throw new Error(`its messages are ${layout.encoding || "of no encoding"}, not cdr`);
      if (layout.schemaEncoding !== "ros2msg")
        throw new Error(`its schema is ${layout.schemaEncoding || "of no encoding"}, not ros2msg`);
      this.#reader = new MessageReader(parseSchema(layout.schema));
      this.reason = "";
    } catch (error) {
      this.reason = `${layout.type || "no type"}: ${(error as Error).message.split("\n")[0]}`;
    }
  }

  /** Throws for bytes that are not a message of this type. */
  decode(bytes: Uint8Array): unknown {
    if (!this.#reader) throw new Error(this.reason);
    return this.#reader.readMessage(bytes);
  }
}
