// node bag_test.mjs PROGRAM: recordings that are dropped onto the page.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import path from "node:path";
import test from "node:test";
import { Browser } from "./browser.mjs";
import { countAround } from "./pixels.mjs";
import { Program } from "./process.mjs";
import { hallway, program, Robot, scratch } from "./robot.mjs";
import { require } from "./modules.mjs";

/** Six seconds of the hallway, in virtual time. They do not reach the goal: exit status 1. */
async function record(file) {
  const drive = new Program(program, "run", hallway, "--clock", "lockstep", "--seed", "7", "--for", "6", "--record", file);
  assert.equal(await drive.ended, 1, drive.said);
}

/** A bag with a topic that can be read and one whose schema is none. */
async function writeBroken(file) {
  const { McapWriter } = require("@mcap/core");
  const parts = [];
  let size = 0n;
  const writable = {
    position: () => size,
    write: async (bytes) => {
      parts.push(Buffer.from(bytes));
      size += BigInt(bytes.length);
    },
  };
  const writer = new McapWriter({ writable });
  await writer.start({ profile: "ros2", library: "test" });
  const channel = async (topic, type, schema) =>
    writer.registerChannel({
      topic,
      messageEncoding: "cdr",
      metadata: new Map(),
      schemaId: await writer.registerSchema({ name: type, encoding: "ros2msg", data: Buffer.from(schema) }),
    });
  const good = await channel("/said", "std_msgs/msg/String", "string data\n");
  const broken = await channel("/broken", "broken/msg/Thing", "this is : no = schema ]\n");
  for (let i = 0; i < 10; ++i) {
    const at = { sequence: i, logTime: BigInt(1e9 + i * 1e8), publishTime: BigInt(1e9 + i * 1e8) };
    // CDR, little endian: a string of three letters and its end.
    const data = Buffer.from([0, 1, 0, 0, 4, 0, 0, 0, 0x61, 0x62, 0x63, 0]);
    for (const channelId of [good, broken]) await writer.addMessage({ ...at, channelId, data });
  }
  await writer.end();
  writeFileSync(file, Buffer.concat(parts));
}

test("bags are dropped onto the page", async (t) => {
  const folder = scratch(t);
  const recording = path.join(folder, "drive.mcap");
  await record(recording);
  const robot = await Robot.start();
  t.after(() => robot.end("SIGKILL"));
  const browser = await Browser.start();
  t.after(() => browser.end());
  const view = await browser.open(robot.address);

  await t.test("a recording is shown, and scrubbed", async () => {
    await view.drop(recording);
    const { timeline } = await view.eventually("the bag's six seconds", (hook) => hook.source === "bag" && hook.timeline.end - hook.timeline.begin > 5 && hook);
    const strip = await (await view.element("scrub")).boundingBox();
    const at = [];  // it starts at x = 1 m and drives along x
    // Before its third second the robot does not know where on the map it is.
    for (const share of [0.6, 0.9]) {
      await view.page.mouse.click(strip.x + strip.width * share, strip.y + strip.height / 2);
      const wanted = timeline.begin + (timeline.end - timeline.begin) * share;
      // The strip may have a margin for its scale.
      const hook = await view.eventually(`the robot further on, near ${wanted}`, (hook) => {
        const isThere = Math.abs(hook.cursor.time - wanted) < 1 && hook.drawn.robot?.x > (at.at(-1) ?? 0.5) + 0.5;
        return isThere && hook;
      });
      at.push(hook.drawn.robot.x);
      const image = await view.picture(`bag_${share * 10}`);
      const place = await view.toScreen(hook.drawn.robot.x, hook.drawn.robot.y);
      assert.ok(countAround(image, hook.colours.robot, place, 60) > 10, "no robot at its place");
    }
  });

  await t.test("of a broken schema the reason is told, and the rest is shown", async () => {
    const file = path.join(folder, "broken.mcap");
    await writeBroken(file);
    await view.drop(file);
    await view.eventually("the topic is named", (hook) => hook.statuses.some(({ text }) => text.includes("/broken")));
    await view.eventually("its second is there", (hook) => hook.source === "bag" && Math.abs(hook.timeline.end - hook.timeline.begin - 0.9) < 0.01);
    await view.picture("broken_schema");
  });

  await t.test("of a .db3 it says what to do", async () => {
    const file = path.join(folder, "drive.db3");
    writeFileSync(file, Buffer.concat([Buffer.from("SQLite format 3\0"), Buffer.alloc(4096)]));
    await view.drop(file);
    await view.eventually("bag convert is named", (hook) => hook.statuses.some(({ text }) => text.includes("bag convert")));
    await view.picture("db3");
  });

  assert.deepEqual(view.errors, []);
});
