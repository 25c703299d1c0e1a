// The last 60 s of a live source.
import type { Message, Pose2, Seconds, Timeline } from "../app";
import { decode } from "./decode";
import { MessageLog } from "./message_log";
import { Transforms, type TransformStamped } from "./transforms";

export const KEPT = 60; // [s]
const MOST_BYTES = 96e6; // of all messages; beyond it the largest topic loses its older half
const TRIM_PERIOD = 1; // [s]
const JUMP_BACK = 1; // [s] the clock of a simulation that began anew; less than that is the network's disorder

export class LiveTimeline implements Timeline {
  end: Seconds = 0;
  private first: Seconds = 0;
  private trimmed: Seconds = 0;
  private hasClock = false;
  private readonly logs = new Map<string, MessageLog>();
  private readonly transforms = new Transforms();

  constructor(private readonly onBroken: (topic: string, reason: string) => void) {}

  get begin(): Seconds {
    return Math.max(this.first, this.end - KEPT);
  }

  /** The robot's clock, where the server tells it. */
  setClock(time: Seconds): void {
    this.hasClock = true;
    this.setTime(time);
  }

  private setTime(time: Seconds): void {
    if (this.end > 0 && time < this.end - JUMP_BACK) this.jumpBack();
    if (this.end === 0) this.first = time;
    this.end = Math.max(this.end, time);
    if (this.end > this.trimmed + TRIM_PERIOD) this.trim();
  }

  /**
   * What is latched may be as old as it likes: its time says nothing about now. Where there is a clock, a message that comes late is put where it
   * belongs, and only the clock goes back.
   */
  add(channel: { topic: string; type: string; schema: string; latched: boolean }, time: Seconds, bytes: Uint8Array): void {
    const isLate = this.hasClock && time <= this.end;
    if (this.end === 0 || (!channel.latched && !isLate)) this.setTime(time);
    if (channel.type === "tf2_msgs/msg/TFMessage") {
      this.addTransforms(channel.topic, channel.schema, bytes);
      return;
    }
    let log = this.logs.get(channel.topic);
    if (!log || log.type !== channel.type) {
      const { topic, type, schema, latched } = channel;
      log = new MessageLog(topic, type, latched, (cdr) => decode(schema, cdr), (reason) => this.onBroken(topic, reason));
      this.logs.set(topic, log);
    }
    log.add(time, bytes);
  }

  clear(): void {
    this.logs.clear();
    this.transforms.clear();
    this.end = this.first = this.trimmed = 0;
  }

  /** What is latched still holds. */
  private jumpBack(): void {
    for (const [topic, log] of this.logs)
      if (log.isLatched) log.forgetBefore(Infinity);
      else this.logs.delete(topic);
    this.transforms.forgetMoving();
    this.end = this.first = this.trimmed = 0;
  }

  at<T = any>(topic: string, time: Seconds): Message<T> | undefined {
    return this.logs.get(topic)?.at(time);
  }

  between<T = any>(topic: string, from: Seconds, to: Seconds): Message<T>[] {
    return this.logs.get(topic)?.between(from, to) ?? [];
  }

  transform(target: string, source: string, time: Seconds): Pose2 | undefined {
    return this.transforms.lookup(target, source, time);
  }

  root(): string | undefined {
    return this.transforms.root();
  }

  private addTransforms(topic: string, schema: string, bytes: Uint8Array): void {
    try {
      const message = decode<{ transforms: TransformStamped[] }>(schema, bytes);
      this.transforms.add(message.transforms, topic.endsWith("tf_static"));
    } catch (error) {
      this.onBroken(topic, String(error));
    }
  }

  private trim(): void {
    this.trimmed = this.end;
    for (const log of this.logs.values()) log.forgetBefore(this.end - KEPT);
    this.transforms.forgetBefore(this.end - KEPT);
    for (;;) {
      const logs = [...this.logs.values()].sort((a, b) => b.bytes - a.bytes);
      const total = logs.reduce((sum, log) => sum + log.bytes, 0);
      if (total <= MOST_BYTES || !logs[0]!.halve()) break;
    }
  }
}
