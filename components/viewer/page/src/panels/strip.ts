// The strip at the foot of the page: the last minute of a robot or all of a bag on one time axis, and the line that says what is
// looked at, which a person may drag.
import type uPlot from "uplot";
import "uplot/dist/uPlot.min.css";

import type { App, Seconds } from "../app";
import { BagTimeline } from "../bag/bag_timeline";
import { make } from "../page/dom";
import { Wants } from "../page/wants";
import { rolesOf, StripData } from "./strip_data";
import { LANE_HEIGHT, MarkLane, pixelOf } from "./strip_marks";
import { mountPlayback } from "./strip_playback";
import { columns, LEFT, makePlot, RIGHT, ROWS, type RowKind, type View } from "./strip_rows";
import "./strip.css";

const SHOWN: Seconds = 60; // of a robot
const PERIOD = 200; // [ms] between two looks at what came, so that curves cost little
const WHOLE_BAG = 512 * 2 ** 20; // [bytes] of a longer bag only what is around the cursor is read
const AROUND: Seconds = 120;

class Strip {
  readonly #app: App;
  readonly #wants: Wants;
  readonly #plots: { kind: RowKind; plot: uPlot; value: HTMLElement }[] = [];
  readonly #lane = new MarkLane();
  readonly #area = make("div", { className: "strip-area" });
  readonly #line = make("div", { className: "strip-cursor" });
  #data = new StripData();
  #roles: ReturnType<typeof rolesOf> = new Map();
  #view: View = { from: 0, to: SHOWN, origin: 0 };
  #upTo: Seconds = -Infinity;
  #walk = 0; // the one under way
  #lastLook = -Infinity;
  #isDue = false;

