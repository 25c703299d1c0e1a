// What the strip shows, gathered from messages in the order of their times: curves, and marks of what happened.
import type { Channel, Message, Seconds } from "../app";
import { topicOf } from "../page/robots";
import { isConfirmed } from "../scene/confirmed";

export interface Curve {
  times: Seconds[];
  values: number[]; // null where there is nothing to show is not kept: NaN
}

export type Kind = "goal" | "reached" | "ended" | "switch" | "contact";

export interface Mark {
  time: Seconds;
  kind: Kind;
  text: string;
}

/** Of two neighbours, where there are too many, that stays which a person must not miss. */
const KEEP = { measured: Math.max, commanded: Math.max, person: Math.min, index: Math.max, cycle: Math.max, budget: Math.min };
export type CurveName = keyof typeof KEEP;
const MOST_POINTS = 100_000;
const MOST_MARKS = 2000;

const TOPICS = {
  odom: ["/odom", "nav_msgs/msg/Odometry"],
  command: ["/cmd_vel", "geometry_msgs/msg/Twist"],
  stampedCommand: ["/cmd_vel", "geometry_msgs/msg/TwistStamped"],
  comfort: ["/comfort", "bandwagon_msgs/msg/Comfort"],
  cycle: ["/local_planner_cycle", "bandwagon_msgs/msg/PlannerCycle"],
  navigation: ["/navigation_status", "bandwagon_msgs/msg/NavigationStatus"],
  truth: ["/sim/ground_truth", "bandwagon_msgs/msg/GroundTruth"],
  tracks: ["/tracks", "bandwagon_msgs/msg/Tracks"],
} as const;
type Role = keyof typeof TOPICS;

/** Of a bag that has no /comfort: from the truth, else from the tracks. */
const STANDS_IN: [Role, Role][] = [
  ["truth", "comfort"],
  ["tracks", "comfort"],
  ["tracks", "truth"],
];

/** Topics that are there, by what they are for. */
export function rolesOf(channels: readonly Channel[], robot: string): Map<string, Role> {
  const found = new Map<Role, string>();
  for (const [role, [suffix, type]] of Object.entries(TOPICS) as [Role, readonly [string, string]][]) {
    const topic = topicOf(channels, robot, suffix, type);
    if (topic !== undefined) found.set(role, topic);
  }
  for (const [role, better] of STANDS_IN) if (found.has(better)) found.delete(role);
  return new Map([...found].map(([role, topic]) => [topic, role]));
}

/** components/evaluation/collision_index.hpp: half the comfortable distance [m]. */
const SIGMA = 0.6;
const STATUS = { accepted: 1, executing: 2, succeeded: 4, canceled: 5, aborted: 6 };

interface Place {
  x: number;
  y: number;
}

export class StripData {
  readonly curves: Record<CurveName, Curve>;
  readonly marks: Mark[] = [];
  /** What the curve of the planner's cycle is: its time, or, in virtual time, its iterations as a share of their budget. */
  cycleIs: "ms" | "share" = "ms";
  /** Distances come from the robot's centre, because nobody told its rim. */
  isFromCentre = false;
  #robot: (Place & { frame: string }) | undefined;
  #contacts: number | undefined;
  #goal = { id: -1n, status: 0 };

  constructor() {
    this.curves = Object.fromEntries(Object.keys(KEEP).map((name) => [name, { times: [], values: [] }])) as never;
  }

  add(role: Role, { time, value }: Message): void {
    if (role === "odom") this.#addOdometry(time, value);
    else if (role === "command") this.#push("commanded", time, value.linear.x);
    else if (role === "stampedCommand") this.#push("commanded", time, value.twist.linear.x);
    else if (role === "comfort") this.#addComfort(time, value);
    else if (role === "cycle") this.#addCycle(time, value);
    else if (role === "navigation") this.#addNavigation(time, value);
    else if (role === "truth") this.#addTruth(time, value);
    else this.#addTracks(time, value);
  }

  forgetBefore(time: Seconds): void {
    for (const curve of Object.values(this.curves)) {
      const first = curve.times.findIndex((t) => t >= time);
      const count = first < 0 ? curve.times.length : first;
      curve.times.splice(0, count);
      curve.values.splice(0, count);
    }
    while (this.marks.length > 0 && this.marks[0]!.time < time) this.marks.shift();
  }

