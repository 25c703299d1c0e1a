// What is shown, of which robot, and whether it is there.
import type { App } from "../app";
import { element } from "./dom";

export function mountToolbar(app: App): void {
  const connection = element("connection");
  const chooser = element<HTMLSelectElement>("robot");
  const toggle = element("side-toggle");

  const showSource = () => {
    const { source } = app;
    const isLost = source?.kind === "live" && !source.channels().length && app.hands.whyNot.startsWith("No connection");
    connection.className = isLost ? "lost" : (source?.kind ?? "");
    connection.textContent = source ? (isLost ? `waiting for ${source.name}` : source.name) : "";
  };
  const showRobots = () => {
    chooser.replaceChildren(...app.robots.map((name) => new Option(name.slice(1) || "the only one", name)));
    chooser.value = app.robot;
    element("robots").hidden = app.robots.length < 2;
  };

  chooser.onchange = () => (app.robot = chooser.value);
  toggle.onclick = () => {
    const isNarrow = document.body.classList.toggle("narrow");
    toggle.setAttribute("aria-expanded", String(!isNarrow));
  };
  for (const event of ["source", "channels"] as const) app.on(event, showSource);
  app.on("robot", showRobots);
  showSource();
}
