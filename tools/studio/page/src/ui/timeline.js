// SPDX-License-Identifier: Apache-2.0
// The cycle as a timeline: which foot stands when, what is wrong when, and where the picture is. Of
// a run in physics all of it instead, to be scrubbed. Knows the scene alone, so a report has it, too.
import { fill, h, icon, setText, svg } from "../dom.js";
import { atMost, calmly } from "./rate.js";
import { RunCycles } from "./run_cycles.js";

const ROW = 9; // of the drawing's units
const FAULTS = 4; // of what is wrong with no foot
const TRACK = 48; // px, of the whole drawing at least
const LABEL = 11; // px, of a foot's name
const TICKS = 12; // px, of the numbers of a run's cycles
const STANDS = 0.02; // of the weight, from which on a foot in physics stands
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
        onChange: () => view.setSpeed(Number(this.speed.value)),
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
    this.ticks = h("div.ticks", { aria: { hidden: "true" } });
    this.element = h(
      "div.timeline",
      { role: "group", aria: { label: "Timeline" } },
      this.play,
      this.speed,
      this.labels,
      h("div.track", {}, this.drawing, this.ticks, this.head, this.slider),
      this.clock,
    );
    this.drawRunSoon = atMost(250, () => this.run && this.drawRun());
    this.drawSoon = calmly(() => view.player && !this.run && this.draw(view.player));
    this.tell = calmly((share, text, spoken) => {
      this.slider.valueAsNumber = share;
      setText(this.clock, text);
      this.slider.setAttribute("aria-valuetext", spoken);
    });
    view.onPlaying = () => this.showPlaying();
    view.onPose = () => this.showPhase();
    this.showPlaying();
  }

  toggle() {
    const { view } = this;
    if (!this.run) return view.setPlaying(!view.playing);
    const { recording } = view;
    const playing = recording.shown && !view.playing;
    if (!recording.shown) view.seekRecording(recording.end); // holds it
    else if (playing && recording.at >= recording.end) view.seekRecording(recording.begin);
    view.setPlaying(playing);
  }

  scrub() {
    const { view, slider } = this;
    view.setPlaying(false);
    if (!this.run) return view.seekPhase(slider.valueAsNumber);
    const { begin, seconds } = view.recording;
    view.seekRecording(begin + slider.valueAsNumber * seconds);
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
    if (this.run) return view.seekRecording(view.recording.neighbour(count));
    const frame = Math.round(view.phase() * view.player.frames) + count;
    const { cycle } = view.player.at(view.time);
    view.seek((cycle + (frame + 1e-6) / view.player.frames) * view.player.period);
  }

  showPlaying() {
    const { view } = this;
    const playing = this.run && !view.recording.shown ? true : view.playing;
    this.play.replaceChildren(icon(playing ? "pause" : "play"));
    const what = this.run ? "the run" : "the motion";
    const label = playing ? `Pause ${what}` : `Play ${what}`;
    this.play.title = `${label} (space)`;
    this.play.setAttribute("aria-label", label);
  }

  showPhase() {
    const { view } = this;
    const run = Boolean(view.live && view.recording.frames.length > 1);
    if (run !== Boolean(this.run)) this.showRuns(run);
    if (run) return this.showRun();
    if (view.player && view.player !== this.player) this.drawSoon();
    const phase = view.live ? (view.live.phase ?? 0) : view.phase();
    const shown = phase.toFixed(3);
    if (shown === this.shownPhase) return;
    this.shownPhase = shown;
    this.moveHead(phase);
    const period = (view.player?.period ?? 0).toFixed(2);
    const seconds = (phase * period).toFixed(2);
    this.tell(phase, `${seconds} / ${period} s`, `${seconds} of ${period} seconds`);
  }

  /** Changes between the cycle and a run in physics. */
  showRuns(run) {
    this.run = run;
    this.drawnKey = this.shownPhase = this.player = null;
    this.element.classList.toggle("of-a-run", run);
    this.slider.setAttribute("aria-label", run ? "Time of the run" : "Phase of the cycle");
    this.showPlaying();
  }

  showRun() {
    const { view } = this;
    const { recording } = view;
    if (recording.shown !== this.held) {
      this.held = recording.shown;
      this.showPlaying();
    }
    const share = recording.seconds > 0 ? (recording.at - recording.begin) / recording.seconds : 0;
    this.moveHead(share);
    const [at, end] = [recording.at.toFixed(2), recording.end.toFixed(2)];
    this.tell(share, `${at} / ${end} s`, `${at} of ${end} seconds of the run`);
    this.drawRunSoon();
  }

  /** A layer of its own: nothing else is painted anew. @param {number} share of the track */
  moveHead(share) {
    this.head.style.transform = `translateX(${(100 * share).toFixed(2)}cqw)`;
  }

  /** When each foot stood in physics, and from when on the robot lay. */
  drawRun() {
    const { recording, player } = this.view;
    if (!player || !recording.frames.length) return;
    const cycles = new RunCycles(recording, player.period);
    const key = `${recording.begin} ${recording.end} ${cycles.many ? cycles.present : ""}`;
    if (key === this.drawnKey) return;
    this.drawnKey = key;
    const feet = recording.frames[0].feet;
    const rows = Math.max(1, feet.length) * ROW;
    this.drawing.setAttribute("viewBox", `0 0 1000 ${rows + FAULTS}`);
    const stances = recording.stances(STANDS * (player.weight ?? 0));
    const row = (kind) => (spans, i) =>
      spans.map(([a, b]) => bar(kind, a, b, i * ROW + 1, ROW - 2));
    const ticks = cycles.ticks();
    const bars = [
      ...(cycles.many ? stances.map((spans) => cycles.joined(spans)).flatMap(row("walked")) : []),
      ...ticks.map(({ at }) => bar("tick", at, at + 0.0015, 0, rows)),
      ...stances.map((spans) => cycles.shown(spans)).flatMap(row("stance")),
    ];
    fill(
      this.ticks,
      ticks.map(({ at, number }, i) =>
        h("span", { style: { left: `${100 * at}%` } }, i ? `${number}` : `cycle ${number}`),
      ),
    );
    const { fell } = recording.frames.at(-1);
    const from = fell ? (fell.time - recording.begin) / recording.seconds : 1;
    if (from < 1) bars.push(bar("fault", Math.max(0, from), 1, feet.length * ROW + 1, FAULTS - 1));
    fill(this.drawing, bars);
    this.nameFeet(feet, true, TICKS);
  }

  /** @param {number} below px that the rows leave free for what is told of the run */
  nameFeet(feet, others, below = 0) {
    fill(
      this.labels,
      feet.map((foot) => h("span", {}, foot.name)),
    );
    const height = Math.max(1, feet.length) * ROW + (others ? FAULTS : 0);
    const tall = Math.max(TRACK, LABEL * feet.length);
    this.element.style.setProperty("--track", `${tall + below}px`);
    const free = (others ? (tall * FAULTS) / height : 0) + below;
    this.labels.style.paddingBottom = `${free}px`;
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
    this.nameFeet(feet, others);
  }
}

/** A bar of the drawing, from share to share of its width. */
const bar = (name, from, to, y, tall) =>
  svg(`rect.${name}`, { x: 1000 * from, width: 1000 * (to - from), y, height: tall });

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
