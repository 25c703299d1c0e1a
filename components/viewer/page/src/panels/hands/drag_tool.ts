// A button that gives the mouse a tool: pressed, the next drag on the ground belongs to it; Escape or a second press puts it back.
import type { App, Pose2 } from "../../app";
import { create } from "../dom";
import type { Point } from "./poses";

export interface DragTool {
  label: string;
  hint: string;
  test: string;
  /** Stays in the hand after a drag. */
  isKept?: boolean;
  onRelease(from: Point, to: Point): void;
  /** While it is dragged, too. `from` is the same object from press to release. */
  onMove?(from: Point, to: Point): void;
  onTaken?(): void;
  onPut?(): void;
  placed?(): readonly Pose2[];
  stroke?(): readonly Point[];
}

export class DragToolButton {
  readonly button: HTMLButtonElement;
  private wasTaken = false;

  constructor(
    private readonly app: App,
    private readonly tool: DragTool,
    private readonly changed: () => void,
  ) {
    this.button = create(
      "button",
      { type: "button", class: "tool", title: tool.hint, "data-test": tool.test, "aria-pressed": "false", onclick: () => this.toggle() },
      tool.label,
    );
  }

  get isTaken(): boolean {
    return this.app.tool !== undefined && this.app.tool === this.held;
  }

  put(): void {
    if (this.isTaken) this.app.tool = undefined;
    this.changed();
  }

  update(): void {
    this.button.setAttribute("aria-pressed", String(this.isTaken));
    // Another tool, or the scene, may have taken it out of the hand.
    if (this.wasTaken && !this.isTaken) this.tool.onPut?.();
    this.wasTaken = this.isTaken;
  }

  private toggle(): void {
    if (this.isTaken) return this.put();
    this.app.tool?.onCancel();
    this.app.tool = this.held;
    this.tool.onTaken?.();
    this.changed();
  }

  private readonly held = this.makeTool();

  private makeTool() {
    const outer = this;
    return {
      get name() {
        return outer.tool.label;
      },
      get placed() {
        return outer.tool.placed?.() ?? [];
      },
      get stroke() {
        return outer.tool.stroke?.();
      },
      onDrag(from: Point, to: Point, isReleased: boolean) {
        outer.tool.onMove?.(from, to);
        if (!isReleased) return;
        if (!outer.tool.isKept) outer.put();
        outer.tool.onRelease(from, to);
      },
      onCancel() {
        outer.put();
      },
    };
  }
}
