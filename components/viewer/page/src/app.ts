// What the parts of the page share: where messages come from, what is kept of them, the time that is looked at, and the hands.
// A panel is a function `mount(root, app)`; it reads `app.timeline` at `app.cursor` and never asks whether the page is live or plays a bag.

/** Seconds since 1970 as a double: 0.2 us fine. */
export type Seconds = number;

export interface Channel {
  topic: string;
  type: string; // nav_msgs/msg/Odometry
  schema: string; // ros2msg text
  latched: boolean;
}

/** A decoded message of a topic. `value` has the fields of the ROS 2 message; stamps and durations are {sec, nanosec}. */
export interface Message<T = any> {
  topic: string;
  type: string;
  /** When it was received (live) or logged (bag). */
  time: Seconds;
  value: T;
}

/** Where messages come from: a live connection, or a bag. It tells of changes by `App.emit`, of trouble by `App.say`. */
export interface Source {
  readonly kind: "live" | "bag";
  /** ws://127.0.0.1:8765, or the name of the file. */
  readonly name: string;
  readonly timeline: Timeline;
  /** serverInfo.metadata: ROS_DISTRO, clock (wall, lockstep, topic), accept_inputs. Of a bag: its own. */
  readonly metadata: Record<string, string>;
  /** Of a live source alone. */
  readonly hands?: Hands;
  channels(): Channel[];
  /** Counted: each `want` has its `unwant`; what nobody wants is not asked for. `Wants` (page/wants.ts) does it for a panel. */
  want(topic: string): void;
  unwant(topic: string): void;
  /** Who publishes, hears and serves what; asked for at the first call, then kept up to date (event "graph"). */
  graph?(): ConnectionGraph | undefined;
  close(): void;
}

/** Full names of nodes, by topic or service. */
export interface ConnectionGraph {
  published: Record<string, string[]>;
  subscribed: Record<string, string[]>;
  services: Record<string, string[]>;
}

/** The messages: the last 60 s of a live source, all of a bag. Times are those of the robot's clock, simulated or not. */
export interface Timeline {
  /**
   * The newest message at or before `time`; undefined when there is none (or it is not loaded yet).
   * Of a latched topic that was heard later than `time`: its first message.
   */
  at<T = any>(topic: string, time: Seconds): Message<T> | undefined;
  /** Messages with from < time <= to, oldest first. */
  between<T = any>(topic: string, from: Seconds, to: Seconds): Message<T>[];
  /** What can be looked at; for a live source `end` is now on the robot's clock. Both are 0 while there is nothing. */
  readonly begin: Seconds;
  readonly end: Seconds;
  /** Pose of `source` in `target`, both frames of /tf; undefined when they are not connected then. */
  transform(target: string, source: string, time: Seconds): Pose2 | undefined;
  /** Frame the scene is drawn in: the root of the tree, map if there is one. */
  root(time: Seconds): string | undefined;
}

export interface Pose2 {
  x: number;
  y: number;
  theta: number;
}

/** The time that is looked at: the newest (live), or where a person put it (scrubbed, paused, a bag at its rate). */
export interface Cursor {
  readonly time: Seconds;
  /** Follows the newest message of a live source. */
  readonly isLive: boolean;
  readonly isPlaying: boolean;
  rate: number;
  seek(time: Seconds): void;
  step(by: Seconds): void;
  play(): void;
  pause(): void;
  /** Back to the newest. */
  goLive(): void;
}

/** Commands to a live robot. Each may be refused: the promise fails with the reason, which the page shows. */
export interface Hands {
  /** False: a bag, no connection, another one commands, or the server does not allow it. */
  readonly canCommand: boolean;
  /** Its emergency stop is heard though another one commands. */
  readonly canStop: boolean;
  readonly whyNot: string;
  /** Fields that are left out are zero. */
  publish(topic: string, type: string, value: object): Promise<void>;
  call<Response = any>(service: string, request: object): Promise<Response>;
  services(): { name: string; type: string }[];
}

/** "message" and "cursor" come at most once per frame of the screen, the others at once. */
export type Event = "source" | "channels" | "services" | "message" | "cursor" | "status" | "parameters" | "graph" | "robot";

export interface Status {
  level: "info" | "warning" | "error";
  text: string;
  time: Seconds;
}

export interface App {
  readonly source: Source | undefined;
  readonly timeline: Timeline;
  readonly cursor: Cursor;
  readonly hands: Hands;
  readonly metadata: Record<string, string>;
  /** Namespaces of the robots there are, "" or /robot1; and the one that is looked at and commanded. */
  readonly robots: string[];
  robot: string;
  /** Replaces what was shown. */
  open(source: Source): void;
  /** A line for people; errors stay until they are clicked away. */
  say(level: Status["level"], text: string): void;
  readonly statuses: readonly Status[];
  on(event: Event, listener: () => void): () => void;
  emit(event: Event): void;
  graph(): ConnectionGraph | undefined;
  /** What the scene draws instead of answering by itself: tools of the mouse (a goal, a pose, a person). */
  tool: Tool | undefined;
}

/** A press, drag and release on the ground of the scene, in the root frame. */
export interface Tool {
  name: string;
  /** Arrows that are drawn as long as the tool is set: waypoints that were dragged so far. */
  readonly placed?: readonly Pose2[];
  /** A line that is drawn in place of the drag's arrow. */
  readonly stroke?: readonly { x: number; y: number }[];
  onDrag(from: { x: number; y: number }, to: { x: number; y: number }, isReleased: boolean): void;
  onCancel(): void;
}
