// LZ4 frames (the LZ4 frame format, version 1.6.3), as chunks of MCAP files have them. Every length is checked before it is used; checksums
// are skipped, because the chunk has one of its own.

const MAGIC = 0x184d2204;

function fail(what: string): never {
  throw new Error(`LZ4: ${what}`);
}

/** One block behind what `out` already holds up to `at`; returns the new end. Matches may reach into earlier blocks. */
function block(from: Uint8Array, out: Uint8Array, at: number): number {
  let i = 0;
  const more = (start: number): number => {
    let length = start;
    if (start !== 15) return length;
    for (;;) {
      if (i >= from.length) fail("a length is cut");
      const byte = from[i++];
      length += byte;
      if (byte !== 255) return length;
    }
  };
  while (i < from.length) {
    const token = from[i++];
    const literals = more(token >> 4);
    if (i + literals > from.length) fail("literals beyond the block");
    if (at + literals > out.length) fail("more bytes than the chunk says");
    out.set(from.subarray(i, i + literals), at);
    i += literals;
    at += literals;
    if (i === from.length) return at;
    if (i + 2 > from.length) fail("an offset is cut");
    const back = from[i] | (from[i + 1] << 8);
    i += 2;
    if (back === 0 || back > at) fail("a match before the beginning");
    const length = more(token & 15) + 4;
    if (at + length > out.length) fail("more bytes than the chunk says");
    if (back >= length) out.copyWithin(at, at - back, at - back + length);
    else for (let k = 0; k < length; ++k) out[at + k] = out[at + k - back];
    at += length;
  }
  return at;
}

/** Exactly `size` bytes, or an error. */
export function lz4(frame: Uint8Array, size: number): Uint8Array {
  const view = new DataView(frame.buffer, frame.byteOffset, frame.byteLength);
  if (frame.length < 7 || view.getUint32(0, true) !== MAGIC) fail("not a frame");
  const flags = frame[4];
  if (flags >> 6 !== 1) fail(`version ${flags >> 6}`);
  if (flags & 1) fail("a dictionary is needed");
  const hasBlockSum = (flags & 0x10) !== 0;
  let at = 4 + 2 + (flags & 8 ? 8 : 0) + 1;
  const out = new Uint8Array(size);
  let end = 0;
  for (;;) {
    if (at + 4 > frame.length) fail("the frame is cut");
    const word = view.getUint32(at, true);
    at += 4;
    if (word === 0) break;
    const length = word & 0x7fffffff;
    if (at + length > frame.length) fail("a block is cut");
    const bytes = frame.subarray(at, at + length);
    if (word & 0x80000000) {
      if (end + length > size) fail("more bytes than the chunk says");
      out.set(bytes, end);
      end += length;
    } else {
      end = block(bytes, out, end);
    }
    at += length + (hasBlockSum ? 4 : 0);
  }
  if (end !== size) fail(`${end} bytes where the chunk says ${size}`);
  return out;
}
