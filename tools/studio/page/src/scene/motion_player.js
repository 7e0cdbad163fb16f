// SPDX-License-Identifier: Apache-2.0
// A planned cycle as poses at any time: frames are interpolated, each cycle moves and turns the
// next one.
import { Quaternion, Vector3 } from "three";
import { bodyIndex, floatsOf } from "../decode.js";

const Z = new Vector3(0, 0, 1);

export class MotionPlayer {
  /** @param {import("../types.js").Motion} motion */
  constructor(motion) {
    this.motion = motion;
    this.period = motion.period;
    this.root = motion.root; // which a report does not tell
    this.frames = motion.frames;
    this.poses = floatsOf(motion.poses);
    this.bodyCount = this.poses.length / (7 * this.frames);
    this.forces = floatsOf(motion.forces);
    this.feet = motion.feet ?? [];
    this.faults = motion.faults ?? [];
    this.advance = motion.advance ?? [0, 0, 0];
    this.footBody = this.feet.map((foot) =>
      Array.isArray(motion.bodies) ? bodyIndex(motion.bodies, foot.body) : foot.body,
    );
    this.a = new Quaternion();
    this.b = new Quaternion();
    this.p = new Vector3();
  }

  /** Where the cycle of this number begins: x, y and yaw against the first one. */
  cycleStart(cycle) {
    const [dx, dy, dyaw] = this.advance;
    if (Math.abs(dyaw) < 1e-9) return [cycle * dx, cycle * dy, 0];
    let x = 0;
    let y = 0;
    const turns = Math.abs(cycle);
    const sign = Math.sign(cycle);
    for (let n = 0; n < turns; n++) {
      const yaw = sign > 0 ? n * dyaw : -(n + 1) * dyaw;
      x += sign * (Math.cos(yaw) * dx - Math.sin(yaw) * dy);
      y += sign * (Math.sin(yaw) * dx + Math.cos(yaw) * dy);
    }
    return [x, y, cycle * dyaw];
  }

  /** The poses of a frame of the first cycle. */
  frame(k) {
    return this.poses.subarray(7 * k * this.bodyCount, 7 * (k + 1) * this.bodyCount);
  }

  /** Takes a point of the first cycle to where it is in the cycle of this number. */
  carry(cycle, point) {
    const [x, y, yaw] = this.cycleStart(cycle);
    point.applyAxisAngle(Z, yaw);
    point.x += x;
    point.y += y;
  }

  /** Cycle number and phase (0 to 1) at a time [s]. */
  at(time) {
    const cycles = time / this.period;
    const cycle = Math.floor(cycles);
    return { cycle, phase: cycles - cycle };
  }

  /** Where the robot's even motion is at a time: what a camera follows. */
  path(time, out) {
    const { cycle, phase } = this.at(time);
    const [x0, y0] = this.cycleStart(cycle);
    const [x1, y1] = this.cycleStart(cycle + 1);
    return out.set(x0 + phase * (x1 - x0), y0 + phase * (y1 - y0), 0);
  }

  /**
   * Poses of all bodies at a time.
   * @param {Float32Array} out [bodies * 7]
   */
  sample(time, out) {
    const { cycle, phase } = this.at(time);
    const exact = phase * this.frames;
    const frame = Math.min(Math.floor(exact), this.frames - 1);
    const share = exact - frame;
    const next = frame + 1 === this.frames ? 0 : frame + 1;
    const start = this.cycleStart(cycle);
    const after = next === 0 ? this.cycleStart(cycle + 1) : start;
    for (let body = 0; body < this.bodyCount; body++) {
      this.pose(frame, body, start, this.p, this.a);
      const o = 7 * body;
      const { x, y, z } = this.p;
      this.pose(next, body, after, this.p, this.b);
      this.a.slerp(this.b, share);
      out[o] = x + share * (this.p.x - x);
      out[o + 1] = y + share * (this.p.y - y);
      out[o + 2] = z + share * (this.p.z - z);
      out[o + 3] = this.a.w;
      out[o + 4] = this.a.x;
      out[o + 5] = this.a.y;
      out[o + 6] = this.a.z;
    }
    return out;
  }

  pose(frame, body, [x, y, yaw], position, quaternion) {
    const o = 7 * (frame * this.bodyCount + body);
    const p = this.poses;
    position.set(p[o], p[o + 1], p[o + 2]);
    quaternion.set(p[o + 4], p[o + 5], p[o + 6], p[o + 3]);
    if (yaw !== 0) {
      position.applyAxisAngle(Z, yaw);
      quaternion.premultiply(new Quaternion().setFromAxisAngle(Z, yaw));
    }
    position.x += x;
    position.y += y;
  }

  /** The planned ground force of a foot at a time [N], in the frame of the ground. */
  force(time, foot, out) {
    const { cycle, phase } = this.at(time);
    const frame = Math.min(Math.floor(phase * this.frames), this.frames - 1);
    const o = 3 * (frame * this.feet.length + foot);
    out.set(this.forces[o] || 0, this.forces[o + 1] || 0, this.forces[o + 2] || 0);
    return out.applyAxisAngle(Z, cycle * this.advance[2]);
  }

  /** Whether a foot stands at a time. */
  stands(time, foot) {
    const stance = this.feet[foot].stance;
    if (!stance?.length) return false;
    const { phase } = this.at(time);
    return stance[Math.min(Math.floor(phase * stance.length), stance.length - 1)] > 0;
  }

  /** The faults that hold at a time. */
  faultsAt(time) {
    const { phase } = this.at(time);
    return this.faults.filter(({ from, to }) =>
      from <= to ? phase >= from && phase <= to : phase >= from || phase <= to,
    );
  }
}
