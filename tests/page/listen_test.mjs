// node listen_test.mjs PROGRAM: a running robot that listens to other machines. Without its token nothing is read and nothing commanded: each way
// to show one, or none, and each op of both protocols; with it, reading; commands only with --allow-commands.
import assert from "node:assert/strict";
import { writeFileSync, mkdirSync } from "node:fs";
import net from "node:net";
import path from "node:path";
import test from "node:test";
import { require } from "./modules.mjs";
import { eventually, Program, run } from "./process.mjs";
import { hallway, program, quiet, scratch } from "./robot.mjs";

const WebSocket = require("ws");
const address = "10.77.0.1";
const token = "correct-horse-battery";
const subprotocols = ["foxglove.websocket.v1", "foxglove.sdk.v1"];
const parameter = "teb.band.min_obstacle_dist";
const held = async () => Number((await run(program, "param", "get", "/local_planner", parameter)).match(/\S+\s*$/));
const secret = "nobody else's recording";

async function start(t, ...more) {
  const folder = scratch(t);
  const tokenFile = path.join(folder, "token");
  writeFileSync(tokenFile, `${token}\n`, { mode: 0o600 });
  const bags = path.join(folder, "bags");
  mkdirSync(bags);
  writeFileSync(path.join(bags, "night.mcap"), secret);
  const robot = new Program(program, "run", hallway, "--page=0", "--stay", "--listen", address, "--token-file", tokenFile, "--bags", bags,
    ...["--set", "viewer.limits.login_attempts=1000"], ...more, ...quiet);
  t.after(() => robot.end());
  const [, port] = await robot.says(/http:\/\/10\.77\.0\.1:(\d+)/);
  return { robot, port: Number(port) };
}

/** One request by bare bytes; all that comes back until it is silent for a while or closed. */
function ask(port, head, body = "", host = `${address}:${port}`) {
  return new Promise((done, failed) => {
    const socket = net.connect(port, address);
    const parts = [];
    socket.setTimeout(1500, () => socket.destroy());
    socket.on("data", (part) => parts.push(part));
    socket.on("error", failed);
    socket.on("close", () => done(Buffer.concat(parts).toString("latin1")));
    socket.write(`${head.join("\r\n")}\r\nHost: ${host}\r\nContent-Length: ${Buffer.byteLength(body)}\r\n\r\n`);
    socket.write(body);
  });
}
const status = (answer) => Number(answer.match(/^HTTP\/1\.1 (\d+)/)?.[1]);

/** A masked frame of a client, and what each op of both protocols would do were it heard. */
function frame(opcode, payload) {
  const bytes = Buffer.from(payload);
  const header = bytes.length < 126 ? [bytes.length | 0x80] : [126 | 0x80, bytes.length >> 8, bytes.length & 0xff];
  return Buffer.concat([Buffer.from([0x80 | opcode, ...header, 0, 0, 0, 0]), bytes]); // masked with zeros
}
const texts = [
  { op: "subscribe", subscriptions: [{ id: 1, channelId: 1 }] },
  { op: "subscribe", channels: [{ id: 1, channelId: 1 }] },
  { op: "unsubscribe", subscriptionIds: [1] },
  { op: "advertise", channels: [{ id: 1, topic: "/goal_pose", encoding: "json", schemaName: "geometry_msgs/msg/PoseStamped" }] },
  { op: "unadvertise", channelIds: [1] },
  { op: "getParameters", parameterNames: [], id: "all" },
  { op: "setParameters", parameters: [{ name: `/local_planner.${parameter}`, value: 0.33 }], id: "set" },
  { op: "subscribeParameterUpdates", parameterNames: [`/local_planner.${parameter}`] },
  { op: "unsubscribeParameterUpdates", parameterNames: [`/local_planner.${parameter}`] },
  { op: "subscribeConnectionGraph" },
  { op: "unsubscribeConnectionGraph" },
  { op: "fetchAsset", uri: "package://robot.urdf", requestId: 1 },
];
const ops = [
  ...texts.map((text) => frame(1, JSON.stringify(text))),
  frame(2, [1, 1, 0, 0, 0, ...Buffer.from('{"pose": {"position": {"x": 5}}}')]), // a message of a client
  frame(2, [2, 1, 0, 0, 0, 1, 0, 0, 0, 4, 0, 0, 0, ...Buffer.from("json{}")]), // a call of a service
];

const upgrade = ["GET / HTTP/1.1", "Connection: Upgrade", "Upgrade: websocket", "Sec-WebSocket-Version: 13", "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==",
  `Sec-WebSocket-Protocol: ${subprotocols.join(", ")}`];
const paths = ["/", "/main.js", "/bags/", "/bags/night.mcap", "/login", "/logout", "/metrics", `/?token=${token}`, `/bags/night.mcap?token=${token}`];

