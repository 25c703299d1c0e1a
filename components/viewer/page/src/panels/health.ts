// Health: the graph as boxes, diagnostics, the log, the connection.
import type { App } from "../app";
import { Wants } from "../page/wants";
import { create } from "./dom";
import { ConnectionView } from "./health/connection_view";
import { detailsOf } from "./health/details";
import { statusesAt, windowOf, type DiagnosticArray } from "./health/diagnostics";
import { DiagnosticsView } from "./health/diagnostics_view";
import { GraphView } from "./health/graph_view";
import { linksOf } from "./health/links";
import type { LogRecorder } from "./health/log_recorder";
import { LogView } from "./health/log_view";
import "./panels.css";

const DIAGNOSTICS = "/diagnostics";
/** Diagnostics come each second: looked at a little more often than that, whatever else comes. */
const PERIOD_MS = 250;

export function mountHealth(root: HTMLElement, app: App, recorder: LogRecorder): void {
  let chosen: string | undefined;
  const choose = (name: string | undefined) => {
    chosen = name;
    show();
    if (name !== undefined) details.scrollIntoView({ block: "nearest" });
  };
  const graph = new GraphView((name) => choose(name === chosen ? undefined : name));
  const details = create("div", {});
  const diagnostics = new DiagnosticsView(choose);
  const log = new LogView(app, recorder);
  const connection = new ConnectionView(app);
  const wants = new Wants(app);

  const enlarge = create("button", { type: "button", "aria-expanded": "false", title: "The graph on the whole page", "data-test": "enlarge-graph" }, "Enlarge");
  const top = create("section", { class: "graph" }, create("div", { class: "row" }, create("h2", {}, "Graph"), enlarge), graph.root, details);
  const isLarge = () => top.classList.contains("large");
  const setLarge = (large: boolean) => {
    top.classList.toggle("large", large);
    enlarge.setAttribute("aria-expanded", String(large));
    enlarge.textContent = large ? "Close" : "Enlarge";
    show();
  };
  enlarge.addEventListener("click", () => setLarge(!isLarge()));
  top.addEventListener("keydown", (event) => event.key === "Escape" && isLarge() && setLarge(false));
  root.classList.add("health-panel");
  root.append(top, diagnostics.root, log.root, connection.root);

  const show = () => {
    const now = app.cursor.time;
    const components = statusesAt(app.timeline.between<DiagnosticArray>(DIAGNOSTICS, windowOf(now), now), now);
    const links = linksOf(app.graph() ?? { published: {}, subscribed: {}, services: {} }, components.map(({ name }) => name));
    const shown = components.find(({ name }) => name === chosen);
    graph.show(drawn(components), links, shown?.name);
    details.replaceChildren(...(shown === undefined ? [] : [detailsOf(shown, links)]));
    diagnostics.show(components);
    log.show();
    connection.show();
  };
  const listen = () => wants.set(root.hidden ? [] : [DIAGNOSTICS]);
  let last = 0;
  const hear = () => {
    listen();
    if (root.hidden || performance.now() - last < PERIOD_MS) return;
    last = performance.now();
    show();
  };
  for (const event of ["message", "cursor"] as const) app.on(event, hear);
  for (const event of ["graph", "status", "services"] as const) app.on(event, () => !root.hidden && connection.show());
  new ResizeObserver(() => !root.hidden && show()).observe(graph.root);
  // Shown again without a message of its own, as while a bag stands still.
  new MutationObserver(() => root.hidden || show()).observe(root, { attributeFilter: ["hidden"] });
  listen();
  show();
}

/** Boxes are what runs in a lane; the process itself has none. */
function drawn<T extends { lane: string; process: string; name: string; callbacks: unknown[] }>(components: readonly T[]): T[] {
  const inLanes = components.filter(({ lane, process }) => lane !== "" || process !== "");
  return inLanes.length > 0 ? inLanes : [...components];
}
