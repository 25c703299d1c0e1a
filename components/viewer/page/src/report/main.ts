// A report: the JSON in this page, drawn.
import "uplot/dist/uPlot.min.css";
import "./report.css";
import { element, make } from "../page/dom";
import { type DrawnFigure, figureOf } from "./figure";
import { type Block, type Report, VERSION } from "./format";
import { table } from "./table";
import { words } from "./words";

const figures: DrawnFigure[] = [];

function list(items: string[]): HTMLElement {
  return make("ul", {}, ...items.map((item) => make("li", {}, ...words(item))));
}

function drawn(block: Block): Node[] {
  switch (block.kind) {
    case "heading":
      return [make(block.level === 1 ? "h1" : block.level === 2 ? "h2" : "h3", {}, ...words(block.text))];
    case "text":
      return [make("p", {}, ...words(block.text))];
    case "list":
      return [...(block.lead === "" ? [] : [make("p", {}, ...words(block.lead))]), list(block.items)];
    case "outcome": {
      const lines = block.lines.map((line) => make("p", {}, ...words(line)));
      return [make("div", { className: `outcome ${block.tone}` }, ...lines, ...(block.missed.length > 0 ? [list(block.missed)] : []))];
    }
    case "table":
      return [table(block)];
    case "figure": {
      const figure = figureOf(block);
      figures.push(figure);
      return [figure.element];
    }
  }
}

/** For tests: what was drawn. */
function expose(report: Report): void {
  const pictures = report.blocks.flatMap((block) => (block.kind === "figure" ? block.pictures : []));
  const told = pictures.map((picture) => ({
    title: picture.title,
    parts: picture.kind === "columns" ? picture.columns.length : (picture.series ?? []).length,
  }));
  Object.assign(window, { bandwagon: { title: report.title, pictures: told } });
}

const text = document.getElementById("report")?.textContent ?? "{}";
const report = JSON.parse(text) as Report;
if (report.report !== VERSION) throw new Error(`a report of version ${report.report}; this page draws version ${VERSION}`);
document.title = report.title;
const root = element("document");
for (const block of report.blocks) root.append(...drawn(block));
const redraw = () => figures.forEach((figure) => figure.draw());
redraw();
expose(report);
// Behind an address with #id the figure stood elsewhere before the pictures had their heights.
if (location.hash !== "") document.getElementById(decodeURIComponent(location.hash.slice(1)))?.scrollIntoView();

let width = root.clientWidth;
new ResizeObserver(() => {
  if (root.clientWidth === width) return;
  width = root.clientWidth;
  redraw();
}).observe(root);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
