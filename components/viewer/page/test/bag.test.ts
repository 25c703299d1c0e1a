import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import test from "node:test";

import { indexBag } from "../src/bag/bag_index";
import { openBag } from "../src/bag/bag_source";
import { BagTimeline } from "../src/bag/bag_timeline";
import { openChunk } from "../src/bag/chunk";
import { bytesInMemory, bytesOfServer } from "../src/bag/file_bytes";
import { lz4 } from "../src/bag/lz4";
import { counted, mcapOf, type Line } from "./mcap_files";

class Said {
  lines: string[] = [];
  changes = 0;
  changed = () => void ++this.changes;
  say = (level: string, text: string) => void this.lines.push(`${level}: ${text}`);
}

/** What `ask` gives once everything that it asked for was loaded. */
async function settled<T>(ask: () => T | undefined): Promise<T | undefined> {
  for (let i = 0; i < 200; ++i) {
    ask();
    await new Promise((resolve) => setImmediate(resolve));
  }
  return ask();
}

const slowAndFast = (count: number): Line[] =>
  Array.from({ length: count }, (_, i) => ({ topic: "/fast", seconds: 10 + 0.1 * i, value: i })).concat([
    { topic: "/slow", seconds: 10 + 0.1 * count, value: -1 },
  ]);

test("a message is the newest at or before the time that is asked for", async () => {
  const said = new Said();
  const bag = await openBag([bytesInMemory("a.mcap", await mcapOf(slowAndFast(100)))], said);
  const at = (time: number) => settled(() => bag.timeline.at("/fast", time)?.value.data);
  assert.equal(bag.timeline.begin, 10);
  assert.ok(Math.abs(bag.timeline.end - 20) < 1e-6);
  assert.equal(await at(9.99), undefined);
  assert.equal(await at(10), 0);
  assert.equal(await at(15.05), 50);
  assert.equal(await at(99), 99);
  assert.deepEqual(await settled(() => bag.timeline.between("/fast", 10.05, 10.35).map((m) => m.value.data)), [1, 2, 3]);
  assert.deepEqual(said.lines, []);
});

test("what is latched is there from the beginning, what is not is not", async () => {
  const lines = [...slowAndFast(100), { topic: "/map", seconds: 12, value: 7 }].sort((a, b) => a.seconds - b.seconds);
  const bag = await openBag([bytesInMemory("a.mcap", await mcapOf(lines, { latched: ["/map"] }))], new Said());
  assert.equal(await settled(() => bag.timeline.at("/map", 10)?.value.data), 7);
  assert.equal(await settled(() => bag.timeline.at("/map", 19)?.value.data), 7);
  assert.equal(await settled(() => bag.timeline.at("/slow", 10)), undefined);
});

test("memory stays bounded and little is read to look at one instant", async () => {
  const bytes = await mcapOf(slowAndFast(20_000), { chunkSize: 4096 });
  const file = counted("a.mcap", bytes);
  const timeline = new BagTimeline(await indexBag([file]), new Said(), 64 * 1024);
  const summary = file.readBytes;
  assert.equal(await settled(() => timeline.at("/fast", 1000)?.value.data), 9900);
  // One piece, and those that begin within 3 s behind it: 4 kB hold 9 s of messages.
  assert.ok(file.readBytes - summary <= 2 * 4500, `${file.readBytes - summary} bytes`);
  for (let time = 10; time < 2010; time += 50) await settled(() => timeline.at("/fast", time));
  assert.ok(timeline.memory <= 64 * 1024, `${timeline.memory} bytes`);
  assert.equal(await settled(() => timeline.at("/fast", 10)?.value.data), 0);
});

test("a broken schema disables its channel alone, and says why", async () => {
  const said = new Said();
  const schema = (topic: string) => (topic === "/broken" ? "float64 data\nno such thing !" : "float64 data");
  const lines = [...slowAndFast(5), { topic: "/broken", seconds: 11, value: 1 }];
  const bag = await openBag([bytesInMemory("a.mcap", await mcapOf(lines, { schema }))], said);
  assert.equal(said.lines.length, 1);
  assert.match(said.lines[0]!, /^warning: \/broken is not shown: std_msgs\/msg\/Float64: /);
  assert.equal(await settled(() => bag.timeline.at("/broken", 12)), undefined);
  assert.equal(await settled(() => bag.timeline.at("/fast", 12)?.value.data), 4);
});

