// node v1_client.mjs FOXGLOVE_ROBOT: every op and opcode that Foxglove's own client knows (@foxglove/ws-protocol), both ways.
import assert from "node:assert/strict";
import { require } from "../../page/modules.mjs";
import { Arrivals, Robot } from "./robot.mjs";

const { WebSocket } = require("ws");
const { FoxgloveClient } = require("@foxglove/ws-protocol");
const program = process.argv[2];
const text = (bytes) => Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength).toString();

/** A connected client. Everything that it emits arrives as [event, what]. */
async function connect(address) {
  const socket = new WebSocket(address, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]);
  const client = new FoxgloveClient({ ws: socket });
  const arrivals = new Arrivals();
  const plain = {
    message: (m) => [m.subscriptionId, m.timestamp, text(m.data)],
    time: (t) => t.timestamp,
    serviceCallResponse: (r) => [r.serviceId, r.callId, r.encoding, text(r.data)],
    fetchAssetResponse: (a) => [a.requestId, a.status, a.error ?? text(a.data)],
    error: (e) => e.message,
  };
  for (const event of ["serverInfo", "status", "removeStatus", "advertise", "unadvertise", "advertiseServices", "unadvertiseServices",
    "parameterValues", "connectionGraphUpdate", "serviceCallFailure", "message", "time", "serviceCallResponse", "fetchAssetResponse", "error"]) {
    client.on(event, (what) => arrivals.push([event, plain[event] ? plain[event](what) : what]));
  }
  const is = (event, what) => arrivals.next([event, what]);
  return { client, arrivals, is, socket };
}

const schema = (name) => ({ encoding: "cdr", schemaName: name, schemaEncoding: "ros2msg", schema: "string data\n" });
const channel = (id, topic, more = {}) => ({ id, topic, ...schema("std_msgs/msg/String"), ...more });
const service = (id, name) => ({ id, name, type: "test_msgs/srv/Echo", request: schema("test_msgs/srv/Echo_Request"), response: schema("test_msgs/srv/Echo_Response") });
const commander = { op: "status", level: 0, message: "You command the robot", id: "commander" };
const second = 1_000_000_000n;

async function beginning({ arrivals, is, socket }, may_command = "true") {
  const [event, info] = await arrivals.take();
  assert.equal(event, "serverInfo");
  assert.equal(info.name, "Bandwagon");
  assert.equal(info.sessionId, "session 1");
  assert.deepEqual(info.supportedEncodings, ["cdr", "json"]);
  assert.deepEqual(info.metadata, { ROS_DISTRO: "jazzy", may_command });
  assert.equal(info.capabilities.includes("clientPublish"), may_command === "true");
  for (const capability of ["parameters", "parametersSubscribe", "services", "connectionGraph", "time", "assets"])
    assert.ok(info.capabilities.includes(capability), capability);
  assert.equal(info.capabilities.includes("playbackControl"), false);
  assert.equal(socket.protocol, "foxglove.websocket.v1");
  await is("advertise", [channel(1, "/odom"), channel(2, "/map", { metadata: { latched: "true" } })]);
  await is("advertiseServices", [service(5, "/echo"), service(6, "/broken")]);
}

async function hearing(robot, { client, is }) {
  const odom = client.subscribe(1);
  await robot.hears({ subscribe: 1 });
  robot.do("time", { time: 99.5 });
  robot.do("message", { channel: 1, time: 100.25, text: "pose" });
  await is("time", 99_500_000_000n);
  await is("message", [odom, 100_250_000_000n, "pose"]);
  robot.do("time", { time: 3 }); // back
  await is("time", 3n * second);
  for (let i = 0; i < 2; ++i) {
    const map = client.subscribe(2);
    await robot.hears({ subscribe: 2 });
    await is("message", [map, second, "map"]); // latched: again for each subscription
    client.unsubscribe(map);
    await robot.hears({ unsubscribe: 2 });
  }
  client.subscribe(1);
  await is("status", { op: "status", level: 1, message: "subscribe: heard already, one subscription each: channels 1" });
  client.subscribe(77);
  await is("status", { op: "status", level: 2, message: "subscribe: there are no channels 77" });
  client.unsubscribe(odom);
  await robot.hears({ unsubscribe: 1 });

  robot.do("channel", { id: 3, topic: "/new" });
  await is("advertise", [channel(3, "/new")]);
  robot.do("no channel", { id: 3 });
  await is("unadvertise", [3]);
  robot.do("status", { level: 1, text: "a node came twice" });
  await is("status", { op: "status", level: 1, message: "a node came twice" });
}

