// SPDX-License-Identifier: Apache-2.0
// Says that a search may change what was set by hand, or has changed it, with a way to keep it.
import { h, iconButton, setText } from "../dom.js";
import { words } from "../units.js";
import { calmly } from "./rate.js";

const KINDS = { m: ["length", "lengths"], rad: ["angle", "angles"] };

export class HandNote {
  /** @param {import("../studio.js").Studio} studio */
  constructor(studio) {
    this.studio = studio;
    this.words = h("span", { role: "status" });
    this.keep = h("button.small", { type: "button", onClick: () => this.act() });
    this.element = h(
      "div.hand-note",
      { hidden: true },
      this.words,
      this.keep,
      iconButton("close", "Dismiss", () => this.dismiss()),
    );
    studio.store.on(
      ["state", "document"],
      calmly(() => this.update()),
    );
  }

  update() {
    const { hand } = this.studio;
    const changed = hand.changed();
    const names = changed.length ? changed : hand.before ? [] : hand.free();
    this.element.hidden = !names.length;
    if (!names.length) return;
    const what = this.count(names);
    const searches = hand.searching ? "The search changes" : "The search has changed";
    setText(
      this.words,
      changed.length ? `${searches} ${what} that you set.` : `Optimise may change ${what} that you set.`,
    );
    this.words.title = names.map(words).join(", ");
    const them = names.length === 1 ? "it" : "them";
    setText(this.keep, changed.length ? `Put ${them} back and lock` : `Lock ${them}`);
  }

  /** "2 lengths". */
  count(names) {
    const { parameters } = this.studio.store.get("document");
    const units = new Set(names.map((name) => parameters.find((p) => p.name === name)?.unit));
    const [one, several] = (units.size === 1 && KINDS[[...units][0]]) || ["value", "values"];
    return `${names.length} ${names.length === 1 ? one : several}`;
  }

  async act() {
    await this.studio.hand.keep();
    this.update();
  }

  dismiss() {
    this.studio.hand.startAnew();
    this.update();
  }
}
