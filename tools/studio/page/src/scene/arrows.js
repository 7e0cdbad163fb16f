// SPDX-License-Identifier: Apache-2.0
// Arrows for forces: a pool of shafts and heads, of which a picture takes as many as it needs.
import {
  ConeGeometry,
  CylinderGeometry,
  Group,
  Mesh,
  Quaternion,
  Vector3,
} from "three";
import { FlatPaint } from "./paint.js";

const SHAFT = new CylinderGeometry(1, 1, 1, 10).translate(0, 0.5, 0);
const HEAD = new ConeGeometry(1, 1, 14).translate(0, 0.5, 0);
const Y = new Vector3(0, 1, 0);

export class Arrows {
  /** @param {number} colour */
  constructor(colour) {
    this.root = new Group();
    this.material = new FlatPaint({ color: colour, transparent: true, opacity: 0.9 });
    this.used = 0;
    this.thickness = 0.004;
    this.turn = new Quaternion();
    this.unit = new Vector3();
  }

  clear() {
    this.used = 0;
    for (const each of this.root.children) each.visible = false;
  }

  /** @param {Vector3} from @param {Vector3} along its length is the arrow's [m] */
  add(from, along) {
    const length = along.length();
    if (length < this.thickness) return;
    let arrow = this.root.children[this.used];
    if (!arrow) {
      arrow = new Group();
      arrow.add(new Mesh(SHAFT, this.material), new Mesh(HEAD, this.material));
      this.root.add(arrow);
    }
    this.used++;
    const t = this.thickness;
    const head = Math.min(5 * t, 0.6 * length);
    arrow.visible = true;
    arrow.position.copy(from);
    this.unit.copy(along).divideScalar(length);
    arrow.quaternion.copy(this.turn.setFromUnitVectors(Y, this.unit));
    arrow.children[0].scale.set(t, length - head, t);
    arrow.children[1].scale.set(2.6 * t, head, 2.6 * t);
    arrow.children[1].position.set(0, length - head, 0);
  }
}
