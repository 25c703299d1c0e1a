// Keeps the map, or the part of it that was chosen, as a file that map_server reads, and the keep-out zones beside it.
import { create } from "../dom";
import { expectSuccess, offers, serviceOfType, type Hand, type HandsContext } from "./context";
import type { MapPart } from "./crop";

const SAVE_MAP = "slam_toolbox/srv/SaveMap";
const NO_MAP = 1;

/** Hidden where nobody saves anything. */
export class SaveMap implements Hand {
  readonly root: HTMLElement;
  private readonly name = create("input", { type: "text", value: "map", size: 14, "data-test": "map-name" });
  private readonly map = create("button", { type: "submit", "data-test": "save-map" }, "Save map");
  private readonly zones = create("button", { type: "button", "data-test": "save-zones", onclick: () => void this.save("Zones of") }, "Save zones");

  /** `part` of the map alone is saved; undefined: all of it. */
  constructor(
    private readonly context: HandsContext,
    private readonly part: () => MapPart | undefined,
  ) {
    const onsubmit = (event: Event) => {
      event.preventDefault();
      void this.save("Map");
    };
    this.root = create("form", { class: "row", onsubmit }, create("label", {}, create("span", {}, "Map"), this.name), this.map, this.zones);
  }

  update(): void {
    const { app } = this.context;
    this.map.hidden = serviceOfType(app, SAVE_MAP) === undefined && !offers(app, this.saver("map_saver"));
    this.zones.hidden = !this.hasZones;
    this.root.hidden = this.map.hidden && this.zones.hidden;
  }

  private async save(what: "Map" | "Zones of"): Promise<void> {
    const name = this.name.value.trim();
    if (name === "") return this.name.focus();
    const done = await this.context.run(`${what} ${name}`, async () => {
      if (what === "Map") await this.saveMap(name);
      if (this.hasZones) await this.ask("keepout_filter_mask_saver", `${name}_keepout`);
    });
    if (done) this.context.say(`${what} ${name}: saved`);
  }

  /** Who makes the map finishes it before it is saved whole. */
  private async saveMap(name: string): Promise<void> {
    const { app } = this.context;
    const service = serviceOfType(app, SAVE_MAP);
    if (service === undefined || this.part() !== undefined) return this.ask("map_saver", name);
    const { result } = await app.hands.call<{ result: number }>(service, { name: { data: name } });
    if (result === NO_MAP) throw new Error("there is no map yet");
    this.expectSaved(result === 0);
  }

  private async ask(node: string, url: string): Promise<void> {
    const { hands } = this.context.app;
    const part = this.part();
    const request = { map_topic: "", map_url: url };
    if (part === undefined) this.expectSaved((await hands.call<{ result: boolean }>(this.saver(node), request)).result);
    else expectSuccess(await hands.call(`${this.saver(node)}_part`, { ...request, ...part }));
  }

  private expectSaved(isSaved: boolean): void {
    if (!isSaved) throw new Error("not saved: the log says why; a map of that name may be there");
  }

  private get hasZones(): boolean {
    return offers(this.context.app, this.saver("keepout_filter_mask_saver"));
  }

  private saver(node: string): string {
    return `${this.context.app.robot}/${node}/save_map`;
  }
}
