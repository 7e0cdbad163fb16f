// SPDX-License-Identifier: Apache-2.0
// The gait in MuJoCo, in real time: gains, friction and slope by sliders, pushed with the pointer,
// planned against measured forces as curves.
import { fill, h, icon, setText } from "../dom.js";
import { floatsOf } from "../decode.js";
import { post } from "../session/api.js";
import { COLOURS, Plot } from "./plots.js";
import { WalkedSpeed } from "./walked_speed.js";

const SHOWN = 3; // s of curves
const PUSH = 60; // N per metre of the pointer's way, for each kilogram of the robot

const SLIDERS = [
  { key: "stiffness", label: "stiffness", unit: "×", min: 0.25, max: 4, step: 0.05, value: 1 },
  { key: "damping", label: "damping", unit: "×", min: 0.25, max: 4, step: 0.05, value: 1 },
  { key: "friction", label: "friction", unit: "", min: 0.1, max: 1.5, step: 0.05, value: 0.8 },
  { key: "slope", label: "slope", unit: "rad", min: -0.3, max: 0.3, step: 0.01, value: 0 },
];

export class PhysicsPanel {
  constructor(studio) {
    this.studio = studio;
    this.values = Object.fromEntries(SLIDERS.map(({ key, value }) => [key, value]));
    this.taken = {}; // of the task
    this.walked = new WalkedSpeed();
    this.addButtons();
    this.addCurves();
    this.status = h("p.status", { role: "status" });
    this.element = h(
      "section.panel",
      { aria: { label: "Physics" } },
      h("h2", {}, "Physics"),
      h("div.button-row", {}, this.run, this.goOn, this.reset, this.pushing, this.nudge),
      this.pushHint,
      this.status,
      h(
        "div.sliders",
        {},
        SLIDERS.map((slider) => this.slider(slider)),
      ),
      h("p.hint", {}, "For playing here alone: Judge takes what the task says."),
      this.forces,
    );
    this.show(false);
    studio.view.onRecording = () => this.hold();
    studio.view.onSpeed = () => this.running && !this.held && this.send({});
    studio.store.on("forgotten", () => this.forget());
    // Of a body that has changed since, a run that is held has poses that do not fit.
    studio.store.on("design", () => this.held && this.toggle(false));
    studio.store.on("physics", (physics) => this.update(physics));
    studio.store.on("document", (document) => this.takeTask(document));
  }

  addButtons() {
    this.run = h("button.primary", { type: "button", onClick: () => this.toggle() });
    this.reset = h(
      "button",
      { type: "button", onClick: () => this.startAgain() },
      icon("reset"),
      "Start again",
    );
    this.goOn = h(
      "button",
      {
        type: "button",
        hidden: true,
        title: "The physics go on from where they were held",
        onClick: () => this.resume(),
      },
      icon("step"),
      "Go on",
    );
    this.pushing = h(
      "button",
      {
        type: "button",
        title: "Drag on the robot pushes it (or hold shift)",
        aria: { pressed: "false" },
        onClick: () => this.togglePush(),
      },
      "Push",
    );
    this.pushHint = h("p.hint", { hidden: true });
    this.nudge = h(
      "button",
      { type: "button", title: "A short push from the side", onClick: () => this.shortPush() },
      "Nudge",
    );
  }

  addCurves() {
    this.plot = new Plot({
      label: "Vertical forces on the feet, planned and measured",
      series: [],
      x: "s",
      unit: "N",
      height: 150,
    });
    this.legend = h("div.legend");
    this.foot = h("select", {
      aria: { label: "Foot whose forces are shown" },
      onChange: () => (this.plotKey = null),
    });
    this.forces = h(
      "div",
      { hidden: true },
      h("h3", {}, "Planned and measured force", this.foot),
      this.plot.element,
      this.legend,
    );
  }

