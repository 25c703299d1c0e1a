// The emergency stop: large, always there while a robot is, whatever time or tab is looked at. It presses and goes on pressing until the base
// says that the stop is in force; what is shown is what the base says. The release is a second control, and asks before.
import "../style/stop.css";
import type { App } from "../app";
import { make } from "./dom";
import { stopState, type BaseState, type GoalStatus, type StopState } from "./stop_state";
import { Wants } from "./wants";

const AGAIN_MS = 200;
const IN_FORCE_WITHIN_MS = 500; // from here to the base and back
const STALE_S = 1;
const LIFTED_BEFORE_MS = 100; // the button is up before the release is asked for

export function mountStopButton(root: HTMLElement, app: App): void {
  new StopButton(root, app);
}

class StopButton {
  private readonly wants: Wants;
  /** The robot that was told to stop, and since when it has not said that it is; undefined: there is none. */
  private pressing: { robot: string; since: number } | undefined;
  private isAsking = false;
  private said = "";

  private readonly button = make("button", { type: "button", className: "stop", onclick: () => this.press() }, "STOP");
  private readonly text = make("p", {});
  private readonly release = make("button", { type: "button", onclick: () => this.ask(true) }, "Release …");
  private readonly yes = make("button", { type: "button", onclick: () => void this.confirm() }, "The way is free: release");
  private readonly no = make("button", { type: "button", onclick: () => this.ask(false) }, "No");
  private readonly why = make("div", { className: "stop-why" }, this.text, this.release, this.yes, this.no);

  constructor(
    root: HTMLElement,
    private readonly app: App,
  ) {
    this.wants = new Wants(app);
    this.button.dataset.test = "stop";
    this.text.dataset.test = "stop-why";
    this.text.setAttribute("role", "alert");
    this.release.dataset.test = "stop-release";
    this.yes.dataset.test = "stop-release-yes";
    root.append(this.button, this.why);
    for (const event of ["source", "channels", "services", "message", "cursor", "status", "robot"] as const) app.on(event, () => this.update());
    setInterval(() => this.tick(), AGAIN_MS);
    this.update();
  }

  /** Newest, whatever time is looked at. */
  private state(): StopState {
    const { timeline, robot } = this.app;
    const base = timeline.at<BaseState>(`${robot}/base_state`, timeline.end);
    const override = timeline.at<{ data: boolean }>(`${robot}/manual_override`, timeline.end);
    const isFresh = base !== undefined && timeline.end - base.time < STALE_S;
    const goal = timeline.at<GoalStatus>(`${robot}/navigation_status`, timeline.end);
    return stopState(isFresh ? base.value : undefined, override?.value.data ?? false, goal?.value);
  }

  private press(): void {
    this.said = "";
    this.isAsking = false;
    this.pressing = { robot: this.app.robot, since: performance.now() };
    this.send(this.pressing.robot, true);
    this.update();
  }

  private send(robot: string, isPressed: boolean): void {
    this.app.hands.publish(`${robot}/emergency_stop`, "std_msgs/msg/Bool", { data: isPressed }).catch((reason) => {
      this.app.say("error", `STOP was not sent: ${reason instanceof Error ? reason.message : reason}`);
    });
  }

  private tick(): void {
    if (this.pressing && this.app.hands.canStop) this.send(this.pressing.robot, true);
    this.update();
  }

  private ask(isAsking: boolean): void {
    this.isAsking = isAsking;
    this.update();
  }

  private async confirm(): Promise<void> {
    const { robot, hands } = this.app;
    this.isAsking = false;
    this.pressing = undefined;
    this.send(robot, false);
    await new Promise((done) => setTimeout(done, LIFTED_BEFORE_MS));
    try {
      const { success, message } = await hands.call<{ success: boolean; message: string }>(`${robot}/release_stop`, {});
      this.said = success ? "" : `Not released: ${message}`;
      if (success) this.app.say("info", message);
    } catch (reason) {
      this.said = `Not released: ${reason instanceof Error ? reason.message : reason}`;
    }
    this.update();
  }

  private update(): void {
    const { app } = this;
    const isLive = app.source?.kind === "live";
    this.button.hidden = this.why.hidden = !isLive;
    this.wants.set(isLive ? ["base_state", "manual_override", "navigation_status"].map((topic) => `${app.robot}/${topic}`) : []);
    if (!isLive) return;
    const state = this.state();
    if (this.pressing && state.isInForce && this.pressing.robot === app.robot) this.pressing = undefined;
    const isLate = this.pressing !== undefined && performance.now() - this.pressing.since > IN_FORCE_WITHIN_MS;
    this.button.disabled = !app.hands.canStop;
    this.button.title = app.hands.canStop ? "Emergency stop of the robot" : app.hands.whyNot;
    this.button.classList.toggle("in-force", state.isInForce);
    this.show(isLate ? "NOT STOPPED: the base tells of no emergency stop. Use the switch of the base." : [state.text, this.said].filter(Boolean).join(". "));
    this.why.classList.toggle("alarm", isLate);
    const mayRelease = state.canRelease && app.hands.canCommand;
    this.isAsking &&= mayRelease;
    this.release.hidden = !mayRelease || this.isAsking;
    this.yes.hidden = this.no.hidden = !this.isAsking;
  }

  private show(text: string): void {
    if (this.text.textContent !== text) this.text.textContent = text;
    this.why.hidden = text === "";
  }
}
