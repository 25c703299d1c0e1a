import { Grid, type OccupancyGrid } from "../gl/grid";
import type { Message } from "../../app";
import { TopicLayer, type Legend, type View, type Wanted } from "../layer";
import { put, secondsOf } from "../layer";
import { withOpacity, type Rgba } from "../palette";
import { compose, yawOf } from "../../source/transforms";

const OCCUPANCY_GRID = "nav_msgs/msg/OccupancyGrid";

abstract class GridLayer extends TopicLayer<OccupancyGrid> {
  private readonly grid: Grid;
  cells = 0;
  bounds: { x0: number; y0: number; x1: number; y1: number } | undefined;

  constructor(suffix: string, order: number, more: readonly Wanted[] = []) {
    super([suffix, OCCUPANCY_GRID], more);
    this.grid = new Grid(order);
    this.object.add(this.grid.mesh);
  }

  protected abstract colors(view: View): [low: Rgba, high: Rgba];

  protected draw(value: OccupancyGrid, view: View): void {
    const { origin, width, height, resolution } = value.info;
    this.grid.set(value, ...this.colors(view));
    this.cells = width * height;
    const { x, y } = origin.position;
    put(this.grid.mesh, compose({ x: 0, y: 0, theta: 0 }, { x, y, theta: yawOf(origin.orientation) }));
    this.bounds = { x0: x, y0: y, x1: x + width * resolution, y1: y + height * resolution };
    this.stamp = secondsOf(value.header.stamp);
  }

  stamp = 0;
}

const UPDATE = "map_msgs/msg/OccupancyGridUpdate";

interface Update {
  header: { frame_id: string };
  x: number;
  y: number;
  width: number;
  height: number;
  data: Int8Array;
}

/** The map with a part of it exchanged; undefined when the part is not of this map. */
export function laidInto(map: OccupancyGrid, part: Update): OccupancyGrid | undefined {
  const { width, height } = map.info;
  const fits = part.x >= 0 && part.y >= 0 && part.x + part.width <= width && part.y + part.height <= height;
  if (!fits || part.data.length !== part.width * part.height || map.data.length !== width * height) return undefined;
  if (part.header.frame_id !== map.header.frame_id) return undefined;
  const data = new Int8Array(map.data);
  for (let row = 0; row < part.height; ++row) {
    data.set(part.data.subarray(row * part.width, (row + 1) * part.width), (part.y + row) * width + part.x);
  }
  return { ...map, data };
}

/** The map, and what slam says has changed since: its updates hold all that did, so that the newest is enough. */
export class MapLayer extends GridLayer {
  readonly id = "map";
  readonly name = "Map";
  readonly legend: Legend = { shape: "area", colors: (palette) => [palette.occupied] };
  protected override readonly holdsFor = Infinity;
  protected override readonly isHeld = true;

  private laid: { map: unknown; part: unknown; result: Message<OccupancyGrid> } | undefined;

  constructor() {
    super("/map", 0, [["/map_updates", UPDATE]]);
  }

  protected override current(view: View): Message<OccupancyGrid> | undefined {
    const map = super.current(view);
    const part = view.message<Update>("/map_updates", UPDATE);
    if (!map || !part || part.time < map.time) return map;
    if (this.laid?.map !== map || this.laid.part !== part) {
      const value = laidInto(map.value, part.value);
      this.laid = { map, part, result: value ? { ...map, value } : map };
    }
    return this.laid.result;
  }

  protected colors({ palette }: View): [Rgba, Rgba] {
    return [palette.free, palette.occupied];
  }
}

/** Where the robot may not be: the mask of Nav2's keepout filter. */
export class KeepoutLayer extends GridLayer {
  readonly id = "keepout";
  readonly name = "Keep-out zones";
  readonly legend: Legend = { shape: "area", colors: (palette) => [withOpacity(palette.zoneStopped, 0.5)] };
  protected override readonly holdsFor = Infinity;
  protected override readonly isHeld = true;
  /** Cells that keep the robot out. */
  kept = 0;

  constructor() {
    super("/keepout_filter_mask", 11);
  }

  protected override draw(value: OccupancyGrid, view: View): void {
    super.draw(value, view);
    this.kept = value.data.reduce((sum, cell) => sum + Number(cell >= 65), 0);
  }

  protected colors({ palette }: View): [Rgba, Rgba] {
    return [withOpacity(palette.zoneStopped, 0), withOpacity(palette.zoneStopped, 0.5)];
  }
}

export class CostmapLayer extends GridLayer {
  readonly id = "costmap";
  readonly name = "Local costmap";
  readonly legend: Legend = { shape: "area", colors: (palette) => [palette.cost], note: "cost 0 to 100" };

  constructor() {
    super("/local_costmap", 10);
  }

  protected colors({ palette }: View): [Rgba, Rgba] {
    return [withOpacity(palette.cost, 0), withOpacity(palette.cost, 0.62)];
  }
}
