// From where the scene is seen.
import { make } from "../page/dom";

export type Mode = "top" | "tilted" | "time";

const MODES: [Mode, string, string][] = [
  ["top", "Top", "From above"],
  ["tilted", "Tilted", "From aside; Shift or the right button turns it"],
  ["time", "Time", "From aside, and what lies ahead in time rises"],
];

export class ViewButtons {
  readonly root = make("div", { className: "views" });
  private readonly modes = new Map<Mode, HTMLButtonElement>();
  private readonly follow = make("button", { textContent: "Follow", title: "The robot stays in the middle" });

  constructor(onMode: (mode: Mode) => void, onFollow: () => void, onFit: () => void) {
    const group = make("div", { className: "group" });
    for (const [mode, textContent, title] of MODES) {
      const button = make("button", { textContent, title });
      button.dataset.test = `view:${mode}`;
      button.onclick = () => onMode(mode);
      this.modes.set(mode, button);
      group.append(button);
    }
    this.follow.dataset.test = "view:follow";
    this.follow.onclick = onFollow;
    const fit = make("button", { textContent: "Fit", title: "Everything in sight", onclick: onFit });
    this.root.append(fit, this.follow, group);
  }

  update(mode: Mode, isFollowing: boolean): void {
    for (const [its, button] of this.modes) button.setAttribute("aria-pressed", String(its === mode));
    this.follow.setAttribute("aria-pressed", String(isFollowing));
  }
}
