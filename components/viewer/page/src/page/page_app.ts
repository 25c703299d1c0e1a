// The App that all panels share.
import type { App, ConnectionGraph, Event, Hands, Source, Status, Timeline, Tool } from "../app";
import { TimeCursor } from "./cursor";
import { robotsAmong } from "./robots";

const PER_FRAME: ReadonlySet<Event> = new Set<Event>(["message", "cursor"]);
const MOST_STATUSES = 50;

const NOTHING: Timeline = {
  at: () => undefined,
  between: () => [],
  begin: 0,
  end: 0,
  transform: () => undefined,
  root: () => undefined,
};

const NO_HANDS: Hands = {
  canCommand: false,
  canStop: false,
  whyNot: "A recording takes no commands",
  publish: () => Promise.reject(new Error(NO_HANDS.whyNot)),
  call: () => Promise.reject(new Error(NO_HANDS.whyNot)),
  services: () => [],
};

export class PageApp implements App {
  source: Source | undefined;
  readonly cursor = new TimeCursor(() => this.timeline, () => this.source?.kind, () => this.emit("cursor"));
  readonly statuses: Status[] = [];
  robots: string[] = [];
  private chosen = "";
  private theTool: Tool | undefined;
  private readonly listeners = new Map<Event, Set<() => void>>();
  private readonly pending = new Set<Event>();
  private lastFrame: number | undefined;
  private isFrameDue = false;

  get timeline(): Timeline {
    return this.source?.timeline ?? NOTHING;
  }

  get hands(): Hands {
    return this.source?.hands ?? NO_HANDS;
  }

  get metadata(): Record<string, string> {
    return this.source?.metadata ?? {};
  }

  get robot(): string {
    return this.chosen;
  }

  set robot(name: string) {
    this.chosen = name;
    this.emit("robot");
  }

  get tool(): Tool | undefined {
    return this.theTool;
  }

  set tool(tool: Tool | undefined) {
    this.theTool = tool;
    this.emit("cursor"); // drawn and read anew
  }

  graph(): ConnectionGraph | undefined {
    return this.source?.graph?.();
  }

  open(source: Source): void {
    this.source?.close();
    this.source = source;
    this.findRobots();
    this.cursor.reset();
    for (const event of ["source", "channels", "services", "parameters", "graph", "message"] as const) this.emit(event);
  }

  say(level: Status["level"], text: string): void {
    this.statuses.push({ level, text, time: this.timeline.end });
    if (this.statuses.length > MOST_STATUSES) this.statuses.shift();
    this.emit("status");
  }

  on(event: Event, listener: () => void): () => void {
    const listeners = this.listeners.get(event) ?? new Set();
    this.listeners.set(event, listeners.add(listener));
    return () => listeners.delete(listener);
  }

  emit(event: Event): void {
    if (PER_FRAME.has(event)) {
      this.pending.add(event);
      this.askForFrame();
      return;
    }
    if (event === "channels") this.findRobots();
    this.tell(event);
  }

  private tell(event: Event): void {
    for (const listener of this.listeners.get(event) ?? []) listener();
  }

  private askForFrame(): void {
    if (this.isFrameDue) return;
    this.isFrameDue = true;
    requestAnimationFrame((now) => this.onFrame(now));
  }

  private onFrame(now: number): void {
    this.isFrameDue = false;
    const events = [...this.pending];
    this.pending.clear();
    this.cursor.tick(this.lastFrame === undefined ? 0 : (now - this.lastFrame) / 1000);
    this.lastFrame = this.isFrameDue ? now : undefined; // a cursor that moves asks for the next frame
    for (const event of events) this.tell(event);
  }

  private findRobots(): void {
    const robots = robotsAmong(this.source?.channels() ?? []);
    if (robots.length === 0 || robots.join() === this.robots.join()) return; // gone for a while: they will be back
    this.robots = robots;
    if (!robots.includes(this.chosen)) this.chosen = robots[0]!;
    this.tell("robot");
  }
}
