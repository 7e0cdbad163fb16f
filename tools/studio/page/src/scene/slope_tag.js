// SPDX-License-Identifier: Apache-2.0
// How steep the ground is, in words at the edge of the picture: a tilted grid alone does not say.

const LEVEL = 1e-4; // rad

/** The slope of the ground towards a direction [rad], up positive. */
const towards = (up, x, y) => Math.atan((up.x * x + up.y * y) / up.z);

const told = (angle, words) =>
  Math.abs(angle) < LEVEL
    ? null
    : `${Math.abs(angle).toFixed(2)} rad (${((Math.abs(angle) * 180) / Math.PI).toFixed(1)}°) ${words[angle > 0 ? 0 : 1]}`;

export class SlopeTag {
  /** @param {HTMLElement} layer over the canvas */
  constructor(layer) {
    this.label = document.createElement("div");
    this.label.className = "slope-tag";
    this.label.hidden = true;
    layer.append(this.label);
  }

  /**
   * @param {import("three").Vector3} up against gravity, in the ground's frame
   * @param {number[]} advance of a cycle: the way's direction
   */
  show(up, advance) {
    const length = Math.hypot(advance[0], advance[1]);
    const [x, y] = length > 1e-9 ? [advance[0] / length, advance[1] / length] : [1, 0];
    const parts = [
      told(towards(up, x, y), ["up the way", "down the way"]),
      told(towards(up, -y, x), ["up to its left", "up to its right"]),
    ].filter(Boolean);
    this.label.hidden = !parts.length;
    if (parts.length) this.label.textContent = `Slope ${parts.join(", ")}`;
  }
}
