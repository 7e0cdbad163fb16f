// SPDX-License-Identifier: Apache-2.0
// The picture as a film: what is drawn, as still pictures, put together at the end.
import { animatedWebp } from "./animated_webp.js";

const EVERY = 50; // ms between frames, 20 a second
const WIDEST = 960; // pixels
const MOST = 1200; // frames, a minute: what is longer ends by itself
const QUALITY = 0.8;

/** Whether this browser writes WebP. */
export const canFilm = () =>
  document.createElement("canvas").toDataURL("image/webp").startsWith("data:image/webp");

export class Film {
  /** @param {import("./stage.js").Stage} stage @param {() => void} full called once it is full */
  constructor(stage, full) {
    const { canvas } = stage;
    const scale = Math.min(1, WIDEST / canvas.width);
    this.copy = document.createElement("canvas");
    this.copy.width = Math.round(canvas.width * scale);
    this.copy.height = Math.round(canvas.height * scale);
    this.pen = this.copy.getContext("2d");
    this.frames = []; // {time, bytes: Promise<Uint8Array>}
    this.take = () => {
      const now = performance.now();
      if (now - (this.frames.at(-1)?.time ?? -Infinity) < EVERY - 5) return;
      this.frames.push({ time: now, bytes: this.grab(canvas) });
      if (this.frames.length === MOST) full();
    };
    stage.after.add(this.take);
    this.stage = stage;
    stage.touch();
  }

  /** What stands on the canvas just now, in the order of the calls. */
  async grab(canvas) {
    this.pen.drawImage(canvas, 0, 0, this.copy.width, this.copy.height);
    const blob = await new Promise((resolve) => this.copy.toBlob(resolve, "image/webp", QUALITY));
    return new Uint8Array(await blob.arrayBuffer());
  }

  /** Ends it. @returns {Promise<?Uint8Array>} an animated WebP; null where nothing was drawn */
  async end() {
    this.stage.after.delete(this.take);
    const end = performance.now();
    const { frames, copy } = this;
    if (!frames.length) return null;
    const told = [];
    for (const [i, { time, bytes }] of frames.entries())
      told.push({ bytes: await bytes, duration: (frames[i + 1]?.time ?? end) - time });
    return animatedWebp(copy.width, copy.height, told);
  }
}