  /** The newest value at or before `time`, not older than `age`. */
  valueAt(name: CurveName, time: Seconds, age: Seconds = 1): number | undefined {
    const { times, values } = this.curves[name];
    let low = 0;
    let high = times.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (times[middle]! <= time) low = middle + 1;
      else high = middle;
    }
    return low > 0 && times[low - 1]! >= time - age ? values[low - 1] : undefined;
  }

  #push(name: CurveName, time: Seconds, value: number): void {
    const { times, values } = this.curves[name];
    times.push(time);
    values.push(Number.isFinite(value) ? value : NaN);
    if (times.length <= MOST_POINTS) return;
    const half = times.length >> 1;
    for (let i = 0; i < half; ++i) {
      times[i] = times[2 * i]!;
      const [a, b] = [values[2 * i]!, values[2 * i + 1]!];
      values[i] = Number.isNaN(a) ? b : Number.isNaN(b) ? a : KEEP[name](a, b);
    }
    times.length = values.length = half;
  }

  #mark(time: Seconds, kind: Kind, text: string): void {
    this.marks.push({ time, kind, text });
    if (this.marks.length > MOST_MARKS) this.marks.shift();
  }

  #addOdometry(time: Seconds, odometry: any): void {
    const { x, y } = odometry.pose.pose.position;
    this.#robot = { x, y, frame: odometry.header.frame_id };
    this.#push("measured", time, odometry.twist.twist.linear.x);
  }

  #addComfort(time: Seconds, comfort: any): void {
    this.#push("person", time, comfort.closest_person_m);
    this.#push("index", time, comfort.collision_index);
    this.#countContacts(time, comfort.contacts);
  }

  #addCycle(time: Seconds, cycle: any): void {
    const isMeasured = Number.isFinite(cycle.duration_ms);
    this.cycleIs = isMeasured ? "ms" : "share";
    const share = cycle.iteration_budget > 0 ? cycle.iterations / cycle.iteration_budget : NaN;
    this.#push("cycle", time, isMeasured ? cycle.duration_ms : 100 * share);
    this.#push("budget", time, isMeasured ? cycle.budget_ms : 100);
    if (cycle.class_switched) this.#mark(time, "switch", `class ${cycle.chosen_label || "other"}`);
  }

  #addNavigation(time: Seconds, { goal_id, status, reason, navigation_time }: any): void {
    const id = BigInt(goal_id);
    const isNew = id !== this.#goal.id;
    if (!isNew && status === this.#goal.status) return;
    // Who comes later hears of the goal in hand, and when it was taken up.
    const since = navigation_time.sec + navigation_time.nanosec / 1e9;
    if (isNew && status < STATUS.succeeded) this.#mark(time - since, "goal", "goal");
    if (status === STATUS.succeeded) this.#mark(time, "reached", "reached");
    if (status === STATUS.canceled) this.#mark(time, "ended", "canceled");
    if (status === STATUS.aborted) this.#mark(time, "ended", reason ? `aborted: ${reason}` : "aborted");
    this.#goal = { id, status };
  }

  #addTruth(time: Seconds, truth: any): void {
    this.#addPeople(
      time,
      truth.pose.position,
      truth.people.map((p: any) => ({ ...p.position, radius: p.radius })),
    );
    this.#countContacts(time, truth.contacts);
  }

  #addTracks(time: Seconds, tracks: any): void {
    if (this.#robot?.frame !== tracks.header.frame_id) return;
    this.#addPeople(
      time,
      this.#robot!,
      tracks.tracks.filter(isConfirmed).map((t: any) => ({ ...t.position, radius: t.radius })),
    );
  }

  #addPeople(time: Seconds, robot: Place, people: (Place & { radius: number })[]): void {
    this.isFromCentre = true;
    let closest = Infinity;
    let index = 0;
    for (const person of people) {
      const distance = Math.hypot(person.x - robot.x, person.y - robot.y);
      closest = Math.min(closest, distance - person.radius);
      index = Math.max(index, Math.exp(-(distance * distance) / (2 * SIGMA * SIGMA)));
    }
    this.#push("person", time, closest);
    this.#push("index", time, index);
  }

  #countContacts(time: Seconds, contacts: number): void {
    if (this.#contacts !== undefined && contacts > this.#contacts) this.#mark(time, "contact", "contact");
    this.#contacts = contacts;
  }
}
