// SPDX-License-Identifier: Apache-2.0
// Handles on the robot, by which parameters are taken hold of: a knob on a line for lengths, blocks
// for faces of the trunk, a ring about an axis for turns. While one is held, its bounds are seen.
import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  ConeGeometry,
  Group,
  Line,
  Mesh,
  Quaternion,
  SphereGeometry,
  TorusGeometry,
  Vector3,
} from "three";
import { bodyIndex } from "../decode.js";
import { FlatPaint, LinePaint } from "./paint.js";

export const COLOURS = { idle: 0x2f7fd0, active: 0xe8871e, locked: 0x8b95a1, bound: 0xe8871e };
const SHAPES = {
  move: new SphereGeometry(1, 10, 6), // of a few pixels each
  scale: new BoxGeometry(1.7, 1.7, 1.7),
  turn: new SphereGeometry(0.8, 10, 6),
};
const TIP = new ConeGeometry(0.75, 1.5, 14);
const RING = new TorusGeometry(1, 0.035, 8, 56);
const RING_RADIUS = 0.09; // of the robot's size
const KNOB = 6.5; // pixels
const Z = new Vector3(0, 0, 1);
const Y = new Vector3(0, 1, 0);

/** The handles of a parameter, of which it may have one for each limb. */
export function handlesOf({ handle }) {
  if (!handle) return [];
  const { kind, also = [], ...first } = handle;
  return [first, ...also].map((each) => ({ kind, ...each }));
}

class Handle {
  constructor(parameter, handle, bodies) {
    this.name = parameter.name;
    this.kind = handle.kind;
    this.body = bodyIndex(bodies, handle.body);
    this.at = handle.at;
    this.direction = handle.direction;
    this.root = new Group();
    this.root.visible = false; // until it is where it belongs
    this.material = this.own(FlatPaint, COLOURS.idle);
    this.knob = new Mesh(SHAPES[this.kind], this.material);
    this.root.add(this.knob);
    if (this.kind === "turn") {
      this.ring = new Mesh(RING, this.material);
      this.root.add(this.ring);
    } else {
      this.tips = [new Mesh(TIP, this.material), new Mesh(TIP, this.material)];
      this.root.add(...this.tips);
    }
    for (const each of this.root.children) each.renderOrder = 10;
    this.range = this.rangeLine();
    this.centre = new Vector3(); // in the world's frame
    this.along = new Vector3(); // of the value, likewise
    this.held = new Vector3(); // the point that is taken hold of
  }

  own(Material, color) {
    return new Material({ color, depthTest: false, transparent: true, fog: false, opacity: 0.92 });
  }

  rangeLine() {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * 41), 3));
    const group = new Group();
    const line = new Line(geometry, this.own(LinePaint, COLOURS.bound));
    line.frustumCulled = false;
    const cap = this.own(FlatPaint, COLOURS.bound);
    cap.opacity = 0.45;
    const ends = [new Mesh(SHAPES[this.kind], cap), new Mesh(SHAPES[this.kind], cap)];
    group.add(line, ...ends);
    group.visible = false;
    for (const each of group.children) each.renderOrder = 9;
    return group;
  }

  dispose() {
    this.range.children[0].geometry.dispose();
    for (const each of [...this.root.children, ...this.range.children]) each.material.dispose();
  }
}

export class Handles {
  constructor() {
    this.root = new Group();
    /** @type {Handle[]} */ this.all = [];
    this.selected = new Set();
    this.hovered = null;
    this.visible = true;
    this.q = new Quaternion();
    this.p = new Vector3();
  }

  /** @param {import("../types.js").Parameter[]} parameters */
  setParameters(parameters, bodies) {
    for (const each of this.all) each.dispose();
    this.root.clear();
    this.parameters = new Map(parameters.map((each) => [each.name, each]));
    this.all = parameters.flatMap((parameter) =>
      handlesOf(parameter).map((handle) => new Handle(parameter, handle, bodies)),
    );
    for (const each of this.all) this.root.add(each.root, each.range);
  }

  /** @param {number[][][]} places of each parameter's handles, as a design has them */
  moveTo(places) {
    const flat = places.flat();
    if (flat.length !== this.all.length) return;
    this.all.forEach((handle, i) => (handle.at = flat[i]));
  }

