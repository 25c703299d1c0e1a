// node token_test.mjs PROGRAM: who may command a robot that listens on loopback alone. Everybody of this machine reads; commands need the token of
// the printed address: for pages of other ports, the server's own page, and programs without an Origin.
import assert from "node:assert/strict";
import { createServer } from "node:http";
import test from "node:test";
import { Browser } from "./browser.mjs";
import { require } from "./modules.mjs";
import { eventually } from "./process.mjs";
import { Robot } from "./robot.mjs";

const WebSocket = require("ws");

/** A goal by bare protocol, as any program or page could send it; what the server says to it. */
async function goalBy(address, options) {
  const socket = new WebSocket(address, "foxglove.websocket.v1", options);
  const heard = [];
  socket.on("message", (data, isBinary) => isBinary || heard.push(JSON.parse(data)));
  await new Promise((done, failed) => socket.on("open", done).on("error", failed));
  socket.send(JSON.stringify({ op: "advertise", channels: [{ id: 1, topic: "/goal_pose", encoding: "json", schemaName: "geometry_msgs/PoseStamped" }] }));
  const message = Buffer.from(JSON.stringify({ header: { frame_id: "map" }, pose: { position: { x: 4 }, orientation: { w: 1 } } }));
  socket.send(Buffer.concat([Buffer.from([1, 1, 0, 0, 0]), message]));
  const told = await eventually(() => JSON.stringify(heard), () => heard.find(({ op, level, id, message }) => op === "status" && (level === 2 || (id === "commander" && message.startsWith("You")))));
  await eventually(() => "channels are told to everybody", () => heard.some(({ op, channels }) => op === "advertise" && channels.length > 0));
  socket.close();
  return told.message;
}

test("on loopback everybody reads, and the token commands", async (t) => {
  const robot = await Robot.start();
  t.after(() => robot.end("SIGKILL"));
  const { port } = robot;
  const socket = `ws://127.0.0.1:${port}/`;
  const token = new URL(robot.address).searchParams.get("token");
  const own = { origin: `http://127.0.0.1:${port}` };
  for (const [who, options] of [["a program", {}], ["a page of another port", { origin: "http://localhost:3000" }], ["its own page", own]]) {
    assert.match(await goalBy(socket, options), /commands need the token of this run/, who);
    assert.match(await goalBy(`${socket}?token=${"0".repeat(32)}`, options), /not that of this run/, who);
  }
  assert.ok(!/goal 1/.test(robot.process.said), robot.process.said);

  const browser = await Browser.start();
  t.after(() => browser.end());
  await t.test("the page without it shows everything and commands nothing", async () => {
    const view = await browser.open(`http://127.0.0.1:${port}/`);
    await view.eventually("a robot is drawn", (hook) => hook.source === "live" && hook.drawn.robot);
    assert.equal((await view.hook()).canCommand, false);
    assert.equal(await (await view.element("read-only")).evaluate((line) => line.textContent), "read only: open the printed address");
    assert.equal(await (await view.element("goal")).evaluate((button) => button.matches(":disabled")), true);
    await view.picture("read_only");
    assert.deepEqual(view.errors, []);
  });

  await t.test("a page of another port reads and does not command", async () => {
    const elsewhere = createServer((_, response) => response.setHeader("content-type", "text/html").end("<!doctype html><title>elsewhere</title>"));
    await new Promise((done) => elsewhere.listen(0, "127.0.0.1", done));
    t.after(() => elsewhere.close());
    const page = await browser.browser.newPage();
    await page.goto(`http://127.0.0.1:${elsewhere.address().port}/`);
    const info = await page.evaluate((socket) => new Promise((done) => {
      new WebSocket(socket, "foxglove.websocket.v1").onmessage = ({ data }) => done(JSON.parse(data));
    }), socket);
    assert.equal(info.metadata.may_command, "false");
  });

  await t.test("the printed address commands, and leaves the address bar", async () => {
    const asked = [];
    const view = await browser.open(`http://127.0.0.1:${port}/`);
    view.page.on("request", (request) => asked.push(request.headers().referer ?? ""));
    await view.page.goto(robot.address);
    await view.eventually("it may command", (hook) => hook.source === "live" && hook.drawn.robot && hook.canCommand);
    assert.equal(view.page.url(), `http://127.0.0.1:${port}/`);
    await view.page.reload();
    await view.eventually("still after a reload", (hook) => hook.source === "live" && hook.canCommand);
    assert.ok(asked.length > 3 && asked.every((referer) => !referer.includes(token)), asked.join());
    await view.picture("commands");
  });
  assert.match(await goalBy(`${socket}?token=${token}`, {}), /You command the robot/);
  assert.match(await goalBy(socket, { headers: { Authorization: `Bearer ${token}` } }), /You command the robot/);
  assert.ok(robot.process.said.split(token).length === 2, "the token is printed once, in the address");
});
