// SPDX-License-Identifier: Apache-2.0
// What of the body is not as it was given: each change with what it is worth and a way to put it
// back; and the designs with the fewest changes, to be gone through by a slider.
import { fill, h, icon, setText, svg } from "../dom.js";
import { format, significant, words } from "../units.js";
import { calmly } from "./rate.js";

const SAME = 1e-9;
const MOST = 6; // changes that are listed at first
const CHART = { width: 260, height: 54 };

export class ChangesPanel {
  constructor(studio) {
    this.studio = studio;
    this.count = h("p.hint");
    this.find = h(
      "button.small",
      {
        type: "button",
        title:
          "Puts changes back, the one that costs least first, and optimises the rest again (key F)",
        onClick: () => this.findFewest(),
      },
      "Fewest changes",
    );
    this.cancel = h(
      "button.small",
      { type: "button", hidden: true, onClick: () => studio.halt() },
      "Cancel",
    );
    this.busy = h("p.status", { role: "status" });
    this.table = h("table.differences.changes", { aria: { label: "Changes of the given body" } });
    this.more = h("button.link", { type: "button", onClick: () => this.toggleAll() });
    this.element = h(
      "section.panel",
      { aria: { label: "Changes" } },
      h("h2", {}, "Changes", h("span.button-row", {}, this.find, this.cancel)),
      this.busy,
      this.chooser(),
      this.count,
      this.table,
      this.more,
    );
    this.showChangesSoon = calmly(() => this.showChanges());
    studio.store.on(["state", "document", "alternatives fewest"], () => this.update());
  }

  /** Works out the designs with the fewest changes, or says why that cannot be now. */
  findFewest() {
    const hindrance = this.hindrance();
    if (hindrance) this.studio.notices.show("info", hindrance);
    else this.studio.workOut("fewest");
  }

  hindrance() {
    const { store } = this.studio;
    const [state, document] = [store.get("state"), store.get("document")];
    if (!state || !document) return "No robot is here yet.";
    if (state.phase === "searching")
      return "A search goes on: pause it (O), then the fewest changes can be worked out.";
    if (state.phase === "working out") return "Other designs are being worked out already.";
    const free = document.parameters.some(
      ({ given }, i) => !state.frozen?.[i] && Math.abs(state.s[i] - given) > SAME,
    );
    if (free) return "";
    return "The body is as it was given, as far as it is free: optimise (O) or edit it first.";
  }

  /** A bar for each design, as high as what it keeps of the gain, and the slider below. */
  chooser() {
    this.chart = svg("svg.kept", {
      viewBox: `0 0 ${CHART.width} ${CHART.height}`,
      preserveAspectRatio: "none",
      "aria-hidden": "true",
    });
    this.slider = h("input.slider", {
      type: "range",
      step: 1,
      min: 0,
      aria: { label: "Design with fewer changes" },
      onInput: () => this.choose(this.slider.valueAsNumber),
      onChange: () => (this.moving = false),
    });
    this.told = h("p.told", {
      title: "The gain: by how much the cost F fell from the given body to the optimised one",
      aria: { live: "polite" },
    });
    this.counts = h("div.kept-counts", { aria: { hidden: "true" } });
    this.choices = h(
      "div.fewest",
      { hidden: true },
      this.chart,
      this.counts,
      this.slider,
      this.told,
    );
    return this.choices;
  }

  choose(design) {
    this.studio.choose("fewest", design, Boolean(this.moving));
    this.moving = true;
    this.tell(design);
  }

  update() {
    const { store } = this.studio;
    const [state, document] = [store.get("state"), store.get("document")];
    if (!state || !document) return;
    const busy = state.phase === "working out";
    this.cancel.hidden = !busy;
    this.find.disabled = busy || state.phase === "searching";
    setText(this.busy, busy ? "Working out other designs …" : "");
    const usable = state.alternatives?.includes("fewest");
    this.found = usable ? store.get("alternatives fewest") : null;
    this.choices.hidden = !this.found;
    if (this.found) this.showChoices(state);
    if (this.studio.edits.moving) this.showChangesSoon();
    else this.showChanges();
  }

  /** The share of the gain, by how much F fell, that a design keeps. */
  kept(k) {
    const { designs, given_F: given } = this.found;
    return (given - designs[k].F) / (given - designs[0].F || 1);
  }

  changesOf(k) {
    const { parameters } = this.studio.store.get("document");
    return parameters.filter((each, i) => Math.abs(this.found.designs[k].s[i] - each.given) > SAME)
      .length;
  }