  slider({ key, label, unit, min, max, step, value }) {
    const output = h("output");
    const tell = () => setText(output, `${input.valueAsNumber.toFixed(2)} ${unit}`.trim());
    const input = h("input.slider", {
      type: "range",
      min,
      max,
      step,
      aria: { label: `${label} in physics` },
      onInput: () => {
        tell();
        this.values[key] = input.valueAsNumber;
        this.send({});
      },
    });
    input.valueAsNumber = value;
    this.inputs = { ...this.inputs, [key]: { input, tell } };
    tell();
    return h("label.slider-row", {}, h("span", {}, label), input, output);
  }

  /** Friction and slope are the task's, until a hand sets them or the task has others. */
  takeTask({ tasks }) {
    const task = tasks?.[this.studio.store.get("task") ?? 0];
    if (!task || this.running) return;
    for (const [key, value] of [
      ["friction", task.floor_friction],
      ["slope", task.slope?.[0]],
    ]) {
      if (!Number.isFinite(value) || value === this.taken[key]) continue;
      this.taken[key] = this.values[key] = value;
      this.inputs[key].input.valueAsNumber = value;
      this.inputs[key].tell();
    }
  }

  body(extra) {
    const { stiffness, damping, friction, slope } = this.values;
    const task = this.studio.store.get("task") ?? 0;
    const reset = Boolean(this.again);
    this.again = false;
    return {
      run: this.running && !this.held,
      task,
      gains: [stiffness, damping],
      friction,
      slope,
      speed: this.studio.view.speed,
      reset,
      push: this.push ?? null,
      ...extra,
    };
  }

  send(extra) {
    this.studio.latestBeside("physics", () => post("/api/physics", this.body(extra)));
  }

  startAgain() {
    this.again = true;
    this.release();
    this.send({});
  }

  /** Goes on from where the physics were held, whatever of the run is looked at. */
  resume() {
    this.release();
    this.send({});
  }

  /** Another robot is opened: nothing of the run of this one stays. */
  forget() {
    this.release();
    this.push = this.until = this.plotKey = this.names = null;
    this.starting = this.again = false;
    this.times = [];
    this.taken = {};
    this.forces.hidden = true;
    for (const { key, value } of SLIDERS) {
      this.values[key] = this.inputs[key].input.valueAsNumber = value;
      this.inputs[key].tell();
    }
    const { view } = this.studio;
    if (this.running) view.setPlaying(this.wasPlaying ?? true);
    this.show(false);
    view.recording.clear();
    view.leaveRecording();
  }

  release() {
    this.held = false;
    this.goOn.hidden = true;
    this.studio.view.recording.shown = false;
    this.studio.view.pointAt([]);
  }

  toggle(on = !this.running) {
    this.release();
    this.studio.view.recording.clear();
    this.starting = on;
    if (!on) this.until = undefined;
    this.show(on);
    this.times = [];
    this.send({ run: on });
    const { view } = this.studio;
    if (on) this.wasPlaying = view.playing;
    else {
      view.leaveRecording();
      view.setPlaying(this.wasPlaying ?? view.playing);
    }
  }

  show(running) {
    this.running = running;
    fill(
      this.run,
      icon(running ? "stop" : "play"),
      running ? "Back to the plan" : "Play in MuJoCo",
    );
    for (const each of [this.reset, this.pushing, this.nudge]) each.disabled = !running;
    this.pushHint.hidden = !running;
    if (!running) {
      setText(this.status, "The plan is shown.");
      this.status.classList.remove("bad");
      this.togglePush(false);
    }
  }

  togglePush(on = !this.studio.pointer?.pushing) {
    if (this.studio.pointer) this.studio.pointer.pushing = on;
    this.pushing.setAttribute("aria-pressed", String(on));
    setText(
      this.pushHint,
      on
        ? "Drag on the robot: it is pushed that way, the harder the farther. Push again to turn the camera."
        : "Shift and drag on the robot pushes it; Push does so without shift.",
    );
  }

  /** @param {?{body: number, at: number[], along: import("three").Vector3}} pushed by the pointer */
  setPush(pushed) {
    if (!this.running) return;
    const mass = this.studio.store.get("document").mass ?? 1;
    this.push = pushed && {
      body: pushed.body,
      point: pushed.at,
      force: pushed.along.toArray().map((x) => x * PUSH * mass),
    };
    this.send({});
  }

