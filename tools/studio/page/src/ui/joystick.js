// SPDX-License-Identifier: Apache-2.0
// A velocity as a point in a disc: forward is up, left is left.
import { h, svg } from "../dom.js";

const R = 52;

export class Joystick {
  /** @param {(velocity: [number, number], done: boolean) => void} changed [m/s] forward, left */
  constructor(changed) {
    this.changed = changed;
    this.velocity = [0, 0];
    this.scale = 0.5; // m/s at the rim
    this.knob = svg("circle.knob", { r: 8 });
    this.stick = svg("line.stick", { x1: 0, y1: 0 });
    this.rim = svg("text.rim", { x: 0, y: -R + 11, "text-anchor": "middle" });
    const drawing = svg(
      "svg",
      { viewBox: "-62 -62 124 124", "aria-hidden": "true" },
      svg("circle.disc", { r: R }),
      svg("circle.ring", { r: R / 2 }),
      svg("path.cross", { d: `M0-${R}V${R}M-${R} 0H${R}` }),
      this.rim,
      this.stick,
      this.knob,
    );
    this.element = h(
      "div.joystick",
      {
        role: "application",
        tabIndex: 0,
        aria: { label: "Velocity: arrow keys change it" },
        title: "Drag: forward is up. Arrow keys change the velocity.",
      },
      drawing,
    );
    this.drawing = drawing;
    this.element.addEventListener("pointerdown", (event) => {
      event.preventDefault();
      this.element.focus();
      this.element.setPointerCapture(event.pointerId);
      this.held = true;
      this.drag(event, false);
    });
    this.element.addEventListener("pointermove", (event) => this.held && this.drag(event, false));
    this.element.addEventListener("pointerup", (event) => {
      if (!this.held) return;
      this.held = false;
      this.drag(event, true);
    });
    this.element.addEventListener("keydown", (event) => this.key(event));
  }

  drag(event, done) {
    const box = this.drawing.getBoundingClientRect();
    let x = ((event.clientX - box.left) / box.width) * 124 - 62;
    let y = ((event.clientY - box.top) / box.height) * 124 - 62;
    const length = Math.hypot(x, y);
    if (length > R) [x, y] = [(x * R) / length, (y * R) / length];
    if (Math.abs(x) < 4) x = 0;
    if (Math.abs(y) < 4) y = 0;
    const round = (v) => Math.round((v / R) * this.scale * 200) / 200 + 0;
    this.tell([round(-y), round(-x)], done);
  }

  key(event) {
    const step = this.scale / 20;
    const move = { ArrowUp: [1, 0], ArrowDown: [-1, 0], ArrowLeft: [0, 1], ArrowRight: [0, -1] }[
      event.key
    ];
    if (!move) return;
    event.preventDefault();
    event.stopPropagation();
    const round = (v) => Math.round(v * 1000) / 1000;
    this.tell(
      [round(this.velocity[0] + move[0] * step), round(this.velocity[1] + move[1] * step)],
      true,
    );
  }

  tell(velocity, done) {
    this.show(velocity);
    this.changed(velocity, done);
  }

  /** @param {number} scale velocity at the rim [m/s] */
  setScale(scale) {
    this.scale = scale;
    this.rim.textContent = `${scale.toFixed(2)} m/s`;
    this.show(this.velocity);
  }

  show(velocity) {
    this.velocity = velocity;
    const size = Math.max(1, Math.hypot(...velocity) / this.scale);
    const [x, y] = [(-velocity[1] / this.scale / size) * R, (-velocity[0] / this.scale / size) * R];
    for (const [name, value] of [
      ["cx", x],
      ["cy", y],
    ])
      this.knob.setAttribute(name, value.toFixed(1));
    for (const [name, value] of [
      ["x2", x],
      ["y2", y],
    ])
      this.stick.setAttribute(name, value.toFixed(1));
  }
}
