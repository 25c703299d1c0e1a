// A decoded message as lines "path value" in the order of the wire, exactly as bag_leaves writes ours.

const bits = new DataView(new ArrayBuffer(8));

function float(value) {
  if (Number.isNaN(value)) return "nan";
  bits.setFloat64(0, value);
  return bits.getBigUint64(0).toString(16).padStart(16, "0");
}

function scalar(type, value) {
  if (type === "float32" || type === "float64") return float(value);
  if (type === "string") return "x" + Buffer.from(value, "utf8").toString("hex");
  return String(value);
}

/** @param definitions by type name, as @foxglove/rosmsg parses a schema; the message's own has none */
export function leavesOf(definitions, message) {
  const byName = new Map(definitions.map((d) => [d.name ?? "", d.definitions]));
  const lines = [];
  const element = (field, path, value) => {
    if (field.isComplex === true) {
      fields(byName.get(field.type), path + ".", value);
    } else if (field.type === "time" || field.type === "duration") {
      lines.push(`${path}.sec ${value.sec}`, `${path}.nanosec ${value.nsec}`);
    } else {
      lines.push(`${path} ${scalar(field.type, value)}`);
    }
  };
  const fields = (list, prefix, value) => {
    for (const field of list) {
      if (field.isConstant === true) continue;
      const path = prefix + field.name;
      if (field.isArray !== true) {
        element(field, path, value[field.name]);
        continue;
      }
      const array = value[field.name];
      if (field.arrayLength == undefined) lines.push(`${path}.size() ${array.length}`);
      for (let i = 0; i < array.length; ++i) element(field, `${path}[${i}]`, array[i]);
    }
  };
  // The type that comes first is the message.
  fields(definitions[0].definitions, "", message);
  return lines;
}
