// SPDX-License-Identifier: Apache-2.0
// Marks where something is wrong: a ring that faces the viewer, and its words beside it.
import { DoubleSide, Group, Mesh, Quaternion, RingGeometry, Vector3 } from "three";
import { FlatPaint } from "./paint.js";

const RING = new RingGeometry(0.72, 1, 28);
const MOST = 6; // marks at once
const LINE = 19; // pixels from one label to the next below
const BESIDE = 14; // pixels from a mark to its words, left of it where they end the picture
const LETTER = 6.4; // pixels of a letter, on average

/** Moves labels down until none covers another. @param {{x: number, y: number, width: number}[]} spots */
function apart(spots) {
  spots.sort((a, b) => a.y - b.y);
  spots.forEach((spot, i) => {
    for (const above of spots.slice(0, i))
      if (
        spot.y < above.y + LINE &&
        spot.x < above.x + above.width &&
        above.x < spot.x + spot.width
      )
        spot.y = above.y + LINE;
  });
  return spots;
}

export class Marks {
  /** @param {HTMLElement} layer over the canvas, for the words */
  constructor(layer) {
    this.root = new Group();
    this.material = new FlatPaint({
      color: 0xd8342c,
      side: DoubleSide,
      depthTest: false,
      transparent: true,
      opacity: 0.95,
      fog: false,
    });
    this.labels = [];
    this.point = new Vector3();
    this.turn = new Quaternion(); // from the world's frame
    for (let i = 0; i < MOST; i++) {
      const ring = new Mesh(RING, this.material);
      ring.renderOrder = 8;
      ring.visible = false;
      this.root.add(ring);
      const label = document.createElement("div");
      label.className = "mark-label";
      label.hidden = true;
      layer.append(label);
      this.labels.push(label);
    }
  }

  /**
   * @param {{at: Vector3, words: string}[]} marks in the frame of `root`
   * @param {import("./stage.js").Stage} stage that knows how large the layer is: asking for it lays
   * the page out
   */
  show(marks, radius, { camera, wide, tall }) {
    this.shown = marks.slice(0, MOST);
    this.root.getWorldQuaternion(this.turn).invert();
    this.root.children.forEach((ring, i) => {
      const mark = this.shown[i];
      ring.visible = Boolean(mark);
      if (!mark) return;
      ring.position.copy(mark.at);
      ring.scale.setScalar(radius);
      ring.quaternion.copy(this.turn).multiply(camera.quaternion);
    });
    this.place(camera, wide, tall);
  }

  /** Puts the words beside their marks, as the camera sees them. */
  place(camera, width, height) {
    if (!this.shown.length) {
      for (const label of this.labels) label.hidden = true;
      return;
    }
    const spots = [];
    this.labels.forEach((label, i) => {
      const mark = this.shown[i];
      label.hidden = !mark?.words;
      if (label.hidden) return;
      const ring = this.root.children[i];
      ring.getWorldPosition(this.point).project(camera);
      if (label.textContent !== mark.words) label.textContent = mark.words;
      const at = (this.point.x * 0.5 + 0.5) * width;
      const y = (0.5 - this.point.y * 0.5) * height - 8;
      const wide = LETTER * mark.words.length + 12;
      const x = at + BESIDE + wide > width ? Math.max(0, at - BESIDE - wide) : at + BESIDE;
      spots.push({ label, x, y, width: wide });
    });
    for (const { label, x, y } of apart(spots))
      label.style.transform = `translate(${x.toFixed(0)}px, ${y.toFixed(0)}px)`;
  }
}
