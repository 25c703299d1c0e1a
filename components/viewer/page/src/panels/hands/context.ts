// What the tools of the hands share.
import type { App, Pose2 } from "../../app";
import { framePrefix } from "../../page/robots";

export interface HandsContext {
  readonly app: App;
  /** Does it and says what came of it; a refusal is shown with its reason. True: done. */
  run(what: string, command: () => Promise<unknown>): Promise<boolean>;
  /** Says something about a command that needs no answer. */
  say(text: string, isError?: boolean): void;
}

/** A part of the hands: its elements, and what it looks like now. */
export interface Hand {
  readonly root: HTMLElement;
  /** After anything that may change it: what there is, who may command, which robot, which tool. */
  update(): void;
}

export function groundFrame(app: App): string {
  return app.timeline.root(app.timeline.end) ?? "map";
}

export function robotPose(context: HandsContext): Pose2 | undefined {
  const { timeline } = context.app;
  return timeline.transform(groundFrame(context.app), `${framePrefix(context.app.robot)}base_link`, timeline.end);
}

export function offers(app: App, service: string): boolean {
  return app.hands.services().some(({ name }) => name === service);
}

/** Full name of the first service of a type; undefined where nobody offers one. */
export function serviceOfType(app: App, type: string): string | undefined {
  return app.hands.services().find((service) => service.type === type)?.name;
}

/** For services that answer whether it worked, and why not. */
export function expectSuccess(response: { success: boolean; message?: string }): void {
  if (!response.success) throw new Error(response.message || "refused");
}
