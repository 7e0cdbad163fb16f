// SPDX-License-Identifier: Apache-2.0
// The picture of a robot that is assembled: its axes as arrows, spots for what is carried, and
// handles of what is selected: along x, y and z for its place, rings for its axis.
import { Vector3 } from "three";
import { h } from "../../dom.js";
import { floatsOf } from "../../decode.js";
import { Arrows } from "../../scene/arrows.js";
import { Pointer } from "../../scene/pointer.js";
import { SceneView } from "../../scene/scene_view.js";
import { Spots } from "../../scene/spots.js";
import { followTheme } from "../theme.js";

const WAYS = { x: new Vector3(1, 0, 0), y: new Vector3(0, 1, 0), z: new Vector3(0, 0, 1) };
const GRAIN = 0.0005; // m to which a place is dragged
const TURN = Math.PI / 36; // to which an axis is turned
const REACH = 0.3; // m that a handle shows to each side
const ALONG = 0.995; // cosine from which on a ring turns an axis about itself
const MARGIN = 1.25; // of the robot's size that the picture shows: legs hang low here
const KNOB_SHARE = 0.2; // of the robot's size: from a place to the knobs that move it
const AXIS_SHARE = 0.16; // of the robot's size: the arrow of an axis
const SNAP = 60; // pixels from which a carried module goes to a spot

const clean = (value) => Math.round(value * 1e6) / 1e6;

/** Key and value of an item's place, or null where it has none of its own. */
export function placeOf(client, item) {
  const found = client.find(item);
  if (item.startsWith("part/")) return { key: "position", item, value: found.at };
  if (item.endsWith("/foot")) return { key: "offset", item, value: found.offset };
  const limb = client.limbOf(item);
  if (!limb) return null;
  const first = item === limb.item || item === limb.joints[0].item;
  if (first) return { key: "hip", item: limb.item, value: limb.hip };
  return { key: "offset", item, value: found.offset };
}

export class AssemblyScene {
  /** @param {import("../../session/assembly_client.js").AssemblyClient} client */
  constructor(client) {
    this.client = client;
    this.element = h("div.stage");
    this.draft = null; // what is under the user's hand
  }

  /** Makes the picture, once it is to be seen. */
  begin() {
    if (this.view) return;
    const { client } = this;
    this.view = new SceneView(this.element, { meshSource: client.studio.meshSource });
    const { canvas } = this.view.stage;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", "The robot in 3-D. Arrow keys turn the camera.");
    this.view.margin = MARGIN;
    this.spots = new Spots(this.view.labels);
    this.axes = new Arrows(0x2f7fd0);
    this.view.walker.add(this.spots.root, this.axes.root);
    this.view.readParameter = (name) => this.read(name);
    this.view.onPose = () => this.overlay();
    canvas.addEventListener("pointermove", (event) => this.hoverSpot(event), { capture: true });
    canvas.addEventListener("click", (event) => this.clickSpot(event), { capture: true });
    new Pointer(this.view, {
      hover: (name) => {
        this.view.handles.hovered = name;
        this.view.pose();
      },
      drag: (name, value, phase) => this.drag(name, value, phase),
      pick: (body, _add, geom) => this.pick(body, geom),
      push: () => {},
    });
    followTheme((theme) => this.view.setTheme(theme));
  }

  show() {
    const { told } = this.client;
    this.begin();
    const { view } = this;
    const layout = told.design.bodies.length;
    if (layout !== this.layout && !view.stage.turned) view.framed = false;
    this.layout = layout;
    view.setDesign(told.design);
    view.setLive({ poses: floatsOf(told.design.poses), feet: [] });
    this.placeHandles();
    this.highlight();
  }

  /** Handles of what is selected. */
  placeHandles() {
    if (!this.view) return;
    const { client, view } = this;
    const { bodies } = client.told.design;
    const found = client.find(client.selected);
    const place = placeOf(client, client.selected);
    const at = found.at ?? client.limbOf(client.selected)?.joints[0].at;
    const axis = found.axis && new Vector3().fromArray(found.axis);
    const parameters = [];
    for (const [name, way] of Object.entries(WAYS)) {
      const direction = way.toArray();
      const beside = at && at.map((each, i) => each + KNOB_SHARE * view.size * direction[i]);
      if (place)
        parameters.push({ name, handle: { kind: "move", body: 1, at: beside, direction } });
      if (axis && Math.abs(axis.dot(way)) < ALONG)
        parameters.push({ name: `turn ${name}`, handle: { kind: "turn", body: 1, at, direction } });
    }
    view.handles.setParameters(client.carried ? [] : parameters, bodies);
    view.handles.selected = new Set(["turn x", "turn y", "turn z"]);
  }

