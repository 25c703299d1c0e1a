// node read_bags.mjs MODULES BAG_LEAVES NAME=COMPRESSION=PATH...
//
// Reads recordings with @mcap/core, parses each schema with @foxglove/rosmsg, decodes each message with
// @foxglove/rosmsg2-serialization, and compares every value with what bag_leaves, our own decoder, says of the same file.
import { execFileSync } from "node:child_process";
import { createRequire } from "node:module";
import { closeSync, existsSync, mkdtempSync, openSync, readFileSync, readdirSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import assert from "node:assert/strict";
import { BagFile } from "./bag_file.mjs";
import { leavesOf } from "./leaves.mjs";

const [modulesFolder, leavesProgram, ...bags] = process.argv.slice(2);
const require = createRequire(path.join(path.resolve(modulesFolder), "of_this_folder.js"));
const modules = {
  mcap: require("@mcap/core"),
  zstd: require("fzstd"),
  lz4: require("lz4js"),
  crc: require("@foxglove/crc"),
};
const { parse } = require("@foxglove/rosmsg");
const { MessageReader } = require("@foxglove/rosmsg2-serialization");
const yaml = require("yaml");

/** What bag_leaves says: one text of lines for each message. */
function ourWords(file) {
  const folder = mkdtempSync(path.join(tmpdir(), "bandwagon_leaves_"));
  try {
    const output = openSync(path.join(folder, "leaves"), "w");
    execFileSync(leavesProgram, ["show", file], { stdio: ["ignore", output, "inherit"] });
    closeSync(output);
    const text = readFileSync(path.join(folder, "leaves"), "utf8");
    return text === "" ? [] : text.slice(2, -1).split("\n@ ");
  } finally {
    rmSync(folder, { recursive: true });
  }
}

function checkSummary(name, compression, { reader, messages, attachments, metadata }) {
  const said = reader.statistics;
  assert.equal(reader.header.profile, "ros2", name);
  assert.equal(Number(said.messageCount), messages.length, `${name}: messages`);
  assert.equal(said.chunkCount, reader.chunkIndexes.length, `${name}: chunks`);
  assert.equal(said.schemaCount, reader.schemasById.size, `${name}: schemas`);
  assert.equal(said.channelCount, reader.channelsById.size, `${name}: channels`);
  assert.equal(said.attachmentCount, attachments.length, `${name}: attachments`);
  assert.equal(said.metadataCount, metadata.length, `${name}: metadata`);
  const counts = new Map();
  for (const m of messages) counts.set(m.channelId, (counts.get(m.channelId) ?? 0n) + 1n);
  assert.deepEqual([...said.channelMessageCounts].sort(), [...counts].sort(), `${name}: messages by channel`);
  assert.equal(said.messageStartTime, messages.at(0).logTime, `${name}: start`);
  assert.equal(said.messageEndTime, messages.at(-1).logTime, `${name}: end`);
  const compressed = reader.chunkIndexes.filter((c) => c.compression === compression).length;
  assert.ok(compressed > reader.chunkIndexes.length / 2, `${name}: ${compressed} chunks of "${compression}"`);
}

/** The stream holds the same: each message once, and with every chunk the indexes that belong to it. */
function checkStream(name, file, indexed) {
  const records = file.readStream();
  const of = (type) => records.filter((r) => r.type === type);
  const inOrder = of("Message").sort((a, b) => (a.logTime < b.logTime ? -1 : a.logTime > b.logTime ? 1 : 0));
  assert.equal(inOrder.length, indexed.messages.length, `${name}: messages of the stream`);
  inOrder.forEach((m, i) => {
    const other = indexed.messages[i];
    assert.ok(
      m.channelId === other.channelId && m.publishTime === other.publishTime && Buffer.compare(m.data, other.data) === 0,
      `${name}: message ${i} of the stream is another one`,
    );
  });
  const entries = of("MessageIndex").reduce((sum, index) => sum + index.records.length, 0);
  assert.equal(entries, inOrder.length, `${name}: entries of message indexes`);
  assert.equal(of("Chunk").length, indexed.reader.chunkIndexes.length, `${name}: chunks of the stream`);
  assert.equal(of("Attachment").length, indexed.attachments.length, `${name}: attachments of the stream`);
}

/** Every value of every message; returns how many. */
function compareValues(name, { reader, messages }, ours) {
  const decoders = new Map();
  for (const [id, schema] of reader.schemasById) {
    assert.equal(schema.encoding, "ros2msg", `${name}: ${schema.name}`);
    const definitions = parse(new TextDecoder().decode(schema.data), { ros2: true });
    // Of constants alone, as rcl_interfaces/msg/ParameterType, their reader makes nothing.
    const root = definitions.find((definition) => definition.name === undefined);
    const hasFields = root.definitions.length === 0 || root.definitions.some((field) => !field.isConstant);
    decoders.set(id, { definitions, decoder: hasFields ? new MessageReader(definitions) : undefined });
  }
  assert.equal(messages.length, ours.length, `${name}: messages that we read`);
  let values = 0;
  messages.forEach((m, i) => {
    const channel = reader.channelsById.get(m.channelId);
    assert.equal(channel.messageEncoding, "cdr");
    const { definitions, decoder } = decoders.get(channel.schemaId);
    if (decoder === undefined) return;
    const theirs = [`${channel.topic} ${m.logTime} ${m.publishTime}`];
    theirs.push(...leavesOf(definitions, decoder.readMessage(m.data)));
    const own = ours[i].split("\n");
    const line = theirs.findIndex((text, k) => text !== own[k]);
    if (line >= 0 || theirs.length !== own.length) {
      const at = line >= 0 ? line : theirs.length;
      assert.fail(`${name}: message ${i} (${theirs[0]}): they read "${theirs[at]}", we "${own[at]}"`);
    }
    values += theirs.length - 1;
  });
  return values;
}

/** A bit that is wrong is refused by them: their checks are on. */
async function checkThatChecksAreOn(file, { reader }) {
  const inChunk = Number(reader.chunkIndexes[0].chunkStartOffset + reader.chunkIndexes[0].chunkLength) - 5;
  const inSummary = Number(reader.footer.summaryStart) + 20;
  for (const [place, where] of [[inChunk, "chunk"], [inSummary, "summary"]]) {
    const bytes = file.bytes.slice();
    bytes[place] ^= 1;
    const damaged = new BagFile(modules, where, bytes);
    await assert.rejects(damaged.readIndexed(), new RegExp(`Incorrect ${where} CRC`));
  }
}

/** The folder that rosbag2 opens: its metadata.yaml tells what its file holds, and so does the file's last record. */
function checkFolder(name, folder, { messages, metadata, reader }) {
  const inside = yaml.parse(metadata.filter((m) => m.name === "rosbag2").at(-1).metadata.get("serialized_metadata"));
  const top = yaml.parse(readFileSync(path.join(folder, "metadata.yaml"), "utf8")).rosbag2_bagfile_information;
  for (const said of [top, inside]) {
    assert.equal(said.version, 8, name);
    assert.equal(said.storage_identifier, "mcap", name);
    assert.equal(said.message_count, messages.length, name);
    assert.deepEqual(said.relative_file_paths, readdirSync(folder).filter((f) => f.endsWith(".mcap")), name);
    const counts = new Map();
    for (const [id, count] of reader.statistics.channelMessageCounts) {
      const topic = reader.channelsById.get(id).topic;
      counts.set(topic, (counts.get(topic) ?? 0) + Number(count));
    }
    for (const { topic_metadata: topic, message_count: count } of said.topics_with_message_count) {
      assert.equal(count, counts.get(topic.name) ?? 0, `${name}: ${topic.name}`);
      const profiles = yaml.parse(topic.offered_qos_profiles);
      assert.ok(profiles.length > 0 && Number.isInteger(profiles[0].reliability), `${name}: QoS of ${topic.name}`);
    }
  }
}

for (const bag of bags) {
  const [name, compression, place] = bag.split("=");
  const isFolder = statSync(place).isDirectory();
  const files = isFolder ? readdirSync(place).filter((f) => f.endsWith(".mcap")) : [""];
  assert.equal(files.length, 1, `${place}: one file was expected`);
  const file = new BagFile(modules, path.join(place, files[0]));
  const indexed = await file.readIndexed();
  checkSummary(name, compression, indexed);
  checkStream(name, file, indexed);
  const values = compareValues(name, indexed, ourWords(place));
  if (compression === "") await checkThatChecksAreOn(file, indexed);
  if (isFolder) checkFolder(name, place, indexed);
  console.log(
    `${name}: ${indexed.messages.length} messages of ${indexed.reader.schemasById.size} types, ${values} values equal; ` +
      `${indexed.reader.chunkIndexes.length} chunks, ${indexed.attachments.length} attachments, ${indexed.metadata.length} metadata records`,
  );
}
