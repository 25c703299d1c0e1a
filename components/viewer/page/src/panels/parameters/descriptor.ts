// What is known of a parameter before it is changed: rcl_interfaces/msg/ParameterDescriptor, read as this project's nodes write it. Unit and
// default have no field there: the unit stands in brackets at the end of the description, the default and the choices in the constraints.
import { isList, parse, Type, type Value } from "./values";

export interface Parameter {
  node: string;
  name: string;
  type: number;
  doc: string;
  unit: string;
  /** undefined: not told. */
  defaultValue: Value;
  choices: string[];
  /** Rules that are no range: "must be at least 0 m". */
  rule: string;
  /** Both ends are finite and near enough for a slider. */
  range: { from: number; to: number } | undefined;
  isReadOnly: boolean;
}

export interface Descriptor {
  name: string;
  type: number;
  description: string;
  additional_constraints: string;
  read_only: boolean;
  floating_point_range: ArrayLike<{ from_value: number; to_value: number }>;
  integer_range: ArrayLike<{ from_value: number | bigint; to_value: number | bigint }>;
}

/** Open ends are the ends of the type; a slider has none of those. */
const OPEN = 1e9;
const CHOICES = "must be one of ";
const DEFAULT = /(?:^|; )default (.*)$/s;

export function parameterOf(node: string, descriptor: Descriptor): Parameter {
  const [, doc = "", unit = ""] = /^([^]*?)(?:(?:^| )\[([^[\]]*)\])?$/.exec(descriptor.description) ?? [];
  const defaultText = DEFAULT.exec(descriptor.additional_constraints)?.[1];
  const rule = descriptor.additional_constraints.replace(DEFAULT, "");
  const choices = rule.startsWith(CHOICES) && !isList(descriptor.type) ? rule.slice(CHOICES.length).split(", ") : [];
  const range = descriptor.floating_point_range[0] ?? descriptor.integer_range[0];
  return {
    node,
    name: descriptor.name,
    type: descriptor.type,
    doc,
    unit,
    defaultValue: defaultText === undefined ? undefined : parsedDefault(descriptor.type, defaultText),
    choices,
    rule: choices.length > 0 ? "" : rule,
    range: range === undefined ? undefined : finiteRange(Number(range.from_value), Number(range.to_value)),
    isReadOnly: descriptor.read_only,
  };
}

function finiteRange(from: number, to: number): { from: number; to: number } | undefined {
  return from > -OPEN && to < OPEN && from < to ? { from, to } : undefined;
}

function parsedDefault(type: number, text: string): Value {
  const value = parse(type, type === Type.string ? text.replace(/^"(.*)"$|^'(.*)'$/, "$1$2") : text);
  return value instanceof Error ? undefined : value;
}

/** The component's part of a node's name and the robot's: /robot1/people is people of robot1. */
export function componentOf(node: string): { robot: string; component: string } {
  const parts = node.split("/").filter((part) => part !== "");
  const component = parts.at(-1) ?? node;
  const robot = parts.length > 1 && parts[0] !== component ? parts[0]! : "";
  return { robot, component };
}

/** teb.band and min_obstacle_dist of teb.band.min_obstacle_dist. */
export function sectionOf(name: string): { section: string; leaf: string } {
  const dot = name.lastIndexOf(".");
  return { section: name.slice(0, Math.max(dot, 0)), leaf: name.slice(dot + 1) };
}
