// CDR to objects and back, by the schema that came with the channel.
import { parse } from "@foxglove/rosmsg";
import { MessageReader, MessageWriter } from "@foxglove/rosmsg2-serialization";

type Definitions = ReturnType<typeof parse>;

const TIME = "builtin_interfaces/Time";
const TIME_FIELDS: Definitions[number] = {
  name: TIME,
  definitions: [
    { name: "sec", type: "int32", isComplex: false, isArray: false },
    { name: "nanosec", type: "uint32", isComplex: false, isArray: false },
  ],
};

/** The parser makes a type of its own of stamps and durations, with other names of fields than ROS 2 has. */
function withRosTimes(definitions: Definitions): Definitions {
  const fieldsOf = (definition: Definitions[number]) =>
    definition.definitions.map((field) =>
      field.type === "time" || field.type === "duration" ? { ...field, type: TIME, isComplex: true } : field,
    );
  const others = definitions.filter((definition) => definition.name !== TIME);
  return [...others.map((definition) => ({ ...definition, definitions: fieldsOf(definition) })), TIME_FIELDS];
}

export function parseSchema(schema: string): Definitions {
  return withRosTimes(parse(schema, { ros2: true }));
}

const readers = new Map<string, MessageReader>();
const writers = new Map<string, MessageWriter>();

/** Throws where the schema cannot be parsed or the bytes are not of it. */
export function decode<T = any>(schema: string, bytes: Uint8Array): T {
  let reader = readers.get(schema);
  if (!reader) readers.set(schema, (reader = new MessageReader(parseSchema(schema))));
  return reader.readMessage(bytes) as T;
}

/** Fields that `value` leaves out are zero. */
export function encode(schema: string, value: object): Uint8Array {
  let writer = writers.get(schema);
  if (!writer) writers.set(schema, (writer = new MessageWriter(parseSchema(schema))));
  return writer.writeMessage(value);
}
