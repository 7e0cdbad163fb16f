// SPDX-License-Identifier: Apache-2.0
// Edits of parameters on their way to the server: one at a time, the latest values win, and what is
// under the user's hand is shown at once. No more are sent than a screen shows.
import { command } from "./api.js";

const EVERY = 15; // ms between edits: as a screen's pictures
const passed = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

export class Edits {
  /** @param {(error: Error) => void} failed @param {() => void} changed when a draft comes or goes */
  constructor(failed, changed) {
    this.failed = failed;
    this.changed = changed;
    this.drafts = new Map(); // values that are not in the server's state yet
    this.waiting = new Map();
    this.flying = false;
    this.flight = Promise.resolve(); // done when nothing is on its way and nothing waits
    this.moving = null; // the parameters that move on as one edit
  }

  /** The value that is shown of a parameter. */
  value(name, known) {
    return this.drafts.get(name)?.value ?? known;
  }

  /** @param {Object<string, number>} values @param {"begin"|"drag"|"end"|"once"} phase */
  set(values, phase = "once") {
    const names = Object.keys(values).sort().join();
    if (phase === "begin" || phase === "once") this.moving = null;
    for (const [name, value] of Object.entries(values)) {
      this.waiting.set(name, value);
      this.drafts.set(name, { value, revision: Infinity });
    }
    const held = phase === "begin" || phase === "drag";
    this.next = { names, held, fresh: this.next?.fresh || this.moving !== names };
    this.moving = held ? names : null;
    this.changed();
    if (!this.flying) this.flight = this.pump();
  }

  async pump() {
    this.flying = true;
    while (this.waiting.size) await this.sendWaiting();
    this.flying = false;
  }

  async sendWaiting() {
    const values = Object.fromEntries(this.waiting);
    const { held, fresh } = this.next;
    this.waiting.clear();
    this.next = null;
    const begun = performance.now();
    try {
      const { revision } = await command("edit", { values, goes_on: !fresh, held });
      for (const [name, value] of Object.entries(values)) {
        const draft = this.drafts.get(name);
        if (draft?.value === value) draft.revision = revision ?? 0;
      }
      this.settle(this.seen ?? 0);
    } catch (error) {
      for (const name of Object.keys(values)) this.drafts.delete(name);
      this.changed();
      this.failed(error);
    }
    const early = EVERY - (performance.now() - begun);
    if (early > 1) await passed(early);
  }

  /** Waits until what was set is answered. */
  sent() {
    return this.flight;
  }

  /** Whether nothing is on its way. */
  get idle() {
    return !this.flying && !this.waiting.size;
  }

  /** Drops drafts that a state of this revision holds. */
  settle(revision) {
    this.seen = revision;
    for (const [name, draft] of this.drafts)
      if (draft.revision <= revision) this.drafts.delete(name);
  }
}
