// node drive_test.mjs PROGRAM: the page on a running robot, by mouse and keyboard alone.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import test from "node:test";
import { Browser } from "./browser.mjs";
import { count, countAround } from "./pixels.mjs";
import { eventually, run } from "./process.mjs";
import { program, quiet, Robot, scratch } from "./robot.mjs";

test("somebody opens the page of a robot", async (t) => {
  const card = path.join(scratch(t), "card.json");
  const robot = await Robot.start({ options: [...quiet, "--set", "robot.limits.v_max=0.5", "--json", card] });
  t.after(() => robot.end("SIGKILL"));
  const browser = await Browser.start();
  t.after(() => browser.end());
  const view = await browser.open(robot.address);

  await t.test("the map, the people and the robot are drawn", async () => {
    // Two people come up to 3 m and stand there.
    const { colours, drawn } = await view.eventually("map, people, laser and robot drawn", (hook) =>
      hook.drawn.map > 0 && hook.drawn.people.length >= 2 && hook.drawn.laser > 100 && hook.drawn.robot && hook,
    );
    const image = await view.picture("live");
    // Both walls are 20 m long, and one pixel wide at the least.
    assert.ok(count(image, colours.map) > 500, `${count(image, colours.map)} pixels of the map's colour`);
    for (const { x, y } of drawn.people) {
      assert.ok(countAround(image, colours.people, await view.toScreen(x, y), 40) > 10, `nobody of people's colour at ${x}, ${y}`);
    }
    assert.ok(countAround(image, colours.robot, await view.toScreen(drawn.robot.x, drawn.robot.y), 60) > 10, "no robot");
  });

  await t.test("a goal is dragged, a band is drawn, and the goal is reached", async () => {
    await view.click("goal");
    await view.drag([5, 0], [5.6, 0]);
    const { colours } = await view.eventually("a band drawn", (hook) => hook.drawn.band.length > 1 && hook);
    const image = await view.picture("goal");
    const pixels = colours.band.reduce((sum, colour) => sum + count(image, colour, undefined, 40), 0);
    assert.ok(pixels > 100, `${pixels} pixels of the band's colours`);
    await robot.reaches(1);
  });

  await t.test("a parameter is moved and the node has its value", async () => {
    const name = "teb.band.min_obstacle_dist";
    await view.page.click("#tab-parameters");
    await (await view.element("parameter-search")).type(name);
    const slider = await view.element(`slide:/local_planner.${name}`);
    const held = async () => Number((await run(program, "param", "get", "/local_planner", name)).match(/\S+\s*$/));
    const before = await held();
    assert.ok(before > 0, `${name} is ${before}`);
    await slider.focus();
    for (let i = 0; i < 5; ++i) await view.page.keyboard.press("ArrowRight");
    // Each key is a request of its own: the node follows one after the other.
    const shown = () => view.page.$eval(`[data-test="param:/local_planner.${name}"]`, (input) => Number(input.value));
    await eventually(`${name} above ${before}, the same on the page and in the node`, async () => {
      const now = await held();
      return now > before && now === (await shown());
    });
    await view.picture("parameter");
    assert.ok((await shown()) > before);
  });

  await t.test("a person is added, and avoided on the way to the next goal", async () => {
    await view.page.click("#tab-drive");
    // On the straight line from the robot to the goal: who kept to it would run into them.
    await view.click("person");
    await view.drag([7, 0], [7, 0]);
    await view.eventually("somebody at x = 7 m", (hook) => hook.drawn.people.some(({ x, y }) => Math.hypot(x - 7, y) < 0.4));
    await view.picture("person");
    await view.click("goal");
    await view.drag([9, 0], [9.6, 0]);
    await robot.reaches(2);
    await view.picture("avoided");
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
