// SPDX-License-Identifier: Apache-2.0
// The robot's shadow: its meshes flattened onto the ground along the light. The stencil keeps what
// lies twice from being darker, so it costs no shadow map.
import {
  EqualStencilFunc,
  Group,
  IncrementStencilOp,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
} from "three";

export class Shadow {
  /** @param {import("three").Vector3} sun towards the light */
  constructor(sun) {
    this.root = new Group();
    this.material = new MeshBasicMaterial({
      color: 0x000000,
      transparent: true,
      opacity: 0.13,
      depthWrite: false,
      stencilWrite: true,
      stencilFunc: EqualStencilFunc,
      stencilZPass: IncrementStencilOp,
      fog: false,
    });
    const [x, y] = [sun.x / sun.z, sun.y / sun.z];
    this.flat = new Matrix4().set(1, 0, -x, 0, 0, 1, -y, 0, 0, 0, 0, 0.0008, 0, 0, 0, 1);
    this.flat.elements[10] = 1e-5; // keeps normals finite
  }

  setTheme(theme) {
    this.material.opacity = theme === "dark" ? 0.42 : 0.13;
  }

  /** Follows the meshes of a robot, whose world matrices are up to date. */
  follow(meshes) {
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
      shade.geometry = mesh.geometry;
      shade.matrix.multiplyMatrices(this.flat, mesh.matrixWorld);
      shade.matrixWorldNeedsUpdate = true;
    });
  }
}
