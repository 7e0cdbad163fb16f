// SPDX-License-Identifier: Apache-2.0
// Keys for everything that a pointer does, and the list of them, below the way from a robot to one
// that walks.
import { h } from "../dom.js";
import { openDialog } from "./dialogs.js";

const WAY = [
  ["Open", "drop a robot's files on the first page (File, Open another…), or take an example"],
  ["Ask", "Simulate, at the left: Walk, Sideways, Faster, a speed, a payload, a slope"],
  ["Optimise", "at the top; a lock in the list (Design, at the left) keeps a length or an angle"],
  ["Judge", "Simulate, at the right: MuJoCo plays the gait. FAIL? Find one that passes…"],
  ["Export…", "under File, at the top left: the robot and its gait, for MuJoCo as it comes"],
];

const LIST = [
  ["space", "play or pause the motion"],
  [", .", "one frame back, on"],
  ["ctrl z, ctrl shift z", "undo, redo"],
  ["[ ]", "the parameter before, after"],
  ["+ −", "change the selected parameter; with shift ten steps"],
  ["L", "lock or unlock the selected parameter"],
  ["P", "put the selected parameter back to its given value"],
  ["F", "work out with how few changes the body would do"],
  ["escape", "select nothing"],
  ["O", "optimise, pause, continue"],
  ["arrows on the picture", "turn the camera; with shift zoom"],
  ["1 2 3 4", "camera: corner, side, front, top"],
  ["D, S", "workspace: design, simulate"],
  ["ctrl s", "save"],
  ["?", "this page"],
];

const FINGERS = [
  ["a dot on the robot", "drag it: the limb grows, the axis turns, the trunk widens"],
  ["a limb", "tap it: its parameters are selected, axes get their rings"],
  ["one finger", "turns the camera"],
  ["two fingers", "move and zoom"],
  ["a slider", "sideways moves it; up and down scrolls"],
  ["rest on a button or a figure", "says what it is"],
];

const way = () =>
  h(
    "ol.way",
    {},
    WAY.map(([name, words]) => h("li", {}, h("strong", {}, name), ` – ${words}`)),
  );

const table = (list) =>
  h(
    "table.keys",
    {},
    h(
      "tbody",
      {},
      list.map(([keys, words]) =>
        h("tr", {}, h("th", { scope: "row" }, h("kbd", {}, keys)), h("td", {}, words)),
      ),
    ),
  );

export function showShortcuts() {
  const close = h("button.primary", { type: "button", onClick: () => dialog.close() }, "Close");
  const touched = matchMedia("(pointer: coarse)").matches;
  const dialog = openDialog(
    "How to",
    h(
      "div.help",
      {},
      way(),
      touched ? [h("h3", {}, "Fingers"), table(FINGERS)] : [],
      h("h3", {}, "Keys"),
      table(LIST),
    ),
    h("div.actions", {}, close),
  );
}

const typing = (element) =>
  element.matches?.("input:not([type=range]), textarea, select, dialog *") ?? false;

const WAYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** Turns or zooms the camera; false where the key is for something else. */
function moveCamera({ stage }, event) {
  const way = WAYS[event.key];
  if (!way || event.target !== stage.canvas) return false;
  if (event.shiftKey) stage.zoom(way[0] + way[1] > 0 ? 0.9 : 1.11);
  else stage.orbit(way[0] * 0.12, way[1] * 0.08);
  return true;
}

/** Gives the selected parameter its given value again. */
function putBack(studio) {
  const name = studio.selection.first;
  const parameter = studio.store.get("document").parameters.find((each) => each.name === name);
  if (!parameter) return;
  if (studio.readParameter(name).locked)
    studio.notices.show("info", `${name.replaceAll("_", " ")} is locked.`);
  else studio.edit(name, parameter.given, "once");
}

/** What each key without ctrl does. */
function plainKeys(studio) {
  const { view, selection } = studio;
  const choose = (step) => {
    const names = studio.store.get("document").parameters.map((p) => p.name);
    const at = names.indexOf(selection.first);
    selection.set([names[(at + step + names.length) % names.length]]);
  };
  const nudge = (sign, event) =>
    selection.first && studio.list.nudge(selection.first, sign * (event.shiftKey ? 10 : 1));
  return {
    " ": (event) =>
      event.target.tagName !== "BUTTON" &&
      event.target.tagName !== "SUMMARY" &&
      (studio.timeline.toggle(), true),
    ",": () => studio.timeline.stepFrame(-1),
    ".": () => studio.timeline.stepFrame(1),
    "[": () => choose(-1),
    "]": () => choose(1),
    "+": (event) => nudge(1, event),
    "=": (event) => nudge(1, event),
    "-": (event) => nudge(-1, event),
    l: () =>
      selection.first &&
      studio.lock(selection.first, !studio.readParameter(selection.first).locked),
    p: () => putBack(studio),
    f: () => studio.changes.findFewest(),
    o: () => studio.searchButtons.toggle(),
    1: () => view.stage.view("corner"),
    2: () => view.stage.view("side"),
    3: () => view.stage.view("front"),
    4: () => view.stage.view("top"),
    d: () => studio.showWorkspace("design"),
    s: () => studio.showWorkspace("simulate"),
    "?": () => showShortcuts(),
    Escape: () => selection.set([]),
  };
}

export function takeKeys(studio) {
  const plain = plainKeys(studio);
  addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.altKey || document.body.dataset.page !== "workspace")
      return;
    if (event.ctrlKey || event.metaKey) {
      const act = {
        z: () => studio.command(event.shiftKey ? "redo" : "undo"),
        y: () => studio.command("redo"),
        s: () => studio.save(),
      }[event.key.toLowerCase()];
      if (!act || (typing(event.target) && event.key !== "s")) return;
      event.preventDefault();
      act();
      return;
    }
    if (typing(event.target) || !studio.store.get("document")) return;
    if (moveCamera(studio.view, event)) return event.preventDefault();
    const act = plain[event.key] ?? plain[event.key.toLowerCase()];
    if (act && act(event) !== false) event.preventDefault();
  });
}
