// SPDX-License-Identifier: Apache-2.0
// Requests that are made often: of each kind one is on its way, and only the latest waits.

export class Latest {
  /** @param {(error: Error) => void} failed */
  constructor(failed) {
    this.failed = failed;
    this.flying = new Set();
    this.waiting = new Map();
  }

  /** @param {() => Promise<any>} make */
  async send(kind, make) {
    if (this.flying.has(kind)) {
      this.waiting.set(kind, make);
      return;
    }
    this.flying.add(kind);
    try {
      await make();
    } catch (error) {
      this.failed(error);
    }
    this.flying.delete(kind);
    const next = this.waiting.get(kind);
    this.waiting.delete(kind);
    if (next) this.send(kind, next);
  }
}
