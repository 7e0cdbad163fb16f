// SPDX-License-Identifier: Apache-2.0
// The workspace: picture in the middle, what is designed or asked for to its left, what comes of it
// to its right, the timeline below.
import { h, iconButton, setText } from "../dom.js";
import { Pointer } from "../scene/pointer.js";
import { SceneView } from "../scene/scene_view.js";
import { ChangesPanel } from "./changes_panel.js";
import { CostPanel, FaultsPanel } from "./cost_panel.js";
import { menuButton } from "./dialogs.js";
import { HandNote } from "./hand_note.js";
import { HeldBounds } from "./held_bounds.js";
import { JobProgress } from "./job_progress.js";
import { JudgePanel } from "./judge_panel.js";
import { ParameterList } from "./parameter_list.js";
import { PhysicsPanel } from "./physics_panel.js";
import { cameraButtons, pictureButton, RecordButton, shownSwitches } from "./scene_tools.js";
import { SearchButtons, SearchPanel } from "./search_panel.js";
import { showShortcuts, takeKeys } from "./shortcuts.js";
import { SnapshotsPanel } from "./snapshots_panel.js";
import { TaskPanel } from "./task_panel.js";
import { TaskSummary } from "./task_summary.js";
import { followTheme, switchTheme } from "./theme.js";
import { Timeline } from "./timeline.js";

export class Workspace {
  /** @param {import("../studio.js").Studio} studio */
  constructor(studio) {
    this.studio = studio;
    this.stage = h("div.stage");
    studio.view = new SceneView(this.stage, { meshSource: studio.meshSource });
    const { canvas } = studio.view.stage;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", "The robot in 3-D. Arrow keys turn the camera.");
    studio.view.readParameter = (name) => studio.readParameter(name);
    studio.timeline = new Timeline(studio.view);
    studio.searchButtons = new SearchButtons(studio);
    studio.list = new ParameterList(studio);
    studio.changes = new ChangesPanel(studio);
    this.physics = studio.physics = new PhysicsPanel(studio);
    this.below = this.panes();
    this.element = h("div.workspace", {}, this.topBar(), this.below);
    studio.pointer = new Pointer(studio.view, this.pointerActs());
    studio.showWorkspace = (name) => this.show(name);
    this.follow();
    new HeldBounds(studio);
    studio.store.on("held", ({ phase }) =>
      studio.view.stage.setHeld(phase === "begin" || phase === "drag"),
    );
    takeKeys(studio);
    followTheme((theme) => studio.view.setTheme(theme));
    this.show("design");
  }

  topBar() {
    const { studio } = this;
    this.undo = iconButton("undo", "Undo (ctrl z)", () => studio.command("undo"));
    this.redo = iconButton("redo", "Redo (ctrl shift z)", () => studio.command("redo"));
    this.title = h("span.document-name");
    this.job = new JobProgress();
    studio.store.on("job", (job) => this.job.show(job));
    this.tabs = ["design", "simulate"].map((name) =>
      h(
        "button",
        {
          type: "button",
          role: "tab",
          aria: { selected: "false" },
          data: { workspace: name },
          onClick: () => this.show(name),
        },
        name === "design" ? "Design" : "Simulate",
      ),
    );
    const file = menuButton("File", [
      { label: "Save…", hint: "ctrl s", act: () => studio.save() },
      { label: "Report…", act: () => studio.report() },
      { label: "Export…", act: () => studio.exportRobot() },
      { label: "Back to the given body", act: () => studio.command("reset") },
      { label: "Open another…", act: () => studio.showStart() },
    ]);
    this.modules = h(
      "button",
      { type: "button", hidden: true, onClick: () => studio.backToModules() },
      "Modules",
    );
    return h(
      "header.top-bar",
      {},
      h("span.brand", {}, "Legwright"),
      file,
      this.modules,
      this.title,
      h("div.tabs", { role: "tablist", aria: { label: "Workspace" } }, this.tabs),
      h("span.spring"),
      this.job.element, // grows into the gap: what stands behind it stays where it is
      studio.searchButtons.element,
      h("div.segmented", { role: "group", aria: { label: "History" } }, this.undo, this.redo),
      iconButton("sun", "Light or dark", switchTheme),
      iconButton("help", "How to, and keys (?)", showShortcuts),
    );
  }

