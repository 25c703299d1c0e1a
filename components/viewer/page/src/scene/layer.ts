// A layer of the scene: what it hears, and what it makes of it.
import { Group, type Object3D } from "three";
import type { Message, Pose2, Seconds } from "../app";
import type { Palette, Rgba } from "./palette";

/** What a layer sees while it draws. */
export interface View {
  readonly time: Seconds;
  /** Frame the scene is drawn in. */
  readonly root: string;
  /** Namespace of the robot that is looked at, and its frames. */
  readonly robot: string;
  readonly base: string;
  readonly palette: Palette;
  /** Metres up per second ahead; 0 but where time is shown upward. */
  readonly lift: number;
  /** Topic of this robot, or that which all share. */
  topic(suffix: string, type: string): string | undefined;
  message<T>(suffix: string, type: string): Message<T> | undefined;
  /** Pose of a frame in the root frame. */
  place(frame: string, time: Seconds): Pose2 | undefined;
}

export type Wanted = readonly [suffix: string, type: string];

/** What a row of the legend shows beside the name. */
export interface Legend {
  colors: (palette: Palette) => readonly Rgba[];
  shape: "line" | "disc" | "area" | "points" | "ring" | "scale";
  /** Units, and what is not seen by itself. */
  note?: string;
}

export interface Layer {
  readonly id: string;
  readonly name: string;
  readonly legend: Legend;
  readonly isOnAtStart: boolean;
  readonly object: Object3D;
  readonly wants: readonly Wanted[];
  /** Called when anything may have changed while the layer is on; true when it looks different now. */
  update(view: View): boolean;
}

export interface Header {
  stamp: { sec: number; nanosec: number };
  frame_id: string;
}

export function secondsOf({ sec, nanosec }: { sec: number; nanosec: number }): Seconds {
  return sec + nanosec / 1e9;
}

/** Out of sight without a pose; true when that changes anything. */
export function put(object: Object3D, pose: Pose2 | undefined): boolean {
  const { visible, position, rotation } = object;
  object.visible = pose !== undefined;
  if (!pose) return visible;
  if (visible && position.x === pose.x && position.y === pose.y && rotation.z === pose.theta) return false;
  position.set(pose.x, pose.y, 0);
  rotation.z = pose.theta;
  return true;
}

/** A layer of one topic: drawn in the frame of its message when there is another one, placed at each update. */
export abstract class TopicLayer<T> implements Layer {
  abstract readonly id: string;
  abstract readonly name: string;
  abstract readonly legend: Legend;
  readonly isOnAtStart: boolean = true;
  readonly object = new Group();
  readonly wants: readonly Wanted[];
  /** [s] what is older is not shown. */
  protected readonly holdsFor: Seconds = 2;
  private drawn: Message<T> | undefined;
  private drawnWith: { palette: Palette; lift: number } | undefined;

  constructor(
    private readonly wanted: Wanted,
    more: readonly Wanted[] = [],
  ) {
    this.wants = [wanted, ...more];
  }

  update(view: View): boolean {
    const message = this.current(view);
    const { palette, lift } = view;
    const isDue = message && (message !== this.drawn || palette !== this.drawnWith?.palette || lift !== this.drawnWith.lift);
    if (isDue) {
      this.draw(message.value, view);
      this.drawnWith = { palette, lift };
    }
    this.drawn = message;
    const header = message && this.headerOf(message.value);
    const pose = header && view.place(header.frame_id, this.isHeld ? view.time : secondsOf(header.stamp));
    return put(this.object, pose) || isDue === true;
  }

  /** What is fixed to its frame moves on with it between two messages. */
  protected readonly isHeld: boolean = false;

  protected headerOf(value: T): Header | undefined {
    return (value as { header: Header }).header;
  }

  protected current(view: View): Message<T> | undefined {
    const message = view.message<T>(...this.wanted);
    return message && view.time - message.time <= this.holdsFor ? message : undefined;
  }

  protected abstract draw(value: T, view: View): void;
}