async function publishing(robot, { client, is }) {
  const goal = client.advertise({ topic: "/goal_pose", encoding: "json", schemaName: "geometry_msgs/PoseStamped" });
  await robot.hears({ advertise: "/goal_pose", type: "geometry_msgs/msg/PoseStamped" });
  client.sendMessage(goal, Buffer.from('{"pose":{"position":{"x":1.5}}}'));
  await robot.hears({ publish: "/goal_pose", json: { pose: { position: { x: 1.5 } } } });
  await is("status", commander);
  const pose = client.advertise({ topic: "/initialpose", encoding: "cdr", schemaName: "geometry_msgs/msg/PoseWithCovarianceStamped" });
  await robot.hears({ advertise: "/initialpose", type: "geometry_msgs/msg/PoseWithCovarianceStamped" });
  client.sendMessage(pose, new Uint8Array([0, 1, 0, 0, 255]));
  await robot.hears({ publish: "/initialpose", bytes: [0, 1, 0, 0, 255] });
  client.sendMessage(goal, Buffer.from("{"));
  await is("status", { op: "status", level: 2, message: "publish to /goal_pose: no JSON", id: "publish /goal_pose" });
  client.advertise({ topic: "/x", encoding: "cdr", schemaName: "unknown_msgs/Type" });
  await is("status", { op: "status", level: 2, message: "advertise /x: unknown_msgs/msg/Type is not known" });
  client.unadvertise(goal);
  await robot.hears({ unadvertise: "/goal_pose" });
  client.unadvertise(pose);
  await robot.hears({ unadvertise: "/initialpose" });
}

async function calling(robot, { client, is }) {
  const call = (serviceId, callId, encoding, words) =>
    client.sendServiceCallRequest({ serviceId, callId, encoding, data: new DataView(new TextEncoder().encode(words).buffer) });
  call(5, 1, "cdr", "abc");
  await is("serviceCallResponse", [5, 1, "cdr", "abc"]);
  call(5, 2, "json", '{"data":"abc"}');
  await is("serviceCallResponse", [5, 2, "json", '{"data":"abc"}']);
  call(6, 3, "cdr", "");
  await is("serviceCallFailure", { op: "serviceCallFailure", serviceId: 6, callId: 3, message: "no reply" });
  call(99, 4, "cdr", "");
  await is("serviceCallFailure", { op: "serviceCallFailure", serviceId: 99, callId: 4, message: "there is no service 99" });
  robot.do("service", { id: 8, name: "/late" });
  await is("advertiseServices", [service(8, "/late")]);
  robot.do("no service", { id: 8 });
  await is("unadvertiseServices", [8]);
}

async function parameters({ client, is }) {
  const speed = (value) => ({ name: "/node.speed", value, type: "float64" });
  const bytes = { name: "/node.bytes", value: "ECAw", type: "byte_array" };
  client.getParameters([], "all");
  await is("parameterValues", { op: "parameterValues", id: "all", parameters: [bytes, { name: "/node.count", value: 3 }, { name: "/node.fixed", value: true }, speed(0.5)] });
  client.getParameters(["/node.speed", "/node.none"], "two");
  await is("status", { op: "status", level: 2, message: "/node.none: no such parameter" });
  await is("parameterValues", { op: "parameterValues", id: "two", parameters: [speed(0.5)] });
  client.subscribeParameterUpdates(["/node.speed"]);
  client.setParameters([{ name: "/node.speed", value: 1, type: "float64" }, { name: "/node.count", value: 4 }], "set");
  await is("parameterValues", { op: "parameterValues", id: "set", parameters: [speed(1), { name: "/node.count", value: 4 }] });
  await is("parameterValues", { op: "parameterValues", parameters: [speed(1)] }); // the update that was subscribed to
  client.unsubscribeParameterUpdates(["/node.speed"]);
  client.setParameters([{ name: "/node.fixed", value: false }, { name: "/node.count" }], "refused");
  await is("status", { op: "status", level: 2, message: "/node.fixed: may not change" });
  await is("parameterValues", { op: "parameterValues", id: "refused", parameters: [{ name: "/node.fixed", value: true }, { name: "/node.count" }] });
}

