// SPDX-License-Identifier: Apache-2.0
// A design parameter as a row: name, slider, number, lock, reset, what F would gain; and, where it
// is selected, its sentence and its bounds.
import { fill, h, icon, iconButton, setText } from "../dom.js";
import { digitsOf, format, significant, words } from "../units.js";

const KEY_STEPS = 200; // arrow keys go from bound to bound in so many
const NEAR = 1e-9;

/** The step of an arrow key or a wheel's notch [unit of the parameter]. */
export const stepOf = (state) => Math.max((state.upper - state.lower) / KEY_STEPS, 1e-6);

export class ParameterRow {
  /**
   * @param {import("../types.js").Parameter} parameter
   * @param {object} told edit(name, value, phase), lock(name, on), putBack(name, given), bounds(name, lower, upper),
   * select(name, add), hover(name)
   */
  constructor(parameter, told) {
    this.parameter = parameter;
    this.told = told;
    this.dragging = false;
    const { name, unit } = parameter;
    const label = words(name);
    this.slider = h("input.slider", {
      type: "range",
      step: "any",
      aria: { label: `${label}, slider` },
      onInput: () => this.slide(),
      onChange: () => this.endSlide(),
      onKeydown: (event) => this.key(event),
    });
    this.number = h("input.number", {
      type: "number",
      step: "any",
      inputMode: "decimal",
      aria: { label: `${label} [${unit}]` },
      onChange: () => this.enter(),
      onKeydown: (event) => this.key(event),
    });
    this.lock = h("button.icon-button.lock", {
      type: "button",
      onClick: () => told.lock(name, !this.state?.locked),
    });
    this.reset = iconButton("reset", `Back to the given ${format(parameter.given, unit)}`, () =>
      told.edit(name, parameter.given, "once"),
    );
    this.bar = h("span.gradient-fill");
    this.gradient = h("span.gradient", {}, this.bar);
    this.name = h(
      "button.parameter-name",
      { type: "button", onClick: (event) => told.select(name, event.ctrlKey || event.metaKey) },
      label,
    );
    this.atBound = h("span.at-bound", { hidden: true });
    this.detail = h("div.parameter-detail", { hidden: true });
    this.element = h(
      "div.parameter",
      {
        role: "group",
        aria: { label },
        data: { name },
        onPointerenter: () => told.hover(name),
        onPointerleave: () => told.hover(null),
      },
      h("div.parameter-line", {}, this.name, this.atBound, this.number, h("span.unit", {}, unit)),
      h("div.parameter-line", {}, this.slider, this.gradient, this.lock, this.reset),
      this.detail,
    );
  }

  slide() {
    const phase = this.dragging ? "drag" : "begin";
    this.dragging = true;
    this.told.edit(this.parameter.name, this.slider.valueAsNumber, phase);
  }

  endSlide() {
    if (!this.dragging) return;
    this.dragging = false;
    this.told.edit(this.parameter.name, this.slider.valueAsNumber, "end");
  }

  enter() {
    const value = this.number.valueAsNumber;
    if (Number.isFinite(value)) {
      const { lower, upper } = this.state;
      this.told.edit(this.parameter.name, Math.min(upper, Math.max(lower, value)), "once");
    }
    this.shown = undefined;
    this.update(this.state);
  }

  key(event) {
    const sign = {
      ArrowUp: 1,
      ArrowRight: 1,
      "+": 1,
      "=": 1,
      ArrowDown: -1,
      ArrowLeft: -1,
      "-": -1,
    };
    const isNumber = event.target === this.number;
    const turn = sign[event.key];
    if (!turn || (isNumber && !/^Arrow(Up|Down)$/.test(event.key))) return;
    event.preventDefault();
    event.stopPropagation();
    this.told.nudge(this.parameter.name, turn * (event.shiftKey ? 10 : 1));
  }

  /** @param {{value: number, lower: number, upper: number, locked: boolean, gradient: ?number}} state */
  update(state) {
    const { parameter, slider, number } = this;
    const old = this.state ?? {};
    this.state = state;
    const moved = Object.keys(state).some((key) => state[key] !== old[key]);
    if (!moved && this.shown !== undefined) return;
    if (old.lower !== state.lower || old.upper !== state.upper || this.shown === undefined) {
      slider.min = state.lower;
      slider.max = state.upper;
      number.min = state.lower;
      number.max = state.upper;
      const share = (parameter.given - state.lower) / (state.upper - state.lower || 1);
      slider.style.setProperty("--given", `${(100 * Math.min(1, Math.max(0, share))).toFixed(1)}%`);
      this.fillBounds();
    }
    if (this.shown !== state.value) {
      this.shown = state.value;
      if (!this.dragging) slider.valueAsNumber = state.value;
      if (document.activeElement !== number || !number.matches(":focus-visible") || this.dragging)
        number.value = state.value.toFixed(digitsOf(parameter.unit));
      else if (Math.abs(number.valueAsNumber - state.value) > NEAR)
        number.value = state.value.toFixed(digitsOf(parameter.unit));
      const changed = Math.abs(state.value - parameter.given) > NEAR;
      this.reset.disabled = !changed || state.locked;
      this.element.classList.toggle("changed", changed);
    }
    this.showBound(state);
    if (old.locked !== state.locked) this.showLock(state.locked);
    this.showGradient(state);
  }

