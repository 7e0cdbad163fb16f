// SPDX-License-Identifier: Apache-2.0
// What the robot shall do: gait and footfalls, velocity, and what it carries and walks on.
import { fill, h, setText } from "../dom.js";
import { significant, words } from "../units.js";
import { Footfalls } from "./footfalls.js";
import { Joystick } from "./joystick.js";
import { TradeOff } from "./trade_off.js";

/** Numbers of a task: where they stand in the task file, and how they are read from the document. */
const NUMBERS = [
  {
    key: "turn",
    label: "turn",
    unit: "rad/s",
    step: 0.05,
    write: (v) => ({ travel: { turn_rate: v } }),
  },
  {
    key: "period",
    label: "period",
    unit: "s",
    step: 0.05,
    min: 0.05,
    max: 20,
    write: (v) => ({ gait: { period: v } }),
  },
  {
    key: "payload",
    label: "payload",
    unit: "kg",
    step: 0.1,
    min: 0,
    write: (v) => ({ payload: v > 0 ? { mass: v } : null }),
  },
  {
    key: "slope",
    index: 0,
    label: "slope up",
    unit: "rad",
    step: 0.01,
    write: (v) => ({ ground: { slope_along: v } }),
  },
  {
    key: "slope",
    index: 1,
    label: "slope left",
    unit: "rad",
    step: 0.01,
    write: (v) => ({ ground: { slope_across: v } }),
  },
  {
    key: "step",
    label: "step over",
    unit: "m",
    step: 0.005,
    min: 0,
    write: (v) => ({ limits: { step_over: v > 0 ? v : null } }),
  },
  {
    key: "com_height",
    label: "COM height",
    unit: "m",
    step: 0.005,
    min: 0.001,
    expert: true,
    write: (v) => ({ style: { com_height: v } }),
  },
  {
    key: "swing_height",
    label: "swing height",
    unit: "m",
    step: 0.005,
    min: 0,
    expert: true,
    write: (v) => ({ limits: { swing_height: v } }),
  },
  {
    key: "friction",
    label: "friction planned",
    unit: "",
    step: 0.05,
    min: 0.01,
    expert: true,
    write: (v) => ({ limits: { friction: v } }),
  },
  {
    key: "floor_friction",
    label: "friction of floor",
    unit: "",
    step: 0.05,
    min: 0.01,
    expert: true,
    write: (v) => ({ limits: { floor_friction: v } }),
  },
  {
    key: "min_normal",
    label: "least foot force",
    unit: "",
    step: 0.01,
    min: 0,
    max: 0.5,
    expert: true,
    write: (v) => ({ limits: { min_normal: v } }),
  },
  {
    key: "torque_margin",
    label: "torque in hand",
    unit: "",
    step: 0.05,
    min: 0,
    expert: true,
    write: (v) => ({ limits: { torque_margin: v } }),
  },
  {
    key: "stance_width",
    label: "stance width",
    unit: "×",
    step: 0.05,
    min: 0.2,
    max: 5,
    expert: true,
    write: (v) => ({ style: { stance_width: v } }),
  },
  {
    key: "aim_speed",
    label: "planned speed",
    unit: "×",
    step: 0.01,
    min: 0.5,
    max: 2,
    expert: true,
    write: (v) => ({ travel: { aim_speed: v } }),
  },
  {
    key: "aim_turn_rate",
    label: "turn added",
    unit: "rad/s",
    step: 0.01,
    expert: true,
    write: (v) => ({ travel: { aim_turn_rate: v } }),
  },
];

export class TaskPanel {
  constructor(studio) {
    this.studio = studio;
    this.index = 0;
    this.tabs = h("div.tabs", { role: "tablist", aria: { label: "Tasks" } });
    this.tradeOff = new TradeOff(studio);
    this.gait = h("select.wide", { aria: { label: "Gait" }, onChange: () => this.chooseGait() });
    this.about = h("p.hint");
    this.footfalls = new Footfalls((rows) => this.setFootfalls(rows));
    this.joystick = new Joystick((velocity, done) => this.setVelocity(velocity, done));
    this.aim = h("p.hint", { hidden: true });
    this.forward = this.numberInput("forward [m/s]", 0.01, () => this.typedVelocity());
    this.left = this.numberInput("left [m/s]", 0.01, () => this.typedVelocity());
    this.fields = NUMBERS.map((field) => this.field(field));
    this.terms = h("div.term-weights");
    this.element = h("section.panel.task", { aria: { label: "Task" } }, this.layout());
    studio.store.on("document", (document) => this.update(document));
    studio.store.on("task", (index) => this.select(index));
    studio.store.on("taskRefused", () => this.restore());
  }

