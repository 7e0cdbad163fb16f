// SPDX-License-Identifier: Apache-2.0
// Discs on the ground under the feet that stand, and the paths of the feet through the air.
import {
  BufferAttribute,
  BufferGeometry,
  CircleGeometry,
  Group,
  Line,
  Mesh,
  Vector3,
} from "three";
import { FlatPaint, LinePaint } from "./paint.js";

const DISC = new CircleGeometry(1, 24);
const HEIGHT = 0.0012; // m, over the ground and the shadow

export class Footprints {
  constructor() {
    this.root = new Group();
    this.paths = new Group();
    this.discs = new Group();
    this.root.add(this.paths, this.discs);
    this.discMaterial = new FlatPaint({
      color: 0x1f8a70,
      transparent: true,
      opacity: 0.55,
      depthWrite: false,
      fog: false,
    });
    this.pathMaterial = new LinePaint({ color: 0x7a8696, transparent: true, opacity: 0.7 });
    this.point = new Vector3();
  }

  /**
   * Draws the feet's paths over a cycle.
   * @param {import("./motion_player.js").MotionPlayer} player
   */
  setMotion(player, soles) {
    this.soles = soles;
    while (this.discs.children.length < player.feet.length) {
      const disc = new Mesh(DISC, this.discMaterial);
      disc.renderOrder = 2;
      this.discs.add(disc);
    }
    this.fitPaths(player.feet.length, player.frames + 1);
    this.paths.children.forEach(({ geometry }, i) => {
      const { position } = geometry.attributes;
      for (let k = 0; k <= player.frames; k++) {
        soles(player.frame(k % player.frames), i, this.point);
        if (k === player.frames) player.carry(1, this.point);
        this.point.toArray(position.array, 3 * k);
      }
      position.needsUpdate = true;
    });
  }

  /** A line of `count` points for each foot; lines of before stay where they fit. */
  fitPaths(feet, count) {
    const { children } = this.paths;
    const points = children[0]?.geometry.attributes.position.count;
    if (children.length === feet && points === count) return;
    for (const line of children) line.geometry.dispose();
    this.paths.clear();
    for (let i = 0; i < feet; i++) {
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * count), 3));
      const line = new Line(geometry, this.pathMaterial);
      line.frustumCulled = false;
      this.paths.add(line);
    }
  }

  /** Shows which feet stand at a time, and the paths of the cycle that goes on. */
  update(player, time, poses, radius) {
    const { cycle } = player.at(time);
    const [x, y, yaw] = player.cycleStart(cycle);
    this.paths.position.set(x, y, 0);
    this.paths.rotation.z = yaw;
    this.discs.children.forEach((disc, i) => {
      disc.visible = i < player.feet.length && player.stands(time, i);
      if (!disc.visible) return;
      this.soles(poses, i, disc.position);
      disc.position.z = HEIGHT;
      disc.scale.setScalar(radius);
    });
  }
}
