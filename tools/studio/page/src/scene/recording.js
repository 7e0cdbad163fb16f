// SPDX-License-Identifier: Apache-2.0
// What physics did, to be looked at again: poses and forces as they came, interpolated between, so
// that slow motion is smooth. A new start begins a new recording.
import { Quaternion } from "three";

const LONGEST = 120; // s of simulated time that are kept
const GAP = 1.0; // s between frames, beyond which they are not of one run

export class Recording {
  constructor() {
    this.a = new Quaternion();
    this.b = new Quaternion();
    this.clear();
  }

  clear() {
    this.frames = []; // {time, poses, feet, phase, up, fell}, by rising time
    this.shown = false; // whether it is what the picture shows
    this.at = 0;
  }

  get begin() {
    return this.frames[0]?.time ?? 0;
  }
  get end() {
    return this.frames.at(-1)?.time ?? 0;
  }
  get seconds() {
    return this.end - this.begin;
  }

  /** @param {{time: number, poses: Float32Array, feet: object[], phase: number}} frame */
  add(frame) {
    const { frames } = this;
    const last = frames.at(-1);
    if (last && (frame.time < last.time || frame.time > last.time + GAP)) this.clear();
    if (this.frames.at(-1)?.time === frame.time) this.frames.pop();
    this.frames.push(frame);
    while (this.seconds > LONGEST) this.frames.shift();
    this.at = frame.time;
  }

  /** The last frame that is not after a time. */
  index(time) {
    let [low, high] = [0, this.frames.length - 1];
    while (low < high) {
      const middle = Math.ceil((low + high) / 2);
      if (this.frames[middle].time <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** The time of a frame so many on or back from the present one. */
  neighbour(count) {
    const at = Math.min(this.frames.length - 1, Math.max(0, this.index(this.at) + count));
    return this.frames[at]?.time ?? 0;
  }

  /** The run at a time, as SceneView.setLive() takes it; null where nothing was recorded. */
  show(time) {
    if (!this.frames.length) return null;
    this.shown = true;
    this.at = Math.min(this.end, Math.max(this.begin, time));
    const k = this.index(this.at);
    const [from, to] = [this.frames[k], this.frames[k + 1] ?? this.frames[k]];
    const span = to.time - from.time;
    const share = span > 0 ? (this.at - from.time) / span : 0;
    return { ...from, time: this.at, poses: this.between(from.poses, to.poses, share) };
  }

  between(from, to, share) {
    if (share === 0 || from.length !== to.length) return from;
    const out = Float32Array.from(from);
    for (let o = 0; o < out.length; o += 7) {
      for (let k = 0; k < 3; k++) out[o + k] += share * (to[o + k] - from[o + k]);
      this.a.set(from[o + 4], from[o + 5], from[o + 6], from[o + 3]);
      this.b.set(to[o + 4], to[o + 5], to[o + 6], to[o + 3]);
      this.a.slerp(this.b, share);
      out.set([this.a.w, this.a.x, this.a.y, this.a.z], o + 3);
    }
    return out;
  }

  /** When each foot stood, as shares of the run: [[from, to], …] for each foot. */
  stances(least) {
    const { frames, begin, seconds } = this;
    const count = frames[0]?.feet.length ?? 0;
    return Array.from({ length: count }, (_, foot) => {
      const found = [];
      let from = null;
      frames.forEach(({ time, feet }, i) => {
        const stands = (feet[foot]?.force?.[2] ?? 0) > least;
        if (stands) from ??= time;
        if (from !== null && (!stands || i === frames.length - 1)) {
          found.push([(from - begin) / seconds, (time - begin) / seconds]);
          from = null;
        }
      });
      return found;
    });
  }
}
