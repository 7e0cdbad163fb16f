// SPDX-License-Identifier: Apache-2.0
// Shapes of MuJoCo's geoms. Boxes, balls and cylinders are unit shapes, scaled; capsules and meshes
// have a geometry of their own, which changes only when their size does. Round ones have as many
// sides as are seen: triangles are what a picture costs most where GL runs on the processor.
import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  CapsuleGeometry,
  CylinderGeometry,
  SphereGeometry,
} from "three";
import { toCreasedNormals } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import { floatsOf, indicesOf } from "../decode.js";

const MAKE = {
  box: () => new BoxGeometry(2, 2, 2),
  sphere: (sides) => new SphereGeometry(1, sides, sides / 2),
  ellipsoid: (sides) => new SphereGeometry(1, sides, sides / 2),
  cylinder: (sides) => new CylinderGeometry(1, 1, 2, sides).rotateX(Math.PI / 2), // along z
};
const units = new Map(); // of these, what was made: shared by all geoms

const CREASE = 0.6; // rad between faces, from which on an edge is seen
const FEWEST = 8; // sides of what is round
export const MOST = 24;

/** The radius of a geom that is round [m]; 0 of others. */
function radiusOf({ type, size }) {
  if (type === "ellipsoid") return Math.max(...size);
  return type === "sphere" || type === "cylinder" || type === "capsule" ? size[0] : 0;
}

/**
 * How many sides a geom needs, for its outline to be within an error of a round one.
 * @param {number} error [m]
 */
export function sidesOf(geom, error) {
  const radius = radiusOf(geom);
  if (!radius) return 0;
  const sides = Math.PI / Math.acos(Math.max(0, 1 - error / radius));
  return Math.min(MOST, Math.max(FEWEST, 2 * Math.ceil(sides / 2)));
}

/** What the shape of a geom depends on besides its scale: equal keys, equal geometry. */
export function shapeKey(geom, sides) {
  if (geom.type === "capsule") return `capsule ${geom.size[0]} ${geom.size[1]} ${sides}`;
  if (geom.type === "mesh") return `mesh ${geom.mesh}`;
  return `${geom.type} ${sides}`;
}

/** The geometry of a geom that is no mesh; null for what is not drawn (planes). */
export function shapeOf(geom, sides) {
  if (geom.type === "capsule") {
    const [radius, half] = geom.size;
    return new CapsuleGeometry(radius, 2 * half, Math.ceil(sides / 4), sides).rotateX(Math.PI / 2);
  }
  if (!MAKE[geom.type]) return null;
  const key = shapeKey(geom, sides);
  if (!units.has(key)) units.set(key, MAKE[geom.type](sides));
  const geometry = units.get(key);
  geometry.userData.shared = true; // must not be disposed of
  return geometry;
}

/** The factors by which a geom's geometry is scaled. */
export function scaleOf(geom) {
  const [a, b, c] = geom.size;
  if (geom.type === "box" || geom.type === "ellipsoid") return [a, b, c];
  if (geom.type === "sphere") return [a, a, a];
  if (geom.type === "cylinder") return [a, a, b];
  return [1, 1, 1];
}

/** @param {import("../types.js").Mesh} mesh */
export function meshGeometry(mesh) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(floatsOf(mesh.vertices), 3));
  geometry.setIndex(new BufferAttribute(indicesOf(mesh.faces), 1));
  const normals = floatsOf(mesh.normals);
  if (normals.length === geometry.attributes.position.array.length)
    geometry.setAttribute("normal", new BufferAttribute(normals, 3));
  else return toCreasedNormals(geometry, CREASE);
  return geometry;
}