test("a message that is not of its type is left out, and said once", async () => {
  const said = new Said();
  const lines = slowAndFast(5);
  const bag = await openBag([bytesInMemory("a.mcap", await mcapOf(lines, { schema: () => "float64[9] data" }))], said);
  for (const time of [10, 10.1, 10.2]) assert.equal(await settled(() => bag.timeline.at("/fast", time)), undefined);
  assert.equal(said.lines.length, 1);
  assert.match(said.lines[0]!, /\/fast: a message of it is no std_msgs\/msg\/Float64/);
});

test("files without a summary, cut ones among them, are read up to where they end", async () => {
  const whole = await mcapOf(slowAndFast(100));
  for (const [share, last] of [
    [1.0, 99],
    [0.5, undefined],
  ] as const) {
    const said = new Said();
    const cut = whole.slice(0, Math.floor((whole.length - 40) * share)); // 37 bytes are footer and magic
    const bag = await openBag([bytesInMemory("cut.mcap", cut)], said);
    assert.match(said.lines.join(), /cut.mcap: no summary/);
    assert.equal(await settled(() => bag.timeline.at("/fast", 10.1)?.value.data), 1);
    const end = await settled(() => bag.timeline.at("/fast", 99)?.value.data);
    if (last === undefined) assert.ok(end > 10 && end < 99, `${end}`);
    else assert.equal(end, last);
  }
});

test("messages outside of chunks are found", async () => {
  const bytes = await mcapOf(slowAndFast(100), { useChunks: false });
  const bag = await openBag([bytesInMemory("loose.mcap", bytes)], new Said());
  assert.equal(await settled(() => bag.timeline.at("/fast", 15.05)?.value.data), 50);
});

test("files of a split bag are one", async () => {
  const lines = slowAndFast(100);
  const parts = [lines.slice(60), lines.slice(0, 60)];
  const files = await Promise.all(parts.map(async (part, i) => bytesInMemory(`bag_${i}.mcap`, await mcapOf(part))));
  const bag = await openBag(files, new Said());
  assert.equal(await settled(() => bag.timeline.at("/fast", 10.5)?.value.data), 5);
  assert.equal(await settled(() => bag.timeline.at("/fast", 19.5)?.value.data), 95);
});

test("what is no bag is refused with the reason", async () => {
  const refused = (name: string, bytes: Uint8Array) => openBag([bytesInMemory(name, bytes)], new Said());
  await assert.rejects(refused("a.db3", new Uint8Array(100)), /bandwagon bag convert a.db3/);
  await assert.rejects(refused("a", new TextEncoder().encode("SQLite format 3\0")), /bandwagon bag convert/);
  await assert.rejects(refused("a.mcap", new Uint8Array(0)), /it is empty/);
  await assert.rejects(refused("a.mcap", new TextEncoder().encode("what is this")), /no MCAP file/);
  await assert.rejects(refused("a.mcap", (await mcapOf(slowAndFast(9))).slice(0, 40)), /holds no message that can be read/);
});

test("wrong bytes anywhere end in a reason, never in a hang or a message that was not written", async () => {
  const whole = await mcapOf(slowAndFast(100));
  let random = 20261122;
  const next = (bound: number) => (random = (random * 48271) % 2147483647) % bound;
  for (let round = 0; round < 300; ++round) {
    const bytes = whole.slice();
    for (let k = 0; k < 3; ++k) bytes[8 + next(bytes.length - 8)] = next(256);
    try {
      const bag = await openBag([bytesInMemory("mutated.mcap", bytes)], new Said());
      bag.timeline.at("/fast", 15);
      await new Promise((resolve) => setImmediate(resolve));
      const found = bag.timeline.at("/fast", 15);
      if (found) assert.equal(found.value.data, Math.round((found.time - 10) / 0.1));
    } catch (error) {
      assert.ok(!(error instanceof assert.AssertionError), (error as Error).message);
      assert.ok((error as Error).message.length > 0);
    }
  }
});