  /** The names of the parameters that have a handle on one of these bodies. */
  namesOn(body) {
    return [...new Set(this.all.filter((each) => each.body === body).map((each) => each.name))];
  }

  isShown(handle) {
    if (!this.visible) return false;
    if (this.selected.has(handle.name) || this.hovered === handle.name) return true;
    return handle.kind !== "turn"; // rings are seen where they are wanted
  }

  /**
   * Follows robot and camera.
   * @param {import("./robot_body.js").RobotBody} robot
   * @param {(name: string) => {value: number, lower: number, upper: number, locked: boolean}} read
   */
  update(robot, camera, height, size, read) {
    const perPixel = (2 * Math.tan((camera.fov * Math.PI) / 360)) / height;
    for (const handle of this.all) {
      handle.root.visible = this.isShown(handle);
      handle.range.visible = false;
      if (!handle.root.visible) continue;
      robot.place(handle.body, handle.at, handle.centre);
      robot.turn(handle.body, handle.direction, handle.along);
      const state = read(handle.name);
      const active = this.selected.has(handle.name) || this.hovered === handle.name;
      const colour = state.locked ? COLOURS.locked : active ? COLOURS.active : COLOURS.idle;
      handle.material.color.set(colour);
      this.p.copy(handle.centre).applyMatrix4(this.root.matrixWorld);
      const pixel = camera.position.distanceTo(this.p) * perPixel;
      if (handle.kind === "turn") this.shapeRing(handle, pixel, size, state);
      else this.shapeKnob(handle, pixel, active);
      if (active) this.showRange(handle, pixel, size, state);
    }
  }

  shapeKnob(handle, pixel, active) {
    handle.root.position.copy(handle.centre);
    handle.held.copy(handle.centre);
    const knob = KNOB * pixel * (active ? 1.15 : 0.8);
    handle.knob.scale.setScalar(knob);
    this.q.setFromUnitVectors(Y, this.p.copy(handle.along).normalize());
    handle.knob.quaternion.copy(this.q);
    handle.tips.forEach((tip, i) => {
      const sign = i ? -1 : 1;
      tip.visible = active;
      tip.scale.setScalar(knob * 0.8);
      tip.quaternion.copy(this.q);
      if (i) tip.rotateX(Math.PI);
      tip.position.copy(this.p).multiplyScalar(sign * knob * 2.5);
    });
  }

  /** A ring whose knob stands at the value's angle. */
  shapeRing(handle, pixel, size, { value }) {
    handle.root.position.copy(handle.centre);
    const axis = this.p.copy(handle.along).normalize();
    handle.root.quaternion.setFromUnitVectors(Z, axis);
    handle.radius = size * RING_RADIUS;
    handle.ring.scale.setScalar(handle.radius);
    handle.ring.scale.z = Math.max(handle.radius, 35 * pixel);
    handle.knob.scale.setScalar(KNOB * pixel);
    const spot = new Vector3(Math.cos(value), Math.sin(value), 0).multiplyScalar(handle.radius);
    handle.knob.position.copy(spot);
    handle.held.copy(spot).applyQuaternion(handle.root.quaternion).add(handle.centre);
  }

  /** The ghosts of the bounds: how far the handle can go. */
  showRange(handle, pixel, size, { value, lower, upper }) {
    const [line, low, high] = handle.range.children;
    const position = line.geometry.attributes.position;
    const count = position.count;
    const spot = new Vector3();
    handle.range.visible = true;
    for (let i = 0; i < count; i++) {
      const v = lower + ((upper - lower) * i) / (count - 1);
      if (handle.kind === "turn") {
        spot.set(Math.cos(v), Math.sin(v), 0).multiplyScalar(handle.radius * 1.12);
        spot.applyQuaternion(handle.root.quaternion).add(handle.centre);
      } else
        spot
          .copy(handle.along)
          .multiplyScalar(v - value)
          .add(handle.centre);
      position.setXYZ(i, spot.x, spot.y, spot.z);
      if (i === 0) low.position.copy(spot);
    }
    high.position.copy(spot);
    position.needsUpdate = true;
    for (const end of [low, high]) {
      end.scale.setScalar(KNOB * pixel * 0.75);
      end.quaternion.copy(handle.kind === "turn" ? handle.root.quaternion : handle.knob.quaternion);
    }
  }
}
