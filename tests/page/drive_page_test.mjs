// node drive_page_test.mjs PROGRAM: the page of a finished drive (`run --html`), opened as a file.
import assert from "node:assert/strict";
import path from "node:path";
import test from "node:test";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";
import { count, countAround } from "./pixels.mjs";
import { Program } from "./process.mjs";
import { hallway, program, scratch } from "./robot.mjs";

test("the page of a drive plays it without a server", async (t) => {
  const file = path.join(scratch(t), "drive.html");
  // Ten seconds of the hallway, in virtual time. They do not reach the goal: exit status 1.
  const drive = new Program(program, "run", hallway, "--clock", "lockstep", "--seed", "7", "--for", "10", "--html", file);
  assert.equal(await drive.ended, 1, drive.said);
  const browser = await Browser.start();
  t.after(() => browser.end());
  const view = await browser.open(pathToFileURL(file).href);
  const asked = [];
  view.page.on("request", (request) => asked.push(request.url()));
  const { timeline } = await view.eventually("ten seconds", (hook) => hook.source === "bag" && hook.timeline.end - hook.timeline.begin > 9 && hook);

  await t.test("it plays by itself, and draws", async () => {
    await view.eventually("time goes on", (hook) => hook.cursor.isPlaying && hook.cursor.time > timeline.begin + 0.5);
    await view.eventually("map, laser, people and robot", ({ drawn }) => drawn.map > 0 && drawn.laser > 0 && drawn.people.length > 0 && drawn.robot);
  });

  await t.test("the line of the strip is dragged, and the drive is there", async () => {
    await view.click("play");
    await view.eventually("it waits", (hook) => !hook.cursor.isPlaying);
    const strip = await (await view.element("scrub")).boundingBox();
    const y = strip.y + strip.height / 2;
    await view.page.mouse.move(strip.x + 0.3 * strip.width, y);
    await view.page.mouse.down();
    for (const share of [0.5, 0.7, 0.9]) await view.page.mouse.move(strip.x + share * strip.width, y);
    await view.page.mouse.up();
    const wanted = timeline.begin + 0.9 * (timeline.end - timeline.begin);
    const hook = await view.eventually(`the cursor near ${wanted}`, (seen) => Math.abs(seen.cursor.time - wanted) < 0.6 && seen.drawn.band.length > 0 && seen);
    const image = await view.picture("drive_page");
    const { x, y: across } = hook.drawn.robot;
    assert.ok(countAround(image, hook.colours.robot, await view.toScreen(x, across), 60) > 10, "no robot at its place");
    // The curve of the driven speed, in the dark and in the light colours of style.
    const curves = ["#56b4e9", "#0072b2"].map((colour) => count(image, colour, strip, 30));
    assert.ok(Math.max(...curves) > 100, `the curve of the speed has ${curves} pixels`);
  });

  await t.test("keys: arrows step, space plays", async () => {
    const before = (await view.hook()).cursor.time;
    await view.page.keyboard.press("ArrowLeft");
    await view.eventually("0.1 s back", (hook) => Math.abs(hook.cursor.time - (before - 0.1)) < 1e-3);
    await view.page.keyboard.down("Shift");
    await view.page.keyboard.press("ArrowLeft");
    await view.page.keyboard.up("Shift");
    await view.eventually("1 s more", (hook) => Math.abs(hook.cursor.time - (before - 1.1)) < 1e-3);
    await view.page.keyboard.press("Home");
    await view.eventually("the beginning", (hook) => hook.cursor.time === timeline.begin);
    await view.page.keyboard.press("Space");
    await view.eventually("it plays", (hook) => hook.cursor.isPlaying && hook.cursor.time > timeline.begin + 0.3);
  });

  assert.deepEqual(asked, [], "it asked for something else");
  assert.deepEqual(view.errors, []);
});
