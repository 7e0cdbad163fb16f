// SPDX-License-Identifier: Apache-2.0
// The ground: a grid of lines, which slides under a robot that is kept in the picture and fades
// into the background. Lines alone, because a plane's pixels cost most of a picture in software;
// each is cut to what can be seen, because software GL drops lines that end behind the camera.
import {
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  Group,
  LineSegments,
  Matrix4,
} from "three";
import { LinePaint } from "./paint.js";

const REACH = 40; // cells to each side
const MAJOR = 5; // every so many cells a stronger line

/** The lines of one strength, of which each picture has the parts before the camera. */
class Lines extends LineSegments {
  /** @param {(number: number) => boolean} passes which lines there are, of -REACH to REACH */
  constructor(passes, material) {
    const numbers = [];
    for (let i = -REACH; i <= REACH; i++) if (passes(i)) numbers.push(i);
    const geometry = new BufferGeometry();
    const points = new BufferAttribute(new Float32Array(12 * numbers.length), 3);
    geometry.setAttribute("position", points.setUsage(DynamicDrawUsage));
    super(geometry, material);
    this.numbers = numbers;
    this.points = points;
    this.frustumCulled = false;
  }

  /**
   * @param {number[]} depth coefficients of x, y and 1 for the depth of a point of the ground
   * @param {number} near least depth that is drawn @param {number} far depth at which all has faded
   */
  cut([x, y, one], near, far) {
    const { points, numbers } = this;
    let count = 0;
    const add = (number, rate, start, along) => {
      // Where depth = start + rate t passes both, along the line.
      const [a, b] = [(near - start) / rate, (far - start) / rate];
      const from = Math.max(-REACH, Math.min(a, b));
      const to = Math.min(REACH, Math.max(a, b));
      if (!(from < to)) return;
      for (const t of [from, to]) points.setXYZ(count++, along ? t : number, along ? number : t, 0);
    };
    for (const number of numbers) {
      add(number, x, y * number + one, true);
      add(number, y, x * number + one, false);
    }
    this.geometry.setDrawRange(0, count);
    points.needsUpdate = true;
  }
}

export class Ground {
  constructor() {
    this.mesh = new Group();
    this.minor = new LinePaint();
    this.major = new LinePaint();
    this.mesh.add(
      new Lines((i) => i % MAJOR !== 0, this.minor),
      new Lines((i) => i % MAJOR === 0, this.major),
    );
    this.toCamera = new Matrix4();
    this.setCell(0.1);
  }

  setColours({ line, minor }) {
    this.major.color.set(line);
    this.minor.color.set(minor);
  }

  /** @param {number} cell [m] */
  setCell(cell) {
    this.tile = cell * MAJOR;
    this.mesh.scale.setScalar(cell);
  }

  /** Slides the grid, as if its origin were at (x, y). */
  moveTo(x, y) {
    const wrap = (v) => v - Math.round(v / this.tile) * this.tile;
    this.mesh.position.set(wrap(x), wrap(y), 0);
  }

  /** Cuts the lines to what a camera sees, up to where fog hides them. */
  cutFor(camera, fog) {
    const { elements: m } = this.toCamera.multiplyMatrices(
      camera.matrixWorldInverse,
      this.mesh.matrixWorld,
    );
    for (const lines of this.mesh.children)
      lines.cut([-m[2], -m[6], -m[14]], camera.near, Math.min(fog.far, camera.far));
  }
}
