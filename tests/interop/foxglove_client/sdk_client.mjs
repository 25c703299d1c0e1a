// node sdk_client.mjs FOXGLOVE_ROBOT: foxglove.sdk.v1 by its documented texts and bytes, written and read by hand.
import assert from "node:assert/strict";
import { require } from "../../page/modules.mjs";
import { Arrivals, Robot } from "./robot.mjs";

const { WebSocket } = require("ws");
const robot = await Robot.start(process.argv[2]);

/** Texts arrive as objects, binary messages as hexadecimal digits. */
async function connect(offered) {
  const socket = new WebSocket(robot.address, offered);
  const arrivals = new Arrivals();
  socket.on("message", (data, isBinary) => arrivals.push(isBinary ? data.toString("hex") : JSON.parse(data.toString())));
  await new Promise((opened, failed) => socket.on("open", opened).on("error", failed));
  return {
    socket,
    arrivals,
    is: (expected) => arrivals.next(expected),
    say: (op, fields = {}) => socket.send(JSON.stringify({ op, ...fields })),
    send: (hex) => socket.send(Buffer.from(hex.replaceAll(" ", ""), "hex")),
    hex: (digits) => arrivals.next(digits.replaceAll(" ", "")),
  };
}
const hex = (text) => Buffer.from(text).toString("hex");

// The name is echoed; where both are offered, the SDK's is spoken; where none of them is, nothing.
for (const [offered, chosen] of [
  [["foxglove.sdk.v1"], "foxglove.sdk.v1"],
  [["foxglove.websocket.v1"], "foxglove.websocket.v1"],
  [["foxglove.websocket.v1", "foxglove.sdk.v1"], "foxglove.sdk.v1"],
]) {
  const { socket } = await connect(offered);
  assert.equal(socket.protocol, chosen);
  socket.close();
}
await assert.rejects(connect(["foxglove.websocket.v2"]), /400/);
await assert.rejects(connect([]), /400/);

const { arrivals, say, send, is, hex: bytes } = await connect(["foxglove.sdk.v1"]);
assert.equal((await arrivals.take()).op, "serverInfo");
const { op, channels } = await arrivals.take();
assert.equal(op, "advertise");
assert.ok(channels.every((c) => c.encoding === "cdr" && c.schemaEncoding === "ros2msg" && c.schema !== "")); // the SDK's clients need a schema
assert.equal((await arrivals.take()).op, "advertiseServices");

say("subscribe", { subscriptions: [{ id: 0x01020304, channelId: 1 }, { id: 7, channelId: 2 }] });
await bytes(`01 07000000 00ca9a3b00000000 ${hex("map")}`); // at 1 s
robot.do("time", { time: 4 });
robot.do("message", { channel: 1, time: 4.294967296, text: "ab" });
await bytes("02 00286bee00000000"); // 4,000,000,000 ns
await bytes(`01 04030201 0000000001000000 ${hex("ab")}`); // 2^32 ns
say("unsubscribe", { subscriptionIds: [0x01020304] });
for (const heard of [{ subscribe: 1 }, { subscribe: 2 }, { unsubscribe: 1 }]) await robot.hears(heard);

say("advertise", { channels: [{ id: 9, topic: "/cmd_vel_teleop", encoding: "cdr", schemaName: "geometry_msgs/Twist" }] });
await robot.hears({ advertise: "/cmd_vel_teleop", type: "geometry_msgs/msg/Twist" });
send("01 09000000 00010000 ff");
await robot.hears({ publish: "/cmd_vel_teleop", bytes: [0, 1, 0, 0, 255] });
await is({ op: "status", level: 0, message: "You command the robot", id: "commander" });
say("unadvertise", { channelIds: [9] });
await robot.hears({ unadvertise: "/cmd_vel_teleop" });

send(`02 05000000 0a000000 03000000 ${hex("cdr")} 0102`);
await bytes(`03 05000000 0a000000 03000000 ${hex("cdr")} 0102`);
send(`02 06000000 0b000000 04000000 ${hex("json")} 7b7d`);
await is({ op: "serviceCallFailure", serviceId: 6, callId: 11, message: "no reply" });

say("getParameters", { parameterNames: ["/node.speed"], id: "p" });
await is({ op: "parameterValues", parameters: [{ name: "/node.speed", value: 0.5, type: "float64" }], id: "p" });
say("subscribeParameterUpdates", { parameterNames: [] });
say("setParameters", { parameters: [{ name: "/node.speed", value: 2, type: "float64" }] });
await is({ op: "parameterValues", parameters: [{ name: "/node.speed", value: 2, type: "float64" }] }); // as an update: no answer was asked for
say("unsubscribeParameterUpdates", { parameterNames: [] });

say("subscribeConnectionGraph");
await is({ op: "connectionGraphUpdate", publishedTopics: [], subscribedTopics: [], advertisedServices: [], removedTopics: [], removedServices: [] });
say("unsubscribeConnectionGraph");

say("fetchAsset", { uri: "package://robot/robot.urdf", requestId: 1 });
await bytes(`04 01000000 00 00000000 ${hex("<r/>")}`);
say("fetchAsset", { uri: "a", requestId: 2 });
await bytes(`04 02000000 01 0d000000 ${hex("there is no a")}`);

// Playback control is not offered; a request is refused, not taken for an unknown opcode.
send(`03 00 0000803f 00 0000000000000000 02000000 ${hex("ab")}`);
await is({ op: "status", level: 2, message: "Playback control is not offered: this is a robot, not a recording" });

// What is no message of the protocol is told and harms nothing.
for (const [sent, said] of [
  ["ff", "binary opcode 255: no such opcode"],
  ["02 05000000 0a000000 ffffffff 01", "binary opcode 2: 14 bytes end within its fields"],
  ["01 0900", "binary opcode 1: 3 bytes end within its fields"],
]) {
  send(sent);
  await is({ op: "status", level: 2, message: `Not understood: ${said}` });
}
say("subscribe", { subscriptions: [{ id: "one", channelId: 1 }] });
await is({ op: "status", level: 2, message: 'Not understood: subscribe: subscriptions[0].id = "one": must be a whole number from 0 to 4294967295' });
say("getParameters", { parameterNames: ["/node.fixed"], id: "still here" });
await is({ op: "parameterValues", parameters: [{ name: "/node.fixed", value: true }], id: "still here" });
await robot.end();
console.log("foxglove.sdk.v1 by its bytes");
process.exit(0);
