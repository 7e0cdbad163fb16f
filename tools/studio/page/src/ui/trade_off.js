// SPDX-License-Identifier: Apache-2.0
// What several tasks are worth against each other: their weights, and the front of designs between
// them, along which the weights move the body at once, where it was worked out.
import { h } from "../dom.js";
import { FrontPlot, nearestOf } from "./front_plot.js";
import { Weights } from "./weights.js";

const SAME = 1e-9;

export class TradeOff {
  constructor(studio) {
    this.studio = studio;
    this.weights = new Weights((weights, goesOn) => this.weigh(weights, goesOn));
    this.plot = new FrontPlot((design) => studio.choose("front", design, false));
    this.find = h(
      "button.small",
      {
        type: "button",
        title: "The best body for each of several weightings: takes a while, and any change ends it",
        onClick: () => studio.workOut("front"),
      },
      "Work out the front",
    );
    this.along = h(
      "button.small",
      {
        type: "button",
        title: "The weights move the body along the front, or only count for the next search",
        aria: { pressed: "true" },
        onClick: () => this.setAlong(!this.isAlong),
      },
      "Along the front",
    );
    this.cancel = h(
      "button.small",
      { type: "button", onClick: () => studio.halt() },
      "Cancel",
    );
    this.status = h("p.status", { role: "status" });
    this.isAlong = true;
    this.element = h(
      "div.trade-off",
      { hidden: true },
      this.weights.element,
      h("div.button-row", {}, this.find, this.cancel, this.along),
      this.status,
      this.plot.element,
    );
    studio.store.on(["state", "document", "alternatives front"], () => this.update());
  }

  setAlong(on) {
    this.isAlong = on;
    this.along.setAttribute("aria-pressed", String(on));
  }

  weigh(weights, goesOn) {
    const { studio } = this;
    if (this.front && this.isAlong)
      studio.choose("front", nearestOf(this.front.designs, weights), goesOn);
    else studio.latest("weights", () => studio.commandQuietly("weights", { weights }));
  }

  update() {
    const { store } = this.studio;
    const [state, document] = [store.get("state"), store.get("document")];
    if (!state || !document) return;
    const names = document.tasks.map((each) => each.name);
    this.element.hidden = names.length < 2;
    if (names.length < 2 || state.weights.length !== names.length) return;
    this.weights.set(names, state.weights);
    const busy = state.phase === "working out";
    const usable = state.alternatives?.includes("front");
    this.front = usable ? store.get("alternatives front") : null;
    this.find.hidden = busy || names.length > 3;
    this.find.textContent = this.front ? "Work it out anew" : "Work out the front";
    this.find.disabled = state.phase === "searching";
    this.cancel.hidden = !busy;
    this.along.hidden = this.plot.element.hidden = !this.front;
    this.status.textContent = busy ? "Working out other designs …" : "";
    if (!this.front) {
      if (this.drawn) this.weights.showDesigns([]);
      this.drawn = null;
      return;
    }
    if (this.front !== this.drawn) {
      this.drawn = this.front;
      this.plot.draw(names, this.front.designs);
      this.weights.showDesigns(this.front.designs);
    }
    this.plot.show(
      this.front.designs.findIndex(({ s }) => s.every((x, i) => Math.abs(x - state.s[i]) < SAME)),
    );
  }
}
