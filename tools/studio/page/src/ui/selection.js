// SPDX-License-Identifier: Apache-2.0
// Which parameters are selected and which one is pointed at, in list and picture alike.

export class Selection {
  constructor() {
    this.names = new Set();
    this.hovered = null;
    this.followers = [];
  }

  on(act) {
    this.followers.push(act);
  }

  tell() {
    for (const each of this.followers) each(this);
  }

  set(names) {
    this.names = new Set(names);
    this.tell();
  }

  hover(name) {
    if (this.hovered === name) return;
    this.hovered = name;
    this.tell();
  }

  /** The one that keys act on. */
  get first() {
    return this.names.values().next().value ?? null;
  }
}
