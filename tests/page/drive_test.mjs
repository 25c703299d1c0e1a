// node drive_test.mjs PROGRAM: the page on a running robot, by mouse and keyboard alone.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import test from "node:test";
import { Browser } from "./browser.mjs";
import { count, countAround } from "./pixels.mjs";
import { eventually, run } from "./process.mjs";
import { program, Robot, scratch } from "./robot.mjs";

test("somebody opens the page of a robot", async (t) => {
  const card = path.join(scratch(t), "card.json");
  const robot = await Robot.start({ options: ["--set", "navigator.goal.enabled=false", "--json", card] });
  t.after(() => robot.end("SIGKILL"));
  const browser = await Browser.start();
  t.after(() => browser.end());
  const view = await browser.open(robot.address);

  await t.test("the map, the people and the robot are drawn", async () => {
    // The hallway has eight people; those whom the laser sees at its beginning are tracked.
    const { colours, drawn } = await view.eventually("map, people, laser and robot drawn", (hook) =>
      hook.drawn.map > 0 && hook.drawn.people.length >= 2 && hook.drawn.laser > 100 && hook.drawn.robot && hook,
    );
    const image = await view.picture("live");
    // Both walls are 20 m long, and one pixel wide at the least.
    assert.ok(count(image, colours.map) > 500, `${count(image, colours.map)} pixels of the map's colour`);
    let seen = 0;
    for (const { x, y } of drawn.people) seen += countAround(image, colours.people, await view.toScreen(x, y), 60) > 10 ? 1 : 0;
    // Between the hook and the picture they walk on, and one may leave the view.
    assert.ok(seen >= drawn.people.length / 2, `people's colour at ${seen} of ${drawn.people.length} people`);
    assert.ok(countAround(image, colours.robot, await view.toScreen(drawn.robot.x, drawn.robot.y), 60) > 10, "no robot");
  });

  await t.test("a goal is dragged, bands are drawn, and it is reached", async () => {
    await view.click("goal");
    await view.drag([4, 0], [4.6, 0]);
    const { colours } = await view.eventually("bands drawn", (hook) => hook.drawn.bands > 0 && hook);
    const image = await view.picture("goal");
    const pixels = colours.band.reduce((sum, colour) => sum + count(image, colour, undefined, 40), 0);
    assert.ok(pixels > 100, `${pixels} pixels of the bands' colours`);
    await robot.reaches(1);
  });

  await t.test("a parameter is moved and the node has its value", async () => {
    const name = "teb.band.min_obstacle_dist";
    await view.page.click("#tab-parameters");
    const slider = await view.element(`slide:/local_planner.${name}`);
    const before = Number(await run(program, "param", "get", "/local_planner", name));
    await slider.focus();
    for (let i = 0; i < 5; ++i) await view.page.keyboard.press("ArrowRight");
    const moved = await eventually(`${name} other than ${before}`, async () => {
      const now = Number(await run(program, "param", "get", "/local_planner", name));
      return now > before && now;
    });
    const shown = await view.page.$eval(`[data-test="param:/local_planner.${name}"]`, (input) => Number(input.value));
    await view.picture("parameter");
    assert.equal(shown, moved);
  });

  await t.test("a person is added, and avoided on the way to the next goal", async () => {
    await view.page.click("#tab-drive");
    const before = (await view.hook()).drawn.people.length;
    await view.click("person");
    await view.drag([6, 0], [6, 0]);
    await view.eventually("one person more", (hook) => hook.drawn.people.some(({ x, y }) => Math.hypot(x - 6, y) < 0.4));
    await view.picture("person");
    await view.click("goal");
    await view.drag([8, 0], [8.6, 0]);
    await robot.reaches(2);
    assert.ok(before >= 0);
  });

  await t.test("nobody was touched, and the page had no errors", async () => {
    assert.equal(await robot.end(), 0, robot.process.said);
    const { collisions, min_distance_m: nearest } = JSON.parse(readFileSync(card, "utf8"));
    assert.equal(collisions, 0);
    assert.ok(nearest > 0, `${nearest} m`);
    // That the robot went is told as an error of the socket.
    assert.deepEqual(view.errors.filter((error) => !/WebSocket/.test(error)), []);
  });
});
