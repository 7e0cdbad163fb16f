// SPDX-License-Identifier: Apache-2.0
// Weights of several tasks: a slider between two, a triangle of three, a slider each of more.
import { fill, h, svg } from "../dom.js";

const CORNERS = [
  [0, -50],
  [50, 37],
  [-50, 37],
];
const LEAST = 0.01; // a weight must not be 0

/** The weights of a point in the triangle. */
function weightsAt(x, y) {
  const [[ax, ay], [bx, by], [cx, cy]] = CORNERS;
  const d = (by - cy) * (ax - cx) + (cx - bx) * (ay - cy);
  const a = ((by - cy) * (x - cx) + (cx - bx) * (y - cy)) / d;
  const b = ((cy - ay) * (x - cx) + (ax - cx) * (y - cy)) / d;
  return normal([a, b, 1 - a - b]);
}

function normal(weights) {
  const kept = weights.map((w) => Math.max(LEAST, w));
  const sum = kept.reduce((a, b) => a + b, 0);
  return kept.map((w) => w / sum);
}

export class Weights {
  /** @param {(weights: number[], goes_on: boolean) => void} changed */
  constructor(changed) {
    this.changed = changed;
    this.element = h("div.weights");
  }

  /** @param {string[]} names @param {number[]} weights what stands; not while one is moved */
  set(names, weights) {
    if (this.moving && names.join("\n") === this.key) return;
    this.weights = normal(weights);
    this.names = names;
    const key = names.join("\n");
    if (key !== this.key) {
      this.key = key;
      fill(this.element, names.length < 2 ? null : this.build(names));
    }
    this.show();
  }

  build(names) {
    const one = (i) =>
      h("input.slider", {
        type: "range",
        min: LEAST,
        max: 1 - LEAST,
        step: 0.01,
        aria: { label: `Weight of ${names[i]}` },
        onInput: (event) => this.take(i, event.target.valueAsNumber),
        onChange: () => this.end(),
      });
    this.sliders = names.length === 2 ? [one(1)] : names.map((_, i) => one(i));
    this.texts = names.map(() => h("output"));
    if (names.length === 2)
      return h(
        "div.two-weights",
        {},
        h("span", {}, names[0], " ", this.texts[0]),
        this.sliders[0],
        h("span", {}, this.texts[1], " ", names[1]),
      );
    const rows = names.map((name, i) =>
      h("label.weight-row", {}, h("span", {}, name), this.sliders[i], this.texts[i]),
    );
    return [names.length === 3 ? this.triangle(names) : null, rows];
  }

  take(i, weight) {
    if (this.names.length === 2) this.tell([1 - weight, weight]);
    else {
      const rest = this.weights.reduce((sum, w, k) => (k === i ? sum : sum + w), 0) || 1;
      this.tell(this.weights.map((w, k) => (k === i ? weight : (w * (1 - weight)) / rest)));
    }
  }

  triangle(names) {
    this.knob = svg("circle.knob", { r: 6 });
    const anchor = ["middle", "start", "end"];
    const drawing = svg(
      "svg.triangle",
      { viewBox: "-90 -66 180 122", "aria-hidden": "true" },
      svg("path.disc", { d: `M${CORNERS.map((c) => c.join(" ")).join("L")}Z` }),
      CORNERS.map(([x, y], i) =>
        svg(
          "text",
          { x, y: y + (i ? 14 : -5), "text-anchor": anchor[i] === "middle" ? "middle" : "middle" },
          names[i],
        ),
      ),
      this.knob,
    );
    const drag = (event) => {
      const box = drawing.getBoundingClientRect();
      const x = ((event.clientX - box.left) / box.width) * 180 - 90;
      const y = ((event.clientY - box.top) / box.height) * 122 - 66;
      this.tell(weightsAt(x, y));
    };
    drawing.addEventListener("pointerdown", (event) => {
      drawing.setPointerCapture(event.pointerId);
      drag(event);
    });
    drawing.addEventListener("pointermove", (event) => event.buttons && drag(event));
    drawing.addEventListener("pointerup", () => this.end());
    return drawing;
  }

  tell(weights) {
    this.weights = normal(weights);
    this.show();
    const rounded = this.weights.map((w) => Math.round(w * 1000) / 1000);
    this.changed(rounded, Boolean(this.moving));
    this.moving = true;
  }

  /** What follows is another change. */
  end() {
    this.moving = false;
  }

  /** Draws the weights of designs that are known into the triangle. */
  showDesigns(designs) {
    this.dots?.remove();
    this.dots = null;
    if (!designs.length || !this.knob || this.names?.length !== 3) return;
    const at = (weights, k) => CORNERS.reduce((sum, c, i) => sum + weights[i] * c[k], 0);
    this.dots = svg(
      "g.dots",
      {},
      designs.map(({ weights }) =>
        svg("circle", { cx: at(weights, 0), cy: at(weights, 1), r: 2.2 }),
      ),
    );
    this.knob.before(this.dots);
  }

  show() {
    if (this.names.length < 2) return;
    this.weights.forEach((w, i) => (this.texts[i].textContent = `${Math.round(100 * w)} %`));
    if (this.names.length === 2) this.sliders[0].valueAsNumber = this.weights[1];
    else this.sliders.forEach((slider, i) => (slider.valueAsNumber = this.weights[i]));
    if (!this.knob || this.names.length !== 3) return;
    const at = [0, 1].map((k) => CORNERS.reduce((sum, c, i) => sum + this.weights[i] * c[k], 0));
    this.knob.setAttribute("cx", at[0].toFixed(1));
    this.knob.setAttribute("cy", at[1].toFixed(1));
  }
}
