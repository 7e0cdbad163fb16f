// SPDX-License-Identifier: Apache-2.0
// What an assembly consists of, as a list: arrow keys go through it.
import { fill, h } from "../../dom.js";

export class Outline {
  /** @param {import("../../session/assembly_client.js").AssemblyClient} client */
  constructor(client) {
    this.client = client;
    this.list = h("ul.outline");
    this.element = h("section.panel", { aria: { label: "Robot" } }, h("h2", {}, "Robot"), this.list);
    this.list.addEventListener("keydown", (event) => this.key(event));
  }

  show() {
    const { trunk, parts, limbs } = this.client.told;
    const held = this.list.contains(document.activeElement);
    this.buttons = [];
    fill(
      this.list,
      this.row("trunk", "Trunk", trunk.module ?? "a box", 0),
      parts.map(({ item, module }) => this.row(item, module, "on the trunk", 1)),
      limbs.map((limb) => this.rowsOf(limb)),
    );
    this.mark();
    if (held) this.focusSelected();
  }

  rowsOf({ item, names, mirror, joints, foot }) {
    const shown = mirror ? names.flatMap((name) => [`${name}L`, `${name}R`]) : names;
    return [
      this.row(item, `Limb ${names.join(", ")}`, shown.join(" "), 0),
      joints.map((joint) => this.row(joint.item, joint.name, joint.servo, 1)),
      this.row(foot.item, "foot", foot.module, 1),
    ];
  }

  row(item, name, below, depth) {
    const button = h(
      `button.outline-row.depth-${depth}`,
      { type: "button", data: { item }, onClick: () => this.client.select(item) },
      h("span", {}, name),
      h("small", {}, below),
    );
    this.buttons.push(button);
    return h("li", {}, button);
  }

  mark() {
    for (const each of this.buttons)
      each.setAttribute("aria-pressed", String(each.dataset.item === this.client.selected));
  }

  focusSelected() {
    this.buttons.find((each) => each.dataset.item === this.client.selected)?.focus();
  }

  key(event) {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const at = this.buttons.indexOf(document.activeElement);
    const next = this.buttons[(at + step + this.buttons.length) % this.buttons.length];
    this.client.select(next.dataset.item);
    next.focus();
  }
}
