// Has the robot explore until its map is closed, and stops it.
import { create } from "../dom";
import type { Hand, HandsContext } from "./context";

const BOOL = "std_msgs/msg/Bool";
const STRING = "std_msgs/msg/String";

/** Hidden where nobody explores. */
export class Explore implements Hand {
  readonly root: HTMLElement;

  constructor(private readonly context: HandsContext) {
    this.root = create("div", { class: "row" }, this.button("Explore", "explore", true), this.button("Stop exploring", "stop-exploring", false));
  }

  update(): void {
    const status = this.topic("status");
    const channels = this.context.app.source?.channels() ?? [];
    this.root.hidden = !channels.some(({ topic, type }) => topic === status && type === STRING);
  }

  private topic(name: string): string {
    return `${this.context.app.robot}/explore/${name}`;
  }

  private button(label: string, test: string, data: boolean): HTMLButtonElement {
    const onclick = () => void this.context.run(label, () => this.context.app.hands.publish(this.topic("resume"), BOOL, { data }));
    return create("button", { type: "button", "data-test": test, onclick }, label);
  }
}
