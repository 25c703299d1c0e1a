import type { App } from "../../app";
import { BandLayer } from "./band";
import { CandidatesLayer } from "./candidates";
import { ConesLayer } from "./cones";
import { GoalLayer } from "./goal";
import { GraphLayer } from "./graph";
import { LaserLayer } from "./laser";
import { CostmapLayer, KeepoutLayer, MapLayer } from "./map";
import { ParticlesLayer } from "./particles";
import { PeopleLayer } from "./people";
import { PlanLayer } from "./plan";
import { PoseLayer } from "./pose";
import { PredictionsLayer } from "./predictions";
import { RobotLayer } from "./robot";
import { TrailLayer } from "./trail";
import { ZonesLayer } from "./zones";

/** In the order of the legend. */
export function makeLayers(app: App) {
  return {
    robot: new RobotLayer(() => app.robots),
    trail: new TrailLayer(() => app.timeline.begin),
    goal: new GoalLayer(),
    plan: new PlanLayer(),
    band: new BandLayer(),
    candidates: new CandidatesLayer(),
    people: new PeopleLayer(),
    predictions: new PredictionsLayer(),
    cones: new ConesLayer(),
    zones: new ZonesLayer(),
    laser: new LaserLayer(),
    costmap: new CostmapLayer(),
    keepout: new KeepoutLayer(),
    map: new MapLayer(),
    graph: new GraphLayer(),
    pose: new PoseLayer(),
    particles: new ParticlesLayer(),
  };
}

export type Layers = ReturnType<typeof makeLayers>;
