// SPDX-License-Identifier: Apache-2.0
// A footfall diagram whose cells are set by clicking and dragging: a row for each foot, a column
// for each knot of the cycle. A foot stands once in a cycle, so a row is one run of cells, which
// may go over the seam.
import { fill, h } from "../dom.js";

/** The longest run of 1 on a ring: [first cell, count]. */
export function ringRun(cells) {
  const n = cells.length;
  if (cells.every(Boolean)) return [0, n];
  let best = [0, 0];
  for (let i = 0; i < n; i++) {
    if (!cells[i] || cells[(i + n - 1) % n]) continue;
    let count = 0;
    while (count < n && cells[(i + count) % n]) count++;
    if (count > best[1]) best = [i, count];
  }
  return best;
}

/** Cells of a run on a ring of n. */
export function cellsOf(first, count, n) {
  return Array.from({ length: n }, (_, i) => ((i - first + n) % n < count ? 1 : 0));
}

export class Footfalls {
  /** @param {(rows: {foot: string, first: number, count: number, cells: number[]}[]) => void} changed */
  constructor(changed) {
    this.changed = changed;
    this.element = h("div.footfall-grid", { role: "group", aria: { label: "Footfalls" } });
    this.head = h("div.footfall-head");
    this.element.addEventListener("pointerdown", (event) => this.down(event));
    this.element.addEventListener("pointermove", (event) => this.move(event));
    this.element.addEventListener("pointerup", () => this.up());
    this.element.addEventListener("pointercancel", () => this.build(this.given));
    this.element.addEventListener("keydown", (event) => this.key(event));
  }

  /** @param {{foot: string, cells: number[]}[]} rows */
  set(rows) {
    const key = JSON.stringify(rows);
    if (key === this.key_ || this.painting) return;
    this.key_ = key;
    this.build(rows);
  }

  build(rows) {
    this.given = rows;
    const focused = this.element.contains(document.activeElement)
      ? document.activeElement.dataset.row
      : null;
    this.painting = null;
    this.rows = rows.map(({ foot, cells }) => ({ foot, cells: [...cells] }));
    fill(
      this.element,
      this.rows.map(({ foot, cells }, r) =>
        h(
          "div.footfall-row",
          {
            role: "slider",
            tabIndex: 0,
            data: { row: r },
            aria: { label: `${foot} stands`, valuenow: 0 },
            title: "Arrow keys shift the stance, with shift they lengthen it",
          },
          h("span.foot", {}, foot),
          cells.map((on, c) => h(`span.cell${on ? ".on" : ""}`, { data: { row: r, cell: c } })),
        ),
      ),
    );
    this.rows.forEach((_, r) => this.describe(r));
    if (focused !== null) this.element.children[focused]?.focus();
  }

  describe(r) {
    const { cells } = this.rows[r];
    const [first, count] = ringRun(cells);
    const element = this.element.children[r];
    const n = cells.length;
    const text = `from ${Math.round((100 * first) / n)} % of the cycle for ${Math.round((100 * count) / n)} %`;
    element.setAttribute("aria-valuenow", first);
    element.setAttribute("aria-valuetext", text);
  }

  cellAt(event) {
    const cell = document.elementFromPoint(event.clientX, event.clientY)?.closest?.(".cell");
    return cell && this.element.contains(cell) ? cell : null;
  }

  down(event) {
    const cell = this.cellAt(event);
    if (!cell || event.button !== 0) return;
    event.preventDefault();
    this.element.setPointerCapture(event.pointerId);
    const r = Number(cell.dataset.row);
    this.element.children[r].focus();
    this.painting = { r, to: this.rows[r].cells[cell.dataset.cell] ? 0 : 1 };
    this.paint(Number(cell.dataset.cell));
  }

  move(event) {
    if (!this.painting) return;
    const row = this.element.children[this.painting.r];
    const box = row.lastChild.getBoundingClientRect();
    const start = row.children[1].getBoundingClientRect().left;
    const n = this.rows[this.painting.r].cells.length;
    const c = Math.floor(((event.clientX - start) / (box.right - start)) * n);
    if (c >= 0 && c < n) this.paint(c);
  }

  paint(c) {
    const { r, to } = this.painting;
    this.rows[r].cells[c] = to;
    this.element.children[r].children[c + 1].classList.toggle("on", Boolean(to));
  }

  up() {
    if (!this.painting) return;
    const { r } = this.painting;
    this.painting = null;
    this.keepRun(r);
  }

  /** One run remains of what was painted; an empty row is as it was. */
  keepRun(r) {
    const row = this.rows[r];
    const [first, count] = ringRun(row.cells);
    if (!count) return this.build(this.given);
    row.cells = cellsOf(first, count, row.cells.length);
    this.tell();
  }

  tell() {
    const told = this.rows.map(({ foot, cells }) => {
      const [first, count] = ringRun(cells);
      return { foot, cells, first, count };
    });
    this.build(this.rows);
    this.changed(told);
  }

  key(event) {
    const row = event.target.closest?.(".footfall-row");
    const move = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!row) return;
    const r = Number(row.dataset.row);
    if (move) {
      event.preventDefault();
      event.stopPropagation();
      const { cells } = this.rows[r];
      const n = cells.length;
      let [first, count] = ringRun(cells);
      if (event.shiftKey) count = Math.min(n, Math.max(1, count + move));
      else first = (first + move + n) % n;
      this.rows[r].cells = cellsOf(first, count, n);
      this.tell();
    } else if (event.key === "ArrowDown" || event.key === "ArrowUp") {
      event.preventDefault();
      this.element.children[r + (event.key === "ArrowDown" ? 1 : -1)]?.focus();
    }
  }
}
