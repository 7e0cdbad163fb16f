// SPDX-License-Identifier: Apache-2.0
// What need not follow every event.

/** `act`, called with the latest arguments and at most once in so many milliseconds. */
export function atMost(ms, act) {
  let timer = 0;
  let last = -Infinity;
  let latest = [];
  return (...values) => {
    latest = values;
    if (timer) return;
    const wait = Math.max(0, ms - (performance.now() - last));
    const run = () => {
      timer = 0;
      last = performance.now();
      act(...latest);
    };
    if (wait === 0) run();
    else timer = setTimeout(run, wait);
  };
}

const CALM = 150; // ms: what is read, not watched

/** `act`, as often as a panel's numbers need to be drawn anew while something moves. */
export const calmly = (act) => atMost(CALM, act);
