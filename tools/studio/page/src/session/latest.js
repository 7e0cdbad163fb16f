// SPDX-License-Identifier: Apache-2.0
// Requests that are made often: of each kind one is on its way, and only the latest waits.

export class Latest {
  /** @param {(error: Error) => void} failed */
  constructor(failed) {
    this.failed = failed;
    this.flights = new Map(); // by kind: done when nothing of it is on its way and nothing waits
    this.waiting = new Map();
  }

  /** @param {() => Promise<any>} make */
  send(kind, make) {
    this.waiting.set(kind, make);
    if (!this.flights.has(kind)) this.flights.set(kind, this.fly(kind));
  }

  async fly(kind) {
    for (let make; (make = this.waiting.get(kind));) {
      this.waiting.delete(kind);
      try {
        await make();
      } catch (error) {
        this.failed(error);
      }
    }
    this.flights.delete(kind);
  }

  /** Waits until what was sent is answered. */
  sent() {
    return Promise.all(this.flights.values());
  }
}
