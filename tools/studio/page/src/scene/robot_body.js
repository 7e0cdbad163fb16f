// SPDX-License-Identifier: Apache-2.0
// A robot in the scene: one group for each body, one mesh for each geom. Meshes stay while the
// design changes; a geometry is swapped only where a size asks for another.
import { Color, Group, Mesh, Quaternion } from "three";
import { bodyIndex } from "../decode.js";
import { meshGeometry, scaleOf, shapeKey, shapeOf, sidesOf } from "./geometry.js";
import { LitPaint } from "./paint.js";

const HIGHEST_GROUP = 2; // MuJoCo draws groups 0 to 2
const HIGHLIGHT = new Color(0x2f7fd0);
const ERROR = 0.35; // pixels between what is round and what is drawn,
const GHOST_ERROR = 1.2; // of a ghost

/** The geometry of a geom's shadow: half as round, which nobody sees in what is flat and faint. */
const shadeOf = (geom, sides) => shapeOf(geom, Math.max(8, 2 * Math.ceil(sides / 4)));

/** Frees a geometry that is one mesh's own. */
const free = (geometry) => geometry && !geometry.userData.shared && geometry.dispose();

export class RobotBody {
  /**
   * @param {object} options
   * @param {?number} options.ghost opacity of a robot that is drawn as a ghost
   * @param {(id: string) => Promise<import("../types.js").Mesh>} options.meshSource
   * @param {() => void} options.changed called when a mesh has arrived
   */
  constructor({ ghost = null, tint = null, meshSource, changed }) {
    this.root = new Group();
    this.ghost = ghost;
    this.tint = tint;
    this.meshSource = meshSource;
    this.changed = changed;
    /** @type {Group[]} */ this.groups = [];
    /** @type {Mesh[]} */ this.meshes = [];
    this.bodies = [];
    this.loaded = new Map(); // mesh geometries by id
    this.pixel = 0; // m of the robot, where it is drawn; 0: as finely as can be
  }

  /** @param {import("../types.js").Design} design */
  setDesign(design) {
    if (this.layoutOf(design) !== this.layout) this.rebuild(design);
    this.bodies = design.bodies;
    design.geoms.forEach((geom, i) => this.updateMesh(this.meshes[i], geom, design));
  }

  layoutOf(design) {
    return design.bodies.length + "|" + design.geoms.map((g) => `${g.body} ${g.type}`).join("|");
  }

  rebuild(design) {
    this.dispose();
    this.layout = this.layoutOf(design);
    this.groups = design.bodies.map(() => new Group());
    for (const group of this.groups) this.root.add(group);
    this.meshes = design.geoms.map((geom) => {
      const material = new LitPaint();
      if (this.ghost !== null)
        Object.assign(material, { transparent: true, opacity: this.ghost, depthWrite: false });
      const mesh = new Mesh(undefined, material);
      mesh.geometry.dispose();
      mesh.userData.body = bodyIndex(design.bodies, geom.body);
      this.groups[mesh.userData.body]?.add(mesh);
      return mesh;
    });
  }

  updateMesh(mesh, geom, design) {
    const [r, g, b, a] = geom.rgba;
    mesh.visible = geom.group <= HIGHEST_GROUP && a > 0 && geom.type !== "plane";
    mesh.position.fromArray(geom.pos);
    mesh.quaternion.set(geom.quat[1], geom.quat[2], geom.quat[3], geom.quat[0]);
    mesh.scale.fromArray(scaleOf(geom));
    mesh.material.color.setRGB(r, g, b, "srgb");
    if (this.tint) mesh.material.color.lerp(this.tint, 0.75);
    if (a < 1 && this.ghost === null)
      Object.assign(mesh.material, { transparent: true, opacity: a });
    mesh.userData.geom = geom;
    this.shape(mesh, design);
  }

  /** Gives a mesh the geometry of its geom and of its shadow, where it has them not. */
  shape(mesh, design) {
    const { geom } = mesh.userData;
    const sides = sidesOf(geom, (this.ghost === null ? ERROR : GHOST_ERROR) * this.pixel);
    const key = shapeKey(geom, sides);
    if (mesh.userData.shape === key) return;
    mesh.userData.shape = key;
    this.freeShapes(mesh);
    mesh.userData.kept = geom.type === "mesh";
    if (geom.type === "mesh") return this.loadMesh(mesh, geom.mesh, key, design);
    mesh.geometry = shapeOf(geom, sides) ?? mesh.geometry;
    if (this.ghost === null) mesh.userData.shade = shadeOf(geom, sides);
  }

  /** Frees what is this mesh's own; geometries of files stay. */
  freeShapes(mesh) {
    if (!mesh.userData.kept) free(mesh.geometry);
    free(mesh.userData.shade);
    mesh.userData.shade = null;
  }

  /** Draws what is round as finely as is seen where a pixel is so large. @param {number} pixel [m] */
  setPixel(pixel) {
    if (pixel === this.pixel || !this.root.visible) return;
    this.pixel = pixel;
    for (const mesh of this.meshes) this.shape(mesh);
  }

  loadMesh(mesh, id, key, design) {
    const take = (geometry) => {
      if (mesh.userData.shape !== key) return;
      mesh.geometry = geometry;
      this.changed();
    };
    if (!this.loaded.has(id)) {
      const source = design.meshes?.[id] ?? this.meshSource?.(id);
      this.loaded.set(id, Promise.resolve(source).then(meshGeometry));
    }
    this.loaded.get(id).then(take, () => (mesh.visible = false));
  }

  /** Once all meshes are here, or are known not to come. */
  complete() {
    return Promise.allSettled(this.loaded.values());
  }

  /** @param {Float32Array} poses position and quaternion (wxyz) of each body */
  setPoses(poses) {
    this.groups.forEach((group, i) => {
      const o = 7 * i;
      if (o + 6 >= poses.length) return;
      group.position.set(poses[o], poses[o + 1], poses[o + 2]);
      group.quaternion.set(poses[o + 4], poses[o + 5], poses[o + 6], poses[o + 3]);
    });
  }

  /** Colours the bodies of these indices as selected; none for an empty list. */
  highlight(bodies) {
    for (const mesh of this.meshes) {
      const on = bodies.includes(mesh.userData.body);
      mesh.material.emissive.copy(HIGHLIGHT).multiplyScalar(on ? 0.35 : 0);
    }
  }

  /** A point of a body's frame in the frame of `root`. */
  place(body, at, out) {
    const group = this.groups[body];
    if (!group) return out.set(0, 0, 0);
    return out.fromArray(at).applyQuaternion(group.quaternion).add(group.position);
  }

  /** A direction of a body's frame in the frame of `root`. */
  turn(body, direction, out) {
    const group = this.groups[body];
    return out.fromArray(direction).applyQuaternion(group ? group.quaternion : new Quaternion());
  }

  dispose() {
    for (const mesh of this.meshes) {
      this.freeShapes(mesh);
      mesh.material.dispose();
    }
    this.root.clear();
    this.groups = [];
    this.meshes = [];
  }
}