async function graph(robot, { client, is }) {
  client.subscribeConnectionGraph();
  const nothing = { op: "connectionGraphUpdate", publishedTopics: [], subscribedTopics: [], advertisedServices: [], removedTopics: [], removedServices: [] };
  await is("connectionGraphUpdate", nothing);
  robot.do("graph", { published: { "/a": ["/x"] }, subscribed: { "/a": ["/y"] }, services: { "/s": ["/x"] } });
  await is("connectionGraphUpdate", {
    ...nothing,
    publishedTopics: [{ name: "/a", publisherIds: ["/x"] }],
    subscribedTopics: [{ name: "/a", subscriberIds: ["/y"] }],
    advertisedServices: [{ name: "/s", providerIds: ["/x"] }],
  });
  robot.do("graph", { published: {}, subscribed: {}, services: {} });
  await is("connectionGraphUpdate", { ...nothing, removedTopics: ["/a"], removedServices: ["/s"] });
  client.unsubscribeConnectionGraph();
}

async function assets({ client, is }) {
  client.fetchAsset("package://robot/robot.urdf", 4294967295);
  await is("fetchAssetResponse", [4294967295, 0, "<r/>"]);
  client.fetchAsset("package://robot/none", 1);
  await is("fetchAssetResponse", [1, 1, "there is no package://robot/none"]);
}

const robot = await Robot.start(program);
const all = await connect(robot.address);
await beginning(all);
await hearing(robot, all);
await publishing(robot, all);
await assets(all);
await graph(robot, all);
await calling(robot, all);
await parameters(all);
all.client.close();
await robot.end();

const shared = await Robot.start(program, "one_commander");
const [first, other] = [await connect(shared.address), await connect(shared.address)];
await beginning(first);
await beginning(other);
first.client.setParameters([{ name: "/node.speed", value: 2, type: "float64" }]);
await first.is("status", commander);
const [, seen] = await other.arrivals.take();
assert.equal(seen.level, 1);
assert.match(seen.message, /^127\.0\.0\.1:\d+ commands the robot$/);
other.client.setParameters([{ name: "/node.speed", value: 3, type: "float64" }], "mine");
const [, refused] = await other.arrivals.take();
assert.match(refused.message, /^setParameters: 127\.0\.0\.1:\d+ commands the robot; it is another one's turn 10 s after/);
await other.is("parameterValues", { op: "parameterValues", id: "mine", parameters: [{ name: "/node.speed", value: 2, type: "float64" }] });
first.client.close();
await other.is("removeStatus", { op: "removeStatus", statusIds: ["commander"] });
await shared.end();

const short = await Robot.start(program, "short_turn");
const brief = await connect(short.address);
await beginning(brief);
brief.client.sendServiceCallRequest({ serviceId: 5, callId: 0, encoding: "cdr", data: new DataView(new ArrayBuffer(0)) });
await brief.is("status", commander);
await brief.is("serviceCallResponse", [5, 0, "cdr", ""]);
await brief.is("removeStatus", { op: "removeStatus", statusIds: ["commander"] }); // silent for 0.3 s
await short.end();

const closed = await Robot.start(program, "look_only");
const looker = await connect(closed.address);
await beginning(looker, "false");
await looker.is("status", { op: "status", level: 0, message: "Read only: nobody may command", id: "read_only" });
looker.client.sendServiceCallRequest({ serviceId: 5, callId: 1, encoding: "cdr", data: new DataView(new ArrayBuffer(0)) });
const why = "read only: nobody may command";
await looker.is("serviceCallFailure", { op: "serviceCallFailure", serviceId: 5, callId: 1, message: why });
looker.client.advertise({ topic: "/goal_pose", encoding: "json", schemaName: "geometry_msgs/PoseStamped" });
await looker.is("status", { op: "status", level: 2, message: `advertise /goal_pose: ${why}` });
looker.client.getParameters(["/node.fixed"], "read");
await looker.is("parameterValues", { op: "parameterValues", id: "read", parameters: [{ name: "/node.fixed", value: true }] });
await closed.end();
console.log("every op and opcode of @foxglove/ws-protocol, both ways");
process.exit(0);
