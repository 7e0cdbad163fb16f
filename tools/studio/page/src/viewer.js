// SPDX-License-Identifier: Apache-2.0
// The viewer that a page embeds: designs and their motions, to be turned and scrubbed, without a
// server. It plays what it is given:
//   legwrightViewer(element, {designs: [{name, design, motion}], theme: "auto"})
import { h } from "./dom.js";
import { SceneView } from "./scene/scene_view.js";
import { cameraButtons, shownSwitches } from "./ui/scene_tools.js";
import { Timeline } from "./ui/timeline.js";
import css from "./viewer.css";

const SHOWN = [
  ["forces", "Forces"],
  ["paths", "Paths"],
  ["faults", "Faults"],
];

let styled = false;

/** Styles once for all viewers of a page; a constructed sheet needs no inline style. */
function addStyles() {
  if (styled) return;
  styled = true;
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(css);
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
}

class Viewer {
  constructor(element, { designs, theme = "auto", ghosts = true }) {
    if (!designs?.length)
      throw new Error("legwrightViewer: `designs` is empty; expected one or more");
    addStyles();
    this.designs = designs;
    this.theme = theme;
    this.stage = h("div.stage");
    this.element = h("div.legwright-viewer", { role: "group", aria: { label: "Robot in 3-D" } });
    element.replaceChildren(this.element);
    this.element.append(this.stage);
    this.view = new SceneView(this.stage);
    const { canvas } = this.view.stage;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", "The robot in 3-D. Arrow keys turn the camera.");
    canvas.addEventListener("keydown", (event) => this.key(event));
    this.timeline = new Timeline(this.view);
    this.tools = h(
      "div.scene-tools",
      {},
      this.tabs(),
      cameraButtons(this.view),
      shownSwitches(this.view, SHOWN),
    );
    if (ghosts && designs.length > 1) this.tools.append(this.ghostSwitch());
    this.element.append(this.tools, this.timeline.element);
    this.followTheme();
    this.followVisibility();
    this.show(designs.length - 1);
  }

  tabs() {
    this.buttons = this.designs.map(({ name }, i) =>
      h(
        "button",
        { type: "button", aria: { pressed: "false" }, onClick: () => this.show(i) },
        name,
      ),
    );
    return h(
      "div.segmented",
      { role: "group", aria: { label: "Design" }, hidden: this.designs.length < 2 },
      this.buttons,
    );
  }

  ghostSwitch() {
    this.ghostButton = h("button", { type: "button", aria: { pressed: "false" } }, "Ghost");
    this.ghostButton.title = "The other design within this one";
    this.ghostButton.addEventListener("click", () => {
      this.ghost = !this.ghost;
      this.show(this.index);
    });
    return h("div.segmented", {}, this.ghostButton);
  }

  /** Shows a design by its number. */
  show(index) {
    const { design, motion } = this.designs[index];
    this.index = index;
    this.buttons.forEach((button, i) => button.setAttribute("aria-pressed", String(i === index)));
    this.view.setDesign(design);
    this.view.setMotion(motion);
    const other = this.ghost ? this.designs[index === 0 ? this.designs.length - 1 : 0] : null;
    this.view.setGhost(other);
    this.ghostButton?.setAttribute("aria-pressed", String(Boolean(this.ghost)));
  }

  /** Light or dark as asked, as the page says (`data-theme`), or as the system has it. */
  followTheme() {
    const dark = matchMedia("(prefers-color-scheme: dark)");
    this.apply = () => {
      const asked = this.theme === "auto" ? document.documentElement.dataset.theme : this.theme;
      const theme = asked ?? (dark.matches ? "dark" : "light");
      this.element.dataset.theme = theme;
      this.view.setTheme(theme);
    };
    dark.addEventListener("change", this.apply);
    this.apply();
  }

  /** Plays only while it is seen: a page may hold many. */
  followVisibility() {
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.view.setPlaying(!still);
    new IntersectionObserver(([{ isIntersecting }]) => {
      if (isIntersecting && this.resting) this.view.setPlaying(true);
      this.resting = !isIntersecting && this.view.playing;
      if (this.resting) this.view.setPlaying(false);
    }).observe(this.element);
  }

  setTheme(theme) {
    this.theme = theme;
    this.apply();
  }

  key(event) {
    const move = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[
      event.key
    ];
    if (event.key === " ") this.timeline.toggle();
    else if (event.key === "+") this.view.stage.zoom(0.9);
    else if (event.key === "-") this.view.stage.zoom(1.11);
    else if (move) this.view.stage.orbit(move[0] * 0.12, move[1] * 0.08);
    else return;
    event.preventDefault();
  }
}

/**
 * Fills an element with a viewer.
 * @param {HTMLElement} element with a height of its own
 * @param {object} options
 * @param {{name: string, design: object, motion: object}[]} options.designs Design and Motion of
 * types.js; shown one at a time, the last first
 * @param {"auto"|"light"|"dark"} options.theme
 * @returns {Viewer} with show(index) and setTheme(theme). Throws an Error where WebGL 2 is missing
 */
export function legwrightViewer(element, options) {
  return new Viewer(element, options);
}

globalThis.legwrightViewer = legwrightViewer;
