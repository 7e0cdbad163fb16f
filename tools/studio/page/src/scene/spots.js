// SPDX-License-Identifier: Apache-2.0
// Places on a robot where something can be put: knobs of a few pixels, and the words of the one that
// is pointed at.
import { Group, Mesh, SphereGeometry, Vector3 } from "three";
import { onScreen } from "./handle_drag.js";
import { FlatPaint } from "./paint.js";

const KNOB = new SphereGeometry(1, 14, 10);
const PIXELS = 8;
const COLOURS = { idle: 0x1f8a70, aimed: 0xe8871e };

export class Spots {
  /** @param {HTMLElement} layer over the canvas, for the words */
  constructor(layer) {
    this.root = new Group();
    this.all = [];
    this.label = document.createElement("div");
    this.label.className = "spot-label";
    this.label.hidden = true;
    layer.append(this.label);
    this.layer = layer;
  }

  /** @param {{id: string, at: number[], words: string}[]} spots in the frame of body 1 */
  set(spots, aimed) {
    while (this.all.length > spots.length) {
      const { mesh } = this.all.pop();
      this.root.remove(mesh);
      mesh.material.dispose();
    }
    while (this.all.length < spots.length) {
      const material = new FlatPaint({ depthTest: false, transparent: true, fog: false });
      const mesh = new Mesh(KNOB, material);
      mesh.renderOrder = 11;
      this.root.add(mesh);
      this.all.push({ mesh, centre: new Vector3() });
    }
    spots.forEach((spot, i) => {
      this.all[i].spot = spot;
      const on = spot.id === aimed;
      this.all[i].mesh.material.color.set(on ? COLOURS.aimed : COLOURS.idle);
      this.all[i].mesh.material.opacity = on ? 1 : 0.8;
    });
    this.aimed = aimed;
  }

  /** Follows robot and camera. */
  update(robot, camera) {
    const { clientWidth, clientHeight } = this.layer;
    const pixel = (2 * Math.tan((camera.fov * Math.PI) / 360)) / Math.max(clientHeight, 1);
    this.label.hidden = true;
    for (const { mesh, spot, centre } of this.all) {
      robot.place(1, spot.at, mesh.position);
      centre.copy(mesh.position).applyMatrix4(this.root.matrixWorld);
      const size = PIXELS * (spot.id === this.aimed ? 1.4 : 1);
      mesh.scale.setScalar(size * pixel * camera.position.distanceTo(centre));
      if (spot.id !== this.aimed) continue;
      const at = onScreen(centre, camera, clientWidth, clientHeight);
      this.label.hidden = false;
      this.label.textContent = spot.words;
      this.label.style.transform = `translate(${at.x + 16}px, ${at.y - 10}px)`;
    }
  }

  /** The spot nearest to a point of the canvas, no farther than so many pixels; or null. */
  near(x, y, reach, camera) {
    const { clientWidth, clientHeight } = this.layer;
    let best = null;
    let least = reach;
    for (const { spot, centre } of this.all) {
      const at = onScreen(centre, camera, clientWidth, clientHeight);
      const far = Math.hypot(at.x - x, at.y - y);
      if (far < least && at.depth < 1) [best, least] = [spot, far];
    }
    return best;
  }
}
