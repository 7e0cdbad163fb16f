// SPDX-License-Identifier: Apache-2.0
// What the design costs now: F, what it consists of, the mass; and what is wrong, as words, each
// with a way to the moment at which it is worst.
import { fill, h, setText } from "../dom.js";
import { significant } from "../units.js";
import { atMost, calmly } from "./rate.js";

const MOST_TERMS = 9;
const COST =
  "F sums up how far body and gait are from what is asked of them: the less, the better. The " +
  "search makes it small.";

export class CostPanel {
  constructor(studio) {
    this.studio = studio;
    this.F = h("strong.figure");
    this.rest = h("span.figures");
    this.rows = Array.from({ length: MOST_TERMS }, () => new TermRow());
    this.terms = h(
      "table.terms",
      { aria: { label: "What the cost F consists of" } },
      h("tbody", {}, ...this.rows.map((row) => row.element)),
    );
    this.element = h(
      "section.panel",
      { aria: { label: "Cost" } },
      h("h2", { title: COST }, "Cost F"),
      h("p.headline", {}, this.F, this.rest),
      this.terms,
    );
    studio.store.on(
      "state",
      calmly((state) => this.update(state)),
    );
    studio.store.on("document", () => {
      this.told = null;
      const state = studio.store.get("state");
      if (state) this.update(state);
    });
  }

  update(state) {
    if (state === this.told) return; // a hand moved: what is told of it comes
    this.told = state;
    setText(this.F, significant(state.F));
    const parts = [
      state.settled ? "" : "predicted",
      state.J ? `goal of the body (J) ${significant(state.J)}` : "",
      this.massOf(state),
      ...(state.task_F?.length > 1
        ? state.task_F.map((F, i) => `${this.taskName(i)} ${significant(F, 3)}`)
        : []),
    ];
    setText(this.rest, parts.filter(Boolean).join(" · "));
    this.F.classList.toggle("pending", !state.settled);
    this.showTerms(state);
  }

  /** The mass, and that it stays where the robot's file tells the masses of its links. */
  massOf({ mass }) {
    if (!Number.isFinite(mass)) return "";
    const stays = this.studio.store.get("document")?.mass_changes === false;
    return `${mass.toFixed(3)} kg${stays ? ", as the file has it" : ""}`;
  }

  taskName(i) {
    return this.studio.store.get("document")?.tasks?.[i]?.name ?? `task ${i + 1}`;
  }

  showTerms(state) {
    const terms = [...(state.terms ?? [])].sort((a, b) => b.value - a.value);
    const most = terms[0]?.value || 1;
    this.rows.forEach((row, i) => {
      row.element.hidden = i >= terms.length;
      if (!row.element.hidden) row.show(terms[i], most);
    });
  }
}

/** A term of F; its elements stay, as all of them change while a hand moves the body. */
class TermRow {
  constructor() {
    this.label = h("th", { scope: "row" });
    this.bar = h("span.bar");
    this.value = h("td.value");
    this.element = h(
      "tr",
      { hidden: true },
      this.label,
      h("td.bar-cell", {}, this.bar),
      this.value,
    );
  }

  show({ name, words, value }, most) {
    setText(this.label, words ?? name);
    if (this.name !== name) this.element.title = `${words ?? name} (term ${name} of F)`;
    this.name = name;
    this.bar.style.width = `${Math.max(1, (100 * Math.max(0, value)) / most).toFixed(1)}%`;
    setText(this.value, significant(value, 3));
  }
}

export class FaultsPanel {
  constructor(studio) {
    this.studio = studio;
    this.list = h("ul.faults");
    this.title = h("h2", {}, "What is wrong");
    this.element = h("section.panel", { aria: { label: "What is wrong" } }, this.title, this.list);
    studio.store.on(
      "motion",
      atMost(200, (motion) => this.update(motion)),
    );
    studio.store.on(["refused", "passed"], () => {
      const motion = studio.store.get("motion");
      if (motion) this.update(motion);
    });
  }

  update(motion) {
    const faults = motion.faults ?? [];
    const { store } = this.studio;
    const [refused, passed] = ["refused", "passed"].map((name) => Boolean(store.get(name)));
    const key = JSON.stringify([refused, passed, faults.map(({ words, from }) => [words, from])]);
    if (key === this.key) return;
    this.key = key;
    setText(this.title, faults.length ? `What is wrong (${faults.length})` : "What is wrong");
    if (!faults.length)
      return fill(
        this.list,
        refused
          ? h("li", {}, "The plan keeps all limits, but MuJoCo fails it: see Simulate, Verdict.")
          : h(
              "li.good",
              {},
              passed
                ? "Nothing: the plan keeps all limits, and MuJoCo passes it."
                : "Nothing in the plan: it keeps all limits. MuJoCo is asked under Simulate, Judge.",
            ),
      );
    fill(
      this.list,
      passed
        ? h("li.good", {}, "MuJoCo passes it all the same: these are margins that the plan wants.")
        : null,
      faults.slice(0, 12).map((fault) => this.row(fault)),
      faults.length > 12 ? h("li.more", {}, `and ${faults.length - 12} more`) : null,
    );
  }

  row(fault) {
    const { words, where = "" } = fault;
    const at = words.lastIndexOf(": ");
    const [name, amount] = at < 0 ? [words, ""] : [words.slice(0, at), words.slice(at + 2)];
    return h(
      "li",
      { title: words },
      h("strong", {}, where),
      h("span.fault-name", {}, name.replace(`, ${where}`, "")),
      h("span.amount", {}, amount),
      h("button.link", { type: "button", onClick: () => this.studio.showFault(fault) }, "Show"),
    );
  }
}
