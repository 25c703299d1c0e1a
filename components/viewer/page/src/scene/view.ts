// What the layers see of the app.
import type { App, Message, Pose2, Seconds } from "../app";
import { framePrefix, topicOf } from "../page/robots";
import type { View } from "./layer";
import type { Palette } from "./palette";

const TF_MESSAGE = "tf2_msgs/msg/TFMessage";
const BASES = ["base_link", "base_footprint"];

export class SceneView implements View {
  time: Seconds = 0;
  root = "map";
  base = "base_link";
  lift = 0;
  private topics = new Map<string, string | undefined>();

  constructor(private readonly app: App, public palette: Palette) {}

  get robot(): string {
    return this.app.robot;
  }

  /** Before the layers draw. */
  look(): void {
    this.time = this.app.cursor.time;
    this.root = this.app.timeline.root(this.time) ?? "map";
    const names = BASES.map((name) => framePrefix(this.robot) + name);
    this.base = names.find((name) => this.place(name, this.time) !== undefined) ?? names[0]!;
  }

  forgetTopics(): void {
    this.topics.clear();
  }

  transformTopics(): string[] {
    const channels = this.app.source?.channels() ?? [];
    return channels.filter(({ type }) => type === TF_MESSAGE).map(({ topic }) => topic);
  }

  topic(suffix: string, type: string): string | undefined {
    const key = `${suffix} ${type}`;
    if (!this.topics.has(key)) this.topics.set(key, topicOf(this.app.source?.channels() ?? [], this.robot, suffix, type));
    return this.topics.get(key);
  }

  /** Of a robot that is gone for a while the last messages are still there: by the name the topic would have. */
  message<T>(suffix: string, type: string): Message<T> | undefined {
    const topic = this.topic(suffix, type) ?? this.robot + suffix;
    const message = this.app.timeline.at<T>(topic, this.time);
    return message?.type === type ? message : undefined;
  }

  place(frame: string, time: Seconds): Pose2 | undefined {
    return this.app.timeline.transform(this.root, frame, time);
  }
}
