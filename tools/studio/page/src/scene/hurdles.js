// SPDX-License-Identifier: Apache-2.0
// The height over which a task asks every swing to step: a low bar across the way of each foot,
// where it is lifted most.
import { BoxGeometry, Group, Mesh, Vector3 } from "three";
import { LitPaint } from "./paint.js";

const BAR = new BoxGeometry(1, 1, 1).translate(0, 0, 0.5); // stands on the ground, along x is the way
const WIDE = 0.16; // of the robot's size, across the way
const DEEP = 0.025; // of it, along the way

export class Hurdles {
  constructor() {
    this.root = new Group();
    this.material = new LitPaint({
      color: 0xb65c08,
      transparent: true,
      opacity: 0.55,
      depthWrite: false,
    });
    this.before = new Vector3();
    this.after = new Vector3();
    this.top = new Vector3();
  }

  /**
   * @param {import("./motion_player.js").MotionPlayer} player
   * @param {(poses: Float32Array, foot: number, out: Vector3) => Vector3} soles
   * @param {number} size of the robot [m]
   */
  setMotion(player, soles, size) {
    const height = player.motion.step ?? 0;
    this.root.clear();
    if (!(height > 0)) return;
    player.feet.forEach((_, foot) => {
      const k = this.highest(player, soles, foot);
      const near = (step) => player.frame((k + step + player.frames) % player.frames);
      soles(near(-1), foot, this.before);
      soles(near(0), foot, this.top);
      soles(near(1), foot, this.after);
      const bar = new Mesh(BAR, this.material);
      bar.position.set(this.top.x, this.top.y, 0);
      bar.rotation.z = Math.atan2(this.after.y - this.before.y, this.after.x - this.before.x);
      bar.scale.set(DEEP * size, WIDE * size, height);
      bar.renderOrder = 2;
      this.root.add(bar);
    });
  }

  /** The frame in which a foot is highest; of the first and last the seam of the cycle is avoided. */
  highest(player, soles, foot) {
    let best = 1;
    let most = -Infinity;
    for (let k = 1; k + 1 < player.frames; k++) {
      const { z } = soles(player.frame(k), foot, this.top);
      if (z > most) [best, most] = [k, z];
    }
    return best;
  }

  /** Stands in the cycle that goes on. */
  update(player, time) {
    const { cycle } = player.at(time);
    const [x, y, yaw] = player.cycleStart(cycle);
    this.root.position.set(x, y, 0);
    this.root.rotation.z = yaw;
  }
}
