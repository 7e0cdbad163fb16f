// SPDX-License-Identifier: Apache-2.0
// Elements without a framework. Styles are set through classes and the CSSOM, never as attributes:
// the page's policy allows no inline styles.

/**
 * An element.
 * @param {string} tag with classes: "button.primary"
 * @param {Object<string, any>} props `on…` are listeners, `data`/`aria` objects, `style` CSSOM
 * properties; what the element has as a property is set so, all else as an attribute
 * @param {...(Node|string|null|undefined|false|Array)} children
 */
export function h(tag, props = {}, ...children) {
  const [name, ...classes] = tag.split(".");
  const element = document.createElement(name);
  if (classes.length) element.className = classes.join(" ");
  for (const [key, value] of Object.entries(props)) setProperty(element, key, value);
  append(element, children);
  return element;
}

const SVG = "http://www.w3.org/2000/svg";

/** The same for SVG, where all are attributes but listeners. */
export function svg(tag, props = {}, ...children) {
  const [name, ...classes] = tag.split(".");
  const element = document.createElementNS(SVG, name);
  if (classes.length) element.setAttribute("class", classes.join(" "));
  for (const [key, value] of Object.entries(props)) {
    if (key.startsWith("on")) element.addEventListener(key.slice(2).toLowerCase(), value);
    else if (value !== null && value !== undefined) element.setAttribute(key, value);
  }
  append(element, children);
  return element;
}

function setProperty(element, key, value) {
  if (value === null || value === undefined) return;
  if (key.startsWith("on")) element.addEventListener(key.slice(2).toLowerCase(), value);
  else if (key === "data") Object.assign(element.dataset, value);
  else if (key === "style") Object.assign(element.style, value);
  else if (key === "aria")
    for (const [name, each] of Object.entries(value)) element.setAttribute(`aria-${name}`, each);
  else if (key in element && key !== "list") element[key] = value;
  else element.setAttribute(key, value);
}

function append(element, children) {
  for (const child of children.flat(Infinity))
    if (child !== null && child !== undefined && child !== false) element.append(child);
}

/** Replaces what an element holds. */
export function fill(element, ...children) {
  element.replaceChildren();
  append(element, children);
  return element;
}

/** Sets text only where it differs, so that nothing is laid out anew. */
export function setText(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

const ICONS = {
  play: "M5 3.2v9.6l8-4.8z",
  pause: "M4.5 3h2.6v10H4.5zM8.9 3h2.6v10H8.9z",
  stop: "M4 4h8v8H4z",
  step: "M3.5 3.2v9.6l6.5-4.8zM10.8 3.2h2v9.6h-2z",
  undo: "M6.5 3 2.5 6.5l4 3.5V7.8h2.7a2.2 2.2 0 0 1 0 4.4H6v1.6h3.2a3.8 3.8 0 0 0 0-7.6H6.5z",
  redo: "M9.5 3l4 3.5-4 3.5V7.8H6.8a2.2 2.2 0 0 0 0 4.4H10v1.6H6.8a3.8 3.8 0 0 1 0-7.6h2.7z",
  lock: "M5 7V5.5a3 3 0 0 1 6 0V7h.8v6H4.2V7zm1.5 0h3V5.5a1.5 1.5 0 0 0-3 0z",
  unlock: "M5 7V4.5a3 3 0 0 1 5.8-1l-1.4.5A1.5 1.5 0 0 0 6.5 4.5V7h5.3v6H4.2V7z",
  reset: "M8 3.2a4.8 4.8 0 1 1-4.7 5.7h1.6A3.3 3.3 0 1 0 8 4.7v2L4.5 4 8 1.3z",
  sun: "M8 5a3 3 0 1 0 0 6 3 3 0 0 0 0-6zM7.3 1h1.4v2.2H7.3zm0 11.8h1.4V15H7.3zM1 7.3h2.2v1.4H1zm11.8 0H15v1.4h-2.2zM3.6 2.6l1.5 1.5-1 1-1.5-1.5zm8.3 8.3 1.5 1.5-1 1-1.5-1.5zm1.5-7.3-1.5 1.5-1-1 1.5-1.5zM5.1 11.9l-1.5 1.5-1-1 1.5-1.5z",
  help: "M7.2 11.3h1.5v1.5H7.2zM8 3a2.8 2.8 0 0 0-2.9 2.8h1.5A1.4 1.4 0 1 1 8.7 7c-.9.6-1.5 1.2-1.5 2.3v.8h1.5v-.7c0-.5.3-.8 1-1.3A2.8 2.8 0 0 0 8 3z",
  record: "M8 3.5a4.5 4.5 0 1 0 0 9 4.5 4.5 0 0 0 0-9z",
  close: "m4.2 3.2 3.8 3.8 3.8-3.8 1 1L9 8l3.8 3.8-1 1L8 9l-3.8 3.8-1-1L7 8 3.2 4.2z",
};

/** A small picture for a button; its name is the button's. */
export function icon(name) {
  return svg(
    "svg.icon",
    { viewBox: "0 0 16 16", "aria-hidden": "true", focusable: "false" },
    svg("path", { d: ICONS[name] }),
  );
}

/** A button with a picture, and a name for those who do not see it. */
export function iconButton(name, label, act, props = {}) {
  return h(
    "button.icon-button",
    { type: "button", title: label, aria: { label }, onClick: act, ...props },
    icon(name),
  );
}
