// SPDX-License-Identifier: Apache-2.0
// The table of what differs between two designs, each quantity in its unit.
import { h } from "../dom.js";
import { digitsOf, significant, signed, words } from "../units.js";

const SAME = 1e-7;

function row(label, a, b, change) {
  return h(
    "tr",
    {},
    h("th", { scope: "row", title: label }, label),
    h("td", {}, a),
    h("td", {}, b),
    h("td", {}, change),
  );
}

const fixed = (value, unit) => value.toFixed(digitsOf(unit));
const change = (a, b, unit) => signed(b - a, unit).replace(` ${unit}`, "");

function parameterRow({ name, unit, a, b }) {
  return row(`${words(name)} [${unit}]`, fixed(a, unit), fixed(b, unit), change(a, b, unit));
}

/**
 * @param {string} name of the design that the present one is compared with
 * @param {object} found /api/compare
 * @returns {(HTMLElement|null)[]}
 */
export function comparisonTable(name, { rows, tasks = [], F, mass, verdict }) {
  const changed = rows.filter(({ a, b }) => Math.abs(a - b) > SAME);
  const head = ["", name, "now", "change"].map((text) => h("th", { scope: "col" }, text));
  const costs = [{ name: "", ...F }, ...(tasks.length > 1 ? tasks : [])];
  const table = h(
    "table.differences.compared",
    {},
    h("caption", {}, `Differences from ${name}`),
    h("thead", {}, h("tr", {}, head)),
    h(
      "tbody",
      {},
      costs.map((one) =>
        row(
          one.name ? `cost F, ${one.name}` : "cost F",
          significant(one.a),
          significant(one.b),
          one.a === null ? "–" : signed(one.b - one.a),
        ),
      ),
      row("mass [kg]", fixed(mass.a, "kg"), fixed(mass.b, "kg"), change(mass.a, mass.b, "kg")),
      row("verdict", verdict.a ?? "not judged", verdict.b ?? "not judged", ""),
      changed.map(parameterRow),
    ),
  );
  return [table, changed.length ? null : h("p.empty", {}, "The bodies are the same.")];
}
