// SPDX-License-Identifier: Apache-2.0
// The robot's shadow: its meshes flattened onto the ground along the light. The stencil keeps what
// lies twice from being darker, so it costs no shadow map.
import {
  EqualStencilFunc,
  Group,
  IncrementStencilOp,
  Matrix4,
  Mesh,
  Vector3,
} from "three";
import { FlatPaint } from "./paint.js";

export class Shadow {
  /** @param {import("three").Vector3} sun towards the light */
  constructor(sun) {
    this.root = new Group();
    this.material = new FlatPaint({
      color: 0x000000,
      transparent: true,
      opacity: 0.13,
      depthWrite: false,
      stencilWrite: true,
      stencilFunc: EqualStencilFunc,
      stencilZPass: IncrementStencilOp,
      fog: false,
    });
    this.sun = sun;
    this.flat = new Matrix4();
    this.toGround = new Matrix4();
    this.here = new Vector3();
  }

  setTheme(theme) {
    this.material.opacity = theme === "dark" ? 0.42 : 0.13;
  }

  /** Flattens along the light, as the ground's frame has it. */
  aim() {
    const ground = this.root.parent;
    this.toGround.copy(ground.matrixWorld).invert();
    this.here.copy(this.sun).transformDirection(this.toGround);
    const [x, y] = [this.here.x / this.here.z, this.here.y / this.here.z];
    this.flat.set(1, 0, -x, 0, 0, 1, -y, 0, 0, 0, 1e-5, 0.0008, 0, 0, 0, 1); // normals stay finite
    this.flat.multiply(this.toGround);
  }

  /** Follows the meshes of a robot, whose world matrices are up to date. */
  follow(meshes) {
    this.aim();
    while (this.root.children.length > meshes.length) this.root.children.pop();
    while (this.root.children.length < meshes.length) {
      const mesh = new Mesh(undefined, this.material);
      mesh.matrixAutoUpdate = false;
      mesh.frustumCulled = false;
      mesh.renderOrder = 1;
      this.root.add(mesh);
    }
    meshes.forEach((mesh, i) => {
      const shade = this.root.children[i];
      shade.visible = mesh.visible;
      shade.geometry = mesh.userData.shade ?? mesh.geometry;
      shade.matrix.multiplyMatrices(this.flat, mesh.matrixWorld);
      shade.matrixWorldNeedsUpdate = true;
    });
  }
}
