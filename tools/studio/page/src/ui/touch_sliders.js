// SPDX-License-Identifier: Apache-2.0
// A finger that goes sideways moves a slider; one that goes up or down scrolls past it, and the
// slider stays. Browsers set a slider as soon as it is touched.

const DECIDED = 6; // pixels of a finger's way after which it is one or the other

/** Makes all sliders below `root` so, also those that come later. */
export function takeTouches(root) {
  let touch = null; // a finger on a slider that may be about to scroll

  const give = (value) => {
    const { slider } = touch;
    touch = null;
    slider.value = value;
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  };
  root.addEventListener(
    "pointerdown",
    ({ target, pointerType, pointerId, clientX, clientY }) => {
      if (pointerType !== "touch" || !target.matches?.("input.slider")) return;
      const { value } = target;
      touch = { slider: target, id: pointerId, value, wanted: value, x: clientX, y: clientY };
    },
    true,
  );
  root.addEventListener(
    "input",
    (event) => {
      if (event.target !== touch?.slider) return;
      event.stopPropagation();
      touch.wanted = touch.slider.value;
      touch.slider.value = touch.value;
    },
    true,
  );
  root.addEventListener("pointermove", ({ pointerId, clientX, clientY }) => {
    if (pointerId !== touch?.id) return;
    const [along, across] = [Math.abs(clientX - touch.x), Math.abs(clientY - touch.y)];
    if (along > DECIDED && along > across) give(touch.wanted);
  });
  root.addEventListener("pointercancel", ({ pointerId }) => {
    if (pointerId !== touch?.id) return;
    touch.slider.value = touch.value;
    touch = null;
  });
  root.addEventListener("pointerup", ({ pointerId }) => {
    if (pointerId !== touch?.id) return;
    const { slider, value, wanted } = touch;
    if (wanted === value) return (touch = null);
    give(wanted); // a tap
    slider.dispatchEvent(new Event("change", { bubbles: true }));
  });
}
