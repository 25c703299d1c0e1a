// node stop_test.mjs PROGRAM: the page's emergency stop on a running robot, by mouse alone.
import assert from "node:assert/strict";
import test from "node:test";
import { Browser, size } from "./browser.mjs";
import { eventually, Program, run } from "./process.mjs";
import { program, quiet, Robot } from "./robot.mjs";

test("somebody stops the robot, and lets it go on", async (t) => {
  const robot = await Robot.start({ options: [...quiet, "--set", "robot.limits.v_max=0.3"] });
  t.after(() => robot.end("SIGKILL"));
  const browser = await Browser.start();
  t.after(() => browser.end());
  const view = await browser.open(robot.address);
  /** What release_stop answers, whatever it is. */
  const release = async () => {
    const call = new Program(program, "service", "call", "/release_stop");
    await call.ended;
    return call.said;
  };
  const why = () => view.page.$eval('[data-test="stop-why"]', (text) => text.textContent);
  const speed = async () => Number((await run(program, "topic", "echo", "/odom", "--once")).match(/linear:\s+x: (\S+)/)[1]);
  /** Whole in the scene, and nothing lies over their middles. */
  const seen = async (...names) => {
    const scene = await (await view.page.$("#scene")).boundingBox();
    for (const name of names) {
      const box = await (await view.element(name)).boundingBox();
      const isInside =
        box.x >= scene.x && box.y >= scene.y && box.x + box.width <= scene.x + scene.width && box.y + box.height <= scene.y + scene.height;
      assert.ok(isInside, `${name} at ${JSON.stringify(box)} of the scene at ${JSON.stringify(scene)}`);
      const top = await view.page.evaluate((x, y) => document.elementFromPoint(x, y).dataset.test, box.x + box.width / 2, box.y + box.height / 2);
      assert.equal(top, name);
    }
  };
  const says = (text) => eventually(async () => `"${text}"; the page says "${await why()}"`, async () => (await why()).includes(text));

  await t.test("the button is large, and stays wherever one looks", async () => {
    const box = await (await view.element("stop")).boundingBox();
    assert.ok(box.width >= 100 && box.height >= 100, `${box.width} x ${box.height}`);
    assert.ok(box.x >= 0 && box.x + box.width <= size.width && box.y + box.height <= size.height);
    for (const tab of ["#tab-parameters", "#tab-health", "#tab-drive", "#side-toggle", "#side-toggle"]) {
      await view.page.click(tab);
      await view.element("stop");
    }
    await view.picture("stop_ready");
  });

  await t.test("the project's pages are there, and leave it free", async () => {
    await view.page.click("#help-toggle");
    const choose = async (topic) => (await view.page.waitForSelector(topic)).click();
    await choose('#help nav [data-topic="ekf"]');
    const title = () => view.page.evaluate(() => document.querySelector("#help h1")?.textContent ?? "");
    await eventually("the page of the EKF", async () => (await title()).startsWith("ekf: "));
    await seen("stop");
    await view.picture("help");
    await choose('#help article [data-topic="ekf/theory"]'); // a link in the text
    await eventually("the page that it leads to", async () => (await title()) === "ekf: theory");
    await view.page.click("#help-toggle");
    assert.ok(await view.page.$eval("#help", (help) => help.hidden));
  });

  await t.test("it stops a robot with a goal, and says who", async () => {
    await view.eventually("map and robot drawn", (hook) => hook.drawn.map > 0 && hook.drawn.robot);
    await view.click("goal");
    await view.drag([8, 0], [8.6, 0]);
    const status = () => view.page.evaluate(() => ["hands-said", "navigation-status"].map((name) => document.querySelector(`[data-test="${name}"]`)?.textContent));
    await eventually(async () => `the robot drives; the page says ${JSON.stringify(await status())}`, async () => (await speed()) > 0.1);
    await view.page.keyboard.press("ArrowLeft"); // another time than now is looked at
    await view.click("stop");
    await says("Stopped: the emergency stop is pressed by /");
    await says("Goal 1 waits for the release");
    await view.picture("stop_in_force");
    assert.ok(await view.page.$eval('[data-test="stop"]', (button) => button.classList.contains("in-force")));
    await eventually("the robot stands", async () => Math.abs(await speed()) < 0.01);
    // The button is down: nobody else's release lets go.
    assert.match(await release(), /the emergency stop is pressed by/);
    await says("Stopped: the emergency stop is pressed by /");
  });

  await t.test("a release asks before, and lets it go on", async () => {
    await view.click("stop-release");
    await view.element("stop-release-yes");
    await view.picture("stop_release");
    await view.click("stop-release-yes");
    await eventually("the robot drives again", async () => (await speed()) > 0.1);
    assert.equal(await why(), "");
  });

  await t.test("a goal that comes while it is stopped is not taken, which is said large, on a telephone too", async () => {
    await view.click("stop");
    await says("Goal 1 waits for the release");
    await eventually("the robot stands", async () => Math.abs(await speed()) < 0.01);
    await view.click("cancel");
    await eventually("no goal is in hand", async () => !(await why()).includes("waits"));
    await view.click("goal");
    await view.drag([8, 0], [8.6, 0]);
    await says("Goal 2 was not taken");
    await view.picture("stop_goal");
    await view.page.setViewport({ width: 375, height: 667 });
    await view.picture("stop_goal_narrow");
    await seen("stop", "stop-why", "stop-release");
    const pixels = await view.page.$eval('[data-test="stop-why"]', (text) => parseFloat(getComputedStyle(text).fontSize));
    assert.ok(pixels >= 18.6, `${pixels} px`); // WCAG calls bold text of 14 pt large
    await view.click("stop-release");
    await seen("stop", "stop-why", "stop-release-yes");
    await view.click("stop-release-yes");
    await view.page.setViewport(size);
    await eventually("nothing keeps it", async () => (await why()) === "");
    assert.ok(Math.abs(await speed()) < 0.01, "it drives off without a goal");
  });

  await t.test("a page that is closed leaves the robot stopped, and does not refuse the release", async () => {
    await view.click("stop");
    await says("Stopped: the emergency stop is pressed by /");
    await view.page.close();
    let answer;
    await eventually(() => `a release; ${answer}`, async () => /pressed the emergency stop and has left/.test((answer = await release())));
  });
});
