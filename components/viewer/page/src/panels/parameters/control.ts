// What a parameter is changed with: a box to tick, a choice, a slider with its number, a text.
import { create } from "../dom";
import type { Parameter } from "./descriptor";
import { isUsable, PLACES, placeOf, valueAt, type Scale } from "./slider_scale";
import { parse, textOf, Type, type Value } from "./values";

export interface Control {
  readonly root: HTMLElement;
  show(value: Value): void;
}

export interface Wishes {
  /** While a slider moves: as often as it likes. */
  slide(value: Value): void;
  set(value: Value): void;
  /** What was written is no value of the type. */
  refuse(reason: string): void;
}

export function controlOf(parameter: Parameter, wishes: Wishes): Control {
  if (parameter.type === Type.boolean) return checkbox(parameter, wishes);
  if (parameter.choices.length > 0) return choice(parameter, wishes);
  const text = field(parameter, wishes);
  const scale = scaleOf(parameter);
  return scale === undefined || parameter.isReadOnly ? text : slider(parameter, scale, text, wishes);
}

function scaleOf({ type, range }: Parameter): Scale | undefined {
  if (range === undefined || (type !== Type.double && type !== Type.integer)) return undefined;
  const scale = { ...range, isInteger: type === Type.integer };
  return isUsable(scale) ? scale : undefined;
}

function labels({ node, name, unit, isReadOnly }: Parameter) {
  return {
    "aria-label": unit === "" ? name : `${name} [${unit}]`,
    "data-test": `param:${node}.${name}`,
    disabled: isReadOnly,
  };
}

function checkbox(parameter: Parameter, wishes: Wishes): Control {
  const input = create("input", { type: "checkbox", ...labels(parameter), onchange: () => wishes.set(input.checked) });
  return { root: input, show: (value) => void (input.checked = value === true) };
}

function choice(parameter: Parameter, wishes: Wishes): Control {
  const options = parameter.choices.map((text) => create("option", { value: text }, text));
  const select = create("select", { ...labels(parameter), onchange: () => wishes.set(select.value) }, ...options);
  return { root: select, show: (value) => void (select.value = String(value)) };
}

function field(parameter: Parameter, wishes: Wishes): Control {
  let held: Value;
  const commit = () => {
    if (input.value === textOf(held)) return;
    const value = parse(parameter.type, input.value);
    if (value instanceof Error) wishes.refuse(value.message);
    else wishes.set(value);
  };
  const isNumber = parameter.type === Type.double || parameter.type === Type.integer;
  const input = create("input", {
    type: "text",
    inputmode: isNumber ? "decimal" : undefined,
    class: isNumber ? "number" : "text",
    spellcheck: "false",
    autocomplete: "off",
    ...labels(parameter),
    onchange: commit,
    onblur: () => (input.value = textOf(held)),
    onkeydown: (event: KeyboardEvent) => {
      if (event.key === "Enter") commit();
      if (event.key === "Escape") input.value = textOf(held);
    },
  });
  return {
    root: input,
    show(value) {
      held = value;
      if (document.activeElement !== input || input.disabled) input.value = textOf(value);
    },
  };
}

function slider(parameter: Parameter, scale: Scale, text: Control, wishes: Wishes): Control {
  let isHeld = false;
  const value = () => valueAt(scale, input.valueAsNumber);
  const input = create("input", {
    type: "range",
    min: 0,
    max: PLACES,
    step: 1,
    "aria-label": `${parameter.name}, slider`,
    "data-test": `slide:${parameter.node}.${parameter.name}`,
    oninput: () => {
      isHeld = true;
      speak();
      text.show(value());
      wishes.slide(value());
    },
    onchange: () => {
      isHeld = false;
      wishes.set(value());
    },
    onkeydown: (event: KeyboardEvent) => {
      // The browser's step is a thousandth of the range: one of ours can be more.
      const direction = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[event.key];
      if (direction === undefined) return;
      event.preventDefault();
      step(direction);
    },
  });
  const speak = () => input.setAttribute("aria-valuetext", `${textOf(value())} ${parameter.unit}`);
  const step = (direction: number) => {
    const before = value();
    let place = input.valueAsNumber;
    while (value() === before && place >= 0 && place <= PLACES) input.valueAsNumber = place += direction;
    text.show(value());
    speak();
    wishes.set(value());
  };
  return {
    root: create("span", { class: "slider" }, input, text.root),
    show(shown) {
      text.show(shown);
      if (isHeld) return;
      input.valueAsNumber = placeOf(scale, Number(shown));
      speak();
    },
  };
}
