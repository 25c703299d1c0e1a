// Lines for people over the scene: what was said, until it is old or clicked away.
import type { App, Status } from "../app";

const SHOWN_FOR = { info: 4000, warning: 10_000, error: Infinity }; // [ms]
const MOST_LINES = 4;

export function mountStatusLines(root: HTMLElement, app: App): void {
  let last: Status | undefined;
  app.on("status", () => {
    const from = last ? app.statuses.lastIndexOf(last) + 1 : 0;
    for (const status of app.statuses.slice(from)) show(root, status);
    last = app.statuses.at(-1);
    while (root.childElementCount > MOST_LINES) root.firstElementChild!.remove();
  });
}

function show(root: HTMLElement, { level, text }: Status): void {
  const previous = [...root.children].find((child) => child.textContent === text);
  previous?.remove(); // said again: at the end, once
  const line = document.createElement("button");
  line.className = `status ${level}`;
  line.textContent = text;
  line.title = "Click to dismiss";
  line.onclick = () => line.remove();
  root.append(line);
  if (Number.isFinite(SHOWN_FOR[level])) setTimeout(() => line.remove(), SHOWN_FOR[level]);
}
