// Driving by hand: keys and buttons that are held. Whatever takes the page out of hand (another window, a hidden tab, a lost connection, a
// field that is typed into) lets go of all of them.
import { create, setText } from "../dom";
import type { Hand, HandsContext } from "./context";
import { DIRECTION_OF_KEY, Driver, type Direction } from "./driver";
import { slider } from "./slider";
import { STAMPED_TWIST, stampedTwist } from "./stamped_twist";

const PAD: readonly [Direction, string, string][] = [
  ["forward", "▲", "W or arrow up"],
  ["left", "◀", "A or arrow left"],
  ["backward", "▼", "S or arrow down"],
  ["right", "▶", "D or arrow right"],
];

export class Teleop implements Hand {
  private readonly driver: Driver;
  private isArmed = false;
  /** Whom the first press was for: the last zero goes there too. */
  private driven = "";

  private readonly arm = create(
    "button",
    { type: "button", class: "tool", "aria-pressed": "false", "data-test": "teleop", onclick: () => this.setArmed(!this.isArmed) },
    "Drive by hand",
  );
  private readonly buttons = PAD.map(([direction, sign, keys]) => this.padButton(direction, sign, keys));
  private readonly linear = slider("speed", "m/s", 0.05, 1.5, 0.4);
  private readonly angular = slider("turn", "rad/s", 0.1, 2.5, 0.8);
  private readonly hint = create("p", { class: "hint", role: "status" });
  private readonly pad = create(
    "div",
    { class: "teleop-body" },
    create("div", { class: "pad", role: "group", "aria-label": "Hold to drive" }, ...this.buttons),
    create("div", { class: "speeds" }, this.linear.root, this.angular.root),
  );
  readonly root = create("div", { class: "teleop" }, create("div", { class: "row" }, this.arm), this.pad, this.hint);

  constructor(private readonly context: HandsContext) {
    this.driver = new Driver(
      async (twist) => context.app.hands.publish(`${this.driven}/cmd_vel_teleop_stamped`, STAMPED_TWIST, stampedTwist(twist, context.app.timeline.end)),
      () => ({ linear: this.linear.value(), angular: this.angular.value() }),
      { every: (ms, tick) => every(ms, tick) },
      (reason) => {
        context.say(`Driving by hand: ${reason instanceof Error ? reason.message : reason}`, true);
        this.setArmed(false);
      },
    );
    // Before the page's other keys: while driving the arrows are for driving alone.
    window.addEventListener("keydown", (event) => this.keyDown(event), true);
    window.addEventListener("keyup", (event) => this.keyUp(event), true);
    for (const lost of ["blur", "pagehide"]) window.addEventListener(lost, () => this.letGo());
    document.addEventListener("visibilitychange", () => this.letGo());
    document.addEventListener("focusin", (event) => isTyping(event.target) && this.letGo());
  }

  update(): void {
    if (!this.context.app.hands.canCommand) this.setArmed(false);
    this.show();
  }

  letGo(): void {
    this.driver.releaseAll();
    this.show();
  }

  private setArmed(isArmed: boolean): void {
    if (!isArmed) this.driver.releaseAll();
    this.isArmed = isArmed;
    this.show();
  }

  private show(): void {
    this.arm.setAttribute("aria-pressed", String(this.isArmed));
    this.pad.hidden = this.hint.hidden = !this.isArmed;
    this.buttons.forEach((button, i) => button.setAttribute("aria-pressed", String(this.driver.holds(PAD[i]![0]))));
    setText(this.hint, this.driver.isDriving ? "driving" : "Hold W A S D, the arrows or a button; Escape ends");
  }

  private press(what: string, direction: Direction): void {
    if (!this.driver.isDriving) this.driven = this.context.app.robot;
    this.driver.press(what, direction);
    this.show();
  }

  private keyDown(event: KeyboardEvent): void {
    if (!this.isArmed) return;
    if (event.key === "Escape") return this.setArmed(false);
    // With one of these held the system may keep the key's release to itself.
    if (event.ctrlKey || event.altKey || event.metaKey) return this.letGo();
    const direction = DIRECTION_OF_KEY[event.code];
    if (direction === undefined || isTyping(event.target)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    if (!event.repeat) this.press(event.code, direction);
  }

  private keyUp(event: KeyboardEvent): void {
    this.driver.release(event.code);
    this.show();
  }

  private padButton(direction: Direction, sign: string, keys: string): HTMLButtonElement {
    const what = `button ${direction}`;
    const press = () => this.press(what, direction);
    const release = () => {
      this.driver.release(what);
      this.show();
    };
    const isPress = (event: KeyboardEvent) => event.key === " " || event.key === "Enter";
    return create(
      "button",
      {
        type: "button",
        class: `pad-${direction}`,
        title: `${direction}: ${keys}`,
        "aria-label": `${direction} while held`,
        "data-test": `drive-${direction}`,
        onpointerdown: (event: PointerEvent) => {
          (event.currentTarget as Element).setPointerCapture(event.pointerId);
          press();
        },
        onpointerup: release,
        onpointercancel: release,
        onlostpointercapture: release,
        oncontextmenu: (event: Event) => event.preventDefault(),
        onkeydown: (event: KeyboardEvent) => {
          if (!isPress(event)) return;
          event.preventDefault();
          if (!event.repeat) press();
        },
        onkeyup: (event: KeyboardEvent) => isPress(event) && release(),
        onblur: release,
      },
      sign,
    );
  }
}

function every(ms: number, tick: () => void): () => void {
  const timer = setInterval(tick, ms);
  return () => clearInterval(timer);
}

/** Whether keys belong to what is typed. A slider is moved by arrows too. */
function isTyping(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && target.matches("input, select, textarea, [contenteditable]");
}
