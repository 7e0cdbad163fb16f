// SPDX-License-Identifier: Apache-2.0
// What a pointer's way on the screen means for the value of the handle it holds. The robot walks on
// meanwhile, so the way is measured against how the handle looked when it was taken hold of.
import { Vector3 } from "three";

const FLATTEST = 60; // pixels per metre of a handle's size, below which a line points at the viewer

/** Where a point of the world is on the screen [pixels]. */
export function onScreen(point, camera, width, height) {
  const p = point.clone().project(camera);
  return { x: (p.x * 0.5 + 0.5) * width, y: (0.5 - p.y * 0.5) * height, depth: p.z };
}

/**
 * Begins to drag.
 * @param {object} handle of Handles, up to date
 * @param {import("three").Matrix4} world of the handles' frame
 * @returns {(x: number, y: number) => number} the change of the value for a pointer there [m, rad]
 */
export function beginDrag(handle, world, camera, width, height, x, y) {
  const centre = handle.centre.clone().applyMatrix4(world);
  const held = handle.held.clone().applyMatrix4(world);
  const along = handle.along.clone().transformDirection(world);
  return handle.kind === "turn"
    ? turning(centre, held, along, camera, width, height, x, y)
    : moving(held, along.multiplyScalar(handle.along.length()), camera, width, height, x, y);
}

/** Along a line: the pointer's way along the line's picture. */
function moving(held, along, camera, width, height, x, y) {
  const step = 1e-3;
  const a = onScreen(held, camera, width, height);
  const b = onScreen(held.clone().addScaledVector(along, step), camera, width, height);
  let [dx, dy] = [(b.x - a.x) / step, (b.y - a.y) / step]; // pixels per unit of the value
  let squared = dx * dx + dy * dy;
  if (squared < FLATTEST * FLATTEST) {
    [dx, dy] = [0, -300]; // seen end on: up is more
    squared = dx * dx + dy * dy;
  }
  return (px, py) => ((px - x) * dx + (py - y) * dy) / squared;
}

/** About an axis: the pointer's angle about the axis' picture, or, seen from its side, its way. */
function turning(centre, held, axis, camera, width, height, x, y) {
  const c = onScreen(centre, camera, width, height);
  const view = centre.clone().sub(camera.position).normalize();
  const facing = axis.dot(view);
  if (Math.abs(facing) > 0.25) {
    const sign = facing < 0 ? -1 : 1; // screens have y down
    let last = Math.atan2(y - c.y, x - c.x);
    let sum = 0;
    return (px, py) => {
      const angle = Math.atan2(py - c.y, px - c.x);
      let change = angle - last;
      if (change > Math.PI) change -= 2 * Math.PI;
      if (change < -Math.PI) change += 2 * Math.PI;
      sum += change;
      last = angle;
      return sign * sum;
    };
  }
  const radius = held.clone().sub(centre);
  const tangent = new Vector3().crossVectors(axis, radius);
  return moving(held, tangent, camera, width, height, x, y);
}
