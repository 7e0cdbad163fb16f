// SPDX-License-Identifier: Apache-2.0
// How fast a robot goes in physics, against its plan: over the last cycle, as within one its speed
// rises and falls.

const STILL = 0.01; // m/s or rad/s: a plan that is slower turns on the spot, or stands

/** The yaw [rad] of a pose: place and quaternion. */
function yawOf([, , , w, x, y, z]) {
  return Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
}

export class WalkedSpeed {
  constructor() {
    this.samples = [];
  }

  /** @param {number} time [s] @param {Float32Array} poses of all bodies */
  add(time, poses, { period, root }) {
    const last = this.samples.at(-1);
    if (last && time < last.time) this.samples = []; // it began anew
    const trunk = poses.slice(7 * root, 7 * root + 7);
    const at = trunk.subarray(0, 3);
    const before = this.samples.at(-1)?.yaw ?? yawOf(trunk);
    const turned = yawOf(trunk) - before;
    const yaw = before + Math.atan2(Math.sin(turned), Math.cos(turned)); // goes on beyond half a turn
    this.samples.push({ time, at, yaw });
    while (this.samples.length > 2 && this.samples[1].time <= time - period) this.samples.shift();
  }

  /**
   * "0.098 m/s, planned 0.100"; nothing before a cycle has passed.
   * @param {{period: number, advance: number[]}} plan
   */
  words({ period, advance: [dx, dy, turn] }) {
    const [first, last] = [this.samples[0], this.samples.at(-1)];
    const passed = (last?.time ?? 0) - (first?.time ?? 0);
    if (!(passed > 0.9 * period)) return "";
    const planned = Math.hypot(dx, dy) / period;
    const rate = turn / period;
    if (planned < STILL && Math.abs(rate) >= STILL) {
      const turned = (last.yaw - first.yaw) / passed;
      return `turns ${turned.toFixed(2)} rad/s, planned ${rate.toFixed(2)}`;
    }
    const gone = Math.hypot(...last.at.map((x, i) => x - first.at[i]));
    return `${(gone / passed).toFixed(3)} m/s, planned ${planned.toFixed(3)}`;
  }
}