  highlight() {
    const { selected, told } = this.client;
    const limb = this.client.find(selected)?.joints ? `${selected}/` : null;
    const bodies = told.items
      .map((item, body) => (item === selected || (limb && item.startsWith(limb)) ? body : -1))
      .filter((body) => body > 0);
    this.view.robot.highlight(selected === "trunk" ? [] : bodies);
    this.view.pose();
  }

  read(name) {
    const around = (value, reach) => ({ value, lower: value - reach, upper: value + reach });
    if (name.startsWith("turn")) return around(this.draft?.name === name ? this.draft.value : 0, 7);
    const place = placeOf(this.client, this.client.selected);
    const value = place ? place.value["xyz".indexOf(name)] : 0;
    return { ...around(value, REACH), locked: false };
  }

  drag(name, value, phase) {
    const { client } = this;
    if (phase === "begin") {
      client.begin();
      const item = client.selected;
      this.held = { item, place: placeOf(client, item), axis: client.find(item).axis };
    } else if (phase === "drag") {
      if (!this.held || !client.find(this.held.item)) return;
      this.draft = { name, value };
      if (name.startsWith("turn")) this.turnAxis(WAYS[name.at(-1)], value);
      else this.move("xyz".indexOf(name), value);
    } else if (phase === "cancel") this.cancelDrag();
    else this.letGo();
  }

  letGo() {
    this.held = this.draft = null;
    this.view.pose();
  }

  /** Puts back what is under the user's hand; false where nothing is. */
  cancelDrag() {
    if (!this.held) return false;
    const { item, place, axis } = this.held;
    if (this.draft?.name.startsWith("turn")) this.client.drag(item, "axis", axis);
    else if (this.draft) this.client.drag(place.item, place.key, place.value);
    this.letGo();
    return true;
  }

  move(i, value) {
    const { place } = this.held;
    const next = place.value.map(clean);
    next[i] = clean(Math.round(value / GRAIN) * GRAIN);
    this.client.drag(place.item, place.key, next);
  }

  turnAxis(way, angle) {
    const turn = Math.round(angle / TURN) * TURN;
    const axis = new Vector3().fromArray(this.held.axis).applyAxisAngle(way, turn);
    this.client.drag(this.held.item, "axis", axis.toArray().map(clean));
  }

  pick(body, geom) {
    if (this.client.carried || body === null) return;
    const item = this.client.told.items[body];
    const limb = item && this.client.limbOf(item);
    const last = limb?.joints.at(-1).item === item;
    // Feet are geoms of the last link, and the only ones that have a name there.
    this.client.select(last && geom?.name ? limb.foot.item : item || "trunk");
  }

  /** The spot that a pointer means, for what is carried. */
  spotAt(event) {
    const box = this.view.stage.canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    if (x < 0 || y < 0 || x > box.width || y > box.height) return null;
    return this.spots.near(x, y, SNAP, this.view.stage.camera);
  }

  hoverSpot(event) {
    if (this.client.carried) this.client.aim(this.spotAt(event)?.id ?? null);
  }

  clickSpot(event) {
    const spot = this.client.carried && this.spotAt(event);
    if (spot) this.client.put(spot.id);
  }

  /** What is drawn over the robot. */
  overlay() {
    const { client, view } = this;
    if (!client.told) return;
    this.spots.set(client.spots(), client.aimed);
    this.spots.update(view.robot, view.stage.camera);
    this.axes.thickness = 0.006 * view.size;
    this.axes.clear();
    const [from, along] = [new Vector3(), new Vector3()];
    for (const joint of client.told.limbs.flatMap((limb) => limb.joints)) {
      const share = joint.item === client.selected ? 1.6 : 1;
      along.fromArray(joint.axis).multiplyScalar(AXIS_SHARE * share * view.size);
      this.axes.add(view.robot.place(1, joint.at, from), along);
    }
  }

  /** Follows the client. */
  follow(what) {
    if (!this.view || !this.client.told) return;
    if (what === "selected" || what === "carried") {
      this.placeHandles();
      this.highlight();
    }
    if (what === "aimed") this.view.pose();
  }
}
