import { Grid, type OccupancyGrid } from "../gl/grid";
import { TopicLayer, type Legend, type View } from "../layer";
import { put, secondsOf } from "../layer";
import { withOpacity, type Rgba } from "../palette";
import { compose, yawOf } from "../../source/transforms";

const OCCUPANCY_GRID = "nav_msgs/msg/OccupancyGrid";

abstract class GridLayer extends TopicLayer<OccupancyGrid> {
  private readonly grid: Grid;
  cells = 0;
  bounds: { x0: number; y0: number; x1: number; y1: number } | undefined;

  constructor(suffix: string, order: number) {
    super([suffix, OCCUPANCY_GRID]);
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

export class MapLayer extends GridLayer {
  readonly id = "map";
  readonly name = "Map";
  readonly legend: Legend = { shape: "area", colors: (palette) => [palette.occupied] };
  protected override readonly holdsFor = Infinity;
  protected override readonly isHeld = true;

  constructor() {
    super("/map", 0);
  }

  protected colors({ palette }: View): [Rgba, Rgba] {
    return [palette.free, palette.occupied];
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
