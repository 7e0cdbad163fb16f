// SPDX-License-Identifier: Apache-2.0
// The modules that there are, by kind: dragged onto the robot, or taken up by a click or enter and
// put down where the list of places, or the picture, says.
import { fill, h } from "../../dom.js";
import { StillPictures } from "../../scene/still.js";
import { get } from "../../session/api.js";
import { significant } from "../../units.js";
import { followTheme, theme } from "../theme.js";

const KINDS = {
  servo: "Servos",
  linear: "Linear actuators",
  foot: "Feet",
  trunk: "Trunks",
  battery: "Batteries",
  computer: "Computers",
  payload: "Payloads",
};
const BEGIN = 6; // pixels from which on a press is a drag

/** What is said of a module below its name. */
function aboutOf(module) {
  const { kind, mass, stall_torque: torque, no_load_speed: speed } = module;
  const of = (value, unit) => `${significant(value, 3)} ${unit}`.replaceAll(" ", "\u00a0");
  const grams = of(1000 * mass, "g");
  if (kind === "linear") {
    const { max_force: force, stroke, rod_speed: rod } = module;
    const sliding = rod ? `, ${of(1000 * rod, "mm/s")}` : "";
    return `${of(force, "N")}${sliding}, ${of(1000 * stroke, "mm")}, ${grams}`;
  }
  if (kind !== "servo") return grams;
  const turning = speed ? `, ${of(speed, "rad/s")}` : "";
  return `${of(torque, "N m")}${turning}, ${grams}`;
}

export class Palette {
  /**
   * @param {import("../../session/assembly_client.js").AssemblyClient} client
   * @param {import("./assembly_scene.js").AssemblyScene} scene
   */
  constructor(client, scene) {
    this.client = client;
    this.scene = scene;
    this.list = h("div.palette");
    this.filter = h("input.wide", {
      type: "search",
      placeholder: "Find a module",
      aria: { label: "Find a module" },
      onInput: () => this.show(),
    });
    this.element = h("section.panel", {}, h("h2", {}, "Modules"), this.filter, this.list);
    this.ghost = h("div.carried-ghost", { hidden: true });
    document.body.append(this.ghost);
  }

  async load() {
    if (this.modules) return;
    this.modules = (await this.client.studio.act(() => get("/api/modules")))?.modules ?? [];
    this.cards = new Map(this.modules.map((each) => [each.name, this.card(each)]));
    this.show();
    followTheme(() => this.drawPictures());
  }

  show() {
    const wanted = this.filter.value.trim().toLowerCase();
    const fits = ({ name, maker, kind }) => `${name} ${maker} ${kind}`.toLowerCase().includes(wanted);
    const groups = Object.entries(KINDS).map(([kind, title]) => {
      const some = this.modules.filter((each) => each.kind === kind && fits(each));
      return some.length
        ? [h("h3", {}, title), h("ul", {}, some.map(({ name }) => this.cards.get(name)))]
        : "";
    });
    const none = wanted && groups.every((group) => group === "");
    fill(this.list, none ? h("p.hint", {}, "No module has this in its name, maker or kind.") : groups);
  }

  card(module) {
    const { name, about } = module;
    const image = h("img", { alt: "", draggable: false, data: { module: name } });
    const button = h(
      "button.module-card",
      { type: "button", title: about, data: { module: name } },
      image,
      h("span", {}, h("strong", {}, name), h("small", {}, aboutOf(module))),
    );
    button.addEventListener("pointerdown", (event) => this.press(event, module, button));
    button.addEventListener("click", () => {
      if (!this.dragged) this.client.carry(module);
      this.dragged = false;
    });
    return h("li", {}, button);
  }

  /** From a press on a card to where it is let go. */
  press(event, module, button) {
    if (event.button !== 0) return;
    const start = event;
    this.dragged = false;
    button.setPointerCapture(event.pointerId);
    const move = (now) => {
      const far = Math.hypot(now.clientX - start.clientX, now.clientY - start.clientY);
      if (this.dragged && !this.client.carried) this.ghost.hidden = true; // it was put away
      if (this.dragged ? !this.client.carried : far < BEGIN) return;
      if (!this.dragged) this.client.carry(module, { dragged: true });
      this.dragged = true;
      this.showGhost(module.name, now);
      this.scene.hoverSpot(now);
    };
    const end = (now) => {
      button.removeEventListener("pointermove", move);
      this.ghost.hidden = true;
      if (!this.dragged) return;
      const spot = now.type === "pointerup" && this.client.carried && this.scene.spotAt(now);
      if (spot) this.client.put(spot.id);
      else this.client.carry(null);
      if (now.type !== "pointerup") this.dragged = false; // no click follows
    };
    button.addEventListener("pointermove", move);
    for (const name of ["pointerup", "pointercancel"])
      button.addEventListener(name, end, { once: true });
  }

  showGhost(name, { clientX, clientY }) {
    this.ghost.hidden = false;
    this.ghost.textContent = name;
    this.ghost.style.transform = `translate(${clientX + 12}px, ${clientY + 8}px)`;
  }

  /** One after the other, so that the page answers meanwhile. */
  async drawPictures() {
    const drawing = (this.drawing = {}); // an older one ends
    const { meshSource } = this.client.studio;
    const pictures = new StillPictures({ width: 128, height: 96, theme: theme(), meshSource });
    for (const [name, card] of this.cards) {
      const image = card.querySelector("img");
      try {
        image.src = await pictures.draw(await get(`/api/module?name=${encodeURIComponent(name)}`));
      } catch {
        image.classList.add("no-picture");
      }
      await new Promise((resolve) => setTimeout(resolve));
      if (this.drawing !== drawing) break;
    }
    pictures.dispose();
  }
}

/** Where what is carried may go, as a list: arrow keys go through it, enter puts it down. */
export class PlaceList {
  constructor(client) {
    this.client = client;
    this.element = h("section.place-list", { hidden: true, aria: { label: "Where it goes" } });
    this.element.addEventListener("keydown", (event) => this.key(event));
    client.on((what) => {
      if (what === "carried" || what === "assembly") this.show();
      if (what === "aimed") this.mark();
    });
  }

  show() {
    const { carried, dragged } = this.client;
    const before = this.element.hidden;
    this.element.hidden = !carried || dragged; // whoever drags looks at the robot
    if (this.element.hidden) return;
    const spots = this.client.spots();
    this.buttons = spots.map(({ id, words }) =>
      h(
        "button",
        {
          type: "button",
          data: { spot: id },
          onFocus: () => this.client.aim(id),
          onPointerenter: () => this.client.aim(id),
          onClick: () => this.client.put(id),
        },
        words,
      ),
    );
    fill(
      this.element,
      h("h2", {}, `${carried.name}: where?`),
      spots.length ? h("div.place-buttons", {}, this.buttons) : h("p", {}, "Nothing takes it yet."),
      h(
        "button.link",
        { type: "button", onClick: () => this.client.carry(null) },
        "Put it away (escape)",
      ),
    );
    if (before) this.buttons[0]?.focus();
  }

  mark() {
    if (this.element.hidden) return;
    for (const each of this.buttons)
      each.classList.toggle("aimed", each.dataset.spot === this.client.aimed);
  }

  key(event) {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const at = this.buttons.indexOf(document.activeElement);
    const next = (at + step + this.buttons.length) % this.buttons.length;
    this.buttons[next]?.focus();
  }
}
