// SPDX-License-Identifier: Apache-2.0
// A robot that declares nothing yet: what was found of it, and what of it may change, to be ticked
// and written.
import { fill, h } from "../dom.js";
import { get, post } from "../session/api.js";
import { format, words } from "../units.js";

export class ProposalPage {
  constructor(studio) {
    this.studio = studio;
    this.body = h("div.proposal-body");
    this.element = h(
      "main.proposal",
      { hidden: true },
      h("h1", {}, "A new robot"),
      h(
        "p.lead",
        {},
        "Its file does not say yet what may change. Tick it; all else of the file stays but for what is noted here.",
      ),
      this.body,
    );
  }

  /** @param {string} forward where it faces; empty: as it seems to be drawn */
  async load(forward = "") {
    this.forward = forward;
    fill(this.body, h("p.empty", {}, "Reading the robot …"));
    const asked = `/api/proposal?forward=${encodeURIComponent(forward)}`;
    const found = await this.studio.act(() => get(asked));
    if (found) this.show(found);
  }

  show(found) {
    const { parameters = [], left_out = [] } = found;
    this.boxes = parameters.map((parameter) =>
      h("input", {
        type: "checkbox",
        checked: parameter.ticked ?? true,
        name: parameter.name,
        aria: { label: words(parameter.name) },
      }),
    );
    fill(
      this.body,
      this.limbs(found),
      h(
        "section.panel",
        {},
        h("h2", {}, "What may change"),
        h(
          "div.button-row",
          {},
          h("button.small", { type: "button", onClick: () => this.tick(true) }, "All"),
          h("button.small", { type: "button", onClick: () => this.tick(false) }, "None"),
        ),
        h(
          "table.differences.proposals",
          {},
          h(
            "tbody",
            {},
            parameters.map((parameter, i) => this.row(parameter, i)),
          ),
        ),
        this.leftOut(left_out),
      ),
      h(
        "div.actions",
        {},
        h("button", { type: "button", onClick: () => this.studio.showStart() }, "Back"),
        h("button.primary", { type: "button", onClick: () => this.write() }, "Write and go on"),
      ),
    );
  }

  /** What was found of the robot: its limbs, with their joints. */
  limbs({ words: about, ahead, told = [], limbs = [] }) {
    const head = ["limb", "joints", "foot"].map((text) => h("th", { scope: "col" }, text));
    const row = ({ name, joints = [], foot }) =>
      h(
        "tr",
        {},
        h("th", { scope: "row" }, name),
        h("td", {}, joints.join(", ")),
        h("td", {}, foot ?? ""),
      );
    return h(
      "section.panel",
      {},
      h("h2", {}, "What was found"),
      h("p", {}, about ?? ""),
      this.facing(ahead),
      told.length ? h("ul.notes", {}, told.map((sentence) => h("li", {}, sentence))) : null,
      h(
        "table.differences.found",
        {},
        h("thead", {}, h("tr", {}, head)),
        h("tbody", {}, limbs.map(row)),
      ),
    );
  }

  /** Where it faces, by the axis of the trunk's frame, to be said otherwise. */
  facing(ahead) {
    const option = (axis) =>
      h("option", { value: axis, selected: axis === ahead }, axis.replace("-", "−"));
    const onChange = ({ target }) => this.load(target.value);
    return h(
      "label.faces",
      {},
      "Ahead is the trunk’s ",
      h("select", { name: "forward", onChange }, ["+x", "-x", "+y", "-y"].map(option)),
    );
  }

  leftOut(reasons) {
    if (!reasons.length) return null;
    const rows = reasons.map((reason) => h("li", {}, reason));
    return h("details", {}, h("summary", {}, `Left out (${reasons.length})`), h("ul", {}, rows));
  }

  row({ name, sentence, unit, value, lower, upper, reason }, i) {
    return h(
      "tr",
      {},
      h("td", {}, h("label", {}, this.boxes[i])),
      h(
        "th",
        { scope: "row" },
        h("label", { onClick: () => this.boxes[i].click() }, words(name)),
        h("p.hint", {}, sentence ?? ""),
        reason ? h("p.hint", {}, reason) : "",
      ),
      h("td", {}, format(value, unit)),
      h("td", {}, `${format(lower, "")} to ${format(upper, unit)}`),
    );
  }

  tick(on) {
    for (const box of this.boxes) box.checked = on;
  }

  write() {
    const names = this.boxes.filter((box) => box.checked).map((box) => box.name);
    this.studio.open(() => post("/api/proposal", { parameters: names, forward: this.forward }));
  }
}
