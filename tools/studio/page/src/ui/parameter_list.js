// SPDX-License-Identifier: Apache-2.0
// All parameters, in groups that fold; the list and the handles on the robot are one selection.
import { fill, h } from "../dom.js";
import { words } from "../units.js";
import { ParameterRow, stepOf } from "./parameter_row.js";
import { calmly } from "./rate.js";

/** Where a parameter stands: its own group, or what its name and unit say. */
function groupOf(parameter) {
  if (parameter.group) return words(parameter.group);
  return parameter.unit === "rad" ? "axes" : "lengths";
}

export class ParameterList {
  /** @param {object} studio */
  constructor(studio) {
    this.studio = studio;
    this.rows = new Map();
    this.element = h("div.parameter-list");
    studio.store.on("document", (document) => this.build(document));
    studio.store.on(
      "state",
      calmly(() => this.update()),
    );
    studio.selection.on(() => this.showSelection());
    this.element.addEventListener("keydown", (event) => this.key(event));
  }

  build(document) {
    const key = document.parameters.map((p) => p.name + p.given).join();
    if (key === this.key_) return this.update();
    this.key_ = key;
    this.rows.clear();
    const groups = new Map();
    for (const parameter of document.parameters) {
      const row = new ParameterRow(parameter, this.told());
      this.rows.set(parameter.name, row);
      const group = groupOf(parameter);
      groups.set(group, [...(groups.get(group) ?? []), row]);
    }
    fill(
      this.element,
      [...groups].map(([name, rows]) =>
        h(
          "details.group",
          { open: true },
          h("summary", {}, name, h("span.count", {}, String(rows.length))),
          rows.map((row) => row.element),
        ),
      ),
    );
    this.update();
  }

  told() {
    const { studio } = this;
    return {
      edit: (name, value, phase) => studio.edit(name, value, phase),
      nudge: (name, steps) => this.nudge(name, steps),
      lock: (name, on) => studio.lock(name, on),
      bounds: (name, lower, upper) => studio.setBounds(name, lower, upper),
      select: (name, add) => {
        const { names } = studio.selection;
        if (add)
          studio.selection.set(
            names.has(name) ? [...names].filter((n) => n !== name) : [...names, name],
          );
        else studio.selection.set(names.has(name) && names.size === 1 ? [] : [name]);
      },
      hover: (name) => studio.selection.hover(name),
      putBack: (name, given) => studio.putBack(name, given),
    };
  }

  /** Moves a parameter by so many keyboard steps; what follows within a second is one edit. */
  nudge(name, steps) {
    const state = this.studio.readParameter(name);
    if (state.locked) return;
    const value = Math.min(state.upper, Math.max(state.lower, state.value + steps * stepOf(state)));
    const goesOn = this.nudged === name;
    this.nudged = name;
    clearTimeout(this.pause);
    this.studio.edit(name, value, goesOn ? "drag" : "begin");
    this.pause = setTimeout(() => {
      this.nudged = null;
      this.studio.edit(name, this.studio.readParameter(name).value, "end");
    }, 1000);
  }

  update() {
    const most = this.steepest();
    for (const [name, row] of this.rows) {
      const state = this.studio.readParameter(name);
      const share = most > 0 ? ((state.gradient ?? 0) * (state.upper - state.lower)) / most : 0;
      row.update({ ...state, share });
    }
  }

  /** The largest change of F that a parameter's slope promises over its range. */
  steepest() {
    let most = 0;
    for (const name of this.rows.keys()) {
      const { gradient, upper, lower } = this.studio.readParameter(name);
      if (Number.isFinite(gradient)) most = Math.max(most, Math.abs(gradient) * (upper - lower));
    }
    return most;
  }

  showSelection() {
    const { names, hovered } = this.studio.selection;
    for (const [name, row] of this.rows) {
      row.select(names.has(name));
      row.hover(hovered === name);
    }
    const first = this.rows.get(this.studio.selection.first);
    if (first && first !== this.scrolled) first.element.scrollIntoView({ block: "nearest" });
    this.scrolled = first;
  }

  /** From name to name by up and down, + and − on the one in focus. */
  key(event) {
    const at = event.target.closest?.(".parameter");
    if (!at || event.target.tagName === "INPUT") return;
    const names = [...this.rows.keys()];
    const i = names.indexOf(at.dataset.name);
    const move = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (move) {
      event.preventDefault();
      this.rows.get(names[Math.min(names.length - 1, Math.max(0, i + move))]).name.focus();
    } else if (["+", "=", "-", "ArrowRight", "ArrowLeft"].includes(event.key)) {
      event.preventDefault();
      const sign = event.key === "-" || event.key === "ArrowLeft" ? -1 : 1;
      this.nudge(names[i], sign * (event.shiftKey ? 10 : 1));
    }
  }
}
