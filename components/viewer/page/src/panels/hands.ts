// Hands: what a person may tell a running robot. All of it is off, with the reason, where nothing may be told.
import type { App } from "../app";
import { create, setText } from "./dom";
import { byNumbers } from "./hands/by_numbers";
import type { HandsContext } from "./hands/context";
import { Crop } from "./hands/crop";
import { DriveControl } from "./hands/drive_control";
import { Explore } from "./hands/explore";
import { goalTool, sendGoal } from "./hands/goal";
import { initialPoseTool, sendInitialPose } from "./hands/initial_pose";
import { Keepout } from "./hands/keepout";
import { PeopleTools } from "./hands/people";
import { SaveMap } from "./hands/save_map";
import { Teleop } from "./hands/teleop";
import { Waypoints } from "./hands/waypoints";
import "./panels.css";

export function mountHands(root: HTMLElement, app: App): void {
  const said = create("p", { class: "said", role: "status", "aria-live": "polite", "data-test": "hands-said" });

  const context: HandsContext = {
    app,
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
    fieldset.disabled = !app.hands.canCommand;
    whyNot.hidden = app.hands.canCommand;
    setText(whyNot, app.hands.whyNot || "no robot is connected");
    if (!app.hands.canCommand && tools.some((tool) => tool.isTaken)) app.tool = undefined;
    for (const part of [goal, pose, people, waypoints, control, teleop, explore, keepout, crop, saveMap]) part.update();
  };

  const goal = goalTool(context, () => update());
  const pose = initialPoseTool(context, () => update());
  const people = new PeopleTools(context, () => update());
  const waypoints = new Waypoints(context, () => update());
  const teleop = new Teleop(context);
  const explore = new Explore(context);
  const keepout = new Keepout(context, () => update());
  const crop = new Crop(context, () => update());
  const saveMap = new SaveMap(context, () => crop.part);
  const control = new DriveControl(
    context,
    () => waypoints.sent,
    () => (waypoints.sent = undefined),
  );
  const tools = [goal, waypoints.tool, pose, people.add, people.push, keepout.draw, keepout.erase, crop.tool];

  const whyNot = create("p", { class: "why-not", role: "status", "data-test": "why-not" });
  const numbers = byNumbers({
    Goal: (at) => void sendGoal(context, at),
    "Initial pose": (at) => void sendInitialPose(context, at),
    Waypoint: (at) => waypoints.add(at),
  });
  const fieldset = create(
    "fieldset",
    { class: "bare" },
    create("div", { class: "row tools", role: "group", "aria-label": "Tools of the mouse" }, ...tools.map(({ button }) => button)),
    waypoints.root,
    control.root,
    teleop.root,
    explore.root,
    crop.root,
    saveMap.root,
    numbers,
    said,
  );
  root.classList.add("hands-panel");
  root.append(whyNot, fieldset);

  for (const event of ["status", "source", "services", "channels"] as const) app.on(event, update);
  app.on("robot", () => {
    teleop.letGo();
    update();
  });
  for (const event of ["message", "cursor"] as const) app.on(event, () => control.showStatus());
  // The scene takes a tool away without an event of its own.
  app.on("cursor", () => tools.forEach((tool) => tool.update()));
  window.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && tools.some((tool) => tool.isTaken)) app.tool?.onCancel();
  });
  update();
}
