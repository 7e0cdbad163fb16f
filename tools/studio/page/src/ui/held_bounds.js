// SPDX-License-Identifier: Apache-2.0
// While a parameter is under the user's hand, the bodies at its two bounds are seen as ghosts.
import { get } from "../session/api.js";
import { atMost } from "./rate.js";

const LINGER = 700; // ms after the hand is off
const SOON = 200; // ms after which they are asked for: the first edits come first
const ANEW = 500; // ms between ghosts that follow solved motions

export class HeldBounds {
  constructor(studio) {
    this.studio = studio;
    this.name = null;
    studio.store.on("held", ({ name, phase }) => this.take(name, phase));
    const anew = atMost(ANEW, () => this.loaded && this.load());
    studio.store.on("motion", (motion) => motion && !motion.predicted && anew());
    studio.store.on("forgotten", () => this.end());
  }

  /** @param {"begin"|"drag"|"end"|"once"} phase of an edit */
  take(name, phase) {
    clearTimeout(this.timer);
    if (phase === "once") return this.end();
    if (phase === "end") {
      this.timer = setTimeout(() => this.end(), LINGER);
      return;
    }
    if (this.name === name) return;
    this.name = name;
    this.loaded = false;
    clearTimeout(this.soon);
    this.soon = setTimeout(() => this.load(), SOON);
  }

  load() {
    const { studio, name } = this;
    this.loaded = true;
    const task = studio.store.get("task") ?? 0;
    studio.latestBeside("bounds", async () => {
      const found = await get(`/api/bounds?name=${encodeURIComponent(name)}&task=${task}`);
      if (this.name === name) studio.view.setBounds(found);
    });
  }

  end() {
    if (this.name === null) return;
    clearTimeout(this.soon);
    this.name = null;
    this.loaded = false;
    this.studio.view.setBounds(null);
  }
}
