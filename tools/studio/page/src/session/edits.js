// SPDX-License-Identifier: Apache-2.0
// Edits of parameters on their way to the server, which edit_worker.js sends; what is under the
// user's hand is shown at once.
import { ApiError } from "./api.js";

export class Edits {
  /** @param {(error: Error) => void} failed @param {() => void} changed when a draft comes or goes */
  constructor(failed, changed) {
    this.failed = failed;
    this.changed = changed;
    this.drafts = new Map(); // values that are not in the server's state yet
    this.number = 0; // of the last edit
    this.flight = Promise.resolve(); // done when nothing is on its way and nothing waits
    this.moving = null; // the parameters that move on as one edit
    this.worker = new Worker("edit_worker.js");
    this.worker.onmessage = ({ data }) => this.take(data);
    this.worker.onerror = () => this.end();
  }

  /** Without its worker nothing is sent any more. */
  end() {
    this.ended = true;
    this.drafts.clear();
    this.changed();
    this.landed?.();
    this.landed = null;
    this.failed(new ApiError(0, { message: "Edits cannot be sent: load this page anew." }));
  }

  /** The value that is shown of a parameter. */
  value(name, known) {
    return this.drafts.get(name)?.value ?? known;
  }

  /** @param {Object<string, number>} values @param {"begin"|"drag"|"end"|"once"} phase */
  set(values, phase = "once") {
    if (this.ended) return this.end();
    const names = Object.keys(values).sort().join();
    if (phase === "begin" || phase === "once") this.moving = null;
    for (const [name, value] of Object.entries(values))
      this.drafts.set(name, { value, revision: Infinity });
    const held = phase === "begin" || phase === "drag";
    const fresh = this.moving !== names;
    this.moving = held ? names : null;
    if (this.idle) this.flight = new Promise((resolve) => (this.landed = resolve));
    this.worker.postMessage({ number: ++this.number, values, held, fresh });
    this.changed();
  }

  /** Takes the answer to what was sent last. */
  take({ number, values, revision, refusal }) {
    for (const [name, value] of Object.entries(values)) {
      const draft = this.drafts.get(name);
      if (draft?.value !== value) continue; // what the hand set since is not answered yet
      if (refusal) this.drafts.delete(name);
      else draft.revision = revision;
    }
    if (refusal) this.failed(new ApiError(refusal.status, refusal));
    else this.settle(this.seen ?? 0);
    if (refusal) this.changed();
    if (number < this.number) return;
    this.landed();
    this.landed = null;
  }

  /** Waits until what was set is answered. */
  sent() {
    return this.flight;
  }

  /** Whether nothing is on its way. */
  get idle() {
    return !this.landed;
  }

  /** Drops drafts that a state of this revision holds. */
  settle(revision) {
    this.seen = revision;
    for (const [name, draft] of this.drafts)
      if (draft.revision <= revision) this.drafts.delete(name);
  }
}