  showChoices(state) {
    const { designs, fewest, kept } = this.found;
    this.present = designs.findIndex(({ s }) => s.every((x, i) => Math.abs(x - state.s[i]) < SAME));
    if (this.found !== this.drawn) {
      this.drawn = this.found;
      this.slider.max = designs.length - 1;
      const step = CHART.width / designs.length;
      const height = (k) => Math.max(1, CHART.height * Math.max(0, this.kept(k)));
      this.bars = designs.map((_, k) =>
        svg(`rect.kept-bar${k === fewest ? ".fewest" : ""}`, {
          x: k * step + 1,
          width: Math.max(1, step - 2),
          y: CHART.height - height(k),
          height: height(k),
          onClick: () => this.choose(k),
        }),
      );
      fill(
        this.counts,
        designs.map((_, k) => h("span", {}, String(this.changesOf(k)))),
      );
      const line = CHART.height * (1 - kept);
      fill(
        this.chart,
        this.bars,
        svg("line.kept-line", { x1: 0, x2: CHART.width, y1: line, y2: line }),
      );
    }
    this.bars.forEach((each, k) => each.classList.toggle("present", k === this.present));
    if (this.moving) return;
    if (this.present >= 0) this.slider.valueAsNumber = this.present;
    this.tell(this.present);
  }

  /** What a design comes to, in words. */
  tell(k) {
    if (k < 0) {
      const few = this.found.fewest;
      const text = `${this.changesOf(few)} changes would keep ${this.percent(few)} of the gain.`;
      this.slider.setAttribute("aria-valuetext", text);
      return setText(this.told, text);
    }
    const count = this.changesOf(k);
    const text = `${count} ${count === 1 ? "change" : "changes"}, cost F ${significant(this.found.designs[k].F)}: ${this.percent(k)} of the gain`;
    this.slider.setAttribute("aria-valuetext", text);
    setText(this.told, text);
  }

  percent(k) {
    return `${(100 * this.kept(k)).toFixed(1)} %`;
  }

  showChanges() {
    const { store } = this.studio;
    const [state, document] = [store.get("state"), store.get("document")];
    if (!state || !document) return;
    const { parameters } = document;
    // What a change is worth was asked of one design alone.
    const worths = new Map(
      this.found && this.present === 0
        ? this.found.worths.map(({ name, worth }) => [name, worth])
        : [],
    );
    const rows = parameters
      .map((parameter, i) => ({
        parameter,
        now: state.s[i],
        locked: state.frozen?.[i],
        worth: worths.get(parameter.name),
        size: Math.abs(state.s[i] - parameter.given) / (parameter.scale || 1),
      }))
      .filter(({ now, parameter }) => Math.abs(now - parameter.given) > SAME)
      .sort((a, b) => worthOf(b) - worthOf(a) || b.size - a.size);
    const key = JSON.stringify([
      rows.map(({ parameter, now, worth, locked }) => [parameter.name, now, worth, locked]),
      this.all,
    ]);
    if (key === this.key) return;
    this.key = key;
    const few = rows.length === 1 ? "1 parameter is" : `${rows.length} parameters are`;
    setText(
      this.count,
      rows.length ? `${few} not as given, of ${parameters.length}.` : "The body is as it was given.",
    );
    const shown = this.all ? rows : rows.slice(0, MOST);
    this.more.hidden = rows.length <= MOST;
    setText(this.more, this.all ? "Fewer" : `and ${rows.length - MOST} more`);
    fill(
      this.table,
      rows.length && worths.size
        ? h(
            "thead",
            {},
            h(
              "tr",
              {},
              ["", "now", "worth"].map((text) => h("th", { scope: "col" }, text)),
              h("td"),
            ),
          )
        : null,
      h(
        "tbody",
        {},
        shown.map((each) => this.row(each)),
      ),
    );
  }

  row({ parameter, now, worth, locked }) {
    const { name, given, unit } = parameter;
    const label = `Put ${words(name)} back to ${format(given, unit)}`;
    return h(
      "tr",
      { title: `${words(name)}: given ${format(given, unit)}, now ${format(now, unit)}` },
      h("th", { scope: "row" }, words(name)),
      h("td", {}, format(now, unit)),
      worth === undefined
        ? null
        : h(
            "td",
            { title: "The cost F rises by so much where this one alone is put back" },
            worth === null ? "all" : `cost +${significant(worth, 2)}`,
          ),
      h(
        "td",
        {},
        h(
          "button.icon-button",
          {
            type: "button",
            title: locked ? `${words(name)} is locked` : label,
            disabled: Boolean(locked),
            aria: { label },
            onClick: () => this.studio.edit(name, given, "once"),
          },
          icon("reset"),
        ),
      ),
    );
  }

  toggleAll() {
    this.all = !this.all;
    this.update();
  }
}

/** Without a motion a change is worth everything; what is not known comes last. */
const worthOf = ({ worth }) => (worth === undefined ? 0 : (worth ?? 1e9));
