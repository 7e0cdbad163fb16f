// SPDX-License-Identifier: Apache-2.0
// Light or dark: as the system has it, until the user switches.

const KEY = "legwright-theme";
const dark = matchMedia("(prefers-color-scheme: dark)");

const stored = () => {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null; // storage may be forbidden
  }
};

export const theme = () => stored() ?? (dark.matches ? "dark" : "light");

/** Calls `act` with the theme now and whenever it changes. */
export function followTheme(act) {
  const apply = () => {
    document.documentElement.dataset.theme = theme();
    act(theme());
  };
  dark.addEventListener("change", apply);
  addEventListener("legwright-theme", apply);
  apply();
}

export function switchTheme() {
  try {
    localStorage.setItem(KEY, theme() === "dark" ? "light" : "dark");
  } catch {
    return;
  }
  dispatchEvent(new Event("legwright-theme"));
}
