// Finds parameters by words of their component, name, unit and documentation; all of them have to be there.
import type { Parameter } from "./descriptor";

export function matcher(query: string): (parameter: Parameter) => boolean {
  const words = query.toLowerCase().split(/\s+/).filter((word) => word !== "");
  return ({ node, name, doc, unit }) => {
    const text = `${node} ${name} ${doc} ${unit}`.toLowerCase();
    return words.every((word) => text.includes(word));
  };
}
