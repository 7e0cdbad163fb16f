// SPDX-License-Identifier: Apache-2.0
// The robot that is assembled, as the server has it; what is selected of it, and what is carried to
// it: a module of the palette or a limb that is to be copied.
import { post } from "./api.js";

/** @typedef {{name: string, kind: string}|{name: string, item: string}} Carried */

export class AssemblyClient {
  /** @param {import("../studio.js").Studio} studio */
  constructor(studio) {
    this.studio = studio;
    this.followers = [];
    this.selected = "trunk";
    /** @type {?Carried} */ this.carried = null;
    this.step = 0; // of what a hand does
    this.aimed = null; // the id of the spot that is pointed at
    studio.store.on("assembly", (told) => told && this.take(told));
  }

  /** Calls `act` with what changed: "assembly", "selected", "carried", "aimed". */
  on(act) {
    this.followers.push(act);
  }

  tell(what) {
    for (const each of this.followers) each(what);
  }

  take(told) {
    this.told = told;
    if (this.wanted && this.find(this.wanted)) this.selected = this.wanted;
    this.wanted = null;
    if (!this.find(this.selected)) this.selected = "trunk";
    if (this.carried && !this.spots().length) this.carried = null;
    this.tell("assembly");
  }

  /** What the server tells of an item, or undefined. */
  find(item) {
    const { trunk, parts, limbs } = this.told;
    const all = [trunk, ...parts, ...limbs.flatMap((limb) => [limb, ...limb.joints, limb.foot])];
    return all.find((each) => each.item === item);
  }

  /** The limb that an item is, or is of. */
  limbOf(item) {
    return this.told.limbs.find((limb) => item === limb.item || item.startsWith(`${limb.item}/`));
  }

  /** @param {string} item that is there, or comes with the next that is told */
  select(item) {
    if (this.selected === item) return;
    if (!this.find(item)) {
      this.wanted = item;
      return;
    }
    this.selected = item;
    this.tell("selected");
  }

  /** @param {?Carried} carried @param {{dragged: boolean}} how held by the pointer, or taken up */
  carry(carried, { dragged = false } = {}) {
    this.carried = carried;
    this.dragged = dragged;
    this.aimed = null;
    this.tell("carried");
  }

  aim(id) {
    if (this.aimed === id) return;
    this.aimed = id;
    this.tell("aimed");
  }

  /** The spots that take what is carried. */
  spots() {
    if (!this.carried || !this.told) return [];
    const { kind } = this.carried;
    return this.told.spots.filter((spot) => (kind ? spot.takes.includes(kind) : spot.begins_limb));
  }

  /** Puts what is carried onto a spot. */
  put(spot) {
    const { carried } = this;
    this.carry(null);
    if (carried.kind) return this.obey({ do: "put", module: carried.name, spot });
    return this.obey({ do: "copy", item: carried.item, spot });
  }

  /** Another module in the place of an item's. */
  replace(item, module) {
    return this.obey({ do: "put", module, spot: item });
  }

  async obey(command) {
    this.begin(); // what a hand does from now on is a step of its own
    const done = await this.studio.inOrder(() => post("/api/assembly", command));
    if (done) this.studio.notices.clear("error");
    if (done?.item) this.select(done.item);
    return done;
  }

  set(item, key, value) {
    return this.obey({ do: "set", item, key, value });
  }

  /** A value under the user's hand: what is sent from `begin` on is one step of undo. */
  begin() {
    this.step += 1;
  }

  drag(item, key, value) {
    const { step } = this;
    this.studio.latest("assembly", async () => {
      const goes_on = this.draggedStep === step;
      this.draggedStep = step;
      await post("/api/assembly", { do: "set", item, key, value, goes_on });
    });
  }
}
