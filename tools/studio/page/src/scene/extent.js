// SPDX-License-Identifier: Apache-2.0
// How large a robot is, and where its soles are.
import { Box3, Quaternion, Vector3 } from "three";

/** Size (the larger of length and height) and height of a robot as it is posed [m]. */
export function sizeOf(robot) {
  robot.root.updateMatrixWorld(true);
  const box = new Box3();
  for (const mesh of robot.meshes) if (mesh.visible) box.expandByObject(mesh);
  const extent = box.getSize(new Vector3());
  if (box.isEmpty()) return { size: 0.5, height: 0.3 };
  return { size: Math.max(extent.x, extent.y, extent.z), height: box.max.z };
}

/** The lowest point of a foot: below its ball, or below what is farthest from its joint. */
function soleGeom(design, body) {
  const name = design.bodies[body]?.name;
  const on = design.geoms.filter((geom) => geom.body === body || geom.body === name);
  const length = (geom) => Math.hypot(...geom.pos);
  const balls = on.filter((geom) => geom.type === "sphere");
  const all = balls.length ? balls : on;
  return all.reduce((a, b) => (!a || length(b) > length(a) ? b : a), null);
}

/**
 * @returns {(poses: Float32Array, foot: number, out: Vector3) => Vector3} the point of a foot that
 * touches the ground, in the frame of the poses
 */
export function soleFinder(design, player) {
  const quaternion = new Quaternion();
  const soles = player.feet.map((foot, i) => {
    let body = player.footBody[i];
    if (typeof body !== "number" || body < 0)
      body = design.bodies.findIndex((each) => each.name === foot.body);
    const geom = soleGeom(design, body);
    const radius = geom ? (geom.type === "sphere" ? geom.size[0] : Math.min(...geom.size)) : 0;
    return { body, at: foot.at ?? geom?.pos ?? [0, 0, 0], radius };
  });
  return (poses, foot, out) => {
    const { body, at, radius } = soles[foot];
    const o = 7 * body;
    quaternion.set(poses[o + 4], poses[o + 5], poses[o + 6], poses[o + 3]);
    out.fromArray(at).applyQuaternion(quaternion);
    out.set(out.x + poses[o], out.y + poses[o + 1], out.z + poses[o + 2] - radius);
    return out;
  };
}
