// SPDX-License-Identifier: Apache-2.0
// The cycles of a run in physics on the timeline: where they begin, and which of their footfalls
// are drawn. Of many cycles those of one: all of them would be stripes that nobody reads.
const MANY = 12; // cycles, beyond which their footfalls are not told apart
const NUMBERS = 8; // along the timeline, at most
const STEPS = [1, 2, 5, 10, 20, 50, 100, 200];

export class RunCycles {
  /**
   * @param {import("../scene/recording.js").Recording} recording
   * @param {number} period of the gait [s]
   */
  constructor(recording, period) {
    const { frames, begin, seconds, at } = recording;
    this.length = seconds > 0 ? period / seconds : 1; // shares of the run from here on
    this.count = 1 / this.length;
    this.many = this.count > MANY;
    const last = frames.at(-1);
    const start = last.time - (last.phase ?? 0) * period - begin; // of the last cycle
    this.first = ((start % period) + period) % period / (seconds || 1);
    this.number = Math.round((begin + this.first * seconds) / period); // of the one that begins then
    this.present = Math.floor(((at - begin) / (seconds || 1) - this.first) / this.length);
  }

  /** Where cycles begin, and how many were before, far enough apart to be read. */
  ticks() {
    const step = STEPS.find((each) => this.count / each <= NUMBERS) ?? STEPS.at(-1);
    const found = [];
    for (let k = 0, at = this.first; at < 1; at = this.first + ++k * this.length)
      if ((this.number + k) % step === 0 && this.number + k > 0)
        found.push({ at, number: this.number + k });
    return found;
  }

  /** Stances with the swings between them: a gap is a step that was missed. */
  joined(spans) {
    const out = [];
    for (const [from, to] of spans)
      if (out.length && from - out.at(-1)[1] < this.length) out.at(-1)[1] = to;
      else out.push([from, to]);
    return out;
  }

  /** Of many cycles the stances of the one at the playhead. */
  shown(spans) {
    if (!this.many) return spans;
    const from = this.first + this.present * this.length;
    return spans
      .map(([a, b]) => [Math.max(a, from), Math.min(b, from + this.length)])
      .filter(([a, b]) => b > a);
  }
}
