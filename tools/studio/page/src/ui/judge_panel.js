// SPDX-License-Identifier: Apache-2.0
// The judge: roll-outs in the background with progress, and the verdict's lines, each with a way to
// the moment it speaks of.
import { fill, h, setText } from "../dom.js";
import { post, remove } from "../session/api.js";
import { JobProgress } from "./job_progress.js";

/** The verdict of each task without its reasons, which the lines below tell. */
const headline = (words) =>
  words
    .split("\n")
    .map((line) => (line.startsWith("FAIL") ? line.split(":")[0] : line))
    .join("\n");

const ADVICE =
  "What helps as a rule: optimise from here, then “Find one that passes…”; or ask for less: a " +
  "lower speed, another gait, stronger servos.";

export class JudgePanel {
  constructor(studio) {
    this.studio = studio;
    this.start = h("button.primary", { type: "button", onClick: () => this.begin() }, "Judge");
    this.cancel = h(
      "button",
      { type: "button", hidden: true, onClick: () => studio.act(() => remove("/api/judge")) },
      "Cancel",
    );
    this.find = h(
      "button",
      {
        type: "button",
        title: "Searches on from this body: of many designs the best that MuJoCo passes (optimize)",
        onClick: () => studio.optimize(),
      },
      "Find one that passes…",
    );
    this.found = h("button", { type: "button", onClick: () => this.openFound() });
    this.exportFound = h(
      "button",
      {
        type: "button",
        title: "The body and the gait that MuJoCo passed, as that run hands them back",
        onClick: () => studio.exportRobot(this.path),
      },
      "Export the one that passes…",
    );
    this.ofFound = h("div.button-row", { hidden: true }, this.found, this.exportFound);
    this.progress = h("progress", {
      max: 1,
      value: 0,
      hidden: true,
      aria: { label: "Progress of the judge" },
    });
    this.finding = new JobProgress({ cancel: () => studio.act(() => remove("/api/job")) });
    this.title = h("h2", {}, "Verdict");
    this.verdict = h("p.verdict", { role: "status" });
    this.advice = h("p.hint", { hidden: true }, ADVICE);
    this.lines = h("ul.verdict-lines");
    this.kept = h("ul.verdict-lines");
    this.keptTitle = h("summary");
    this.folded = h("details", { hidden: true }, this.keptTitle, this.kept);
    this.element = h(
      "section.panel",
      { aria: { label: "Judge" } },
      this.title,
      h("p.hint", {}, "Plays the gait in MuJoCo at half, default and double gains."),
      h("div.button-row", {}, this.start, this.cancel, this.find, this.progress),
      this.finding.element,
      this.verdict,
      this.advice,
      this.ofFound,
      this.lines,
      this.folded,
    );
    studio.store.on("judge", (judge) => this.update(judge));
    studio.store.on(["state", "document"], () => this.markOld());
    studio.store.on("forgotten", () => this.forget());
    studio.store.on("job", (job) => this.showFound(job));
  }

  async begin() {
    this.asked = true;
    await this.studio.answered();
    await this.studio.act(() => post("/api/judge", {}));
  }

  update({ running, words, done = 0, of = 0, lines = [], verdict, failed, judged }) {
    this.start.disabled = Boolean(running);
    this.cancel.hidden = this.progress.hidden = !running;
    if (of > 0) this.progress.value = done / of;
    else this.progress.removeAttribute("value");
    const doing = `${words ?? "playing"}${of > 0 ? `, ${done} of ${of}` : ""} …`;
    setText(this.verdict, running ? doing : verdict ? headline(verdict.words) : (failed ?? ""));
    const sign = verdict?.word === "PASS" ? "good" : "bad";
    this.verdict.className = `verdict ${running || !verdict ? "" : sign}`;
    this.judged = verdict ? judged : undefined;
    this.passes = verdict?.word === "PASS";
    this.advice.hidden = !verdict || this.passes;
    this.markOld();
    this.showLines(lines);
    if (this.asked && (running || verdict)) this.verdict.scrollIntoView({ block: "nearest" });
    if (!running) this.asked = false;
  }

  /** Limits that are missed; folded are those that are kept, or of which a fall left nothing. */
  showLines(lines) {
    const kept = lines.filter(({ passed }) => passed);
    const missed = lines.filter(({ passed, numbers }) => !passed && numbers?.value !== null);
    const unmeasured = lines.filter((line) => !kept.includes(line) && !missed.includes(line));
    const [shown, rest] = missed.length ? [missed, [...kept, ...unmeasured]] : [unmeasured, kept];
    for (const [list, some] of [[this.lines, shown], [this.kept, rest]])
      fill(list, some.map((line) => this.line(line)));
    this.folded.hidden = !rest.length;
    const told = [
      kept.length && `${kept.length} ${kept.length === 1 ? "limit is" : "limits are"} kept`,
      missed.length && unmeasured.length && `${unmeasured.length} could not be measured`,
    ];
    setText(this.keptTitle, told.filter(Boolean).join(", "));
  }

  forget() {
    this.update({});
    this.ofFound.hidden = true;
  }

  /** What a search with MuJoCo's verdicts has written can be opened. */
  showFound(job) {
    const { what, running, path, passes } = job;
    const isSearch = what === "optimize";
    this.find.disabled = isSearch && Boolean(running);
    this.finding.show(isSearch ? job : {});
    if (passes === undefined) return;
    this.path = path;
    this.ofFound.hidden = false;
    this.exportFound.hidden = !passes;
    setText(this.found, passes ? "Open the one that passes" : "Open the best, which fails");
  }

  openFound() {
    return this.studio.open(() => post("/api/open", { path: this.path }));
  }

  line({ words, term, passed, moment, numbers, marks }) {
    return h(
      `li.${passed ? "good" : "bad"}`,
      {},
      h("span.sign", { aria: { hidden: "true" } }, passed ? "✓" : "✗"),
      h("span", { title: term }, h("span.unseen", {}, passed ? "passed: " : "failed: "), words),
      moment
        ? h(
            "button.link",
            {
              type: "button",
              onClick: () => this.studio.showMoment(moment, numbers?.gains, marks),
            },
            moment.whole ? "Show the walk" : "Show me",
          )
        : null,
    );
  }

  /** Says so where body or task have changed since. */
  markOld() {
    const { judged } = this;
    const { store } = this.studio;
    const [s, text] = [store.get("state")?.s, store.get("document")?.task_text];
    const old = Boolean(
      judged && s && (judged.task_text !== text || judged.s.some((value, i) => value !== s[i])),
    );
    this.element.classList.toggle("old", old);
    setText(this.title, old ? "Verdict of an earlier design" : "Verdict");
    const known = Boolean(judged) && !old;
    store.set("refused", known && !this.passes);
    store.set("passed", known && this.passes);
  }
}