  constructor(root: HTMLElement, app: App) {
    this.#app = app;
    this.#wants = new Wants(app);
    const bar = make("div", { className: "strip-bar" });
    mountPlayback(bar, app);
    const rows = make("div", { className: "strip-rows" });
    const fold = make("button", { className: "strip-fold", textContent: "Curves", title: "Show or hide the curves" });
    fold.setAttribute("aria-pressed", "true");
    fold.onclick = () => {
      rows.hidden = !rows.hidden;
      fold.setAttribute("aria-pressed", String(!rows.hidden));
      this.#begin();
    };
    bar.append(make("span", { className: "space" }), this.#legend(), fold);
    rows.append(this.#labels(), this.#area);
    root.append(bar, rows);
    this.#area.dataset["test"] = "scrub";
    this.#area.append(this.#lane.canvas, ...this.#plots.map(({ plot }) => plot.root), this.#line);
    this.#listen(rows);
  }

  #color = (variable: string) => getComputedStyle(this.#area).getPropertyValue(variable).trim();

  #labels(): HTMLElement {
    const labels = make("div", { className: "strip-labels" });
    labels.style.paddingTop = `${LANE_HEIGHT}px`;
    ROWS.forEach((kind, i) => {
      const isLast = i === ROWS.length - 1;
      const value = make("b");
      const label = make("div", { className: "strip-label" }, make("span", { textContent: kind.title }), value);
      label.style.height = `${kind.height}px`;
      labels.append(label);
      const plot = makePlot(kind, isLast, () => this.#view, () => this.#data, this.#color);
      this.#plots.push({ kind, plot, value });
    });
    return labels;
  }

  #legend(): HTMLElement {
    const entries: [string, string][] = [
      ["asked", "--strip-command"],
      ["driven", "--strip-speed"],
      ["class switch", "--strip-switch"],
      ["contact", "--error"],
    ];
    const legend = make("span", { className: "strip-legend" });
    for (const [text, color] of entries) {
      const sample = make("i");
      sample.style.background = `var(${color})`;
      legend.append(make("span", {}, sample, text));
    }
    return legend;
  }

  #listen(rows: HTMLElement): void {
    const app = this.#app;
    app.on("source", () => this.#begin());
    app.on("robot", () => this.#begin());
    app.on("channels", () => this.#chooseTopics());
    app.on("message", () => this.#look());
    app.on("cursor", () => this.#show());
    new ResizeObserver(() => this.#resize()).observe(rows);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.#draw());
    this.#listenToPointer();
  }

  /** A press or a drag anywhere on the curves; what plays waits meanwhile. */
  #listenToPointer(): void {
    const app = this.#app;
    const area = this.#area;
    let goesOn = false;
    const seek = (event: PointerEvent) => {
      const box = area.getBoundingClientRect();
      const share = (event.clientX - box.left - LEFT) / (box.width - LEFT - RIGHT);
      const { from, to } = this.#view;
      const { begin, end } = app.timeline;
      app.cursor.seek(Math.min(Math.max(from + share * (to - from), begin), end));
    };
    area.addEventListener("pointerdown", (event) => {
      if (event.button !== 0 || app.timeline.end <= 0) return;
      goesOn = app.cursor.isPlaying && !app.cursor.isLive;
      app.cursor.pause();
      area.setPointerCapture(event.pointerId);
      seek(event);
    });
    area.addEventListener("pointermove", (event) => {
      if (area.hasPointerCapture(event.pointerId)) seek(event);
    });
    area.addEventListener("lostpointercapture", () => {
      if (goesOn) app.cursor.play();
      goesOn = false;
    });
  }

  /** Another source or robot, or shown again. */
  #begin(): void {
    this.#data = new StripData();
    this.#upTo = -Infinity;
    ++this.#walk;
    this.#roles = new Map();
    this.#chooseTopics();
    this.#draw();
  }

  #chooseTopics(): void {
    const isHidden = this.#area.parentElement!.hidden;
    const roles = isHidden ? new Map() : rolesOf(this.#app.source?.channels() ?? [], this.#app.robot);
    const isSame = [...roles.keys()].join() === [...this.#roles.keys()].join();
    this.#roles = roles;
    this.#wants.set(roles.keys());
    const { timeline } = this.#app;
    if (!isSame && timeline instanceof BagTimeline) void this.#read(timeline);
  }

  /** All of a bag, once; of a long one what is around the cursor. */
  async #read(timeline: BagTimeline): Promise<void> {
    const mine = ++this.#walk;
    const data = (this.#data = new StripData());
    const isWhole = timeline.index.files.reduce((sum, file) => sum + file.size, 0) <= WHOLE_BAG;
    const middle = this.#app.cursor.time;
    const span = isWhole
      ? { from: timeline.begin, to: timeline.end }
      : { from: Math.max(timeline.begin, middle - AROUND), to: Math.min(timeline.end, middle + AROUND) };
    this.#view = { ...span, origin: timeline.begin };
    const roles = this.#roles;
    await timeline.walk(
      [...roles.keys()],
      span,
      (message) => data.add(roles.get(message.topic)!, message),
      () => {
        this.#drawSoon();
        return mine !== this.#walk;
      },
    );
    this.#draw();
  }

  /** What came from a robot since the last look. */
  #look(): void {
    const { timeline, source } = this.#app;
    if (source?.kind !== "live" || this.#area.parentElement!.hidden) return;
    const now = performance.now();
    if (now - this.#lastLook < PERIOD) return;
    this.#lastLook = now;
    if (timeline.end < this.#upTo - 1) this.#data = new StripData(); // a simulation began anew
    const from = timeline.end < this.#upTo - 1 ? -Infinity : this.#upTo;
    const messages = [...this.#roles.keys()].flatMap((topic) => timeline.between(topic, from, timeline.end));
    for (const message of messages.sort((a, b) => a.time - b.time)) this.#data.add(this.#roles.get(message.topic)!, message);
    this.#upTo = timeline.end;
    this.#data.forgetBefore(timeline.end - SHOWN - 2);
    this.#view = { from: timeline.end - SHOWN, to: timeline.end, origin: timeline.end };
    this.#draw();
  }

  #drawSoon(): void {
    if (this.#isDue) return;
    this.#isDue = true;
    setTimeout(() => {
      this.#isDue = false;
      this.#draw();
    }, PERIOD);
  }

  #draw(): void {
    if (this.#area.parentElement!.hidden) return;
    for (const { kind, plot } of this.#plots) plot.setData(columns(this.#data, kind));
    this.#lane.draw(this.#data.marks, this.#view, this.#color);
    this.#show();
  }

  /** The line, and what holds there. */
  #show(): void {
    const { cursor, timeline } = this.#app;
    if (this.#area.parentElement!.hidden) return;
    const { time } = cursor;
    const isOutside = time < this.#view.from || time > this.#view.to;
    if (isOutside && timeline instanceof BagTimeline && this.#roles.size > 0) void this.#read(timeline);
    this.#line.hidden = timeline.end <= 0 || isOutside;
    this.#line.style.transform = `translateX(${pixelOf(this.#view, this.#area.clientWidth, time)}px)`;
    for (const { kind, value } of this.#plots) {
      const curve = kind.lines.at(-1)!.curve;
      const found = this.#data.valueAt(curve, time);
      const unit = kind.unit(this.#data);
      const isTold = this.#data.curves[curve].times.length > 0;
      value.textContent = found !== undefined && !Number.isNaN(found) ? `${found.toFixed(kind.digits)} ${unit}` : isTold ? "–" : "not told";
    }
  }

  #resize(): void {
    const width = this.#area.clientWidth;
    if (width < LEFT + RIGHT + 20) return;
    for (const { plot } of this.#plots) plot.setSize({ width, height: plot.height });
    this.#draw();
  }
}

export function mountStrip(root: HTMLElement, app: App): void {
  new Strip(root, app);
}
