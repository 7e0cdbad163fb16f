// SPDX-License-Identifier: Apache-2.0
// What is typed into a field of a number takes the place of what stands there: the press that goes
// to the field selects its text, a second one puts the caret.

/** Makes all number fields below `root` so, also those that come later. */
export function takeNumbers(root) {
  let entered = null; // the field that a press has just gone to
  root.addEventListener("focusin", ({ target }) => {
    entered = target.matches?.('input[type="number"]') ? target : null;
  });
  root.addEventListener("click", ({ target }) => {
    if (target === entered) target.select();
    entered = null;
  });
}
