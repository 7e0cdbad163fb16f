// SPDX-License-Identifier: Apache-2.0
// Questions and long texts over the page; menus; notices at its edge.
import { h } from "../dom.js";

/** Opens a dialog; escape and a click beside it close it. @returns {HTMLDialogElement} */
export function openDialog(title, ...children) {
  const dialog = h(
    "dialog",
    { aria: { label: title }, onClick: (event) => event.target === dialog && dialog.close() },
    h("h2", {}, title),
    children,
  );
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
  return dialog;
}

/**
 * Asks for a line of text.
 * @returns {Promise<?string>} null where it was not given
 */
export function ask(title, value = "", { label = "Name", action = "Keep", hint = "" } = {}) {
  return new Promise((resolve) => {
    const input = h("input.wide", { type: "text", value, required: true, aria: { label } });
    const form = h(
      "form",
      { method: "dialog", onSubmit: () => resolve(input.value.trim() || null) },
      h("label.field", {}, label, input),
      hint ? h("p.hint", {}, hint) : "",
      h(
        "div.actions",
        {},
        h("button", { type: "button", onClick: () => dialog.close() }, "Cancel"),
        h("button.primary", { type: "submit" }, action),
      ),
    );
    const dialog = openDialog(title, form);
    dialog.addEventListener("close", () => resolve(null));
    input.select();
  });
}

/**
 * A button that opens a menu: arrow keys go through it, escape closes it.
 * @param {{label: string, act: () => void, hint?: string}[]} items
 */
export function menuButton(label, items) {
  const list = h("div.menu", { role: "menu", hidden: true });
  const button = h(
    "button",
    {
      type: "button",
      aria: { haspopup: "menu", expanded: "false" },
      onClick: () => show(list.hidden),
    },
    label,
  );
  const show = (on) => {
    list.hidden = !on;
    button.setAttribute("aria-expanded", String(on));
    if (on) list.firstChild.focus();
  };
  for (const { label: name, act, hint } of items)
    list.append(
      h(
        "button",
        {
          type: "button",
          role: "menuitem",
          onClick: () => {
            show(false);
            button.focus();
            act();
          },
        },
        name,
        hint ? h("kbd", {}, hint) : "",
      ),
    );
  const element = h("div.menu-holder", {}, button, list);
  element.addEventListener("keydown", (event) => {
    if (list.hidden) return;
    const all = [...list.children];
    const i = all.indexOf(document.activeElement);
    const move = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (event.key === "Escape") {
      show(false);
      button.focus();
    } else if (move) all[(i + move + all.length) % all.length].focus();
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  document.addEventListener("pointerdown", (event) => {
    if (!list.hidden && !element.contains(event.target)) show(false);
  });
  return element;
}

/** Notices at the edge of the page: what was done, what could not be. */
export class Notices {
  constructor() {
    this.element = h("div.notices", { role: "status", aria: { live: "polite" } });
  }

  /** Takes away those of a level: what they said holds no longer. */
  clear(level) {
    for (const note of this.element.querySelectorAll(`.notice.${level}`)) note.remove();
  }

  /** @param {"info"|"done"|"warning"|"error"} level what is done stays until it is dismissed */
  show(level, words) {
    const close = () => note.remove();
    const same = [...this.element.children].find((each) => each.dataset.words === words);
    const times = 1 + Number(same?.dataset.times ?? 0);
    same?.remove();
    const note = h(
      `div.notice.${level}`,
      { role: level === "error" ? "alert" : "status", data: { words, times } },
      h("span", {}, times > 1 ? `${words} (${times} times)` : words),
      h("button.link", { type: "button", aria: { label: "Dismiss" }, onClick: close }, "Dismiss"),
    );
    while (this.element.children.length > 3)
      (this.element.querySelector(".notice:not(.done)") ?? this.element.firstChild).remove();
    this.element.append(note);
    if (level !== "done") setTimeout(close, level === "error" ? 12000 : 5000);
  }
}
