// SPDX-License-Identifier: Apache-2.0
// What is selected of an assembly, key by key as its file says it.
import { fill, h } from "../../dom.js";

const AXES = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
const shown = (value) => String(Math.round(value * 1e6) / 1e6);

export class ItemForm {
  /** @param {import("../../session/assembly_client.js").AssemblyClient} client */
  constructor(client) {
    this.client = client;
    this.title = h("h2");
    this.body = h("div.item-form");
    this.element = h(
      "section.panel",
      { aria: { label: "What is selected" } },
      this.title,
      this.body,
    );
  }

  show() {
    const { client } = this;
    const { selected } = client;
    const found = client.find(selected);
    const { activeElement: focused } = document;
    const stays = this.shownItem === selected && this.body.contains(focused);
    const field = stays && focused.dataset.field;
    this.fillIn(selected, found);
    if (field) this.body.querySelector(`[data-field="${field}"]`)?.focus();
    this.shownItem = selected;
  }

  /** Sets a value; where it is refused, the field shows again what holds. */
  async set(item, key, value) {
    const done = await this.client.set(item, key, value);
    if (!done) this.fillInAgain(item);
  }

  fillInAgain(item) {
    const found = this.client.find(item); // it may be gone meanwhile
    if (found && this.shownItem === item) this.fillIn(item, found);
  }

  fillIn(item, found) {
    const [title, rows] = this.rowsOf(item, found);
    fill(this.title, title);
    fill(this.body, rows);
  }

  rowsOf(item, found) {
    if (item === "trunk") return ["Trunk", this.trunk(found)];
    if (item.startsWith("part/"))
      return [found.module, [this.vector(item, "position", "m", found.at), this.remove(item)]];
    if (item.endsWith("/foot")) return ["Foot", this.foot(item, found)];
    if (found.joints) return [`Limb ${found.names.join(", ")}`, this.limb(item, found)];
    return [`Joint ${found.name}`, this.joint(item, found)];
  }

  trunk({ module, size, mass }) {
    const { name } = this.client.told;
    const rows = [this.text("trunk", "name", "name of the robot", name)];
    if (module) rows.push(h("p.hint", {}, `The module ${module}, ${shown(1000 * mass)} g.`));
    else
      rows.push(
        this.vector("trunk", "size", "m", size, "length, width, height"),
        this.number("trunk", "mass", "kg", mass),
      );
    return rows;
  }

  foot(item, { module, offset }) {
    return [
      this.module(item, "foot", module),
      this.vector(item, "offset", "m", offset, "from the last joint"),
    ];
  }

  limb(item, { names, hip, mirror, copies, step }) {
    const copy = () => this.client.carry({ name: `Like ${names[0]}`, item });
    const rows = [
      this.field(
        "names",
        h("input", {
          type: "text",
          value: names.join(", "),
          data: { field: "names" },
          onChange: ({ target }) =>
            this.set(item, "names", target.value.split(/[\s,]+/).filter(Boolean)),
        }),
      ),
      this.vector(item, "hip", "m", hip, "of the first joint, in the trunk"),
      this.field(
        "mirror image",
        h("input", {
          type: "checkbox",
          checked: mirror,
          data: { field: "mirror" },
          onChange: ({ target }) => this.set(item, "mirror", target.checked),
        }),
      ),
      this.number(item, "copies", "", copies, 1),
    ];
    if (copies > 1) rows.push(this.vector(item, "step", "m", step, "from one to the next"));
    rows.push(
      h(
        "div.button-row",
        {},
        h("button", { type: "button", onClick: copy }, "Another like it…"),
        this.removeButton(item),
      ),
    );
    return rows;
  }

  joint(item, found) {
    const { name, link, servo, axis, offset, roll, range, servo_range: own, torque } = found;
    const strong = `Torque at most ${shown(torque)} N m`;
    const hint = found.linear
      ? `${strong} as drawn. Lever and mount of a linear actuator are set in the file.`
      : `${strong}.`;
    const first = this.client.limbOf(item).joints[0].item === item;
    const along = Object.entries(AXES).map(([label, value]) =>
      h(
        "button.small",
        { type: "button", onClick: () => this.set(item, "axis", value) },
        label,
      ),
    );
    return [
      this.text(item, "name", "name", name),
      this.text(item, "link", "link that it moves", link),
      this.module(item, "servo", servo, first ? ["servo"] : ["servo", "linear"]),
      h("p.hint", {}, hint),
      this.vector(item, "axis", "", axis, "the horn looks along it"),
      h("div.button-row", {}, along),
      first ? "" : this.vector(item, "offset", "m", offset, "from the joint above"),
      this.number(item, "roll", "rad", roll),
      this.range(item, range, own),
      this.remove(item),
    ];
  }

  range(item, range, own) {
    const inputs = [0, 1].map((i) =>
      h("input", {
        type: "number",
        step: "any",
        value: range ? shown(range[i]) : "",
        placeholder: own ? shown(own[i]) : "free",
        aria: { label: `${i ? "largest" : "least"} angle` },
        data: { field: `range ${i}` },
        onChange: () => {
          const both = inputs.map((each) => each.valueAsNumber);
          if (both.every(Number.isFinite)) this.set(item, "range", both);
          else if (both.every(Number.isNaN)) this.set(item, "range", null);
        },
      }),
    );
    return this.field("range [rad]", h("span.three", {}, inputs));
  }

  /** A list of the modules of a kind, or of several, of which another can be chosen. */
  module(item, kind, name, kinds = [kind]) {
    const some = (this.modules ?? []).filter((each) => kinds.includes(each.kind));
    const names = some.map((each) => each.name);
    if (!names.includes(name)) names.unshift(name);
    const options = names.map((each) => h("option", { value: each, selected: each === name }, each));
    const change = ({ target }) => this.client.replace(item, target.value);
    return this.field(kind, h("select", { data: { field: kind }, onChange: change }, options));
  }

  vector(item, key, unit, value, hint = "") {
    const inputs = value.map((each, i) =>
      h("input", {
        type: "number",
        step: unit === "m" ? 0.005 : "any",
        value: shown(each),
        aria: { label: `${key} ${"xyz"[i]}` },
        data: { field: `${key} ${i}` },
        onChange: () => {
          const all = inputs.map((input) => input.valueAsNumber);
          if (all.every(Number.isFinite)) this.set(item, key, all);
          else this.fillInAgain(item);
        },
      }),
    );
    const label = unit ? `${key} [${unit}]` : key;
    return this.field(label, h("span.three", {}, inputs), hint);
  }

  number(item, key, unit, value, step = "any") {
    const input = h("input", {
      type: "number",
      step,
      value: shown(value),
      data: { field: key },
      onChange: () =>
        Number.isFinite(input.valueAsNumber)
          ? this.set(item, key, input.valueAsNumber)
          : this.fillInAgain(item),
    });
    return this.field(unit ? `${key} [${unit}]` : key, input);
  }

  text(item, key, label, value) {
    const change = ({ target }) => this.set(item, key, target.value.trim());
    return this.field(
      label,
      h("input", { type: "text", value, data: { field: key }, spellcheck: false, onChange: change }),
    );
  }

  field(label, control, hint = "") {
    return h("label.field", { title: hint }, h("span", {}, label), control);
  }

  remove(item) {
    return h("div.button-row", {}, this.removeButton(item));
  }

  removeButton(item) {
    const act = () => this.client.obey({ do: "remove", item });
    return h("button", { type: "button", onClick: act }, "Remove (delete)");
  }
}
