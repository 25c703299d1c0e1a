// Colours in a screenshot.
import { inflateSync } from "node:zlib";

/** Reads a PNG as chromium writes them: 8 bits, RGB or RGBA, not interlaced. */
export function decodePng(png) {
  const data = [];
  let width, height, channels;
  for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at)) {
    const type = png.toString("latin1", at + 4, at + 8);
    const body = png.subarray(at + 8, at + 8 + png.readUInt32BE(at));
    if (type === "IDAT") data.push(body);
    if (type !== "IHDR") continue;
    [width, height] = [body.readUInt32BE(0), body.readUInt32BE(4)];
    channels = { 2: 3, 6: 4 }[body[9]];
    if (body[8] !== 8 || channels === undefined || body[12] !== 0) throw new Error("a PNG of another kind");
  }
  const raw = inflateSync(Buffer.concat(data));
  const stride = width * channels;
  const pixels = Buffer.alloc(stride * height);
  for (let y = 0; y < height; ++y) unfilter(raw, y * (stride + 1), pixels, y * stride, stride, channels);
  return { width, height, channels, pixels };
}

/** One line, by the filter that its first byte names (PNG specification, section 9.2). */
function unfilter(raw, from, pixels, to, stride, channels) {
  const filter = raw[from];
  for (let i = 0; i < stride; ++i) {
    const left = i < channels ? 0 : pixels[to + i - channels];
    const up = to === 0 ? 0 : pixels[to + i - stride];
    const corner = to === 0 || i < channels ? 0 : pixels[to + i - stride - channels];
    const guess = [0, left, up, (left + up) >> 1, paeth(left, up, corner)][filter];
    pixels[to + i] = raw[from + 1 + i] + guess;
  }
}

function paeth(left, up, corner) {
  const guess = left + up - corner;
  const [a, b, c] = [Math.abs(guess - left), Math.abs(guess - up), Math.abs(guess - corner)];
  return a <= b && a <= c ? left : b <= c ? up : corner;
}

export function rgb(hex) {
  return [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));
}

/** How many pixels of a rectangle are of a colour, each channel within `tolerance`. */
export function count(image, colour, { x = 0, y = 0, width = image.width, height = image.height } = {}, tolerance = 12) {
  const wanted = rgb(colour);
  const [left, top] = [Math.max(0, Math.round(x)), Math.max(0, Math.round(y))];
  const [right, bottom] = [Math.min(image.width, Math.round(x + width)), Math.min(image.height, Math.round(y + height))];
  let found = 0;
  for (let row = top; row < bottom; ++row) {
    for (let column = left; column < right; ++column) {
      const at = (row * image.width + column) * image.channels;
      found += wanted.every((value, channel) => Math.abs(image.pixels[at + channel] - value) <= tolerance) ? 1 : 0;
    }
  }
  return found;
}

/** The same in a square of `size` pixels around a point. */
export function countAround(image, colour, { x, y }, size) {
  return count(image, colour, { x: x - size / 2, y: y - size / 2, width: size, height: size });
}
