// What was changed, as a part of a graph file: components: NAME: parameters: ... Below robots: where there are several.
import type { Entry } from "./store";
import { componentOf } from "./descriptor";
import { numberText, Type, type Scalar, type Value } from "./values";

type Tree = Map<string, Tree | string>;

/** `all` gives the other parameters of a node: a list of structs (walls.0.x) is written whole, as a graph file has it. */
export function graphYaml(changed: readonly Entry[], all: (node: string) => readonly Entry[], hasRobots: boolean): string {
  const components: Tree = new Map();
  const robots: Tree = new Map();
  for (const entry of withWholeLists(changed, all)) {
    const { node, name, type } = entry.parameter;
    const { robot: prefix, component } = componentOf(node);
    const robot = hasRobots ? prefix : "";
    const path = robot === "" ? [component, "parameters"] : [robot, component];
    put(robot === "" ? components : robots, [...path, ...name.split(".")], yamlValue(type, entry.value));
  }
  const lines: string[] = [];
  if (robots.size > 0) write(new Map([["robots", robots]]), 0, lines);
  if (components.size > 0) write(new Map([["components", components]]), 0, lines);
  return lines.map((line) => `${line}\n`).join("");
}

/** Texts that YAML would take for something else are quoted. */
export function yamlValue(type: number, value: Value): string {
  if (Array.isArray(value)) return `[${value.map((each) => yamlScalar(type === Type.doubles, each)).join(", ")}]`;
  return value === undefined ? "~" : yamlScalar(type === Type.double, value);
}

function yamlScalar(isDouble: boolean, value: Scalar): string {
  if (typeof value === "string") return isPlain(value) ? value : JSON.stringify(value);
  if (typeof value !== "number") return String(value);
  if (!Number.isFinite(value)) return Number.isNaN(value) ? ".nan" : value > 0 ? ".inf" : "-.inf";
  const text = numberText(value);
  return isDouble && /^-?\d+$/.test(text) ? `${text}.0` : text;
}

function isPlain(text: string): boolean {
  return /^[A-Za-z_/][\w/. -]*$/.test(text) && !/^(true|false|yes|no|on|off|null|y|n)$/i.test(text) && !text.endsWith(" ");
}

function withWholeLists(changed: readonly Entry[], all: (node: string) => readonly Entry[]): Entry[] {
  const wanted = new Map<string, Entry>();
  for (const entry of changed) {
    const { node, name } = entry.parameter;
    const list = /^(.*?)\.\d+(\.|$)/.exec(name)?.[1];
    const whole = list === undefined ? [entry] : all(node).filter((other) => other.parameter.name.startsWith(`${list}.`));
    for (const each of whole) wanted.set(`${node} ${each.parameter.name}`, each);
  }
  return [...wanted.values()];
}

function put(tree: Tree, path: readonly string[], value: string): void {
  const [key, ...rest] = path as [string, ...string[]];
  if (rest.length === 0) {
    tree.set(key, value);
    return;
  }
  let below = tree.get(key);
  if (!(below instanceof Map)) tree.set(key, (below = new Map()));
  put(below, rest, value);
}

function isIndexed(tree: Tree): boolean {
  return [...tree.keys()].every((key, i) => key === String(i));
}

function write(tree: Tree, indent: number, lines: string[]): void {
  const space = " ".repeat(indent);
  for (const [key, value] of tree) {
    if (typeof value === "string") lines.push(`${space}${key}: ${value}`);
    else if (isIndexed(value)) {
      lines.push(`${space}${key}:`);
      for (const each of value.values()) lines.push(...listElement(each, indent + 2));
    } else {
      lines.push(`${space}${key}:`);
      write(value, indent + 2, lines);
    }
  }
}

function listElement(value: Tree | string, indent: number): string[] {
  const space = " ".repeat(indent);
  if (typeof value === "string") return [`${space}- ${value}`];
  const lines: string[] = [];
  if (isIndexed(value)) for (const each of value.values()) lines.push(...listElement(each, 0));
  else write(value, 0, lines);
  return lines.map((line, i) => `${space}${i === 0 ? "- " : "  "}${line}`);
}
