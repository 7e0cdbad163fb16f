// SPDX-License-Identifier: Apache-2.0
// The ground: a grid of lines, which slides under a robot that is kept in the picture and fades
// into the background. Lines alone, because a plane's pixels cost most of a picture in software.
import { BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments } from "three";

const REACH = 40; // cells to each side
const PIECE = 4; // cells of a line's pieces: software GL drops lines that end behind the camera
const MAJOR = 5; // every so many cells a stronger line

/** Lines through the cells whose number passes, in units of a cell. */
function grid(passes) {
  const points = [];
  for (let i = -REACH; i <= REACH; i++)
    for (let a = -REACH; passes(i) && a < REACH; a += PIECE) {
      const b = a + PIECE;
      points.push(i, a, 0, i, b, 0, a, i, 0, b, i, 0);
    }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
  return geometry;
}

export class Ground {
  constructor() {
    this.mesh = new Group();
    this.minor = new LineBasicMaterial();
    this.major = new LineBasicMaterial();
    this.mesh.add(
      new LineSegments(
        grid((i) => i % MAJOR !== 0),
        this.minor,
      ),
      new LineSegments(
        grid((i) => i % MAJOR === 0),
        this.major,
      ),
    );
    for (const lines of this.mesh.children) lines.frustumCulled = false;
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
}
