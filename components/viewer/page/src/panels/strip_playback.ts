// Play, pause, steps, rate, and back to now: buttons and keys.
import type { App } from "../app";
import { make } from "../page/dom";
import { textOfTime } from "./strip_rows";

const RATES = [0.1, 0.25, 0.5, 1, 2, 4, 8];
const STEP = 0.1; // [s] one cycle of the planner
const LONG_STEP = 1;

function button(name: string, text: string, title: string, onclick: () => void): HTMLButtonElement {
  const made = make("button", { textContent: text, title, onclick });
  made.dataset["test"] = name;
  made.setAttribute("aria-label", title);
  return made;
}

/** True where a key means something else: a field that is written in, a control that it works. */
function isTaken(event: KeyboardEvent): boolean {
  if (event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey) return true;
  const target = event.target as HTMLElement | null;
  if (!target?.closest) return false;
  return target.isContentEditable || target.closest("input, select, textarea, summary, [role=slider], [data-keys]") !== null;
}

export function mountPlayback(root: HTMLElement, app: App): void {
  const toggle = () => {
    const { cursor } = app;
    if (cursor.isPlaying) cursor.pause();
    else cursor.play();
  };
  const step = (by: number) => app.cursor.step(by);
  const play = button("play", "", "Play or pause (space)", toggle);
  const live = button("live", "Live", "Back to now (End)", () => app.cursor.goLive());
  const rate = make("select", { title: "Rate" }, ...RATES.map((r) => new Option(`${r}×`, String(r))));
  rate.dataset["test"] = "rate";
  rate.onchange = () => (app.cursor.rate = Number(rate.value));
  const clock = make("output", { className: "strip-clock" });
  clock.dataset["test"] = "clock";
  root.append(
    button("step-back", "◂", `Back by ${STEP} s (left arrow; with Shift ${LONG_STEP} s)`, () => step(-STEP)),
    play,
    button("step-on", "▸", `On by ${STEP} s (right arrow; with Shift ${LONG_STEP} s)`, () => step(STEP)),
    rate,
    clock,
    live,
  );

  const show = () => {
    const { cursor, timeline, source } = app;
    const isEmpty = timeline.end <= 0;
    const isBag = source?.kind === "bag";
    play.textContent = cursor.isPlaying ? "❚❚" : "▶";
    rate.value = String(cursor.rate);
    rate.hidden = cursor.isLive;
    live.hidden = isBag;
    live.setAttribute("aria-pressed", String(cursor.isLive));
    const where = isBag ? cursor.time - timeline.begin : cursor.time - timeline.end;
    const length = textOfTime(timeline.end - timeline.begin, 1);
    clock.textContent = isEmpty || cursor.isLive ? "" : isBag ? `${textOfTime(where, 1)} of ${length}` : textOfTime(where, 1);
  };
  for (const event of ["cursor", "message", "source"] as const) app.on(event, show);
  show();

  addEventListener("keydown", (event) => {
    if (isTaken(event)) return;
    const length = event.shiftKey ? LONG_STEP : STEP;
    const actions: Record<string, () => void> = {
      " ": toggle,
      ArrowLeft: () => step(-length),
      ArrowRight: () => step(length),
      Home: () => app.cursor.seek(app.timeline.begin),
      End: () => app.cursor.goLive(),
    };
    const action = actions[event.key];
    if (!action || (event.key === " " && (event.target as HTMLElement).closest?.("button, [role=tab]"))) return;
    event.preventDefault();
    action();
  });
}
