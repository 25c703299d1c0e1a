// A line at the top of the page while its robot takes no commands from it; what to do is its title and in the panels.
import "../style/read_only.css";
import type { App } from "../app";
import { make } from "./dom";

export function mountReadOnly(after: HTMLElement, app: App): void {
  const line = make("span", { className: "read-only", textContent: "read only: open the printed address" });
  line.setAttribute("role", "status");
  line.dataset.test = "read-only";
  after.after(line);
  const update = () => {
    line.hidden = !(app.source?.kind === "live" && app.metadata.may_command === "false");
    line.title = app.hands.whyNot;
  };
  app.on("source", update);
  update();
}