  shortPush() {
    const mass = this.studio.store.get("document").mass ?? 1;
    this.push = { body: this.studio.view.player?.root ?? 1, point: [0, 0, 0], force: [0, 4 * mass, 0] };
    this.send({});
    setTimeout(() => {
      this.push = null;
      this.send({});
    }, 200);
  }

  update(physics) {
    if (!physics?.poses || !physics.running) {
      if (this.held) return;
      if (this.running && physics?.running === false && !this.starting) this.toggle(false);
      return;
    }
    this.starting = false;
    if (this.held) return;
    if (!this.running && !this.goesOn()) return;
    if (!this.running) this.show(true); // another page began it
    const { poses, feet, phase, time, speed, fell, up } = physics;
    const live = { time, poses: floatsOf(poses), feet: feet ?? [], phase, up, fell };
    this.studio.view.recording.add(live);
    this.studio.view.setLive(live);
    const pace = Number.isFinite(speed) ? `${speed.toFixed(2)} × real time` : "";
    const end = fell ? `fell after ${fell.time.toFixed(2)} s: ${fell.words}` : "";
    const plan = this.studio.view.player;
    if (plan) this.walked.add(time, live.poses, plan);
    const walks = plan && !fell ? this.walked.words(plan) : "";
    setText(this.status, [`${time.toFixed(2)} s`, pace, walks, end].filter(Boolean).join(" · "));
    this.status.classList.toggle("bad", Boolean(fell));
    this.curves(physics);
    this.rewound ||= time < this.until; // events from before the new start may still come
    if (this.rewound && time >= this.until) this.hold();
  }

  /** Whether frames come one after the other: a single one may be the last of a while ago. */
  goesOn() {
    const now = performance.now();
    const soon = now - (this.frameAt ?? -Infinity) < 500;
    this.frameAt = now;
    return soon;
  }

  /**
   * Plays from the start to a moment that the judge speaks of, and holds there.
   * @param {number} time [s] @param {string} gains at which it was: half, default or double
   */
  playUntil(time, gains = "") {
    const factor = /half/.test(gains) ? 0.5 : /double/.test(gains) ? 2 : 1;
    for (const key of ["stiffness", "damping"]) {
      this.values[key] = this.inputs[key].input.valueAsNumber = factor;
      this.inputs[key].tell();
    }
    this.until = time;
    this.rewound = false;
    this.again = true;
    if (!this.running) return this.toggle(true);
    this.release();
    this.send({});
  }

  /** Keeps the picture of this moment; the physics rest. */
  hold() {
    if (this.held) return;
    this.until = undefined;
    this.held = true;
    this.goOn.hidden = false;
    setText(this.status, `Held at ${this.studio.view.recording.end.toFixed(2)} s of the run.`);
    this.send({ run: false });
  }

  curves({ time, feet }) {
    this.forces.hidden = !feet?.length;
    if (!feet?.length) return;
    const names = feet.map((foot) => foot.name).join();
    if (names !== this.names) {
      this.names = names;
      fill(
        this.foot,
        feet.map((foot, i) => h("option", { value: i }, foot.name)),
      );
    }
    if (!this.times || time < (this.times.at(-1)?.time ?? 0)) this.times = [];
    this.times.push({ time, feet });
    while (this.times[0].time < time - SHOWN) this.times.shift();
    const i = Number(this.foot.value) || 0;
    if (this.plotKey !== `${names} ${i}`) {
      this.plotKey = `${names} ${i}`;
      const series = [
        { label: "planned", colour: COLOURS[2], dash: [5, 4] },
        { label: "measured", colour: COLOURS[1], width: 2 },
      ];
      this.plot.rebuild(series);
      fill(
        this.legend,
        series.map(({ label, colour }) =>
          h("span", {}, h("i", { style: { background: colour } }), label),
        ),
      );
    }
    const z = (force) => (Array.isArray(force) ? force[2] : (force ?? null));
    this.plot.set([
      this.times.map((each) => each.time),
      this.times.map((each) => z(each.feet[i]?.planned)),
      this.times.map((each) => z(each.feet[i]?.force)),
    ]);
  }
}
