// Values of parameters: as rcl_interfaces/msg/ParameterValue has them on the wire, as the page keeps them, and as people write them.

export type Scalar = boolean | number | bigint | string;
/** undefined: not set. */
export type Value = Scalar | Scalar[] | undefined;

/** rcl_interfaces/msg/ParameterType */
export const Type = {
  notSet: 0,
  boolean: 1,
  integer: 2,
  double: 3,
  string: 4,
  bytes: 5,
  booleans: 6,
  integers: 7,
  doubles: 8,
  strings: 9,
} as const;

const FIELDS = [
  undefined,
  "bool_value",
  "integer_value",
  "double_value",
  "string_value",
  "byte_array_value",
  "bool_array_value",
  "integer_array_value",
  "double_array_value",
  "string_array_value",
] as const;

export function isList(type: number): boolean {
  return type >= Type.bytes && type <= Type.strings;
}

/** Integers as numbers where a number holds them. */
export function fromWire(message: { type: number } & Record<string, unknown>): Value {
  const field = FIELDS[message.type];
  if (field === undefined) return undefined;
  const value = message[field];
  return isList(message.type) ? Array.from(value as Iterable<Scalar>, narrowed) : narrowed(value as Scalar);
}

export function toWire(type: number, value: Value): object {
  const field = FIELDS[type];
  if (field === undefined || value === undefined) return { type: Type.notSet };
  return { type, [field]: Array.isArray(value) ? value.map((each) => widened(type, each)) : widened(type, value) };
}

export function equal(a: Value, b: Value): boolean {
  if (Array.isArray(a) && Array.isArray(b)) return a.length === b.length && a.every((each, i) => equal(each, b[i]));
  return a === b;
}

/** As a person reads it: 0.4, true, [1, 2]. */
export function textOf(value: Value): string {
  if (value === undefined) return "not set";
  if (Array.isArray(value)) return `[${value.map(textOf).join(", ")}]`;
  return typeof value === "number" ? numberText(value) : String(value);
}

/** The shortest text of what was meant: 0.30000000000000004 is 0.3. */
export function numberText(value: number): string {
  return Number.isFinite(value) ? String(Number(value.toPrecision(12))) : String(value);
}

/** What a person wrote; a sentence when it is no value of that type. */
export function parse(type: number, text: string): Value | Error {
  if (isList(type)) return parseList(type, text);
  const trimmed = text.trim();
  switch (type) {
    case Type.boolean:
      return trimmed === "true" ? true : trimmed === "false" ? false : new Error("must be true or false");
    case Type.integer:
      return /^[+-]?\d+$/.test(trimmed) ? narrowed(BigInt(trimmed)) : new Error("must be a whole number");
    case Type.double:
      return parseDouble(trimmed);
    default:
      return text;
  }
}

function parseDouble(text: string): number | Error {
  if (/^[+-]?\.?inf(inity)?$/i.test(text)) return text.startsWith("-") ? -Infinity : Infinity;
  const value = Number(text);
  return text === "" || Number.isNaN(value) ? new Error("must be a number") : value;
}

function parseList(type: number, text: string): Value | Error {
  const inside = text.trim().replace(/^\[([^]*)\]$/, "$1").trim();
  if (inside === "") return [];
  const element = type === Type.strings ? Type.string : type === Type.booleans ? Type.boolean : type === Type.doubles ? Type.double : Type.integer;
  const values: Scalar[] = [];
  for (const part of inside.split(",")) {
    const value = parse(element, part.trim());
    if (value instanceof Error) return new Error(`${part.trim() || "nothing"}: ${value.message}`);
    values.push(value as Scalar);
  }
  return values;
}

function narrowed(value: Scalar): Scalar {
  return typeof value === "bigint" && BigInt(Number(value)) === value && Number.isSafeInteger(Number(value)) ? Number(value) : value;
}

function widened(type: number, value: Scalar): Scalar {
  return (type === Type.integer || type === Type.integers) && typeof value === "number" ? BigInt(value) : value;
}
