// A table, whose rows become cards on a narrow screen.
import { make } from "../page/dom";
import type { Cell, Table } from "./format";
import { figure, words } from "./words";

function content(cell: Cell, decimals?: number): (Node | string)[] {
  if (typeof cell === "string") return words(cell);
  if (typeof cell === "number") return [String(cell)];
  if ("tone" in cell) return [make("span", { className: cell.tone }, ...words(cell.text))];
  const text = figure(cell.value, decimals);
  if (cell.low === undefined || cell.low === null || cell.high === undefined || cell.high === null) return [text];
  return [make("b", {}, text), " ", make("span", { className: "range" }, `${figure(cell.low, decimals)} to ${figure(cell.high, decimals)}`)];
}

/** Words stand to the left, and so does their column with its heading; figures to the right. */
function isText(cell: Cell): boolean {
  return typeof cell === "string" ? /^[\p{L}[*]/u.test(cell) : typeof cell === "object" && "tone" in cell;
}

export function table(block: Table): HTMLElement {
  const hasText = block.columns.map((_, i) => i === 0 || block.rows.some((row) => row[i] !== undefined && isText(row[i])));
  const heads = block.columns.map(({ name }, i) => make("th", { className: hasText[i] ? "text" : "", scope: "col" }, ...words(name)));
  const rows = block.rows.map((row) => {
    const cells = row.map((cell, i) => {
      const made = make("td", { className: hasText[i] ? "text" : "" }, ...content(cell, block.columns[i]?.decimals));
      made.dataset.is = block.columns[i]?.name ?? "";
      return made;
    });
    return make("tr", {}, ...cells);
  });
  return make("div", { className: "table" }, make("table", {}, make("thead", {}, make("tr", {}, ...heads)), make("tbody", {}, ...rows)));
}
