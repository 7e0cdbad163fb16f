// SPDX-License-Identifier: Apache-2.0
// Named snapshots: keep one, go on from one, see one as a ghost in the present design, and the
// table of what differs.
import { fill, h } from "../dom.js";
import { get } from "../session/api.js";
import { comparisonTable } from "./comparison.js";
import { ask } from "./dialogs.js";

export class SnapshotsPanel {
  constructor(studio) {
    this.studio = studio;
    this.list = h("ul.snapshots");
    this.comparison = h("div.comparison", { aria: { live: "polite" } });
    this.beside = false;
    this.places = [
      this.placeButton("Within", false, "The other design as a ghost in this one"),
      this.placeButton("Beside", true, "The two designs side by side"),
    ];
    this.place = h("div.segmented", { hidden: true, aria: { label: "Other design" } }, this.places);
    this.element = h(
      "section.panel",
      { aria: { label: "Snapshots" } },
      h(
        "h2",
        {},
        "Snapshots",
        h("button.small", { type: "button", onClick: () => this.keep() }, "Keep…"),
      ),
      this.list,
      this.place,
      this.comparison,
    );
    studio.store.on("state", (state) => this.update(state));
    studio.store.on("judge", ({ running }) => !running && this.compareSoon());
    studio.store.on("forgotten", () => {
      this.ghost = undefined;
      this.place.hidden = true;
      fill(this.comparison);
    });
  }

  placeButton(label, beside, title) {
    const pressed = { pressed: String(beside === this.beside) };
    return h(
      "button.small",
      { type: "button", title, aria: pressed, onClick: () => this.setBeside(beside) },
      label,
    );
  }

  setBeside(beside) {
    this.beside = beside;
    this.places.forEach((button, k) =>
      button.setAttribute("aria-pressed", String((k === 1) === beside)),
    );
    if (this.shown) this.studio.view.setGhost(this.shown, { beside });
  }

  update(state) {
    const names = state.names ?? [];
    const key = names.join("\n") + this.ghost;
    if (key !== this.key) {
      this.key = key;
      fill(
        this.list,
        names.length
          ? names.map((name) => this.row(name))
          : h("li.empty", {}, "None yet. Keep the design to come back to it, or to compare."),
      );
    }
    if (this.ghost !== undefined && state.settled) this.compareSoon();
  }

  row(name) {
    const { studio } = this;
    const shown = this.ghost === name;
    return h(
      "li",
      {},
      h("span.name", {}, name),
      h(
        "button.small",
        { type: "button", aria: { pressed: String(shown) }, onClick: () => this.toggleGhost(name) },
        "Compare",
      ),
      h(
        "button.small",
        { type: "button", onClick: () => studio.command("branch", { name }) },
        "Go on from",
      ),
    );
  }

  async keep() {
    const known = this.studio.store.get("state")?.names ?? [];
    const name = await ask("Keep this design as", `design ${known.length + 1}`);
    if (name) this.studio.command("snapshot", { name });
  }

  async toggleGhost(name) {
    const { studio } = this;
    this.ghost = this.ghost === name ? undefined : name;
    this.update(studio.store.get("state"));
    this.place.hidden = this.ghost === undefined;
    if (this.ghost === undefined) {
      this.shown = null;
      studio.view.setGhost(null);
      fill(this.comparison);
      return;
    }
    await studio.act(async () => {
      const task = studio.store.get("task") ?? 0;
      const of = `snapshot=${encodeURIComponent(name)}`;
      const [design, motion] = await Promise.all([
        get(`/api/design?${of}`),
        get(`/api/motion?${of}&task=${task}`),
      ]);
      if (this.ghost !== name) return;
      this.shown = { design, motion, name };
      studio.view.setGhost(this.shown, { beside: this.beside });
    });
    await this.compare();
    if (this.ghost === name) this.element.scrollIntoView({ block: "start" });
  }

  compareSoon() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.compare(), 400);
  }

  async compare() {
    if (this.ghost === undefined) return;
    const name = this.ghost;
    const found = await this.studio.act(() => get(`/api/compare?a=${encodeURIComponent(name)}&b=`));
    if (!found || this.ghost !== name) return;
    fill(this.comparison, comparisonTable(name, found));
  }
}
