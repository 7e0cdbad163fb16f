// SPDX-License-Identifier: Apache-2.0
// Pointers over the picture, mouse, pen and finger alike: hovering and dragging handles, picking
// bodies, pushing. What is not a handle turns the camera.
import { Raycaster, Vector2, Vector3 } from "three";
import { beginDrag, onScreen } from "./handle_drag.js";

const REACH = { mouse: 13, pen: 16, touch: 26 }; // pixels around a handle
const CLICK = 5; // pixels within which a press is a click
const TOGETHER = 400; // ms within which a second finger makes two that move the camera

export class Pointer {
  /**
   * @param {import("./scene_view.js").SceneView} view
   * @param {object} told
   * @param {(name: ?string) => void} told.hover
   * @param {(name: string, value: number, phase: "begin"|"drag"|"end"|"cancel") => void} told.drag
   * @param {(body: ?number, add: boolean, geom: ?object) => void} told.pick
   * @param {(push: ?{body: number, at: number[], along: Vector3}) => void} told.push
   */
  constructor(view, told) {
    this.view = view;
    this.told = told;
    this.ray = new Raycaster();
    this.held = null;
    this.pushing = false; // whether a drag on the robot pushes it
    const { canvas } = view.stage;
    const on = (name, act) => canvas.addEventListener(name, act, { capture: true });
    on("pointerdown", (event) => this.down(event));
    on("pointermove", (event) => this.move(event));
    on("pointerup", (event) => this.up(event, "end"));
    on("pointercancel", (event) => this.up(event, "cancel"));
    on("pointerleave", () => this.held || this.hover(null));
  }

  spot(event) {
    const box = this.view.stage.canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top, box };
  }

  /** The handle under the pointer, the nearest where there are several. */
  handleAt(event) {
    const { x, y, box } = this.spot(event);
    const { handles, stage } = this.view;
    let best = null;
    let least = REACH[event.pointerType] ?? REACH.mouse;
    for (const handle of handles.all) {
      if (!handle.root.visible) continue;
      const world = handle.held.clone().applyMatrix4(handles.root.matrixWorld);
      const at = onScreen(world, stage.camera, box.width, box.height);
      const far = Math.hypot(at.x - x, at.y - y) - (handles.selected.has(handle.name) ? 4 : 0);
      if (far < least && at.depth < 1) [best, least] = [handle, far];
    }
    return best;
  }

  /** The body under the pointer, and the point in its frame. */
  bodyAt(event) {
    const { x, y, box } = this.spot(event);
    const ndc = new Vector2((2 * x) / box.width - 1, 1 - (2 * y) / box.height);
    const { robot, stage } = this.view;
    this.ray.setFromCamera(ndc, stage.camera);
    const hit = this.ray.intersectObjects(
      robot.meshes.filter((mesh) => mesh.visible),
      false,
    )[0];
    if (!hit) return null;
    const body = hit.object.userData.body;
    const { geom } = hit.object.userData;
    const at = robot.groups[body].worldToLocal(hit.point.clone());
    return { body, at, point: hit.point, geom };
  }

  down(event) {
    if (!event.isTrusted) return; // what is handed to the camera
    if (this.held && !event.isPrimary) this.giveToCamera(event);
    if (event.button !== 0 || !event.isPrimary || !this.view.design) return;
    const { x, y, box } = this.spot(event);
    this.start = { x, y };
    const handle = this.handleAt(event);
    if (handle) return this.take(handle, event, x, y, box);
    if (this.pushing || event.shiftKey) this.beginPush(event);
  }

  take(handle, event, x, y, box) {
    this.grab(event);
    const { handles, stage } = this.view;
    const state = this.view.readParameter(handle.name);
    if (state.locked) {
      this.told.drag(handle.name, state.value, "locked");
      return;
    }
    const world = handles.root.matrixWorld;
    const { width, height } = box;
    const change = beginDrag(handle, world, stage.camera, width, height, x, y);
    this.held = { name: handle.name, from: state.value, state, change };
    this.told.drag(handle.name, state.value, "begin");
  }

  /** Keeps the pointer for this drag; the camera stays. */
  grab(event) {
    event.stopImmediatePropagation();
    event.preventDefault();
    this.first = event;
    const { canvas, controls } = this.view.stage;
    canvas.focus({ preventScroll: true });
    canvas.setPointerCapture(event.pointerId);
    controls.enabled = false;
  }

  /** Two fingers of which the first met a handle or the robot: what it took stays as it was. */
  giveToCamera({ timeStamp }) {
    const { first, held } = this;
    if (first.pointerType !== "touch" || timeStamp - first.timeStamp > TOGETHER) return;
    this.letGo(held.from, "cancel");
    this.start = null;
    const { pointerId, pointerType, clientX, clientY } = first;
    const told = new PointerEvent("pointerdown", { pointerId, pointerType, clientX, clientY });
    this.view.stage.canvas.dispatchEvent(told);
  }

  letGo(value, phase) {
    const { held } = this;
    this.held = null;
    this.view.stage.controls.enabled = true;
    if (held.push) {
      this.view.push = null;
      this.told.push(null);
    } else this.told.drag(held.name, value, phase);
  }

  beginPush(event) {
    const hit = this.bodyAt(event);
    if (!hit) return;
    this.grab(event);
    this.held = { push: hit };
  }

  move(event) {
    if (!this.view.design) return;
    if (!this.held) {
      if (event.buttons === 0) this.hover(this.handleAt(event)?.name ?? null);
      return;
    }
    event.stopImmediatePropagation();
    if (event.pointerId !== this.first.pointerId) return; // another finger
    const { x, y } = this.spot(event);
    if (this.held.push) return this.movePush(event);
    const { from, state, change, name } = this.held;
    const value = Math.min(state.upper, Math.max(state.lower, from + change(x, y)));
    this.held.value = value;
    this.told.drag(name, value, "drag");
  }

  movePush(event) {
    const { x, y, box } = this.spot(event);
    const { camera } = this.view.stage;
    const { point, body, at } = this.held.push;
    const depth = point.clone().project(camera).z;
    const to = new Vector3((2 * x) / box.width - 1, 1 - (2 * y) / box.height, depth);
    const along = to.unproject(camera).sub(point); // in the ground's frame from here on
    along.applyQuaternion(this.view.stage.tilted.quaternion.clone().invert());
    this.view.push = { body, at: at.toArray(), along };
    this.told.push(this.view.push);
  }

  up(event, phase) {
    const { canvas, controls } = this.view.stage;
    const { held, first } = this;
    if (held && event.pointerId !== first.pointerId) return; // another finger goes
    controls.enabled = true;
    if (held) {
      event.stopImmediatePropagation();
      if (canvas.hasPointerCapture(event.pointerId)) canvas.releasePointerCapture(event.pointerId);
      return this.letGo(held.value ?? held.from, phase);
    }
    if (!this.start || phase !== "end") return;
    const { x, y } = this.spot(event);
    const still = Math.hypot(x - this.start.x, y - this.start.y) < CLICK;
    this.start = null;
    if (!still) return;
    const hit = this.bodyAt(event);
    this.told.pick(hit?.body ?? null, event.ctrlKey || event.metaKey, hit?.geom);
  }

  hover(name) {
    const { canvas } = this.view.stage;
    canvas.style.cursor = name ? "grab" : "";
    if (this.hovered === name) return;
    this.hovered = name;
    this.told.hover(name);
  }
}
