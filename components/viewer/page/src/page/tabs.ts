// The panels at the side: one is shown, and mounted when it is shown first.
import type { App } from "../app";
import { element, make } from "./dom";

export interface Tab {
  name: string;
  mount(root: HTMLElement, app: App): void;
}

export function mountTabs(app: App, tabs: readonly Tab[]): void {
  const entries = tabs.map((tab) => ({
    tab,
    button: make("button", { role: "tab", textContent: tab.name, id: `tab-${tab.name.toLowerCase()}` }),
    panel: make("section", { role: "tabpanel", hidden: true }),
    isMounted: false,
  }));
  const show = (shown: (typeof entries)[number]) => {
    for (const entry of entries) {
      entry.button.setAttribute("aria-selected", String(entry === shown));
      entry.panel.hidden = entry !== shown;
    }
    if (!shown.isMounted) shown.tab.mount(shown.panel, app);
    shown.isMounted = true;
  };
  for (const entry of entries) {
    entry.button.onclick = () => show(entry);
    entry.panel.setAttribute("aria-labelledby", entry.button.id);
  }
  element("tabs").append(...entries.map(({ button }) => button));
  element("panels").append(...entries.map(({ panel }) => panel));
  if (entries[0]) show(entries[0]);
  else document.body.classList.add("narrow");
}
