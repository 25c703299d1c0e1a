// node connection_test.mjs PROGRAM: the robot goes and comes back.
import assert from "node:assert/strict";
import test from "node:test";
import { Browser } from "./browser.mjs";
import { Robot } from "./robot.mjs";

test("a lost connection is shown and found again", async (t) => {
  let robot = await Robot.start();
  t.after(() => robot.end("SIGKILL"));
  const browser = await Browser.start();
  t.after(() => browser.end());
  const view = await browser.open(robot.address);
  const isDriving = (hook) => hook.source === "live" && hook.drawn.robot && hook;
  const { timeline } = await view.eventually("live", isDriving);
  const { port } = robot;

  await robot.end("SIGKILL");
  await view.eventually("the loss is shown", (hook) => hook.source === "lost");
  const { canCommand, whyNot } = await view.hook();
  assert.equal(canCommand, false);
  assert.notEqual(whyNot, "");
  await view.picture("lost");

  robot = await Robot.start({ port });
  assert.equal(robot.port, port, "the port of a process that was killed is free at once");
  const again = await view.eventually("live again, later than before", (hook) => isDriving(hook) && hook.timeline.end > timeline.end && hook);
  assert.equal(again.canCommand, false);
  assert.match(again.whyNot, /not that of this run/); // another run has another token
  await view.element("read-only");
  await view.picture("found_again");
  await view.page.goto(robot.address);
  await view.eventually("commands with the new token", (hook) => isDriving(hook) && hook.canCommand);
});
