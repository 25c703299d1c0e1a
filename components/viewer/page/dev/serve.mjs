// node dev/serve.mjs MODULES SITE BAG.mcap [--port 8765] [--rate 1] [--people 20]: a robot to work on the page with.
//
// Serves the folder SITE that build.mjs wrote, and plays the bag again and again over the Foxglove WebSocket protocol on the same port. Takes no
// commands. --people N adds people who walk in circles to /tracks, to see what many of them cost.
import { createServer } from "node:http";
import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { parseArgs } from "node:util";

const { values: options, positionals } = parseArgs({
  allowPositionals: true,
  options: { port: { type: "string", default: "8765" }, rate: { type: "string", default: "1" }, people: { type: "string", default: "0" } },
});
const [modules, site, bag] = positionals.map((name) => path.resolve(name));
if (bag === undefined) {
  console.error("usage: node dev/serve.mjs MODULES SITE BAG.mcap [--port N] [--rate R] [--people N]");
  process.exit(2);
}
const require = createRequire(path.join(modules, "of_this_folder.js"));
const { WebSocketServer } = require("ws");
const { McapIndexedReader } = require("@mcap/core");
const fzstd = require("fzstd");
const { parse } = require("@foxglove/rosmsg");
const { MessageReader, MessageWriter } = require("@foxglove/rosmsg2-serialization");

const TYPES = { ".html": "text/html; charset=utf-8", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml" };
const LATCHED = /(^|\/)(map|tf_static|costmap)$/;

const bytes = readFileSync(bag);
const reader = await McapIndexedReader.Initialize({
  readable: { size: async () => BigInt(bytes.length), read: async (at, size) => bytes.subarray(Number(at), Number(at + size)) },
  decompressHandlers: { zstd: (buffer, size) => fzstd.decompress(buffer, new Uint8Array(Number(size))) },
});
const messages = [];
for await (const { channelId, logTime, data } of reader.readMessages()) messages.push({ channelId, time: Number(logTime) / 1e9, data });
const firstOf = new Map(); // a recording has a channel for each writer, the protocol one for each topic
for (const { id, topic } of reader.channelsById.values()) if (!firstOf.has(topic)) firstOf.set(topic, id);
for (const message of messages) message.channelId = firstOf.get(reader.channelsById.get(message.channelId).topic);
const recorded = [...reader.channelsById.values()].filter(({ id, topic }) => firstOf.get(topic) === id);
const channels = recorded.map(({ id, topic, schemaId, messageEncoding }) => {
  const { name, data, encoding } = reader.schemasById.get(schemaId);
  const metadata = LATCHED.test(topic) ? { latched: "true" } : {};
  return { id, topic, encoding: messageEncoding, schemaName: name, schema: new TextDecoder().decode(data), schemaEncoding: encoding, metadata };
});
const channelOf = new Map(channels.map((channel) => [channel.id, channel]));
const begin = messages[0].time;
const length = messages.at(-1).time - begin;

/** The people of the bag, and others who walk in circles. */
function crowded(message) {
  const channel = channelOf.get(message.channelId);
  if (options.people === "0" || !channel.topic.endsWith("/tracks")) return message.data;
  channel.codec ??= (([definitions]) => [new MessageReader(definitions), new MessageWriter(definitions)])([parse(channel.schema, { ros2: true })]);
  const tracks = channel.codec[0].readMessage(message.data);
  for (let id = 1000; tracks.tracks.length < Number(options.people); ++id) {
    const at = (t) => ({ x: 2 + ((id * 7) % 17) + Math.cos(t + id), y: (((id * 5) % 9) - 4) / 2 + Math.sin(t + id), z: 0 });
    const velocity = { x: -Math.sin(message.time + id), y: Math.cos(message.time + id), z: 0 };
    const predictions = Array.from({ length: 15 }, (_, i) => {
      const seconds = (i + 1) / 5;
      const spread = 0.01 + 0.02 * seconds;
      const { x, y } = at(message.time + seconds);
      const time_from_start = { sec: Math.floor(seconds), nsec: (seconds % 1) * 1e9 };
      return { time_from_start, x, y, cov_xx: spread, cov_xy: 0, cov_yy: spread / 2 };
    });
    const covariance = new Float64Array(16).map((_, i) => (i % 5 === 0 ? 0.01 : 0));
    tracks.tracks.push({ id, position: at(message.time), velocity, covariance, radius: 0.3, predictions });
  }
  return channel.codec[1].writeMessage(tracks);
}

const http = createServer((request, response) => {
  const name = request.url === "/" ? "index.html" : path.basename(request.url.split("?")[0]);
  const file = path.join(site, `${name}.gz`);
  if (!existsSync(file)) return void response.writeHead(404).end();
  const headers = { "content-type": TYPES[path.extname(name)], "content-encoding": "gzip" };
  response.writeHead(200, { ...headers, "content-security-policy": "default-src 'self'; connect-src 'self'" });
  response.end(readFileSync(file));
});

function frame(opcode, subscription, seconds, data) {
  const head = Buffer.alloc(opcode === 1 ? 13 : 9);
  head[0] = opcode;
  if (opcode === 1) head.writeUInt32LE(subscription, 1);
  head.writeBigUInt64LE(BigInt(Math.round(seconds * 1e9)), opcode === 1 ? 5 : 1);
  return data ? Buffer.concat([head, data]) : head;
}

const clients = new Map();
const server = new WebSocketServer({ server: http, handleProtocols: (names) => [...names].find((name) => name.startsWith("foxglove.")) });
server.on("connection", (socket) => {
  const subscriptions = new Map(); // of channel
  clients.set(socket, subscriptions);
  const tell = (message) => socket.send(JSON.stringify(message));
  tell({ op: "serverInfo", name: path.basename(bag), capabilities: ["time"], metadata: { ROS_DISTRO: "jazzy" }, sessionId: String(process.pid) });
  tell({ op: "advertise", channels });
  socket.on("message", (text) => {
    const message = JSON.parse(text);
    for (const { id, channelId } of message.subscriptions ?? []) {
      subscriptions.set(channelId, id);
      if (channelOf.get(channelId)?.metadata.latched === undefined) continue;
      for (const one of messages) if (one.channelId === channelId) socket.send(frame(1, id, one.time, one.data));
    }
    for (const id of message.subscriptionIds ?? []) for (const [channel, its] of subscriptions) if (its === id) subscriptions.delete(channel);
  });
  socket.on("close", () => clients.delete(socket));
});

let next = 0;
let started = performance.now();
setInterval(() => {
  const played = ((performance.now() - started) / 1000) * Number(options.rate);
  for (; next < messages.length && messages[next].time - begin <= played; ++next) {
    const message = messages[next];
    if (![...clients.values()].some((subscriptions) => subscriptions.has(message.channelId))) continue;
    const data = crowded(message);
    for (const [socket, subscriptions] of clients)
      if (subscriptions.has(message.channelId)) socket.send(frame(1, subscriptions.get(message.channelId), message.time, data));
  }
  for (const socket of clients.keys()) socket.send(frame(2, 0, begin + Math.min(played, length)));
  if (played < length) return;
  next = 0;
  started = performance.now();
  for (const socket of clients.keys()) socket.send(frame(2, 0, begin));
}, 10);
http.listen(Number(options.port), "127.0.0.1", () => console.log(`http://127.0.0.1:${options.port}`));