  layout() {
    const pick = (expert) => this.fields.filter((_, i) => Boolean(NUMBERS[i].expert) === expert);
    return [
      h("h2", {}, "Task"),
      this.tabs,
      this.tradeOff.element,
      h("div.behaviours", { role: "group", aria: { label: "Behaviours" } }, this.behaviours()),
      h("h3", {}, "Velocity"),
      h(
        "div.velocity",
        {},
        this.joystick.element,
        h(
          "div.fields",
          {},
          h("label.field", {}, "forward", this.forward, h("span.unit", {}, "m/s")),
          h("label.field", {}, "left", this.left, h("span.unit", {}, "m/s")),
          this.fields[0],
        ),
      ),
      this.aim,
      h("h3", {}, "Gait"),
      this.gait,
      this.about,
      this.footfalls.element,
      h("div.fields.two", {}, pick(false).slice(1)),
      h(
        "details.expert",
        {},
        h("summary", {}, "Style, limits, weights"),
        h("div.fields.two", {}, pick(true)),
        h("h3", {}, "Weights of the terms of the cost F"),
        this.terms,
      ),
    ];
  }

  numberInput(label, step, act) {
    return h("input.number", { type: "number", step, aria: { label }, onChange: act });
  }

  field({ label, unit, step, min, max, write }) {
    const input = this.numberInput(unit ? `${label} [${unit}]` : label, step, () => {
      const value = input.valueAsNumber;
      if (Number.isFinite(value)) this.change(write(value));
    });
    if (min !== undefined) input.min = min;
    if (max !== undefined) input.max = max;
    return h("label.field", {}, label, input, h("span.unit", {}, unit));
  }

  behaviours() {
    const speed = () => Math.hypot(...this.task.velocity) || this.joystick.scale * 0.3;
    const behaviour = (label, act) => h("button.small", { type: "button", onClick: act }, label);
    const travel = (velocity, turn_rate = 0) => this.change({ travel: { velocity, turn_rate } });
    const factor = (f) =>
      travel(
        this.task.velocity.map((v) => round(v * f)),
        round(this.task.turn * f),
      );
    return [
      behaviour("Walk", () => travel([round(speed()), 0])),
      behaviour("Backwards", () => travel([-round(speed()), 0])),
      behaviour("Sideways", () => travel([0, round(speed())])),
      behaviour("Turn on the spot", () => travel([0, 0], 0.4)),
      behaviour("Faster", () => factor(1.25)),
      behaviour("Slower", () => factor(0.8)),
      behaviour("Carry", () => {
        const mass = this.studio.store.get("document").mass ?? 1;
        this.change({ payload: { mass: Math.max(0.05, Math.round(mass * 4) / 20) } });
      }),
    ];
  }

  get task() {
    return this.studio.store.get("document").tasks[this.index];
  }

  select(index) {
    this.index = index;
    const document = this.studio.store.get("document");
    if (document) this.update(document);
  }

  update({ tasks, gaits, terms, leg_length: leg }) {
    if (!tasks?.length) return;
    this.index = Math.min(this.index, tasks.length - 1);
    const { task } = this;
    fill(
      this.tabs,
      tasks.length < 2
        ? null
        : tasks.map((each, i) =>
            h(
              "button",
              {
                type: "button",
                role: "tab",
                aria: { selected: String(i === this.index) },
                onClick: () => this.studio.showTask(i),
              },
              each.name,
            ),
          ),
    );
    const top = Math.sqrt(9.81 * (leg ?? 0.3));
    this.joystick.setScale(nice(Math.max(0.3 * top, 1.3 * Math.hypot(...task.velocity))));
    if (!this.joystick.held) this.joystick.show(task.velocity);
    this.showGaits(gaits ?? [], task);
    this.footfalls.set(task.footfalls);
    showNumber(this.forward, task.velocity[0]);
    showNumber(this.left, task.velocity[1]);
    this.showAim(task);
    NUMBERS.forEach(({ key, index }, i) => {
      const value = index === undefined ? task[key] : task[key]?.[index];
      showNumber(
        this.fields[i].querySelector("input"),
        value ?? (key === "payload" || key === "step" ? 0 : null),
      );
    });
    this.showTerms(terms ?? [], task);
  }

