// SPDX-License-Identifier: Apache-2.0
// Shapes of MuJoCo's geoms. Boxes, balls and cylinders are one unit shape each, scaled; capsules
// and meshes have a geometry of their own, which changes only when their size does.
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

const UNIT = {
  box: new BoxGeometry(2, 2, 2),
  sphere: new SphereGeometry(1, 20, 12),
  ellipsoid: new SphereGeometry(1, 20, 12),
  cylinder: new CylinderGeometry(1, 1, 2, 24).rotateX(Math.PI / 2), // along z
};

const CREASE = 0.6; // rad between faces, from which on an edge is seen

/** What the shape of a geom depends on besides its scale: equal keys, equal geometry. */
export function shapeKey(geom) {
  if (geom.type === "capsule") return `capsule ${geom.size[0]} ${geom.size[1]}`;
  if (geom.type === "mesh") return `mesh ${geom.mesh}`;
  return geom.type;
}

/** The geometry of a geom that is no mesh; null for what is not drawn (planes). */
export function shapeOf(geom) {
  if (geom.type === "capsule")
    return new CapsuleGeometry(geom.size[0], 2 * geom.size[1], 6, 16).rotateX(Math.PI / 2);
  return UNIT[geom.type] ?? null;
}

/** Whether the geometry is shared by all geoms of its type and must not be disposed of. */
export function isShared(geometry) {
  return Object.values(UNIT).includes(geometry);
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