  panes() {
    const { studio } = this;
    this.panels = {
      design: {
        left: [
          new TaskSummary(studio).element,
          h(
            "section.panel",
            { aria: { label: "Parameters" } },
            h("h2", {}, "Parameters"),
            studio.list.element,
          ),
        ],
        right: [
          new CostPanel(studio),
          studio.changes,
          new FaultsPanel(studio),
          new SnapshotsPanel(studio),
        ].map((each) => each.element),
      },
      simulate: {
        left: [new TaskPanel(studio).element],
        right: [new SearchPanel(studio), new JudgePanel(studio), this.physics].map(
          (each) => each.element,
        ),
      },
    };
    this.sides = Object.entries(this.panels).flatMap(([name, { left, right }]) => [
      h(
        "aside.side.left",
        { data: { workspace: name }, aria: { label: name === "design" ? "Design" : "Task" } },
        left,
      ),
      h("aside.side.right", { data: { workspace: name }, aria: { label: "Results" } }, right),
    ]);
    this.tools = h(
      "div.scene-tools",
      {},
      cameraButtons(studio.view),
      shownSwitches(studio.view),
      this.handlesSwitch(),
      h("div.segmented", {}, pictureButton(studio), new RecordButton(studio).element),
      new HandNote(studio).element,
    );
    this.hint = h("div.scene-hint", { hidden: true });
    const middle = h(
      "main.middle",
      { aria: { label: "Robot" } },
      this.stage,
      this.tools,
      this.hint,
      studio.timeline.element,
    );
    return h("div.panes", {}, this.sides[0], this.sides[2], middle, this.sides[1], this.sides[3]);
  }

  handlesSwitch() {
    const { handles } = this.studio.view;
    const button = h("button", { type: "button", aria: { pressed: "true" } }, "Handles");
    button.addEventListener("click", () => {
      this.handlesOff = !this.handlesOff;
      button.setAttribute("aria-pressed", String(!this.handlesOff));
      this.showHandles();
    });
    handles.visible = true;
    this.handlesButton = h("div.segmented", {}, button);
    return this.handlesButton;
  }

  showHandles() {
    const { view } = this.studio;
    this.handlesButton.hidden = this.name !== "design";
    view.handles.visible = !this.handlesOff && this.name === "design";
    view.pose();
  }

  pointerActs() {
    const { studio } = this;
    return {
      hover: (name) => studio.selection.hover(name),
      drag: (name, value, phase) => {
        studio.selection.set([name]);
        if (phase === "locked")
          studio.notices.show("info", `${name.replaceAll("_", " ")} is locked.`);
        else studio.edit(name, value, phase === "cancel" ? "end" : phase);
      },
      pick: (body, add) => {
        const names = this.namesNear(body);
        studio.selection.set(add ? [...studio.selection.names, ...names] : names);
      },
      push: (push) => this.physics.setPush(push),
    };
  }

  /** The parameters with a handle on a body, or on the nearest body above it. */
  namesNear(body) {
    const { handles, design } = this.studio.view;
    for (let at = body; at > 0; at = design.bodies[at].parent) {
      const names = handles.namesOn(at);
      if (names.length) return names;
    }
    return [];
  }

  follow() {
    const { studio } = this;
    const { store, view } = studio;
    // Nothing can be asked of what is not known yet.
    const known = () => (this.below.inert = !store.get("document"));
    known();
    store.on(["document", "forgotten"], known);
    store.on("document", (document) => {
      setText(this.title, document.label || document.name);
      this.title.title = document.path ?? "";
      view.handles.setParameters(document.parameters, store.get("design")?.bodies ?? []);
      const places = store.get("design")?.handles;
      if (places) view.handles.moveTo(places);
      view.pose(); // new handles are taken hold of from now on, not from the next picture on
    });
    store.on("design", (design) => {
      view.setDesign(design);
      if (design.handles) view.handles.moveTo(design.handles);
    });
    store.on("motion", (motion) => {
      view.setMotion(motion);
      this.stage.classList.toggle("predicted", Boolean(motion.predicted));
    });
    store.on("forgotten", () => {
      view.framed = false;
      view.player = null;
      view.setGhost(null);
    });
    store.on("state", (state) => {
      this.undo.disabled = !state.can_undo;
      this.redo.disabled = !state.can_redo;
      view.stage.touch();
    });
    store.on("opened", (opened) => (this.modules.hidden = !opened?.of_modules));
    studio.selection.on(({ names, hovered }) => {
      view.handles.selected = names;
      view.handles.hovered = hovered;
      this.showValue(hovered ?? studio.selection.first);
      view.pose();
    });
    store.on("state", () => this.showValue(studio.selection.hovered ?? studio.selection.first));
  }

  /** The value of what is pointed at or held, beside the picture. */
  showValue(name) {
    const document = this.studio.store.get("document");
    const parameter = document?.parameters.find((each) => each.name === name);
    this.hint.hidden = !parameter || this.name !== "design";
    if (this.hint.hidden) return;
    const { unit } = parameter;
    const { value, lower, upper, locked } = this.studio.readParameter(name);
    const digits = unit === "m" ? 4 : 3;
    const degrees = unit === "rad" ? ` (${((value * 180) / Math.PI).toFixed(1)}°)` : "";
    const range = `${lower.toFixed(digits)} to ${upper.toFixed(digits)}`;
    setText(
      this.hint,
      `${name.replaceAll("_", " ")}  ${value.toFixed(digits)} ${unit}${degrees}, ${locked ? "locked" : range}`,
    );
  }

  /** @param {"design"|"simulate"} name */
  show(name) {
    this.name = name;
    for (const each of [...this.tabs, ...this.sides]) {
      const on = each.dataset.workspace === name;
      if (each.role === "tab") each.setAttribute("aria-selected", String(on));
      else each.hidden = !on;
    }
    this.showHandles();
    this.showValue(this.studio.selection.first);
  }
}
