// What the page and its server cost; no test. One robot drives through the hallway on this machine, in real time.
//
//   BANDWAGON_NODE_MODULES=build/node node tests/page/cost.mjs build/release/bin/bandwagon [SECONDS [MINUTES]]
//
// SECONDS (20) are what each share of a core is taken over, MINUTES (1) how long the page is looked at for its heap. Shares by the kernel's
// count of threads' time on a core: without viewer, with one, with one and its client. By in_test_environment.
import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { loadavg } from "node:os";
import { Browser } from "./browser.mjs";
import { require } from "./modules.mjs";
import { eventually, Program } from "./process.mjs";
import { hallway, program, Robot } from "./robot.mjs";

const WebSocket = require("ws");
const seconds = Number(process.argv[3] ?? 20);
const minutes = Number(process.argv[4] ?? 1);
const people = 20;
const later = (s) => new Promise((done) => setTimeout(done, s * 1000));
const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

/** Time on a core so far [s]: of the viewer's own threads, and of all. */
function used(pid) {
  const sum = { own: 0, all: 0 };
  for (const thread of readdirSync(`/proc/${pid}/task`)) {
    const of = (file) => readFileSync(`/proc/${pid}/task/${thread}/${file}`, "utf8").trim();
    const time = Number(of("schedstat").split(" ")[0]) * 1e-9;
    sum.all += time;
    if (of("comm") === "viewer") sum.own += time;
  }
  return sum;
}

/** Shares of a core while `seconds` pass [%]. */
async function share(pid) {
  const [before, start] = [used(pid), process.hrtime.bigint()];
  await later(seconds);
  const [after, passed] = [used(pid), Number(process.hrtime.bigint() - start) * 1e-9];
  return { own: ((after.own - before.own) / passed) * 100, all: ((after.all - before.all) / passed) * 100 };
}

/** The viewer's own threads, and by how much the whole process takes more than without it, which drives of planners blur. */
const shares = (with_, without) => `${with_.own.toFixed(2)}, ${(with_.all - without.all).toFixed(2)}`;

/** A client that subscribes to every channel and decodes nothing. */
function subscribeToEverything(port) {
  const socket = new WebSocket(`ws://127.0.0.1:${port}`, "foxglove.websocket.v1");
  socket.counted = { messages: 0, bytes: 0 };
  socket.on("message", (data, isBinary) => {
    if (isBinary) {
      socket.counted.messages += 1;
      socket.counted.bytes += data.length;
      return;
    }
    const message = JSON.parse(data);
    if (message.op !== "advertise") return;
    socket.send(JSON.stringify({ op: "subscribe", subscriptions: message.channels.map(({ id }) => ({ id, channelId: id })) }));
  });
  return socket;
}

/** As many people as there are to be, those of the hallway included; they stand beside the way. Where somebody is, nobody is let in: then the next place. */
function addPeople() {
  let count = 8;
  for (let x = 1.5; count < people && x < 19; x += 0.6) {
    const request = `{position: {x: ${x}, y: ${count % 2 ? -2.6 : 2.6}}}`;
    const answer = execFileSync(program, ["service", "call", "/add_person", "bandwagon_msgs/srv/AddPerson", request], { encoding: "utf8" });
    if (/success: true/.test(answer)) count += 1;
  }
}

function memory(pid) {
  return Number(readFileSync(`/proc/${pid}/status`, "utf8").match(/VmRSS:\s+(\d+)/)[1]) / 1024;
}

async function framesPerSecond(view) {
  const rates = [];
  for (let i = 0; i < 10; ++i) {
    const [frames, start] = [(await view.hook()).drawn.frames, performance.now()];
    await later(1);
    rates.push(((await view.hook()).drawn.frames - frames) / ((performance.now() - start) / 1000));
  }
  return median(rates);
}

