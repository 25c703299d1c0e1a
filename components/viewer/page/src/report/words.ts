// Texts of a report as nodes of the page. Nothing of them becomes markup but **bold** and [words](address).

const PART = /\\([*[\]\\])|\*\*((?:[^*\\]|\\.)+)\*\*|\[((?:[^\]\\]|\\.)+)\]\(([^)\s]+)\)/g;

/** Beside the report or in it: no address of elsewhere. */
function isNear(address: string): boolean {
  return !/^[a-z][a-z0-9+.-]*:/i.test(address) && !address.startsWith("//");
}

export function words(text: string): (Node | string)[] {
  const nodes: (Node | string)[] = [];
  let end = 0;
  for (const part of text.matchAll(PART)) {
    nodes.push(text.slice(end, part.index));
    end = part.index + part[0].length;
    const [whole, escaped, bold, link, address] = part;
    if (escaped !== undefined) nodes.push(escaped);
    else if (bold !== undefined) nodes.push(made("b", words(bold)));
    else if (isNear(address!)) nodes.push(Object.assign(made("a", words(link!)), { href: address! }));
    else nodes.push(whole);
  }
  nodes.push(text.slice(end));
  return nodes;
}

function made<K extends keyof HTMLElementTagNameMap>(tag: K, children: (Node | string)[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  element.append(...children);
  return element;
}

const DIGITS = 3;
const NOTHING = "–";

/** With three significant digits, none after a whole number of four: 37.4, 0.0218, 1520. */
export function figure(value: number | null | undefined, decimals?: number): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return NOTHING;
  if (decimals !== undefined) return value.toFixed(decimals);
  if (value === 0) return "0";
  const beforePoint = Math.floor(Math.log10(Math.abs(value))) + 1;
  return value.toFixed(Math.min(6, Math.max(0, DIGITS - beforePoint)));
}
