// SPDX-License-Identifier: Apache-2.0
// The search: its buttons, F and its terms over the iterations, what the last one changed.
import { fill, h, icon, setText } from "../dom.js";
import { duration, format, significant, words } from "../units.js";
import { COLOURS, Plot } from "./plots.js";

const MOST_TERMS = 5;

/** Optimise, Pause, Continue, Step, Stop: the same in both workspaces. */
export class SearchButtons {
  constructor(studio) {
    this.studio = studio;
    this.main = h("button.primary", { type: "button", onClick: () => this.toggle() });
    this.step = h(
      "button",
      { type: "button", title: "One design iteration", onClick: () => studio.command("step") },
      icon("step"),
      "Step",
    );
    this.stop = h(
      "button",
      {
        type: "button",
        title: "End the search, or what goes on in the background; the design stays as it is",
        onClick: () => studio.stopAll(),
      },
      icon("stop"),
      "Stop",
    );
    this.element = h(
      "div.search-buttons",
      { role: "group", aria: { label: "Search" } },
      this.main,
      this.step,
      this.stop,
    );
    studio.store.on(["state", "paused", "job", "judge"], () => this.update());
  }

  toggle() {
    if (this.searching) this.studio.pauseSearch();
    else this.studio.startSearch();
  }

  update() {
    const state = this.studio.store.get("state");
    const paused = this.studio.store.get("paused");
    this.searching = state?.phase === "searching";
    const label = this.searching ? "Pause" : paused ? "Continue" : "Optimise";
    if (label !== this.label) {
      this.label = label;
      fill(this.main, icon(this.searching ? "pause" : "play"), label);
    }
    this.step.disabled = this.searching;
    this.stop.disabled = !Object.values(this.studio.atWork()).some(Boolean);
  }
}

export class SearchPanel {
  constructor(studio) {
    this.studio = studio;
    this.status = h("p.status", { role: "status" });
    this.plot = new Plot({
      label: "Cost F and its largest terms over the iterations",
      series: [],
      x: "iteration",
      log: true,
    });
    this.legend = h("div.legend");
    this.changed = h("table.differences");
    this.changedTitle = h("h3", { hidden: true }, "The last iteration changed");
    this.element = h(
      "section.panel",
      { aria: { label: "Search" } },
      h("h2", {}, "Search"),
      this.status,
      this.plot.element,
      this.legend,
      this.changedTitle,
      this.changed,
    );
    this.points = [];
    studio.store.on("state", (state) => this.update(state));
    studio.store.on("point", (point) => this.add(point));
    studio.store.on("searchCleared", () => this.clear());
  }

  clear() {
    this.points = [];
    fill(this.changed);
  }

  update(state) {
    const left = Number.isFinite(state.seconds_left)
      ? `, about ${duration(state.seconds_left)} left`
      : "";
    const doing = {
      searching: `Searching: iteration ${state.iterations}${left}`,
      solving: "Solving for the motion",
      "working out": "Working out other designs",
      idle: state.settled ? "At rest" : "The motion is predicted, not solved",
    }[state.phase];
    setText(this.status, `${doing} · cost F ${significant(state.F)}`);
  }

  add(point) {
    this.points.push(point);
    if (this.points.length > 4000) this.points.splice(0, 1000);
    if (this.timer) return;
    this.timer = setTimeout(() => {
      this.timer = 0;
      this.draw();
    }, 200);
  }

  /** The terms that are largest now get a curve each. */
  draw() {
    const last = this.points.at(-1);
    if (!last) return;
    const top = [...(last.terms ?? [])].sort((a, b) => b.value - a.value).slice(0, MOST_TERMS);
    const names = top.map((term) => term.name);
    const series = [
      { label: "cost F", colour: COLOURS[0], width: 2.25 },
      ...top.map((term, i) => ({
        label: term.words ?? term.name,
        colour: COLOURS[i + 1],
        width: 1.25,
      })),
    ];
    const key = names.join();
    if (key !== this.key) {
      this.key = key;
      this.plot.rebuild(series);
      fill(
        this.legend,
        series.map(({ label, colour }) =>
          h("span", {}, h("i", { style: { background: colour } }), label),
        ),
      );
    }
    const positive = (value) => (value > 1e-12 ? value : null); // the axis is logarithmic
    this.plot.set([
      this.points.map((_, i) => i + 1),
      this.points.map((point) => positive(point.F)),
      ...names.map((name) =>
        this.points.map((point) =>
          positive(point.terms?.find((term) => term.name === name)?.value),
        ),
      ),
    ]);
    this.showChanges(last);
  }

  showChanges(point) {
    const { parameters: all } = this.studio.store.get("document") ?? { parameters: [] };
    const parameters = new Map(all.map((p) => [p.name, p]));
    const size = ({ name, from, to }) => Math.abs(to - from) / (parameters.get(name)?.scale || 1);
    const rows = [...(point.changed ?? [])].sort((a, b) => size(b) - size(a)).slice(0, 6);
    this.changedTitle.hidden = !rows.length;
    fill(
      this.changed,
      h(
        "tbody",
        {},
        rows.map(({ name, from, to }) => {
          const unit = parameters.get(name)?.unit ?? "";
          return h(
            "tr",
            {},
            h("th", { scope: "row" }, words(name)),
            h("td", {}, format(from, unit)),
            h("td", {}, "→ ", format(to, unit)),
          );
        }),
      ),
    );
  }
}