/** Bytes of the page's heap after its garbage was collected, one sample in ten seconds; the line through them per minute. */
async function heapGrowth(view) {
  const session = await view.page.createCDPSession();
  const samples = [];
  for (let i = 0; i <= minutes * 6; ++i) {
    await session.send("HeapProfiler.collectGarbage");
    samples.push((await session.send("Runtime.getHeapUsage")).usedSize / 1e6);
    await later(10);
  }
  const mean = (values) => values.reduce((a, b) => a + b, 0) / values.length;
  // The timeline holds a minute: until then it fills.
  const full = samples.map((y, i) => [i / 6, y]).filter(([x]) => x >= Math.min(1.5, minutes / 2));
  const [mx, my] = [mean(full.map(([x]) => x)), mean(full.map(([, y]) => y))];
  const slope = full.reduce((sum, [x, y]) => sum + (x - mx) * (y - my), 0) / full.reduce((sum, [x]) => sum + (x - mx) ** 2, 0);
  return { first: samples[0], last: samples.at(-1), slope };
}

const options = ["--set", "robot.limits.v_max=0.3", "--set", "people.enabled=false", "--set", "ideal_people.enabled=true"];
const say = (what, value) => console.log(`${what.padEnd(44)} ${value}`);
say("load average before", loadavg().map((l) => l.toFixed(2)).join(" "));
const alone = new Program(program, "run", hallway, "--stay", "--seed", "7", ...options);
await later(5); // discovery settles
const without = await share(alone.pid);
await alone.end();
say("without viewer, whole process [% of a core]", without.all.toFixed(2));

const robot = await Robot.start({ options });
const { pid } = robot.process;
try {
  await later(5);
  const idle = await share(pid);
  say("no client: own threads, process more [%]", shares(idle, without));

  const client = subscribeToEverything(robot.port);
  await eventually("messages of every kind", () => client.counted.messages > 100);
  client.counted = { messages: 0, bytes: 0 };
  const busy = await share(pid);
  say("one client with everything on: the same [%]", shares(busy, without));
  say("  messages/s, kB/s", `${(client.counted.messages / seconds).toFixed(0)}, ${(client.counted.bytes / seconds / 1000).toFixed(0)}`);
  client.close();

  addPeople();
  const browser = await Browser.start();
  try {
    const view = await browser.open(robot.address);
    await view.eventually("robot and people drawn", (hook) => hook.drawn.robot && hook.drawn.people.length > 0);
    await view.page.setCacheEnabled(false);
    await view.page.reload();
    await view.page.waitForFunction(() => window.bandwagon?.drawn.frames > 0 && window.bandwagon.drawn.map > 0, { polling: "raf" });
    const drawn = await view.page.evaluate(() => performance.now());
    await view.page.waitForFunction(() => performance.getEntriesByName("first-contentful-paint").length > 0);
    const { bytes, painted } = await view.page.evaluate(() => ({
      bytes: [...performance.getEntriesByType("navigation"), ...performance.getEntriesByType("resource")].reduce((sum, e) => sum + e.encodedBodySize, 0),
      painted: performance.getEntriesByName("first-contentful-paint")[0].startTime,
    }));
    say("page, compressed [bytes]", bytes);
    say("first contentful paint [ms]", painted?.toFixed(0));
    say("map drawn [ms]", drawn?.toFixed(0));
    await view.eventually(`${people} people`, (hook) => hook.drawn.people.length >= people);
    say("people drawn", (await view.hook()).drawn.people.length);
    say("frames/s at 1280x720, median of 10 s", (await framesPerSecond(view)).toFixed(1));
    const before = memory(pid);
    const heap = await heapGrowth(view);
    say("heap of the page, first and last [MB]", `${heap.first.toFixed(1)}, ${heap.last.toFixed(1)}`);
    say("  after it has filled, growth [MB/minute]", heap.slope.toFixed(3));
    say("memory of the robot, before and after [MB]", `${before.toFixed(1)}, ${memory(pid).toFixed(1)}`);
  } finally {
    await browser.end();
  }
} finally {
  await robot.end();
}
say("load average after", loadavg().map((l) => l.toFixed(2)).join(" "));
