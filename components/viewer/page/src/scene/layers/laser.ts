import { Discs } from "../gl/discs";
import { TopicLayer, type Header, type Legend, type View } from "../layer";

interface LaserScan {
  header: Header;
  angle_min: number;
  angle_increment: number;
  range_min: number;
  range_max: number;
  ranges: Float32Array;
}

const LEAST_PIXELS = 3;

/** Where the laser was reflected; what lies outside its range is no reflection. */
export class LaserLayer extends TopicLayer<LaserScan> {
  readonly id = "laser";
  readonly name = "Laser";
  readonly legend: Legend = { shape: "points", colors: (palette) => [palette.laser] };
  protected override readonly holdsFor = 1;
  private readonly discs = new Discs(60);

  constructor() {
    super(["/scan", "sensor_msgs/msg/LaserScan"]);
    this.object.add(this.discs.mesh);
  }

  get points(): number {
    return this.object.visible ? this.discs.count : 0;
  }

  protected draw(scan: LaserScan, { palette }: View): void {
    this.discs.clear();
    scan.ranges.forEach((range, i) => {
      if (!(range >= scan.range_min && range < scan.range_max)) return;
      const angle = scan.angle_min + i * scan.angle_increment;
      this.discs.add({ x: range * Math.cos(angle), y: range * Math.sin(angle), a: 0, b: 0 }, palette.laser, undefined, 0, LEAST_PIXELS);
    });
    this.discs.done();
  }
}
