// SPDX-License-Identifier: Apache-2.0
// How far long work in the background is, as words and as a bar.
import { h, setText } from "../dom.js";
import { duration } from "../units.js";

const SEARCH = 0.3; // of the bar of `optimize`, for the search before anything is played
const HALF = 12; // designs that MuJoCo has played when the rest of the bar is half full

/** The part of the bar that is full, or null where nobody knows. */
export function shareOf({ what, words, done = 0, of = 0 }) {
  const share = of > 0 ? Math.min(1, done / of) : null;
  if (what !== "optimize") return share;
  if (words === "searching") return SEARCH * (share ?? 0);
  if (words === "roll-outs") return 1; // what was found is judged
  return done > 0 ? SEARCH + (1 - SEARCH) * (done / (done + HALF)) : 0;
}

/** "playing designs in MuJoCo, 7 so far". */
export function wordsOf({ what, words = "", done = 0, of = 0 }) {
  if (of > 0) return `${words}, ${done} of ${words === "searching" ? "about " : ""}${of}`;
  return done > 0 ? `${words}, ${done} so far` : words;
}

export class JobProgress {
  /** @param {{cancel?: () => void}} options a way to end it */
  constructor({ cancel } = {}) {
    this.words = h("span", { role: "status" });
    this.passed = h("span.passed", { aria: { hidden: "true" } });
    this.bar = h("progress", { max: 1, aria: { label: "Progress" } });
    this.element = h(
      "span.job-status",
      { hidden: true },
      this.words,
      this.passed,
      this.bar,
      cancel ? h("button.small", { type: "button", onClick: cancel }, "Cancel") : "",
    );
  }

  show(job) {
    const { running, what } = job;
    this.element.hidden = !running;
    clearInterval(this.clock);
    if (!running) return (this.begun = null);
    this.job = job;
    this.begun ??= performance.now();
    this.bar.title =
      what === "optimize" ? "How many designs will be played nobody knows: the bar slows down" : "";
    const share = shareOf(job);
    if (share === null) this.bar.removeAttribute("value");
    else this.bar.value = share;
    this.tell();
    this.clock = setInterval(() => this.tell(), 1000);
  }

  tell() {
    setText(this.words, wordsOf(this.job));
    setText(this.passed, duration((performance.now() - this.begun) / 1000));
  }
}
