// The legend, in which layers are switched on and off.
import { make } from "../page/dom";
import type { Layer } from "./layer";
import { toHex, type Palette } from "./palette";

export class LayerList {
  readonly root = make("details", { className: "layers", open: window.innerWidth > 860 }, make("summary", { textContent: "Layers" }));
  private readonly rows: { layer: Layer; row: HTMLElement; swatch: HTMLElement }[] = [];

  constructor(layers: readonly Layer[], isOn: (layer: Layer) => boolean, onSwitch: (layer: Layer, isOn: boolean) => void) {
    for (const layer of layers) {
      const box = make("input", { type: "checkbox", checked: isOn(layer) });
      box.dataset.test = `layers:${layer.id}`;
      box.onchange = () => onSwitch(layer, box.checked);
      const swatch = make("span", { className: `swatch of-${layer.legend.shape}` });
      const row = make("label", {}, box, swatch, make("span", { textContent: layer.name }));
      if (layer.legend.note) row.append(make("small", { textContent: layer.legend.note }));
      this.rows.push({ layer, row, swatch });
      this.root.append(row);
    }
  }

  /** Those of which there is nothing to see are pale. */
  update(palette: Palette, isThere: (layer: Layer) => boolean): void {
    for (const { layer, row, swatch } of this.rows) {
      row.classList.toggle("absent", !isThere(layer));
      const colors = layer.legend.colors(palette).map(toHex);
      const [from, to] = [colors[0]!, colors.at(-1)!];
      swatch.style.setProperty("--from", from);
      swatch.style.background = layer.legend.shape === "scale" ? `linear-gradient(90deg, ${colors.join()})` : "";
      swatch.style.setProperty("--middle", colors[1] ?? from);
      swatch.style.setProperty("--to", to);
    }
  }
}
