// SPDX-License-Identifier: Apache-2.0
// How far a report or an export is, in the bar.
import { h, setText } from "../dom.js";

export class JobStatus {
  constructor(studio) {
    this.words = h("span");
    this.progress = h("progress", { max: 1, aria: { label: "Progress" } });
    this.element = h(
      "span.job-status",
      { role: "status", hidden: true },
      this.words,
      this.progress,
    );
    studio.store.on("job", (job) => this.update(job));
  }

  update({ running, words = "", done = 0, of = 0 }) {
    this.element.hidden = !running;
    setText(this.words, words);
    if (of > 0) this.progress.value = done / of;
    else this.progress.removeAttribute("value");
  }
}
