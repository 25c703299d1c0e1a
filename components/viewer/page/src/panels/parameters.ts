// Parameters: every one of every node, with what is known of it, changed while the robot drives.
import type { App } from "../app";
import { Wants } from "../page/wants";
import { create, setText } from "./dom";
import { Follower } from "./follower";
import { Changes } from "./parameters/changes";
import { matcher } from "./parameters/search";
import { Sections } from "./parameters/sections";
import { ParameterStore, type Entry, type ParameterEvent } from "./parameters/store";
import { graphYaml } from "./parameters/yaml";
import "./panels.css";

const LIST = "rcl_interfaces/srv/ListParameters";
const EVENTS = "/parameter_events";
const TRIES = 3;
const RETRY_MS = 1000;

export function mountParameters(root: HTMLElement, app: App): void {
  /** Nodes that were asked, and those whose answers are not shown yet. */
  const asked = new Set<string>();
  const anew = new Set<string>();
  const store = new ParameterStore(
    (service, request) => app.hands.call(service, request),
    (entry) => {
      sections.show(entry);
      changesSoon();
    },
    (node) => {
      anew.add(node);
      listSoon();
    },
  );
  const actions = { canCommand: () => app.hands.canCommand, set: (entry: Entry, value: Entry["value"]) => store.set(entry, value) };
  const sections = new Sections(actions);
  const changes = new Changes({
    undo: (entries) => void undo(entries),
    yaml: () => graphYamlOf(store, app),
    say: (text) => app.say("info", text),
  });

  const search = create("input", { type: "search", placeholder: "Search: name, unit, what it does", "aria-label": "Search parameters", "data-test": "parameter-search", oninput: () => list() });
  const reload = create("button", { type: "button", title: "Ask all nodes again", onclick: () => void load(nodes()) }, "Reload");
  const state = create("p", { class: "hint", role: "status", "data-test": "parameter-state" });
  root.classList.add("parameters-panel");
  root.append(create("div", { class: "row search" }, search, reload), state, changes.root, sections.root);

  const list = () => {
    const query = search.value.trim();
    if (query === "") sections.showAll(store.nodes(), (node) => store.of(node), anew);
    anew.clear();
    if (query === "") return;
    const matches = matcher(query);
    sections.showFound(store.nodes(), (node) => store.of(node).filter(({ parameter }) => matches(parameter)));
  };
  const showChanges = () => {
    changes.show(store.changed());
    changes.enable(app.hands.canCommand);
  };
  const listSoon = oncePerFrame(() => {
    list();
    showChanges();
  });
  const changesSoon = oncePerFrame(showChanges);

  const undo = async (entries: readonly Entry[]) => {
    for (const entry of entries) {
      await store.set(entry, entry.first).catch((reason) => app.say("error", `${entry.parameter.name}: ${reason.message}`));
    }
  };

  const nodes = () =>
    app.hands
      .services()
      .filter(({ name, type }) => type === LIST && name.endsWith("/list_parameters"))
      .map(({ name }) => name.slice(0, -"/list_parameters".length));
  const load = async (wanted: string[], tries = TRIES) => {
    if (wanted.length === 0) return showState();
    for (const node of wanted) asked.add(node);
    setText(state, wanted.length === 1 ? `Asking ${wanted[0]} …` : `Asking ${wanted.length} nodes …`);
    const failures = new Map<string, string>();
    await store.load(wanted, (node, reason) => failures.set(node, reason instanceof Error ? reason.message : String(reason)));
    showState([...failures].map(([node, reason]) => `${node}: ${reason}`));
    // A node that has just come up, or is busy, answers a little later; one that is gone is asked again when its services are back.
    const again = [...failures.keys()].filter((node) => nodes().includes(node));
    for (const node of failures.keys()) asked.delete(node);
    if (again.length > 0 && tries > 1) setTimeout(() => void load(again.filter((node) => !asked.has(node)), tries - 1), RETRY_MS);
  };
  const showState = (failures: string[] = []) => {
    const count = store.nodes().reduce((sum, node) => sum + store.of(node).length, 0);
    if (failures.length > 0) setText(state, failures.join("; "));
    else if (app.source?.kind === "bag") setText(state, "A bag has no parameters to ask for");
    else setText(state, count === 0 ? "No node has been found yet" : `${count} parameters; ${app.hands.canCommand ? "changes are live" : app.hands.whyNot}`);
  };

  const events = new Follower<ParameterEvent>(EVENTS);
  const loadNew = () => void load(nodes().filter((node) => !asked.has(node)));
  const follow = () => {
    for (const { value } of events.take(app.timeline).messages) store.follow(value);
  };
  new Wants(app).set([EVENTS]);
  app.on("source", () => {
    asked.clear();
    loadNew();
  });
  app.on("services", loadNew);
  app.on("message", follow);
  app.on("status", () => {
    sections.showRows();
    changes.enable(app.hands.canCommand);
    showState();
  });
  loadNew();
}

function graphYamlOf(store: ParameterStore, app: App): string {
  return graphYaml(store.changed(), (node) => store.of(node), app.robots.length > 1);
}

function oncePerFrame(work: () => void): () => void {
  let isDue = false;
  return () => {
    if (isDue) return;
    isDue = true;
    requestAnimationFrame(() => {
      isDue = false;
      work();
    });
  };
}
