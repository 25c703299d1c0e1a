// diagnostic_msgs/msg/DiagnosticArray, read as this project's processes write it (runtime/host/process_services.cpp): one status per component,
// in its values what the runtime measures of it.
import type { Message, Seconds } from "../../app";

export type Level = 0 | 1 | 2 | 3;
export const LEVEL_NAMES = ["ok", "warn", "error", "stale"] as const;

export interface WireStatus {
  level: number;
  name: string;
  message: string;
  values: { key: string; value: string }[];
}

export interface DiagnosticArray {
  status: WireStatus[];
}

/** One timer or input: how often it ran, how long [ms], and how long it waited for its turn [ms]. */
export interface Callback {
  name: string;
  calls: number;
  missed: number;
  run: { p50: number; p99: number; max: number };
  wait: { p50: number; p99: number; max: number };
}

export interface Input {
  topic: string;
  age: string;
  /** Age by its limit; undefined without one. 1 and more is too old. */
  share: number | undefined;
  rate: string;
}

export interface Component {
  name: string;
  level: Level;
  message: string;
  process: string;
  lane: string;
  callbacks: Callback[];
  inputs: Input[];
  /** What the component says of itself. */
  values: { key: string; value: string }[];
}

/** Without word for this long a status says nothing about now: each process tells each second. */
const STALE_AFTER: Seconds = 3.5;
/** Before that it is forgotten: who is gone is gone. */
const FORGOTTEN_AFTER: Seconds = 15;

/** The newest of each name up to `now`. */
export function statusesAt(messages: readonly Message<DiagnosticArray>[], now: Seconds): Component[] {
  const newest = new Map<string, { status: WireStatus; time: Seconds }>();
  for (const { time, value } of messages) for (const status of value.status) newest.set(status.name, { status, time });
  return [...newest.values()].map(({ status, time }) => {
    const component = componentOf(status);
    return now - time <= STALE_AFTER ? component : { ...component, level: 3, message: `silent for ${Math.round(now - time)} s` };
  });
}

export function windowOf(now: Seconds): Seconds {
  return now - FORGOTTEN_AFTER;
}

const CALLBACK =
  /^calls (\d+) missed (\d+) run p50 ([\d.]+) p99 ([\d.]+) max ([\d.]+) ms wait p50 ([\d.]+) p99 ([\d.]+) max ([\d.]+) ms$/;
const AGE = /^([\d.]+) ms(?: of ([\d.]+) ms)?$/;

export function componentOf(status: WireStatus): Component {
  const component: Component = {
    name: status.name,
    level: Math.min(3, Math.max(0, status.level)) as Level,
    message: status.message,
    process: "",
    lane: "",
    callbacks: [],
    inputs: [],
    values: [],
  };
  const rates = new Map<string, string>();
  for (const { key, value } of status.values) {
    if (key === "process") component.process = value;
    else if (key === "lane") component.lane = value;
    else if (key.startsWith("rate /")) rates.set(key.slice(5), value);
    else if (key.startsWith("age /")) component.inputs.push(inputOf(key.slice(4), value));
    else addCallback(component, key, value);
  }
  for (const input of component.inputs) input.rate = rates.get(input.topic) ?? "";
  return component;
}

function addCallback(component: Component, name: string, value: string): void {
  const found = CALLBACK.exec(value);
  if (found === null) {
    component.values.push({ key: name, value });
    return;
  }
  const [calls, missed, ...ms] = found.slice(1).map(Number) as [number, number, ...number[]];
  const part = (from: number) => ({ p50: ms[from]!, p99: ms[from + 1]!, max: ms[from + 2]! });
  component.callbacks.push({ name, calls, missed, run: part(0), wait: part(3) });
}

function inputOf(topic: string, text: string): Input {
  const [, age, limit] = AGE.exec(text) ?? [];
  return { topic, age: text, share: age === undefined || limit === undefined ? undefined : Number(age) / Number(limit), rate: "" };
}

/** The callback that takes longest: what a lane has to be planned for. */
export function slowest(component: Component): Callback | undefined {
  return component.callbacks.reduce<Callback | undefined>((most, each) => (each.run.p99 > (most?.run.p99 ?? 0) ? each : most), undefined);
}

export function missed(component: Component): number {
  return component.callbacks.reduce((sum, { missed: count }) => sum + count, 0);
}

/** The input that is nearest to being too old; without limits none. */
export function oldest(component: Component): Input | undefined {
  return component.inputs.reduce<Input | undefined>((most, each) => ((each.share ?? -1) > (most?.share ?? -1) ? each : most), undefined);
}
