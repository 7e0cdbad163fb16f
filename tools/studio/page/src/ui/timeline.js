// SPDX-License-Identifier: Apache-2.0
// The cycle as a timeline: which foot stands when, what is wrong when, and where the picture is.
// Knows the scene alone, so a report has it, too.
import { fill, h, icon, setText, svg } from "../dom.js";

const ROW = 9; // of the drawing's units
const FAULTS = 4; // of what is wrong with no foot
const TRACK = 48; // px, of the whole drawing at least
const LABEL = 11; // px, of a foot's name
const SPEEDS = [1, 0.5, 0.25, 0.1];

export class Timeline {
  /** @param {import("../scene/scene_view.js").SceneView} view */
  constructor(view) {
    this.view = view;
    this.play = h("button.icon-button.play", { type: "button", onClick: () => this.toggle() });
    this.speed = h(
      "select",
      {
        aria: { label: "Speed" },
        title: "Speed",
        onChange: () => (view.speed = Number(this.speed.value)),
      },
      SPEEDS.map((s) => h("option", { value: s }, s === 1 ? "1 ×" : `${s} ×`)),
    );
    this.clock = h("output.clock");
    this.drawing = svg("svg.footfalls", { preserveAspectRatio: "none", "aria-hidden": "true" });
    this.head = h("div.playhead");
    this.slider = h("input.scrub", {
      type: "range",
      min: 0,
      max: 1,
      step: "any",
      aria: { label: "Phase of the cycle" },
      onInput: () => this.scrub(),
      onKeydown: (event) => this.key(event),
    });
    this.labels = h("div.foot-names");
    this.element = h(
      "div.timeline",
      { role: "group", aria: { label: "Timeline" } },
      this.play,
      this.speed,
      this.labels,
      h("div.track", {}, this.drawing, this.head, this.slider),
      this.clock,
    );
    view.onPlaying = () => this.showPlaying();
    view.onPose = () => this.showPhase();
    this.showPlaying();
  }

  toggle() {
    this.view.setPlaying(!this.view.playing);
  }

  scrub() {
    this.view.setPlaying(false);
    this.view.seekPhase(this.slider.valueAsNumber);
  }

  key(event) {
    const move = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
    if (!move) return;
    event.preventDefault();
    event.stopPropagation();
    this.stepFrame(move);
  }

  /** One planned frame on or back. */
  stepFrame(count) {
    const { view } = this;
    if (!view.player) return;
    view.setPlaying(false);
    const frame = Math.round(view.phase() * view.player.frames) + count;
    const { cycle } = view.player.at(view.time);
    view.seek((cycle + (frame + 1e-6) / view.player.frames) * view.player.period);
  }

  showPlaying() {
    const { playing } = this.view;
    this.play.replaceChildren(icon(playing ? "pause" : "play"));
    const label = playing ? "Pause the motion" : "Play the motion";
    this.play.title = `${label} (space)`;
    this.play.setAttribute("aria-label", label);
  }

  showPhase() {
    const { view } = this;
    if (view.player && view.player !== this.player) this.draw(view.player);
    const phase = view.live ? (view.live.phase ?? 0) : view.phase();
    const shown = phase.toFixed(3);
    if (shown === this.shownPhase) return;
    this.shownPhase = shown;
    this.head.style.left = `${(100 * phase).toFixed(2)}%`;
    this.slider.valueAsNumber = phase;
    const period = view.player?.period ?? 0;
    const seconds = (phase * period).toFixed(2);
    setText(this.clock, `${seconds} / ${period.toFixed(2)} s`);
    this.slider.setAttribute("aria-valuetext", `${seconds} of ${period.toFixed(2)} seconds`);
  }

  draw(player) {
    this.player = player;
    this.shownPhase = null;
    const { feet, faults } = player;
    const key = JSON.stringify([
      feet.map(({ name, stance }) => [name, stance]),
      faults.map(({ where, from, to }) => [where, from, to]),
    ]);
    if (key === this.drawnKey) return;
    this.drawnKey = key;
    const rows = faults.map(({ where }) => feet.findIndex((foot) => foot.name === where));
    const others = rows.includes(-1);
    const height = Math.max(1, feet.length) * ROW + (others ? FAULTS : 0);
    this.drawing.setAttribute("viewBox", `0 0 1000 ${height}`);
    const bar = (name, from, to, y, tall) =>
      svg(`rect.${name}`, { x: 1000 * from, width: 1000 * (to - from), y, height: tall });
    const bars = feet.flatMap((foot, i) =>
      runs(foot.stance).map(([from, to]) => bar("stance", from, to, i * ROW + 1, ROW - 2)),
    );
    const wrong = faults.flatMap((fault, i) =>
      spans(fault).map(([from, to]) =>
        rows[i] < 0
          ? bar("fault", from, to, feet.length * ROW + 1, FAULTS - 1)
          : bar("fault", from, to, rows[i] * ROW + ROW - 3.5, 2.5),
      ),
    );
    fill(this.drawing, bars, wrong);
    fill(
      this.labels,
      feet.map((foot) => h("span", {}, foot.name)),
    );
    const tall = Math.max(TRACK, LABEL * feet.length);
    this.element.style.setProperty("--track", `${tall}px`);
    this.labels.style.paddingBottom = others ? `${(tall * FAULTS) / height}px` : "0";
  }
}

/** The phases of a fault, cut at the seam of the cycle. */
const spans = ({ from, to }) =>
  from <= to
    ? [[from, to]]
    : [
        [from, 1],
        [0, to],
      ];

/** Where a list of 0 and 1 holds 1, as shares of its length. */
export function runs(list) {
  const found = [];
  const count = list?.length ?? 0;
  for (let i = 0; i < count; i++) {
    if (!list[i]) continue;
    const from = i;
    while (i < count && list[i]) i++;
    found.push([from / count, i / count]);
  }
  return found;
}
