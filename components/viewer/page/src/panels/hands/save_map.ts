// Keeps the map that slam makes, as a file that map_server reads.
import { create } from "../dom";
import { serviceOfType, type Hand, type HandsContext } from "./context";

const SAVE_MAP = "slam_toolbox/srv/SaveMap";
const NO_MAP = 1;

/** Hidden where nobody makes a map. */
export class SaveMap implements Hand {
  readonly root: HTMLElement;
  private readonly name = create("input", { type: "text", value: "map", size: 14, "data-test": "map-name" });

  constructor(private readonly context: HandsContext) {
    this.root = create(
      "form",
      {
        class: "row",
        onsubmit: (event: Event) => {
          event.preventDefault();
          void this.save();
        },
      },
      create("label", {}, create("span", {}, "Map"), this.name),
      create("button", { type: "submit", "data-test": "save-map" }, "Save map"),
    );
  }

  update(): void {
    this.root.hidden = serviceOfType(this.context.app, SAVE_MAP) === undefined;
  }

  private async save(): Promise<void> {
    const name = this.name.value.trim();
    if (name === "") return this.name.focus();
    const done = await this.context.run(`Map ${name}`, () => this.ask(name));
    if (done) this.context.say(`Map ${name}: saved`);
  }

  private async ask(name: string): Promise<void> {
    const { app } = this.context;
    const service = serviceOfType(app, SAVE_MAP);
    if (service === undefined) throw new Error("nobody makes a map any more");
    const { result } = await app.hands.call<{ result: number }>(service, { name: { data: name } });
    if (result === NO_MAP) throw new Error("there is no map yet");
    if (result !== 0) throw new Error("not saved: the log says why; a map of that name may be there");
  }
}
