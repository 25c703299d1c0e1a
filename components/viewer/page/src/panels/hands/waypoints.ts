// Several poses, then go: through all of them without a stop, or standing still at each. Nav2's actions by their services.
import type { Pose2 } from "../../app";
import { create, setText } from "../dom";
import { groundFrame, offers, robotPose, type Hand, type HandsContext } from "./context";
import { DragToolButton } from "./drag_tool";
import { newGoalId } from "./goal_id";
import { poseOfDrag, poseStamped } from "./poses";

/** Action by what it does with the poses. */
const ACTIONS = { navigate_through_poses: "Drive through", follow_waypoints: "Stop at each" } as const;
type Action = keyof typeof ACTIONS;

/** A goal that was sent as an action: what cancels it. */
export interface ActionGoal {
  service: string;
  id: number[];
}

/** Sends the poses; fails with a sentence when the goal is not taken. */
export async function sendWaypoints(context: HandsContext, action: Action, poses: readonly Pose2[]): Promise<ActionGoal> {
  const { app } = context;
  const name = `${context.app.robot}/${action}/_action`;
  const id = newGoalId();
  const frame = groundFrame(app);
  const goal = { poses: poses.map((pose) => poseStamped(frame, pose)) };
  const response = await app.hands.call<{ accepted: boolean }>(`${name}/send_goal`, { goal_id: { uuid: id }, goal });
  if (!response.accepted) throw new Error(`${action} does not take the goal`);
  return { service: `${name}/cancel_goal`, id };
}

export class Waypoints implements Hand {
  readonly tool: DragToolButton;
  readonly root: HTMLElement;
  /** The newest goal that went out from here. */
  sent: ActionGoal | undefined;

  private poses: Pose2[] = [];
  private readonly count = create("span", { class: "count" });
  private readonly choice = create("select", { "aria-label": "What to do at waypoints" });
  private readonly go = this.button("Go", "waypoints-go", () => void this.send());
  private readonly undo = this.button("Undo", "waypoints-undo", () => this.keep(this.poses.slice(0, -1)));
  private readonly clear = this.button("Clear", "waypoints-clear", () => this.keep([]));

  constructor(
    private readonly context: HandsContext,
    private readonly changed: () => void,
  ) {
    this.tool = new DragToolButton(
      context.app,
      {
        label: "Waypoints",
        hint: "Drag one pose after the other, then Go",
        test: "waypoints",
        isKept: true,
        onRelease: (from, to) => this.add(poseOfDrag(from, to, this.poses.at(-1) ?? robotPose(context))),
        placed: () => this.poses,
      },
      changed,
    );
    this.root = create("div", { class: "row waypoints" }, this.count, this.choice, this.go, this.undo, this.clear);
  }

  add(pose: Pose2): void {
    this.keep([...this.poses, pose]);
  }

  update(): void {
    this.tool.update();
    this.root.hidden = !this.tool.isTaken && this.poses.length === 0;
    setText(this.count, this.poses.length === 1 ? "1 waypoint" : `${this.poses.length} waypoints`);
    this.offerActions();
    this.go.disabled = this.poses.length === 0 || this.choice.value === "";
    this.undo.disabled = this.clear.disabled = this.poses.length === 0;
  }

  private offerActions(): void {
    const offered = Object.keys(ACTIONS).filter((action) =>
      offers(this.context.app, `${this.context.app.robot}/${action}/_action/send_goal`),
    ) as Action[];
    if (offered.join() === [...this.choice.options].map((option) => option.value).join()) return;
    this.choice.replaceChildren(...offered.map((action) => create("option", { value: action }, ACTIONS[action])));
  }

  private keep(poses: Pose2[]): void {
    this.poses = poses;
    this.changed();
  }

  private async send(): Promise<void> {
    const { poses } = this;
    const done = await this.context.run(`${poses.length} waypoints`, async () => {
      this.sent = await sendWaypoints(this.context, this.choice.value as Action, poses);
    });
    if (!done) return;
    this.tool.put();
    this.keep([]);
  }

  private button(label: string, test: string, onclick: () => void): HTMLButtonElement {
    return create("button", { type: "button", "data-test": test, onclick }, label);
  }
}
