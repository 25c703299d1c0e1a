// Hands on the scene: drag moves it, with the right button or Shift turns it, the wheel and two fingers zoom; a tool takes the drag for itself.
import type { App, Tool } from "../app";
import type { Viewpoint } from "./camera";

interface At {
  x: number;
  y: number;
}

export interface PointerEvents {
  /** The view was moved by hand. */
  onMoved(hasPanned: boolean): void;
  /** While a tool draws; undefined when it ended. */
  onDrag(drag: { from: At; to: At } | undefined): void;
}

const TURN_PER_PIXEL = 0.006; // [rad]
const ZOOM_PER_PIXEL = 0.0016;

export function handlePointers(canvas: HTMLElement, view: Viewpoint, app: App, events: PointerEvents): void {
  const pointers = new Map<number, At>();
  let drag: { tool: Tool; pointer: number; from: At; to: At } | undefined;

  const at = (event: MouseEvent): At => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };

  const endDrag = () => {
    drag = undefined;
    events.onDrag(undefined);
  };

  canvas.addEventListener("pointerdown", (event) => {
    canvas.focus({ preventScroll: true });
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, at(event));
    if (drag && pointers.size > 1) {
      drag.tool.onCancel(); // a second finger means the view
      endDrag();
    } else if (app.tool && event.button === 0 && !event.shiftKey && pointers.size === 1) {
      const from = view.ground(at(event).x, at(event).y);
      if (from) drag = { tool: app.tool, pointer: event.pointerId, from, to: from };
    }
  });

  canvas.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const now = at(event);
    if (drag) {
      const to = drag.pointer === event.pointerId ? view.ground(now.x, now.y) : undefined;
      if (!to) return;
      drag.to = to;
      drag.tool.onDrag(drag.from, to, false);
      events.onDrag(drag);
      return;
    }
    if (pointers.size === 2) pinch(event.pointerId, before, now);
    else if (event.buttons & 2 || event.shiftKey) view.orbit((before.x - now.x) * TURN_PER_PIXEL, (before.y - now.y) * TURN_PER_PIXEL);
    else view.drag(before, now);
    pointers.set(event.pointerId, now);
    events.onMoved(!(event.buttons & 2 || event.shiftKey));
  });

  const pinch = (moved: number, before: At, now: At) => {
    const other = [...pointers].find(([id]) => id !== moved)![1];
    const middle = (a: At): At => ({ x: (a.x + other.x) / 2, y: (a.y + other.y) / 2 });
    const apart = (a: At) => Math.max(Math.hypot(a.x - other.x, a.y - other.y), 1);
    const angle = (a: At) => Math.atan2(other.y - a.y, other.x - a.x);
    view.drag(middle(before), middle(now));
    view.zoom(apart(before) / apart(now), middle(now));
    const turn = angle(now) - angle(before);
    view.orbit(Math.atan2(Math.sin(turn), Math.cos(turn)), 0);
  };

  const end = (event: PointerEvent) => {
    pointers.delete(event.pointerId);
    if (drag?.pointer !== event.pointerId) return;
    const { tool, from, to } = drag;
    endDrag();
    if (event.type === "pointercancel") tool.onCancel();
    else tool.onDrag(from, to, true);
  };
  canvas.addEventListener("pointerup", end);
  canvas.addEventListener("pointercancel", end);

  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const pixels = event.deltaY * (event.deltaMode === 1 ? 32 : 1);
      view.zoom(Math.exp(Math.min(Math.max(pixels, -400), 400) * ZOOM_PER_PIXEL), at(event));
      events.onMoved(false);
    },
    { passive: false },
  );

  window.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !app.tool) return;
    const { tool } = app;
    endDrag();
    tool.onCancel();
  });
}