test("a chunk that claims more than 256 MiB is refused before memory is taken", () => {
  const content = new Uint8Array(64);
  new DataView(content.buffer).setBigUint64(16, 1n << 40n, true);
  assert.throws(() => openChunk(content), /claims 1099511627776 bytes/);
});

test("LZ4: matches that overlap, sizes and cuts", () => {
  // token 0x3f: 3 literals, a match of 4 + 15 + 6 = 25 bytes, 3 back; then 5 literals.
  const block = [0x3f, 97, 98, 99, 3, 0, 6, 0x20, 98, 99];
  const frame = Uint8Array.from([0x04, 0x22, 0x4d, 0x18, 0x60, 0x40, 0x82, block.length, 0, 0, 0, ...block, 0, 0, 0, 0]);
  assert.equal(new TextDecoder().decode(lz4(frame, 30)), "abc".repeat(9) + "abc".slice(0, 1) + "bc");
  assert.throws(() => lz4(frame, 29), /more bytes than the chunk says/);
  assert.throws(() => lz4(frame, 31), /30 bytes where the chunk says 31/);
  for (let cut = 0; cut < frame.length; ++cut) assert.throws(() => lz4(frame.slice(0, cut), 30), /LZ4/);
  frame[15] = 9;
  assert.throws(() => lz4(frame, 30), /before the beginning/);
  // The checksum of a block stands behind it.
  const summed = Uint8Array.from([0x04, 0x22, 0x4d, 0x18, 0x70, 0x40, 0, 2, 0, 0, 0x80, 65, 66, 1, 2, 3, 4, 0, 0, 0, 0]);
  assert.equal(new TextDecoder().decode(lz4(summed, 2)), "AB");
});

test("a recorded drive: zstd, odometry, tracks, frames", async () => {
  const file = path.join(process.env.BANDWAGON_PROJECT!, "tests/changes/hallway.mcap");
  const said = new Said();
  const bag = await openBag([bytesInMemory("hallway.mcap", readFileSync(file))], said);
  const { timeline } = bag;
  const middle = 0.5 * (timeline.begin + timeline.end);
  const odometry = await settled(() => timeline.at("/odom", middle));
  assert.equal(odometry?.type, "nav_msgs/msg/Odometry");
  const stamp = odometry!.value.header.stamp;
  assert.ok(Math.abs(stamp.sec + 1e-9 * stamp.nanosec - middle) < 0.1);
  assert.ok((await settled(() => timeline.at("/tracks", middle)))!.value.tracks.length > 0);
  const pose = await settled(() => timeline.transform("odom", "base_link", middle));
  assert.ok(Math.abs(pose!.x - odometry!.value.pose.pose.position.x) < 0.05);
  assert.equal(await settled(() => timeline.root(middle)), "odom"); // this bag has no localization
});

test("a served bag is read by ranges; what the server says is passed on", async () => {
  const bytes = await mcapOf(slowAndFast(9));
  const asked: string[] = [];
  const get = async (_url: string, init: { headers: Record<string, string> }) => {
    const range = init.headers.Range!;
    asked.push(range);
    const [from, to] = /bytes=(\d+)-(\d+)/.exec(range)!.slice(1).map(Number);
    return new Response(bytes.slice(from, to! + 1), {
      status: 206,
      headers: { "Content-Range": `bytes ${from}-${to}/${bytes.length}` },
    });
  };
  const file = await bytesOfServer("a.mcap", "/bags/a.mcap", get);
  assert.equal(file.size, bytes.length);
  const bag = await openBag([file], new Said());
  assert.equal(await settled(() => bag.timeline.at("/fast", 99)?.value.data), 8);
  assert.ok(asked.every((range) => range !== `bytes=0-${bytes.length - 1}`));
  const missing = async () => new Response("", { status: 404 });
  await assert.rejects(bytesOfServer("b.mcap", "/bags/b.mcap", missing), /no such bag in the folder/);
  const whole = async () => new Response(bytes, { status: 200 });
  await assert.rejects(bytesOfServer("b.mcap", "/bags/b.mcap", whole), /does not hand it out in parts/);
});
