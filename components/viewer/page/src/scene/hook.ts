// window.bandwagon: what the page shows, for tests in a browser. To be read only.
import type { App } from "../app";
import { toHex } from "./palette";
import type { SceneOnPage } from "./scene";

function connectionOf({ source, hands }: App): string {
  if (!source) return "none";
  if (source.kind === "bag") return "bag";
  if (source.channels().length > 0) return "live";
  return hands.whyNot.startsWith("No connection") ? "lost" : "connecting";
}

function drawnBy({ layers, frames, isOn }: SceneOnPage) {
  const { map, keepout, graph, people, candidates, band, laser, robot } = layers;
  const isShown = (id: string, object: { visible: boolean }) => object.visible && isOn.get(id) === true;
  return {
    map: isShown("map", map.object) ? map.cells : 0,
    bounds: map.bounds ?? null,
    keepout: isShown("keepout", keepout.object) ? keepout.kept : 0,
    graph: isShown("graph", graph.object) ? { nodes: graph.nodes, loops: graph.loops } : null,
    people: isShown("people", people.object) ? people.positions() : [],
    bands: isShown("candidates", candidates.object) ? candidates.count : 0,
    band: isShown("band", band.object) ? band.positions() : [],
    laser: isShown("laser", laser.object) ? laser.points : 0,
    robot: robot.pose ?? null,
    frames,
  };
}

export function exposeHook(app: App, scene: SceneOnPage): void {
  const hook = {
    get source() {
      return connectionOf(app);
    },
    get cursor() {
      const { time, isLive, isPlaying } = app.cursor;
      return { time, isLive, isPlaying };
    },
    get timeline() {
      return { begin: app.timeline.begin, end: app.timeline.end };
    },
    get drawn() {
      return drawnBy(scene);
    },
    get layers() {
      return Object.fromEntries(scene.isOn);
    },
    get colours() {
      const { occupied, people, speed, robot, laser, goal } = scene.view.palette;
      const [map, theirs, its, scan, target] = [occupied, people, robot, laser, goal].map(toHex);
      return { map, people: theirs, band: speed.map(toHex), robot: its, laser: scan, goal: target };
    },
    toScreen: (x: number, y: number) => {
      const at = scene.viewpoint.toScreen(x, y);
      const box = document.querySelector("#scene canvas")!.getBoundingClientRect();
      return { x: at.x + box.left, y: at.y + box.top };
    },
    get statuses() {
      return app.statuses.map(({ level, text }) => ({ level, text }));
    },
    get canCommand() {
      return app.hands.canCommand;
    },
    get whyNot() {
      return app.hands.whyNot;
    },
  };
  Object.defineProperty(window, "bandwagon", { value: hook });
}
