// A figure: its caption, one legend for all its pictures, and the pictures, beside one another where there is room.
import { make } from "../page/dom";
import { Brush, shade } from "./brush";
import { chartFrame } from "./chart";
import { columnsFrame } from "./columns";
import type { Figure, Picture } from "./format";
import { draw } from "./plot";
import { words } from "./words";

type Sign = (brush: Brush) => void;
const MIDDLE: [number, number] = [13, 6]; // of a sign of 26 x 12 px

/** What stands in the legend, by name: of equal names the first. */
function signsOf(pictures: Picture[]): Map<string, Sign> {
  const signs = new Map<string, Sign>();
  const add = (name: string | undefined, sign: Sign) => name && !signs.has(name) && signs.set(name, sign);
  for (const picture of pictures) {
    if (picture.kind === "columns") {
      if (picture.columns.some(({ published }) => typeof published === "number")) add("published", (brush) => (brush.pen(shade("ink"), 1.6), brush.diamond(MIDDLE)));
      if (picture.columns.some(({ measured }) => measured !== undefined))
        add(picture.measured, (brush) => (brush.pen(shade("ink"), 1.6), brush.line([[13, 0], [13, 12]]), brush.disc(MIDDLE, 3.5, 1, false)));
      if (picture.columns.some(({ runs }) => runs !== undefined)) add(picture.runs, (brush) => (brush.pen(shade("grey"), 1), [6, 13, 20].forEach((x) => brush.disc([x, 6], 2, 1, false))));
      continue;
    }
    for (const { name, color, width = 1.8, dash, dots } of picture.series ?? [])
      add(name, (brush) => (brush.pen(shade(color), width, dash), dots ? [6, 13, 20].forEach((x) => brush.disc([x, 6], 2, 1, false)) : brush.line([[1, 6], [25, 6]])));
    for (const { name, color } of picture.bodies ?? []) add(name, (brush) => (brush.pen(shade(color), 1.2), brush.disc(MIDDLE, 5, 0.15, true)));
    for (const { name, color, symbol } of picture.marks ?? []) add(name, (brush) => (brush.pen(shade(color), 1.5), brush.symbol(symbol, MIDDLE, 4)));
    for (const { name, color, dash, shade: isShade } of picture.areas ?? [])
      add(name, (brush) => (brush.pen(isShade ? shade("shade") : shade(color), 2, dash), isShade ? brush.context.fillRect(2, 0, 22, 12) : brush.line([[3, 1], [23, 1], [23, 11], [3, 11]], true)));
  }
  return signs;
}

function drawSign(canvas: HTMLCanvasElement, sign: Sign): void {
  const ratio = Math.max(1, devicePixelRatio);
  canvas.width = 26 * ratio;
  canvas.height = 12 * ratio;
  const context = canvas.getContext("2d");
  if (context === null) return;
  context.scale(ratio, ratio);
  sign(new Brush(context, 1));
}

export interface DrawnFigure {
  element: HTMLElement;
  /** Once it is in the page, and whenever width or colours have changed. */
  draw(): void;
}

export function figureOf(block: Figure): DrawnFigure {
  const signs = [...signsOf(block.pictures)].map(([name, sign]) => ({ name, sign, canvas: make("canvas") }));
  const legend = make("div", { className: "legend" }, ...signs.map(({ name, canvas }) => make("span", {}, canvas, name)));
  const pictures = block.pictures.map((picture) => {
    const root = make("div", { className: "plot" });
    return { root, frame: picture.kind === "chart" ? chartFrame(picture) : columnsFrame(picture), title: picture.title };
  });
  const element = make(
    "figure",
    { id: block.id ?? "" },
    make("figcaption", {}, make("b", {}, ...words(block.title), "."), " ", ...words(block.caption)),
    ...(signs.length > 0 ? [legend] : []),
    make("div", { className: `pictures in${block.columns}` }, ...pictures.map(({ root, title }) => make("section", {}, make("h4", {}, title), root))),
  );
  let plots: { destroy(): void }[] = [];
  return {
    element,
    draw() {
      for (const plot of plots) plot.destroy();
      for (const { sign, canvas } of signs) drawSign(canvas, sign);
      plots = pictures.map(({ root, frame }) => draw(root, frame));
    },
  };
}
