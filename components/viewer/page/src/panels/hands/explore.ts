// Lets the robot drive to where its map ends, and stops it.
import { create } from "../dom";
import { expectSuccess, type Hand, type HandsContext } from "./context";

/** Hidden where nobody explores. */
export class Explore implements Hand {
  readonly root: HTMLElement;

  constructor(private readonly context: HandsContext) {
    this.root = create(
      "div",
      { class: "row" },
      this.button("Explore", "explore", true),
      this.button("Stop exploring", "stop-exploring", false),
    );
  }

  update(): void {
    this.root.hidden = this.service() === undefined;
  }

  private button(label: string, test: string, data: boolean): HTMLElement {
    return create(
      "button",
      { type: "button", "data-test": test, onclick: () => void this.context.run(label, () => this.ask(data)) },
      label,
    );
  }

  private service(): string | undefined {
    const name = `${this.context.app.robot}/explore/enable`;
    return this.context.app.hands.services().find((service) => service.name === name)?.name;
  }

  private async ask(data: boolean): Promise<void> {
    const service = this.service();
    if (service === undefined) throw new Error("nobody explores any more");
    expectSuccess(await this.context.app.hands.call<{ success: boolean; message: string }>(service, { data }));
  }
}
