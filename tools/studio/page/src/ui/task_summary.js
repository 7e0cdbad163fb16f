// SPDX-License-Identifier: Apache-2.0
// What the robot is to do, beside the body that is to do it; it is changed under Simulate.
import { fill, h } from "../dom.js";

export class TaskSummary {
  constructor(studio) {
    this.words = h("span");
    const change = h(
      "button.link",
      { type: "button", onClick: () => studio.showWorkspace("simulate") },
      "Change…",
    );
    this.element = h(
      "section.panel.task-summary",
      { aria: { label: "What it is to do" } },
      h("h2", {}, "Task"),
      this.words,
      change,
    );
    studio.store.on("document", (document) => this.update(document));
  }

  update({ tasks = [] }) {
    fill(
      this.words,
      tasks.map((task) => h("span", {}, task.words)),
    );
  }
}
