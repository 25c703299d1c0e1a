// Hands: what a person may tell a running robot. All of it is off, with the reason, where nothing may be told.
import type { App } from "../app";
import { element, setText } from "./dom";
import { byNumbers } from "./hands/by_numbers";
import type { HandsContext } from "./hands/context";
import { DriveControl } from "./hands/drive_control";
import { goalTool, sendGoal } from "./hands/goal";
import { initialPoseTool, sendInitialPose } from "./hands/initial_pose";
import { PeopleTools } from "./hands/people";
import { Teleop } from "./hands/teleop";
import { Waypoints } from "./hands/waypoints";
import { robotsOf } from "./robots";
import "./panels.css";

export function mountHands(root: HTMLElement, app: App): void {
  const said = element("p", { class: "said", role: "status", "aria-live": "polite", "data-test": "hands-said" });
  const robots = element("select", { "aria-label": "Robot", "data-test": "robot" });
  const whichRobot = element("label", { class: "row" }, element("span", {}, "Robot"), robots);

  const context: HandsContext = {
    app,
    robot: () => robots.value,
    say(text, isError = false) {
      setText(said, text);
      said.classList.toggle("error", isError);
    },
    async run(what, command) {
      context.say(`${what} …`);
      try {
        await command();
        context.say(`${what}: sent`);
        return true;
      } catch (reason) {
        context.say(`${what}: ${reason instanceof Error ? reason.message : reason}`, true);
        return false;
      }
    },
  };

  const update = () => {
    updateRobots();
    fieldset.disabled = !app.hands.canCommand;
    whyNot.hidden = app.hands.canCommand;
    setText(whyNot, app.hands.whyNot || "no robot is connected");
    if (!app.hands.canCommand && tools.some((tool) => tool.isTaken)) app.tool = undefined;
    for (const part of [goal, pose, people, waypoints, control, teleop]) part.update();
  };

  const goal = goalTool(context, () => update());
  const pose = initialPoseTool(context, () => update());
  const people = new PeopleTools(context, () => update());
  const waypoints = new Waypoints(context, () => update());
  const teleop = new Teleop(context);
  const control = new DriveControl(
    context,
    () => waypoints.sent,
    () => (waypoints.sent = undefined),
  );
  const tools = [goal, waypoints.tool, pose, people.add, people.push];

  const updateRobots = () => {
    const names = robotsOf(
      app.source?.channels().map(({ topic }) => topic) ?? [],
      app.hands.services().map(({ name }) => name),
    );
    if (names.length === 0) names.push("");
    whichRobot.hidden = names.length < 2;
    if (names.join() === [...robots.options].map(({ value }) => value).join()) return;
    const before = robots.value;
    robots.replaceChildren(...names.map((name) => element("option", { value: name }, name.slice(1) || "the robot")));
    if (names.includes(before)) robots.value = before;
  };
  robots.addEventListener("change", () => {
    teleop.letGo();
    update();
  });

  const whyNot = element("p", { class: "why-not", role: "status", "data-test": "why-not" });
  const numbers = byNumbers({
    Goal: (at) => void sendGoal(context, at),
    "Initial pose": (at) => void sendInitialPose(context, at),
    Waypoint: (at) => waypoints.add(at),
  });
  const fieldset = element(
    "fieldset",
    { class: "bare" },
    element("div", { class: "row tools", role: "group", "aria-label": "Tools of the mouse" }, ...tools.map(({ button }) => button)),
    waypoints.root,
    control.root,
    teleop.root,
    numbers,
    said,
  );
  root.classList.add("hands-panel");
  root.append(whyNot, whichRobot, fieldset);

  for (const event of ["status", "source", "services", "channels"] as const) app.on(event, update);
  app.on("source", () => control.sourceChanged());
  for (const event of ["message", "cursor"] as const) app.on(event, () => control.showStatus());
  // The scene takes a tool away without an event of its own.
  app.on("cursor", () => tools.forEach((tool) => tool.update()));
  window.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && tools.some((tool) => tool.isTaken)) app.tool?.onCancel();
  });
  update();
}