test("without the token nothing is read and nothing commanded", async (t) => {
  const { robot, port } = await start(t, "--allow-commands");
  const basic = (text) => `Authorization: Basic ${Buffer.from(text).toString("base64")}`;
  const cookieOf = async () => {
    const answer = await ask(port, ["POST /login HTTP/1.1", `Origin: http://${address}:${port}`, "Connection: close"], `token=${token}`);
    assert.equal(status(answer), 303, answer);
    return answer.match(/Set-Cookie: ([^;]+)/i)[1];
  };
  const ended = await cookieOf();
  await ask(port, ["POST /logout HTTP/1.1", `Origin: http://${address}:${port}`, `Cookie: ${ended}`, "Connection: close"]);
  const ways = {
    "no token": [],
    "a wrong one": ["Authorization: Bearer correct-horse-batterx"],
    "a part of it": ["Authorization: Bearer correct-horse"],
    "an empty one": ["Authorization: Bearer "],
    "a wrong password": [basic("any:correct-horse-batterx")],
    "the token as a name": [basic(`${token}:`)],
    "the token as a cookie": [`Cookie: bandwagon_${port}=${token}`],
    "a session that has ended": [`Cookie: ${ended}`],
    "a session of another port": [`Cookie: bandwagon_1=${ended.split("=")[1]}`],
    "a foreign page with the token": [`Authorization: Bearer ${token}`, "Origin: https://elsewhere.example"],
  };
  for (const [way, headers] of Object.entries(ways)) {
    for (const place of paths) {
      for (const method of ["GET", "HEAD", "POST", "OPTIONS"]) {
        if (place === "/login" && method === "POST" && !headers.length) continue; // that is how a token is shown
        const answer = await ask(port, [`${method} ${place} HTTP/1.1`, ...headers, "Connection: close"]);
        assert.ok([400, 401, 403].includes(status(answer)), `${way}: ${method} ${place}: ${answer.slice(0, 300)}`);
        assert.ok(!answer.includes(secret) && !answer.includes("night"), `${way}: ${method} ${place}`);
      }
    }
    // The upgrade is refused; the ops come on the same connection all the same.
    const answer = await ask(port, [...upgrade, ...headers], Buffer.concat(ops).toString("latin1"));
    assert.ok([400, 401, 403].includes(status(answer)), `${way}: ${answer.slice(0, 300)}`);
    assert.ok(!answer.includes("serverInfo") && !answer.includes("advertise") && !answer.includes("local_planner"), `${way}: ${answer}`);
  }
  const rebound = await ask(port, ["GET /bags/night.mcap HTTP/1.1", `Authorization: Bearer ${token}`, "Connection: close"], "", "robot.elsewhere.example");
  assert.equal(status(rebound), 403, "the token, and the name of somebody else");
  assert.notEqual(await held(), 0.33);
  assert.ok(!/goal 1/.test(robot.said), robot.said);
  assert.ok(!robot.said.includes(token), "no token in what is logged");
});

async function connect(port, subprotocol) {
  const socket = new WebSocket(`ws://any:${token}@${address}:${port}`, subprotocol);
  const heard = [];
  socket.on("message", (data, isBinary) => heard.push(isBinary ? "binary" : JSON.parse(data)));
  socket.on("error", (error) => heard.push({ op: "error", message: String(error) }));
  await eventually(() => JSON.stringify(heard).slice(0, 500), () => heard.find(({ op }) => op === "serverInfo"));
  const tell = (what) => socket.send(JSON.stringify(what));
  return { socket, heard, tell };
}

test("with the token one reads, and commands where that is allowed", async (t) => {
  const { robot, port } = await start(t);
  const own = await ask(port, ["GET /bags/night.mcap HTTP/1.1", `Authorization: Bearer ${token}`, "Connection: close"]);
  assert.equal(status(own), 200);
  assert.ok(own.includes(secret));
  for (const subprotocol of subprotocols) {
    const { socket, heard, tell } = await connect(port, subprotocol);
    assert.equal(heard[0].metadata.may_command, "false");
    assert.ok(!heard[0].capabilities.includes("clientPublish"));
    const channels = () => heard.flatMap((told) => (told.op === "advertise" ? told.channels : []));
    const odom = await eventually(() => `/odom among ${channels().map(({ topic }) => topic)}`, () => channels().find(({ topic }) => topic === "/odom"));
    const wish = { id: 1, channelId: odom.id };
    tell(subprotocol.includes("sdk") ? { op: "subscribe", channels: [wish] } : { op: "subscribe", subscriptions: [wish] });
    await eventually("a message", () => heard.includes("binary"));
    for (const text of texts.slice(3)) tell(text);
    const refusal = () => heard.filter(({ op, level, message }) => op === "status" && level >= 1 && /command/.test(message)).length >= 2;
    await eventually(() => `two refusals in ${JSON.stringify(heard.filter(({ op }) => op === "status"))}`, refusal);
    socket.close();
  }
  assert.notEqual(await held(), 0.33);
  assert.ok(!/goal 1/.test(robot.said), robot.said);
});

test("who is allowed to commands, one at a time", async (t) => {
  const { port } = await start(t, "--allow-commands");
  const first = await connect(port, subprotocols[0]);
  const second = await connect(port, subprotocols[0]);
  const change = (value) => ({ op: "setParameters", parameters: [{ name: `/local_planner.${parameter}`, value }], id: `to ${value}` });
  const statuses = ({ heard }) => heard.filter(({ op }) => op === "status");
  // A node is found a moment after the server is.
  await eventually(() => JSON.stringify(statuses(first)), async () => {
    first.tell(change(0.33));
    return (await held()) === 0.33;
  });
  second.tell(change(0.34));
  await eventually(() => JSON.stringify(statuses(second)), () => statuses(second).some(({ level, message }) => level >= 1 && /command/.test(message)));
  assert.equal(await held(), 0.33);
  first.socket.close();
  second.socket.close();
});