  /** What the plan makes up for, as a search found it: the fields say what is wanted. */
  showAim({ aim_speed: speed = 1, aim_turn_rate: turn = 0 }) {
    this.aim.hidden = speed === 1 && turn === 0;
    const side = turn > 0 ? "left" : "right";
    const parts = [
      speed === 1 ? "" : `${significant(speed, 3)} times as fast as wanted`,
      turn ? `turning by ${significant(Math.abs(turn), 2)} rad/s more to the ${side}` : "",
    ];
    const how = parts.filter(Boolean).join(", ");
    setText(this.aim, `Planned ${how}, to make up for what MuJoCo does otherwise.`);
  }

  showGaits(gaits, task) {
    const own = task.gait_kind === "own";
    const names = gaits.map((gait) => gait.name);
    const key = names.join() + own + task.gait;
    if (key !== this.gaitKey) {
      this.gaitKey = key;
      fill(
        this.gait,
        own ? h("option", { value: "", selected: true }, `${task.gait} (own footfalls)`) : null,
        names.map((name) =>
          h("option", { value: name, selected: !own && name === task.gait }, words(name)),
        ),
      );
    }
    const about = gaits.find((gait) => gait.name === task.gait)?.words ?? "";
    setText(this.about, own ? "Footfalls of your own: click or drag cells." : about);
  }

  showTerms(terms, task) {
    const key = JSON.stringify(task.term_weights) + terms.length;
    if (key === this.termKey) return;
    this.termKey = key;
    fill(
      this.terms,
      terms.map(({ name, words: about, weight }) => {
        const input = this.numberInput(`Weight of ${words(name)}`, "any", () => {
          if (input.valueAsNumber >= 0) this.change({ weights: { [name]: input.valueAsNumber } });
        });
        input.value = task.term_weights?.[name] ?? weight;
        return h("label.field", { title: about }, words(name), input);
      }),
    );
  }

  /** Where the walk is another, nobody knows what MuJoCo does otherwise. */
  change(changes) {
    const { velocity, turn_rate: turn } = changes.travel ?? {};
    const faster = velocity?.some((value, i) => value !== this.task.velocity[i]);
    const turned = turn !== undefined && turn !== this.task.turn;
    const another = faster || turned || changes.gait || "ground" in changes || "payload" in changes;
    const aim = another ? { aim_speed: null, aim_turn_rate: null } : {};
    const travel = { ...changes.travel, ...aim };
    this.studio.setTask(this.index, Object.keys(travel).length ? { ...changes, travel } : changes);
  }

  chooseGait() {
    if (this.gait.value)
      this.change({ gait: { name: this.gait.value, touchdown: null, duty: null } });
  }

  setFootfalls(rows) {
    const n = rows[0].cells.length;
    const by = (value) => Object.fromEntries(rows.map((row) => [row.foot, value(row)]));
    const share = (count) => Math.round((count / n) * 1e6) / 1e6;
    const name = this.task.gait_kind === "own" ? this.task.gait : `my_${this.task.gait}`;
    this.change({
      gait: {
        name,
        touchdown: by(({ first }) => share(first)),
        duty: by(({ count }) => share(count)),
      },
    });
  }

  /** Shows again what holds, also in the field that somebody is in. */
  restore() {
    const field = this.element.contains(document.activeElement) ? document.activeElement : null;
    field?.blur();
    this.select(this.index);
    field?.focus();
  }

  typedVelocity() {
    const velocity = [this.forward.valueAsNumber, this.left.valueAsNumber];
    if (velocity.every(Number.isFinite)) this.change({ travel: { velocity } });
  }

  setVelocity(velocity, done) {
    showNumber(this.forward, velocity[0]);
    showNumber(this.left, velocity[1]);
    if (done) this.change({ travel: { velocity } });
  }
}

const round = (v) => Math.round(v * 1000) / 1000;

/** The next of 0.1, 0.2, 0.5, 1, 2, 5 … */
function nice(value) {
  const size = 10 ** Math.floor(Math.log10(value));
  return [1, 2, 5, 10].map((f) => f * size).find((v) => v >= value * 0.999);
}

function showNumber(input, value) {
  if (document.activeElement === input) return;
  const text = value === null || value === undefined ? "" : String(+Number(value).toFixed(4));
  if (input.value !== text) input.value = text;
}
