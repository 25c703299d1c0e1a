// node report_test.mjs PROGRAM: a report with every kind of part (report_fixture.cpp), opened as a file.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import path from "node:path";
import test from "node:test";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";
import { count } from "./pixels.mjs";
import { program, scratch } from "./robot.mjs";

test("a report draws its tables and pictures without a server", async (t) => {
  const file = path.join(scratch(t), "report.html");
  execFileSync(program, [file]);
  const browser = await Browser.start();
  t.after(() => browser.end());
  const view = await browser.open(pathToFileURL(file).href);
  const { page } = view;
  const asked = [];
  page.on("request", (request) => asked.push(request.url()));
  const texts = (selector) => page.$$eval(selector, (found) => found.map((one) => one.textContent));

  await t.test("tables hold what was measured, in the digits that were asked for", async () => {
    assert.equal(await page.title(), "A <fixture> of reports");
    assert.deepEqual(await texts("thead th"), ["planner", "time [s]", "largest CI", "runs", "verdict"]);
    assert.deepEqual(await texts("tbody tr:nth-child(1) td"), ["teb", "12.3", "0.432 0.400 to 0.500", "40", "met"]);
    assert.deepEqual(await texts("tbody tr:nth-child(2) td"), ["eteb", "–", "0.0200", "40", "not met"]);
    assert.deepEqual(await texts(".outcome.missed li"), ["eteb: 0.02"]);
    assert.deepEqual(await texts("main > ul li"), ["one", "two [*]"]);
  });

  await t.test("addresses are those beside the report", async () => {
    const addresses = await page.$$eval("a", (found) => found.map((one) => one.getAttribute("href")));
    assert.deepEqual(addresses, ["failed/index.html", "#charts"]);
  });

  await t.test("every picture is drawn", async () => {
    const { pictures } = await view.hook();
    assert.deepEqual(pictures, [{ title: "Speed", parts: 3 }, { title: "Error", parts: 1 }, { title: "Room", parts: 2 }, { title: "Mean error", parts: 2 }]);
    assert.equal((await page.$$(".uplot canvas")).length, 4);
    const legends = await Promise.all((await page.$$("figure")).map((figure) => figure.$$eval(".legend span", (found) => found.map((one) => one.textContent))));
    assert.deepEqual(legends, [
      ["robot 0", "robot 1", "robot 2", "way", "fixes", "people", "missed", "other identity", "false", "labelled", "roof"],
      ["published", "mean, 5 to 95 %", "a run"],
    ]);
    // Ink of the first line within the first picture: blue, in the colours of the light or the dark.
    await page.$eval("figure", (figure) => figure.scrollIntoView());
    const box = await (await page.$(".uplot canvas")).boundingBox();
    const image = await view.picture("report");
    const blue = Math.max(...["#0072b2", "#56b4e9"].map((colour) => count(image, colour, box, 30)));
    assert.ok(blue > 100, `the first line has ${blue} pixels`);
  });

  await t.test("nothing is wider than a phone", async () => {
    for (const media of ["light", "dark"]) {
      await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: media }]);
      await page.setViewport({ width: 375, height: 700 });
      await view.eventually("it is drawn anew", async () => (await page.$eval(".uplot canvas", (canvas) => canvas.getBoundingClientRect().width)) < 376, 10);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 375);
      await view.picture(`report_phone_${media}`);
    }
    const background = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    assert.equal(background, "rgb(16, 20, 26)");
  });

  assert.deepEqual(asked, [], "it asked for something else");
  assert.deepEqual(view.errors, []);
});
