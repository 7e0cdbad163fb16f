// SPDX-License-Identifier: Apache-2.0
// A thread that sends edits, one at a time, the latest values in the place of those that wait: the
// page's own thread is busy with pictures half of the time. No more are sent than a screen shows.
//   in   {number, values, held, fresh}
//   out  {number, values, revision} or {number, values, refusal}; number is the latest that is sent
import { command } from "./session/api.js";

const EVERY = 15; // ms between edits: as a screen's pictures
const passed = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

let waiting = null;
let flying = false;

/** What is to be sent of two edits, of which none is sent yet. */
const merged = (before, edit) => ({
  ...edit,
  values: { ...before?.values, ...edit.values },
  fresh: before?.fresh || edit.fresh,
});

/** Also an answer that breaks off or cannot be read is one: the page waits for it. */
async function answerTo({ values, held, fresh }) {
  try {
    const { revision = 0 } = await command("edit", { values, goes_on: !fresh, held });
    return { revision };
  } catch ({ status = 0, where, message, line }) {
    return { refusal: { status, where, message, line } };
  }
}

async function sendWaiting() {
  const begun = performance.now();
  const edit = waiting;
  waiting = null;
  postMessage({ number: edit.number, values: edit.values, ...(await answerTo(edit)) });
  const early = EVERY - (performance.now() - begun);
  if (early > 1) await passed(early);
}

globalThis.onmessage = async ({ data }) => {
  waiting = merged(waiting, data);
  if (flying) return;
  flying = true;
  while (waiting) await sendWaiting();
  flying = false;
};
