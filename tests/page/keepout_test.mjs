// node keepout_test.mjs PROGRAM: somebody draws a keep-out zone on the page, the robot goes round it, and it is there again at the next start.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import path from "node:path";
import test from "node:test";
import { Browser } from "./browser.mjs";
import { countAround } from "./pixels.mjs";
import { eventually } from "./process.mjs";
import { mapDrive, Robot, scratch } from "./robot.mjs";

/** A hall of 14 m by 6 m. */
const walls = [
  [-2, -3, 12, -3],
  [12, -3, 12, 3],
  [12, 3, -2, 3],
  [-2, 3, -2, -3],
].map(([x1, y1, x2, y2]) => `{x1: ${x1}, y1: ${y1}, x2: ${x2}, y2: ${y2}}`);

const options = (folder) => [
  ...["--set", `world.walls=[${walls.join(", ")}]`, "--set", `map_server.walls=[${walls.join(", ")}]`],
  ...["--set", "navigator.goal.enabled=false", "--set", `map_saver.folder=${folder}`],
  ...["--set", "keepout_filter_mask_server.enabled=true", "--set", "keepout_filter_mask_saver.enabled=true"],
  ...["--set", `keepout_filter_mask_saver.folder=${folder}`],
];

/** A drag through these places of the root frame. */
async function stroke(view, places) {
  const at = await Promise.all(places.map(([x, y]) => view.toScreen(x, y)));
  await view.page.mouse.move(at[0].x, at[0].y);
  await view.page.mouse.down();
  for (const { x, y } of at.slice(1)) await view.page.mouse.move(x, y);
  return { release: () => view.page.mouse.up() };
}

const said = (view) => view.page.$eval('[data-test="hands-said"]', ({ textContent }) => textContent);

/** Width and height of a PGM. */
function sizeOf(file) {
  const [, width, height] = /^P5\s+(\d+) (\d+)/.exec(readFileSync(file, "latin1"));
  return [Number(width), Number(height)];
}

test("somebody draws keep-out zones", async (t) => {
  const folder = scratch(t);
  const robot = await Robot.start({ graph: mapDrive, options: options(folder) });
  t.after(() => robot.end("SIGKILL"));
  const browser = await Browser.start();
  t.after(() => browser.end());
  const view = await browser.open(robot.address);
  await view.eventually("map and robot", (hook) => hook.drawn.map > 0 && hook.drawn.robot && hook.drawn.laser > 0);
  for (const layer of ["laser", "costmap"]) await view.click(`layers:${layer}`);

  await t.test("round a place, and it is drawn", async () => {
    await view.click("keepout");
    const line = await stroke(view, [[3, -2.9], [4, -2.9], [4, 1], [3, 1], [3, -2.8]]);
    await view.picture("keepout_stroke");
    await line.release();
    // 1 m by 3.9 m in cells of 0.05 m: 1560, and the cells that the line touches; to half a pixel of the screen.
    const { drawn } = await view.eventually("a zone", (hook) => hook.drawn.keepout > 0 && hook);
    assert.ok(drawn.keepout > 1450 && drawn.keepout < 1850, `${drawn.keepout} cells`);
    await view.picture("keepout_drawn");
  });

  await t.test("a part of it is let in again", async () => {
    const before = (await view.hook()).drawn.keepout;
    await view.click("let-in");
    await (await stroke(view, [[2.8, -2.95], [4.2, -2.95], [4.2, -1.5], [2.8, -1.5], [2.8, -2.9]])).release();
    // 1.4 m of 3.9 m less.
    await view.eventually("a smaller zone", (hook) => hook.drawn.keepout < 0.72 * before && hook.drawn.keepout > 0.55 * before);
    await view.click("keepout");
    await (await stroke(view, [[2.9, -2.9], [4.1, -2.9], [4.1, -1], [2.9, -1], [2.9, -2.8]])).release();
    await view.eventually("the whole zone", (hook) => hook.drawn.keepout > before);
    await view.page.keyboard.press("Escape");
  });

  await t.test("the robot goes round it", async () => {
    await view.click("goal");
    await view.drag([7, -1], [7.5, -1]);
    await view.eventually("the robot past the zone", ({ drawn: { robot: { x, y } } }) => {
      // From its middle 0.3 m to its rim.
      assert.ok(!(x > 2.7 && x < 4.3 && y < 1.2), `at ${x}, ${y}`);
      return x > 4.3;
    });
    await robot.reaches(1);
    await view.picture("keepout_passed");
  });

  await t.test("a goal within is refused with that reason", async () => {
    await view.click("goal");
    await view.drag([3.5, 0], [3.9, 0]);
    await eventually("a reason", async () => /keep-out zone/.test(await view.page.$eval('[data-test="navigation-status"]', (e) => e.textContent)));
  });

  await t.test("a part of the map is saved upright, and the zones beside it", async () => {
    const angle = await view.element("crop").then(async (button) => (await button.click(), view.element("crop-angle")));
    await angle.click({ count: 3 });
    await angle.type("90");
    await view.drag([2, -2.5], [8, 2.5]);
    await view.picture("keepout_crop");
    const name = await view.element("map-name");
    await name.click({ count: 3 });
    await name.type("hall");
    await view.click("save-map");
    await eventually("Map hall: saved", async () => (await said(view)) === "Map hall: saved");
    // 5 m along y by 6 m: 100 by 120 cells, to a pixel of the screen and a cell.
    for (const file of ["hall.pgm", "hall_keepout.pgm"]) {
      const [width, height] = sizeOf(path.join(folder, file));
      assert.ok(Math.abs(width - 100) <= 2 && Math.abs(height - 120) <= 2, `${file}: ${width} x ${height}`);
    }
    await view.click("crop");
  });

  await t.test("zones are saved again and again", async () => {
    for (let i = 0; i < 2; ++i) {
      await view.click("save-zones");
      await eventually("saved", async () => (await said(view)) === "Zones of hall: saved");
    }
    const [width] = sizeOf(path.join(folder, "hall_keepout.pgm"));
    assert.ok(width < 100, `${width} cells: the mask as it was drawn`);
    assert.ok(existsSync(path.join(folder, "hall_keepout.yaml")));
  });

  const kept = (await view.hook()).drawn.keepout;
  await t.test("the page had no errors", async () => {
    assert.equal(await robot.end(), 0, robot.process.said);
    assert.deepEqual(view.errors.filter((error) => !/WebSocket/.test(error)), []);
  });

  await t.test("they are there at the next start", async () => {
    const again = await Robot.start({
      graph: mapDrive,
      options: [...options(folder), "--set", `keepout_filter_mask_server.map=${path.join(folder, "hall_keepout.yaml")}`],
    });
    t.after(() => again.end("SIGKILL"));
    const page = await browser.open(again.address);
    const { colours, drawn } = await page.eventually("the zones", (hook) => hook.drawn.keepout > 0 && hook.drawn.robot && hook);
    assert.equal(drawn.keepout, kept);
    for (const layer of ["laser", "costmap"]) await page.click(`layers:${layer}`);
    const image = await page.picture("keepout_again");
    assert.ok(countAround(image, colours.map, await page.toScreen(5, 3), 8) > 0, "no wall");
    assert.equal(await again.end(), 0);
  });
});
