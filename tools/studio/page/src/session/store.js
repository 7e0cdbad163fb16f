// SPDX-License-Identifier: Apache-2.0
// What the page knows, by key; whoever follows a key is told when it changes.

export class Store {
  constructor(values = {}) {
    this.values = { ...values };
    this.followers = new Map();
  }

  get(key) {
    return this.values[key];
  }

  set(key, value) {
    if (this.values[key] === value) return;
    this.values[key] = value;
    for (const each of this.followers.get(key) ?? []) each(value);
  }

  /** Tells the followers of a key although its value is the same object. */
  touch(key) {
    for (const each of this.followers.get(key) ?? []) each(this.values[key]);
  }

  /** Calls `act` now, where there is a value, and whenever one of the keys changes. */
  on(keys, act) {
    for (const key of [keys].flat()) {
      if (!this.followers.has(key)) this.followers.set(key, new Set());
      this.followers.get(key).add(act);
    }
    const values = [keys].flat().map((key) => this.values[key]);
    if (values.some((value) => value !== undefined && value !== null)) act(values[0]);
  }
}
