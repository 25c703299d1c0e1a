// Cancel, pause, resume, and how the goal in hand is getting on.
import { Wants } from "../../page/wants";
import { create, setText } from "../dom";
import { expectSuccess, offers, type Hand, type HandsContext } from "./context";
import { statusText, type NavigationStatus } from "./navigation_status";
import type { ActionGoal } from "./waypoints";

/** nav2_msgs/srv/ManageLifecycleNodes */
const PAUSE = 1;
const RESUME = 2;

/** Ends the goal in hand, whoever set it. Ours is canceled as an action, so that it ends as canceled and not as aborted. */
export async function cancel(context: HandsContext, sent: ActionGoal | undefined): Promise<void> {
  const { hands } = context.app;
  if (sent !== undefined) {
    const request = { goal_info: { goal_id: { uuid: sent.id }, stamp: { sec: 0, nanosec: 0 } } };
    const { return_code } = await hands.call<{ return_code: number }>(sent.service, request);
    if (return_code === 0) return;
  }
  await hands.publish(`${context.app.robot}/cancel_goal`, "std_msgs/msg/Empty", {});
}

export class DriveControl implements Hand {
  private readonly cancelButton = this.button("Cancel goal", "cancel", () => this.cancel());
  private readonly pauseButton = this.button("Pause", "pause-robot", () => this.manage("Pause", PAUSE));
  private readonly resumeButton = this.button("Resume", "resume-robot", () => this.manage("Resume", RESUME));
  private readonly status = create("p", { class: "navigation", role: "status", "data-test": "navigation-status" });
  readonly root = create(
    "div",
    {},
    create("div", { class: "row" }, this.cancelButton, this.pauseButton, this.resumeButton),
    this.status,
  );
  private readonly wants: Wants;

  constructor(
    private readonly context: HandsContext,
    private readonly sent: () => ActionGoal | undefined,
    private readonly forgetSent: () => void,
  ) {
    this.wants = new Wants(context.app);
  }

  update(): void {
    const manager = offers(this.context.app, this.manager());
    this.pauseButton.disabled = this.resumeButton.disabled = !manager;
    this.pauseButton.title = manager ? "Deactivates navigation: the robot comes to rest, and its goal is canceled" : "no lifecycle manager is there";
    this.showStatus();
  }

  /** Cheap: with every message. */
  showStatus(): void {
    const { app } = this.context;
    const topic = `${this.context.app.robot}/navigation_status`;
    this.wants.set([topic]);
    const message = app.timeline.at<NavigationStatus>(topic, app.cursor.time);
    setText(this.status, message === undefined ? "No goal yet" : statusText(message.value));
  }

  private cancel(): void {
    void this.context.run("Cancel", () => cancel(this.context, this.sent())).then((done) => {
      if (done) this.forgetSent();
    });
  }

  private manage(what: string, command: number): void {
    void this.context.run(what, async () => expectSuccess(await this.context.app.hands.call(this.manager(), { command })));
  }

  private manager(): string {
    return `${this.context.app.robot}/lifecycle_manager_navigation/manage_nodes`;
  }

  private button(label: string, test: string, onclick: () => void): HTMLButtonElement {
    return create("button", { type: "button", "data-test": test, onclick }, label);
  }
}
