// SPDX-License-Identifier: Apache-2.0
// The trade-off between two or three tasks: its designs as points, F of one task against that of
// the other, or in the triangle of their weights.
import { fill, h, svg } from "../dom.js";
import { significant } from "../units.js";

const SIZE = { width: 264, height: 132, left: 8, right: 8, top: 8, bottom: 16 };

/** The design whose weights are nearest. */
export function nearestOf(designs, weights) {
  const far = (each) =>
    each.weights.reduce((sum, w, i) => sum + (w - weights[i]) * (w - weights[i]), 0);
  return designs.reduce((best, each, i) => (far(each) < far(designs[best]) ? i : best), 0);
}

/** Places of values between the least and the largest, by their logarithms. */
function scaled(values, from, to) {
  const logs = values.map((v) => Math.log(Math.max(v, 1e-12)));
  const [least, most] = [Math.min(...logs), Math.max(...logs)];
  return logs.map((x) => from + ((to - from) * (x - least)) / (most - least || 1));
}

/** A point for each design of the front of two tasks. */
export class FrontPlot {
  /** @param {(design: number) => void} choose */
  constructor(choose) {
    this.choose = choose;
    this.drawing = svg("svg.front", {
      viewBox: `0 0 ${SIZE.width} ${SIZE.height}`,
      "aria-hidden": "true",
    });
    this.words = h("p.told", { aria: { live: "polite" } });
    this.element = h("div.front-plot", {}, this.drawing, this.words);
  }

  /** @param {string[]} names of the tasks @param {object[]} designs of the front */
  draw(names, designs) {
    this.names = names;
    this.designs = designs;
    this.drawing.classList.toggle("of-three", names.length !== 2);
    if (names.length !== 2) return fill(this.drawing);
    const { width, height, left, right, top, bottom } = SIZE;
    const [first, second] = [0, 1].map((k) => designs.map(({ task_F }) => task_F[k]));
    const x = scaled(first, left, width - right);
    const y = scaled(second, height - bottom, top);
    this.points = designs.map((_, i) =>
      svg("circle.front-point", { cx: x[i], cy: y[i], r: 4.5, onClick: () => this.choose(i) }),
    );
    fill(
      this.drawing,
      svg("path.front-line", { d: `M${x.map((v, i) => `${v} ${y[i]}`).join("L")}` }),
      this.points,
      svg("text", { x: width - right, y: height - 2, "text-anchor": "end" }, `cost F of ${names[0]} →`),
      svg("text", { x: left, y: height - 2 }, `↑ cost F of ${names[1]}`),
    );
  }

  /** @param {number} present the design that stands; -1: none of them */
  show(present) {
    this.points?.forEach((each, i) => each.classList.toggle("present", i === present));
    const design = this.designs[present];
    this.words.textContent = design
      ? `Design ${present + 1} of ${this.designs.length}: ${this.names
          .map((name, k) => `${name} cost F ${significant(design.task_F[k], 3)}`)
          .join(", ")}`
      : `${this.designs.length} designs are known; the one that stands is none of them.`;
  }
}
