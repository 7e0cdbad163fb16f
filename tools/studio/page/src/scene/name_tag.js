// SPDX-License-Identifier: Apache-2.0
// The name of a robot over it.
import { Vector3 } from "three";

export class NameTag {
  /** @param {HTMLElement} layer over the canvas */
  constructor(layer) {
    this.layer = layer;
    this.label = document.createElement("div");
    this.label.className = "name-tag";
    this.label.hidden = true;
    layer.append(this.label);
    this.point = new Vector3();
  }

  /**
   * @param {string} name empty: no tag
   * @param {import("three").Object3D} root of the robot, on the ground under it
   * @param {number} height over that [m]
   */
  show(name, root, height, camera) {
    this.label.hidden = !name;
    if (!name) return;
    if (this.label.textContent !== name) this.label.textContent = name;
    const { clientWidth, clientHeight } = this.layer;
    this.point.set(0, 0, height);
    root.localToWorld(this.point).project(camera);
    const x = (this.point.x * 0.5 + 0.5) * clientWidth;
    const y = (0.5 - this.point.y * 0.5) * clientHeight;
    this.label.style.transform = `translate(${x.toFixed(0)}px, ${y.toFixed(0)}px) translate(-50%, -100%)`;
  }
}
