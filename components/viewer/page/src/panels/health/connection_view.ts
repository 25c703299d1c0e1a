// The connection: whether this page may command, who does, and what the server says of itself.
import type { App } from "../../app";
import { create } from "../dom";

const COMMANDER = /commands? the robot/;

export function connectionFacts(app: Pick<App, "source" | "hands" | "metadata" | "statuses">): [string, string][] {
  const facts: [string, string][] = [["source", app.source?.name ?? "none"]];
  if (app.source?.kind === "live") {
    facts.push(["commands", app.hands.canCommand ? "allowed" : app.hands.whyNot]);
    const commander = app.statuses.filter(({ text }) => COMMANDER.test(text)).at(-1);
    if (commander !== undefined) facts.push(["commander", commander.text]);
    facts.push(["channels", String(app.source.channels().length)], ["services", String(app.hands.services().length)]);
  }
  for (const [name, value] of Object.entries(app.metadata)) facts.push([name.replaceAll("_", " "), value]);
  return facts;
}

export class ConnectionView {
  private readonly list = create("dl", { "data-test": "connection-facts" });
  readonly root = create("section", { class: "connection" }, create("h2", {}, "Connection"), this.list);
  private shown = "";

  constructor(private readonly app: App) {}

  show(): void {
    const facts = connectionFacts(this.app);
    const now = JSON.stringify(facts);
    if (now === this.shown) return;
    this.shown = now;
    this.list.replaceChildren(...facts.flatMap(([name, value]) => [create("dt", {}, name), create("dd", {}, value)]));
  }
}
