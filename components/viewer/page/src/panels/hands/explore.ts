// Lets the robot drive to where its map ends, and stops it.
import { create } from "../dom";
import type { Hand, HandsContext } from "./context";

/** Hidden where nobody explores. */
export class Explore implements Hand {
  readonly root: HTMLElement;

  constructor(private readonly context: HandsContext) {
    this.root = create("div", { class: "row" }, this.button("Explore", "explore", true), this.button("Stop exploring", "stop-exploring", false));
  }

  update(): void {
    const { app } = this.context;
    this.root.hidden = !(app.source?.channels() ?? []).some(({ topic }) => topic === `${app.robot}/explore/status`);
  }

  private button(label: string, test: string, data: boolean): HTMLElement {
    const { app } = this.context;
    const tell = () => this.context.run(label, () => app.hands.publish(`${app.robot}/explore/resume`, "std_msgs/msg/Bool", { data }));
    return create("button", { type: "button", "data-test": test, onclick: () => void tell() }, label);
  }
}
