// The robot's radius, from the parameters of its planner: those of the section `robot` are the same everywhere.
import type { App } from "../app";

const asked = new Set<string>();

/** Asks each robot once; one that does not answer keeps the usual outline. */
export async function askRadius(app: App, onRadius: (robot: string, radius: number) => void): Promise<void> {
  for (const { name } of app.hands.services()) {
    const [, robot] = /^(.*)\/local_planner\/get_parameters$/.exec(name) ?? [];
    const key = `${app.source?.name} ${robot}`;
    if (robot === undefined || asked.has(key)) continue;
    asked.add(key);
    try {
      const { values } = await app.hands.call<{ values: { double_value: number }[] }>(name, { names: ["robot.radius"] });
      const radius = values[0]?.double_value ?? 0;
      if (radius > 0) onRadius(robot, radius);
    } catch {
      asked.delete(key); // when services change it is asked anew
    }
  }
}