  /** Marks a value that stands at a bound: the search might go on beyond it. */
  showBound({ value, lower, upper }) {
    const { parameter, slider, atBound } = this;
    const { unit, robot_lower, robot_upper } = parameter;
    const near = 1e-6 * (upper - lower);
    const isFree = upper - lower > NEAR;
    const side = !isFree ? "" : value <= lower + near ? "lower" : value >= upper - near ? "upper" : "";
    const bound = side === "lower" ? lower : upper;
    const own = Math.abs(bound - (side === "lower" ? robot_lower : robot_upper)) > NEAR;
    const whose = own ? "set here" : "of the robot's file";
    const told = side ? `At its ${side} bound ${format(bound, unit)}, ${whose}` : "";
    slider.setAttribute("aria-valuetext", [format(value, unit), told].filter(Boolean).join(". "));
    if (told === this.toldBound) return;
    this.toldBound = told;
    this.element.classList.toggle("bounded", Boolean(side));
    atBound.hidden = !side;
    atBound.title = told && `${told}: the search may want to go beyond it`;
    fill(
      atBound,
      h("span", { aria: { hidden: "true" } }, side === "lower" ? "min" : "max"),
      h("span.unseen", {}, told),
    );
  }

  showLock(locked) {
    this.lock.replaceChildren(icon(locked ? "lock" : "unlock"));
    const label = `${locked ? "Unlock" : "Lock"} ${words(this.parameter.name)}`;
    this.lock.title = label;
    this.lock.setAttribute("aria-label", label);
    this.lock.setAttribute("aria-pressed", String(locked));
    this.slider.disabled = this.number.disabled = locked;
    this.reset.disabled ||= locked;
    this.element.classList.toggle("locked", locked);
    if (!locked) this.shown = undefined;
  }

  /** The bar points to where F falls; its length is the fall over the range, against the largest. */
  showGradient({ gradient, share = 0 }) {
    const known = Number.isFinite(gradient);
    const width = known ? Math.min(50, 50 * Math.abs(share)) : 0;
    this.bar.style.width = `${width.toFixed(1)}%`;
    this.bar.style.left = share > 0 ? `${(50 - width).toFixed(1)}%` : "50%";
    const { unit } = this.parameter;
    this.gradient.title = known
      ? `The cost falls to the ${gradient > 0 ? "left" : "right"}: its slope is ${significant(gradient, 3)} per ${unit} (gradient, dF/ds)`
      : "The slope of the cost is not known while motions are predicted (gradient, dF/ds)";
    if (this.slope) setText(this.slope, known ? `${significant(gradient, 3)} per ${unit}` : "–");
  }

  select(on) {
    if (this.detail.hidden === !on) return;
    this.element.classList.toggle("selected", on);
    this.name.setAttribute("aria-expanded", String(on));
    this.detail.hidden = !on;
    if (on && !this.slope) this.fillDetail();
  }

  hover(on) {
    this.element.classList.toggle("hovered", on);
  }

  fillDetail() {
    const { parameter, told } = this;
    const bound = (label) =>
      h("input.number", {
        type: "number",
        step: "any",
        aria: { label: `${label} of ${words(parameter.name)} [${parameter.unit}]` },
        onChange: () =>
          told.bounds(parameter.name, this.low.valueAsNumber, this.high.valueAsNumber),
      });
    this.low = bound("Lower bound");
    this.high = bound("Upper bound");
    this.slope = h("span");
    this.fillBounds();
    this.detail.append(
      h("p", {}, parameter.sentence),
      this.tie(),
      h(
        "div.bounds",
        {},
        h("label", {}, "from ", this.low),
        h("label", {}, " to ", this.high),
        h("span.unit", {}, parameter.unit),
      ),
      h("div.bounds", { title: "Gradient, dF/ds" }, "slope of the cost: ", this.slope),
      h(
        "button.small",
        {
          type: "button",
          title: "Back to the given value, and there it stays while the search goes on",
          onClick: () => told.putBack(parameter.name, parameter.given),
        },
        "Put back and lock",
      ),
    );
    if (this.state) this.showGradient(this.state);
  }

  tie() {
    const { tie } = this.parameter;
    if (!tie || tie.length < 2) return "";
    const parts = tie.map(({ name, mirrored }) => (mirrored ? `${name} (mirrored)` : name));
    return h("p.tie", {}, `Moves together: ${parts.join(", ")}`);
  }

  fillBounds() {
    if (!this.low || !this.state) return;
    const digits = digitsOf(this.parameter.unit);
    for (const [input, value] of [
      [this.low, this.state.lower],
      [this.high, this.state.upper],
    ]) {
      input.value = value.toFixed(digits);
      input.min = this.parameter.robot_lower ?? "";
      input.max = this.parameter.robot_upper ?? "";
    }
  }
}
