// SPDX-License-Identifier: Apache-2.0
// Fingers hover over nothing: a finger that rests on something shows the words that a pointer would
// see there, and then presses nothing. On what is no button a tap shows them, too.
import { h, setText } from "../dom.js";

const RESTS = 450; // ms
const STILL = 8; // pixels within which a finger rests
const SHOWN = 6000; // ms
const ACTS = "button, input, select, textarea, a, summary, label, canvas, [tabindex]";
const GAP = 12; // pixels from the finger's target

/** Makes all titles below `root` so, also those that come later. */
export function takeHeldTitles(root) {
  const bubble = h("div.held-title", { role: "tooltip", hidden: true });
  let touch = null; // a finger on something that has words
  let asked = false; // the press that goes on was for the words

  const hide = () => {
    clearTimeout(touch?.timer);
    touch = null;
  };
  const show = (element) => {
    setText(bubble, element.title);
    (element.closest("dialog") ?? root.body).append(bubble);
    bubble.hidden = false;
    const { left, top, bottom } = element.getBoundingClientRect();
    const x = Math.min(Math.max(8, left), innerWidth - bubble.offsetWidth - 8);
    const above = top - bubble.offsetHeight - GAP;
    const y = above > 8 ? above : bottom + GAP;
    bubble.style.transform = `translate(${x.toFixed(0)}px, ${y.toFixed(0)}px)`;
    clearTimeout(bubble.timer);
    bubble.timer = setTimeout(() => (bubble.hidden = true), SHOWN);
  };
  root.addEventListener(
    "pointerdown",
    ({ target, pointerType, pointerId, clientX, clientY }) => {
      hide();
      bubble.hidden = true;
      asked = false;
      const element = pointerType === "touch" && target.closest?.("[title]:not([title=''])");
      if (!element || target.matches("input[type=range]")) return;
      const rested = () => {
        asked = true;
        show(element);
      };
      const timer = setTimeout(rested, RESTS);
      touch = { element, target, id: pointerId, x: clientX, y: clientY, timer };
    },
    true,
  );
  root.addEventListener(
    "pointermove",
    ({ pointerId, clientX, clientY }) => {
      if (pointerId !== touch?.id) return;
      if (Math.hypot(clientX - touch.x, clientY - touch.y) > STILL) hide();
    },
    true,
  );
  root.addEventListener("pointercancel", hide, true);
  root.addEventListener(
    "pointerup",
    ({ pointerId }) => {
      if (pointerId !== touch?.id) return;
      if (!asked && !touch.target.closest(ACTS)) show(touch.element);
      hide();
    },
    true,
  );
  root.addEventListener(
    "click",
    (event) => {
      if (!asked || event.detail === 0) return; // a key presses, or the page itself
      asked = false;
      event.preventDefault();
      event.stopPropagation();
    },
    true,
  );
  root.addEventListener("contextmenu", (event) => asked && event.preventDefault());
}
