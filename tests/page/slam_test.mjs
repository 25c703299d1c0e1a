// node slam_test.mjs PROGRAM: a robot makes a map, and somebody watches it on the page and keeps it.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import path from "node:path";
import test from "node:test";
import { Browser } from "./browser.mjs";
import { countAround } from "./pixels.mjs";
import { eventually } from "./process.mjs";
import { mapDrive, Robot, scratch } from "./robot.mjs";

/** Two rooms of 6 m by 6 m and a door of 1.6 m between them at x = 4 m; the laser is used to 5 m. */
const walls = [
  [-2, -3, 10, -3],
  [10, -3, 10, 3],
  [10, 3, -2, 3],
  [-2, 3, -2, -3],
  [4, -3, 4, -0.8],
  [4, 0.8, 4, 3],
].map(([x1, y1, x2, y2]) => `{x1: ${x1}, y1: ${y1}, x2: ${x2}, y2: ${y2}}`);

test("somebody watches a map being made", async (t) => {
  const folder = scratch(t);
  const robot = await Robot.start({
    graph: mapDrive,
    options: [
      ...["--set", "ideal_localization.enabled=false", "--set", "map_server.enabled=false", "--set", "slam.enabled=true"],
      ...["--set", "explore.enabled=true"],
      ...["--set", `world.walls=[${walls.join(", ")}]`, "--set", "navigator.goal.enabled=false"],
      ...["--set", "global_planner.unknown_is_obstacle=false", "--set", `slam.folder=${folder}`, "--set", "slam.map_update_interval=1"],
      ...["--set", "slam.max_laser_range=5"],
    ],
  });
  t.after(() => robot.end("SIGKILL"));
  const browser = await Browser.start();
  t.after(() => browser.end());
  const view = await browser.open(robot.address);
  const isWall = async (name, ...places) => {
    const { colours } = await view.hook();
    const image = await view.picture(name);
    for (const [x, y] of places) {
      assert.ok(countAround(image, colours.map, await view.toScreen(x, y), 8) > 0, `no wall at ${x}, ${y}`);
    }
  };
  // They lie over the walls.
  for (const layer of ["laser", "costmap"]) await view.click(`layers:${layer}`);
  let first;

  await t.test("the map of the first room is drawn where its walls stand", async () => {
    first = (await view.eventually("a map", (hook) => hook.drawn.map > 0 && hook.drawn.bounds && hook)).drawn.bounds;
    assert.ok(first.x1 < 9, `the map ends at ${first.x1} m: the far wall is out of sight`);
    await isWall("slam_begin", [2, 3], [2, -3], [4, 2]);
  });

  await t.test("it grows, its origin moves, and the page follows", async () => {
    // Through the door first: a goal off the map is refused.
    await view.click("goal");
    await view.drag([5.5, 0], [6, 0]);
    await robot.reaches(1);
    await view.eventually("the goal within the map", (hook) => hook.drawn.bounds.x1 > 9);
    await view.click("goal");
    await view.drag([8, 0], [8.5, 0]);
    await robot.reaches(2);
    const { drawn } = await view.eventually("the far wall within the map", (hook) => hook.drawn.bounds.x1 > 10 && hook);
    assert.ok(drawn.bounds.x1 - drawn.bounds.x0 > first.x1 - first.x0 + 1);
    await view.page.click('button[title="Everything in sight"]');
    await isWall("slam_grown", [2, 3], [4, 2], [7, 3], [10, 1]);
  });

  await t.test("the pose graph is drawn, and its loops when the robot comes back", async () => {
    await view.eventually("some submaps", (hook) => hook.drawn.graph?.nodes >= 2);
    await view.click("goal");
    await view.drag([0.5, 0], [1, 0]);
    await robot.reaches(3);
    await view.eventually("a loop", (hook) => hook.drawn.graph?.nodes >= 5 && hook.drawn.graph.loops >= 1);
    await view.picture("slam_graph");
  });

  await t.test("the robot is told where it is", async () => {
    const { drawn } = await view.hook();
    const { x, y } = drawn.robot;
    await view.click("initial-pose");
    const heading = drawn.robot.theta ?? 0;
    await view.drag([x, y], [x + Math.cos(heading), y + Math.sin(heading)]);
    await robot.process.says(/the robot is at \(/);
  });

  await t.test("the map is saved, and a second time refused", async () => {
    const name = await view.element("map-name");
    await name.click({ count: 3 });
    await name.type("two_rooms");
    await view.click("save-map");
    const said = () => view.page.$eval('[data-test="hands-said"]', ({ textContent }) => textContent);
    await eventually("Map two_rooms: saved", async () => (await said()) === "Map two_rooms: saved");
    for (const end of ["yaml", "pgm"]) assert.ok(existsSync(path.join(folder, `two_rooms.${end}`)), end);
    await view.click("save-map");
    await eventually("why not", async () => /not saved/.test(await said()));
    await view.picture("slam_saved");
  });

  await t.test("it explores when it is told, and stops", async () => {
    await view.click("explore");
    await robot.process.says(/exploration_in_progress/);
    await view.click("stop-exploring");
    // It said so before it was told to begin, too.
    await eventually("paused again", async () => robot.process.said.match(/exploration_paused/g).length >= 2);
    await view.picture("slam_explore");
  });

  await t.test("the page had no errors", async () => {
    assert.equal(await robot.end(), 0, robot.process.said);
    assert.deepEqual(view.errors.filter((error) => !/WebSocket/.test(error)), []);
  });
});
