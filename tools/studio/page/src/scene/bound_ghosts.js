// SPDX-License-Identifier: Apache-2.0
// The bodies at both bounds of a parameter as ghosts about the robot: how far it can be changed. Of
// both only what differs is drawn: what the parameter moves.
import { Color, Group } from "three";
import { MotionPlayer } from "./motion_player.js";
import { RobotBody } from "./robot_body.js";

const TINT = new Color(0xe8871e);
const OPACITY = 0.2;
const SAME = 1e-6; // m, of shapes and places

const near = (a, b) => a.every((x, i) => Math.abs(x - b[i]) < SAME);

/** Which geoms are not alike in two designs whose motions begin alike. */
function unlike(lower, upper) {
  const [a, b] = [lower, upper].map(({ motion }) => new MotionPlayer(motion).frame(0));
  const moved = (body) => !near(a.subarray(7 * body, 7 * body + 7), b.subarray(7 * body));
  const { geoms } = lower.design;
  const others = upper.design.geoms;
  return geoms.map((geom, i) => {
    const other = others[i];
    return (
      !other ||
      geom.mesh !== other.mesh ||
      !near(geom.size, other.size) ||
      !near(geom.pos, other.pos) ||
      !near(geom.quat, other.quat) ||
      moved(geom.body)
    );
  });
}

export class BoundGhosts {
  /** @param {object} options of RobotBody */
  constructor(options) {
    this.root = new Group();
    this.sides = ["lower", "upper"].map((name) => {
      const robot = new RobotBody({ ...options, ghost: OPACITY, tint: TINT });
      robot.root.visible = false;
      this.root.add(robot.root);
      return { name, robot };
    });
  }

  /** @param {?{lower: {design, motion}, upper: {design, motion}}} bounds */
  set(bounds) {
    this.shown = Boolean(bounds);
    const seen = bounds && unlike(bounds.lower, bounds.upper);
    for (const side of this.sides) {
      side.robot.root.visible = this.shown;
      if (!bounds) continue;
      const { design, motion } = bounds[side.name];
      side.robot.setDesign(design);
      side.robot.meshes.forEach((mesh, i) => (mesh.visible &&= seen[i] ?? true));
      side.player = new MotionPlayer(motion);
      side.poses = new Float32Array(7 * side.player.bodyCount);
    }
  }

  /** @param {number} pixel [m] */
  setPixel(pixel) {
    for (const { robot } of this.sides) robot.setPixel(pixel);
  }

  /** Where they are at a time of a motion; without one they are not seen. */
  pose(player, time) {
    if (!this.shown) return;
    for (const side of this.sides) {
      side.robot.root.visible = Boolean(player);
      if (!player) continue;
      const share = side.player.period / player.period;
      side.robot.setPoses(side.player.sample(time * share, side.poses));
    }
  }
}
