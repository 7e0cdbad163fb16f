// SPDX-License-Identifier: Apache-2.0
// Curves, drawn five times a second at most.
import uPlot from "uplot";

const EVERY = 200; // ms
export const COLOURS = [
  "#2f7fd0",
  "#e8871e",
  "#1f8a70",
  "#b0408f",
  "#8a6d3b",
  "#5b6ee1",
  "#6b7785",
];

/** The value of a colour of the theme. */
const themed = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

export class Plot {
  /**
   * @param {object} what
   * @param {string} what.label for those who do not see it
   * @param {{label: string, colour: string, dash?: number[], width?: number}[]} what.series
   * @param {string} what.x label of the horizontal axis
   * @param {boolean} what.log whether the vertical axis is logarithmic
   */
  constructor({ label, series, x, log = false, height = 170, unit = "" }) {
    this.element = document.createElement("div");
    this.element.className = "plot";
    this.element.setAttribute("role", "img");
    this.element.setAttribute("aria-label", label);
    this.options = { series, x, log, height, unit };
    this.data = [[], ...series.map(() => [])];
    this.observer = new ResizeObserver(() => this.fit());
    this.observer.observe(this.element);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.rebuild());
  }

  axis(extra) {
    const { log } = this.options;
    const filter = (_, ticks) => ticks.map((v) => (log && extra.values && !isDecade(v) ? null : v));
    return {
      stroke: themed("--text-2"),
      grid: { stroke: themed("--line"), width: 1, filter },
      ticks: { stroke: themed("--line"), width: 1, size: 4, filter },
      font: "11px system-ui, sans-serif",
      ...extra,
    };
  }

  build() {
    const { series, x, log, height, unit } = this.options;
    this.plot = new uPlot(
      {
        width: this.element.clientWidth,
        height,
        padding: [8, 8, 0, 0],
        legend: { show: false },
        cursor: { drag: { x: false, y: false } },
        scales: { x: { time: false }, y: log ? { distr: 3, range: logRange } : { distr: 1 } },
        axes: [
          this.axis({
            size: 34,
            label: x,
            labelSize: 14,
            labelFont: "11px system-ui",
            gap: 2,
            labelGap: 0,
          }),
          this.axis({ size: 46, values: (_, ticks) => ticks.map((v) => axisText(v, unit)) }),
        ],
        series: [
          {},
          ...series.map(({ label, colour, dash, width }) => ({
            label,
            stroke: colour,
            dash,
            width: width ?? 1.5,
            points: { show: false },
          })),
        ],
      },
      this.data,
      this.element,
    );
  }

  /** @param {Array<Array<?number>>} data x, then each series */
  set(data) {
    this.data = data;
    if (this.timer) return;
    const wait = Math.max(0, EVERY - (performance.now() - (this.drawn ?? -EVERY)));
    this.timer = setTimeout(() => this.draw(), wait);
  }

  draw() {
    this.timer = 0;
    this.drawn = performance.now();
    if (!this.element.clientWidth) return;
    if (!this.plot) this.build();
    else this.plot.setData(this.data);
  }

  fit() {
    if (!this.element.clientWidth) return;
    if (this.plot)
      this.plot.setSize({ width: this.element.clientWidth, height: this.options.height });
    else if (this.data[0].length) this.draw();
  }

  /** Takes other series, or the colours of another theme. */
  rebuild(series = this.options.series) {
    this.options.series = series;
    if (!this.plot) return;
    this.plot.destroy();
    this.plot = null;
    this.fit();
  }
}

const isDecade = (value) => Math.abs(Math.log10(value) % 1) < 1e-6;

/** What the curves of a logarithmic axis need, four decades at most. */
function logRange(_, low, high) {
  if (!(high > 0)) return [0.1, 1];
  const least = Math.max(low, high * 1e-4);
  return [10 ** Math.floor(Math.log10(least)), 10 ** Math.ceil(Math.log10(high))];
}

function axisText(value, unit) {
  if (value === null) return "";
  const size = Math.abs(value);
  const text =
    size >= 1e4 || (size > 0 && size < 1e-3)
      ? value.toExponential(0)
      : String(+value.toPrecision(3));
  return unit ? `${text} ${unit}` : text;
}
