// SPDX-License-Identifier: Apache-2.0
// A robot is made of modules: the palette to the left, the robot in the middle, what it consists of
// and what is selected to its right.
import { h, iconButton, setText } from "../../dom.js";
import { AssemblyClient } from "../../session/assembly_client.js";
import { post } from "../../session/api.js";
import { significant } from "../../units.js";
import { ask, openDialog } from "../dialogs.js";
import { cameraButtons } from "../scene_tools.js";
import { switchTheme } from "../theme.js";
import { AssemblyScene } from "./assembly_scene.js";
import { ItemForm } from "./item_form.js";
import { Outline } from "./outline.js";
import { Palette, PlaceList } from "./palette.js";

const FIRST = "drag a servo from the palette onto the trunk, where it begins a leg";
const WAYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

export class AssemblyPage {
  /** @param {import("../../studio.js").Studio} studio */
  constructor(studio) {
    this.studio = studio;
    this.client = studio.assembly = new AssemblyClient(studio);
    this.scene = studio.assemblyScene = new AssemblyScene(this.client);
    this.palette = new Palette(this.client, this.scene);
    this.outline = new Outline(this.client);
    this.form = new ItemForm(this.client);
    this.summary = h("div.scene-hint");
    this.tools = h("div.scene-tools");
    const middle = h(
      "main.middle",
      { aria: { label: "Robot" } },
      this.scene.element,
      this.tools,
      new PlaceList(this.client).element,
      this.summary,
    );
    this.element = h(
      "div.assembly",
      { hidden: true },
      this.topBar(),
      h(
        "div.panes",
        {},
        h("aside.side.left", { aria: { label: "Palette" } }, this.palette.element),
        middle,
        h("aside.side.right", {}, this.outline.element, this.form.element),
      ),
    );
    this.client.on((what) => this.follow(what));
    addEventListener("keydown", (event) => this.key(event));
  }

  topBar() {
    const undo = () => this.client.obey({ do: "undo" });
    const redo = () => this.client.obey({ do: "redo" });
    this.undo = iconButton("undo", "Undo (ctrl z)", undo);
    this.redo = iconButton("redo", "Redo (ctrl shift z)", redo);
    this.title = h("span.document-name");
    return h(
      "header.top-bar",
      {},
      h("span.brand", {}, "Legwright"),
      h("button", { type: "button", onClick: () => this.studio.showStart() }, "Open another…"),
      h("button", { type: "button", onClick: () => this.save() }, "Save…"),
      this.title,
      h("span.spring"),
      h("div.segmented", { role: "group", aria: { label: "History" } }, this.undo, this.redo),
      h("button.primary", { type: "button", onClick: () => this.build() }, "Build and design"),
      iconButton("sun", "Light or dark", switchTheme),
    );
  }

  /** Called when the page is shown. */
  async load() {
    this.shown = true;
    if (this.client.told) this.follow("assembly");
    await this.palette.load();
    this.form.modules = this.palette.modules;
    if (this.client.told) this.form.show();
  }

  follow(what) {
    if (this.element.hidden) return;
    if (what === "assembly") {
      this.showTold();
      this.scene.show();
    } else this.scene.follow(what);
    if (what === "selected") {
      this.outline.mark();
      this.form.show();
    }
  }

  showTold() {
    const { name, mass, servos, path, can_undo, can_redo } = this.client.told;
    setText(this.title, name);
    this.title.title = path ?? "";
    this.undo.disabled = !can_undo;
    this.redo.disabled = !can_redo;
    const weight = `${significant(mass, 3)} kg, ${servos} servo${servos === 1 ? "" : "s"}`;
    setText(this.summary, servos ? weight : `${weight}: ${FIRST}`);
    this.outline.show();
    this.form.show();
    if (!this.tools.firstChild) {
      this.scene.begin();
      this.tools.append(cameraButtons(this.scene.view));
    }
  }

  build() {
    return this.studio.open(() => post("/api/assembly/build"));
  }

  async save() {
    const { path, name } = this.client.told;
    const asked = await ask("Save the assembly", path || `${name}.toml`, {
      label: "File",
      action: "Save",
      hint: "Below the folders that the studio was started with.",
    });
    await this.studio.answered();
    if (asked) await this.saveTo(asked, asked === this.savedAs);
  }

  /** Writes the file; one that is there is replaced once that was asked for. */
  async saveTo(file, force) {
    try {
      const { path } = await post("/api/assembly/save", { path: file, force });
      this.savedAs = path; // no comments are in it
      this.studio.notices.show("done", `Saved: ${path}`);
    } catch (error) {
      const isThere = error.status === 409 && !force;
      if (isThere && (await this.mayReplace(file))) await this.saveTo(file, true);
      else if (!isThere) this.studio.fail(error);
    }
  }

  mayReplace(file) {
    return new Promise((resolve) => {
      const say = (yes) => () => {
        resolve(yes);
        dialog.close();
      };
      const dialog = openDialog(
        "Replace the file?",
        h("p", {}, `${file} is there already. Its comments and its order would be lost.`),
        h(
          "div.actions",
          {},
          h("button", { type: "button", onClick: say(false) }, "Cancel"),
          h("button.primary", { type: "button", onClick: say(true) }, "Replace"),
        ),
      );
      dialog.addEventListener("close", () => resolve(false));
    });
  }

  key(event) {
    if (event.defaultPrevented || document.body.dataset.page !== "assembly") return;
    if (document.querySelector("dialog[open]")) return;
    const typing = event.target.matches?.("input, textarea, select");
    const control = event.ctrlKey || event.metaKey;
    const acts = control
      ? {
          z: () => this.client.obey({ do: event.shiftKey ? "redo" : "undo" }),
          y: () => this.client.obey({ do: "redo" }),
          s: () => this.save(),
        }
      : {
          Delete: () => this.client.obey({ do: "remove", item: this.client.selected }),
          Escape: () => this.scene.cancelDrag() || this.client.carry(null),
          1: () => this.scene.view.stage.view("corner"),
          2: () => this.scene.view.stage.view("side"),
          3: () => this.scene.view.stage.view("front"),
          4: () => this.scene.view.stage.view("top"),
        };
    const way = WAYS[event.key];
    const { stage } = this.scene.view ?? {};
    if (way && event.target === stage?.canvas) stage.orbit(way[0] * 0.12, way[1] * 0.08);
    else {
      const act = acts[control ? event.key.toLowerCase() : event.key];
      if (!act || (typing && event.key !== "s" && event.key !== "Escape")) return;
      act();
    }
    event.preventDefault();
  }
}
