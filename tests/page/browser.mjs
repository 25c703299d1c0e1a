// A headless browser on the page, and hands in it: those of a mouse and a keyboard, no calls into the page's code. What was drawn is asked of
// window.bandwagon, which reads and changes nothing.
import { mkdirSync, writeFileSync } from "node:fs";
import path from "node:path";
import { eventually } from "./process.mjs";
import { decodePng } from "./pixels.mjs";
import { require } from "./modules.mjs";

const puppeteer = require("puppeteer-core");
export const size = { width: 1280, height: 720 };

export class Browser {
  /** Without a graphics card: WebGL by SwiftShader, as on a machine of a build farm. */
  static async start() {
    const browser = await puppeteer.launch({
      executablePath: process.env.BANDWAGON_CHROMIUM ?? "/usr/bin/chromium",
      args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-proxy-server"],
      defaultViewport: size,
    });
    return new Browser(browser);
  }

  constructor(browser) {
    this.browser = browser;
  }

  /** A page at an address. What it logs as an error, or throws, is an error of the test: see `errors`. */
  async open(address) {
    const page = await this.browser.newPage();
    const view = new View(page);
    await page.goto(address, { waitUntil: "load" });
    await view.eventually("the page says how it goes", (hook) => hook !== undefined);
    return view;
  }

  end() {
    return this.browser.close();
  }
}

export class View {
  constructor(page) {
    this.page = page;
    this.errors = [];
    page.on("pageerror", (error) => this.errors.push(String(error)));
    page.on("console", (message) => message.type() === "error" && this.errors.push(`${message.text()} ${message.location().url ?? ""}`));
  }

  /** window.bandwagon as plain values. */
  async hook() {
    return this.page.evaluate(() => (window.bandwagon === undefined ? undefined : JSON.parse(JSON.stringify(window.bandwagon))));
  }

  /** Polls window.bandwagon until `seen` of it is true, which is returned. */
  eventually(what, seen, seconds = 30) {
    let hook;
    return eventually(
      () => `${what}; the page: ${JSON.stringify(hook)?.slice(0, 2000)}; errors: ${this.errors.join("; ")}`,
      async () => seen((hook = await this.hook())),
      seconds,
    );
  }

  /** A place of the root frame in pixels of the page. */
  toScreen(x, y) {
    return this.page.evaluate((x, y) => window.bandwagon.toScreen(x, y), x, y);
  }

  /** What is seen now; kept as NAME.png in the folder BANDWAGON_PICTURES, if there is one. */
  async picture(name) {
    const png = Buffer.from(await this.page.screenshot({ type: "png" }));
    const folder = process.env.BANDWAGON_PICTURES;
    if (folder) {
      mkdirSync(folder, { recursive: true });
      writeFileSync(path.join(folder, `${name}.png`), png);
    }
    return decodePng(png);
  }

  element(name) {
    return this.page.waitForSelector(`[data-test="${name}"]`, { visible: true, timeout: 30_000 });
  }

  async click(name) {
    await (await this.element(name)).click();
  }

  /** Presses at one place of the root frame, drags to another, releases. */
  async drag(from, to) {
    const [a, b] = [await this.toScreen(...from), await this.toScreen(...to)];
    await this.page.mouse.move(a.x, a.y);
    await this.page.mouse.down();
    await this.page.mouse.move((a.x + b.x) / 2, (a.y + b.y) / 2);
    await this.page.mouse.move(b.x, b.y);
    await this.page.mouse.up();
  }

  /** Drops files of the disk onto the page, as a file manager does. */
  async drop(...files) {
    const session = await this.page.createCDPSession();
    const at = { x: size.width / 2, y: size.height / 2 };
    const data = { items: [], files, dragOperationsMask: 1 };
    for (const type of ["dragEnter", "dragOver", "drop"]) await session.send("Input.dispatchDragEvent", { type, ...at, data });
    await session.detach();
  }
}
