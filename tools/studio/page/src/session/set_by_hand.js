// SPDX-License-Identifier: Apache-2.0
// Which values were set by hand since the last search, and what a search makes of them. A tab that
// is loaded anew still knows it.

const SAME = 1e-9;
const KEY = "legwright-set-by-hand";

const stored = () => {
  try {
    return sessionStorage.getItem(KEY);
  } catch {
    return null; // storage may be forbidden
  }
};

const store = (text) => {
  try {
    sessionStorage.setItem(KEY, text);
  } catch {
    // Then a tab that is loaded anew does not know it.
  }
};

export class SetByHand {
  /** @param {import("../studio.js").Studio} studio */
  constructor(studio) {
    this.studio = studio;
    this.begin();
    studio.store.on("state", (state) => this.follow(state));
    studio.store.on("opened", (opened) => opened && this.recall(`${opened.path} ${opened.kept}`));
    studio.store.on("forgotten", () => {
      this.session = undefined;
      this.begin();
    });
  }

  begin() {
    this.names = new Set(); // of parameters
    this.before = null; // their values when a search began, by name
    this.known = null; // the values since which hands count, by name
    this.searching = false;
  }

  /** What this tab was told of a session before it was loaded anew. */
  recall(session) {
    if (session === this.session) return;
    this.session = session;
    const { session: of, names, before, known } = JSON.parse(stored() ?? "{}");
    if (of !== session) return;
    this.names = new Set(names);
    this.before = before && new Map(before);
    this.known = known && new Map(known);
  }

  /** For `recall`: of the session that is open alone. */
  keepInTab() {
    if (!this.session) return;
    const { session, names, before, known } = this;
    const list = (map) => map && [...map];
    store(JSON.stringify({ session, names: [...names], before: list(before), known: list(known) }));
  }

  /** A hand has set a value. */
  note(name) {
    if (this.before) this.startAnew();
    if (this.names.has(name)) return;
    this.names.add(name);
    this.keepInTab();
  }

  /** A search begins: what was set by hand is remembered. */
  searchBegins() {
    if (this.before) return;
    this.before = new Map(this.free().map((name) => [name, this.value(name)]));
    this.keepInTab();
  }

  /** Asks for a search; the first state that comes of it may hold what it has changed already. */
  async aroundSearch(ask) {
    const known = this.before;
    this.searchBegins();
    const own = this.before;
    try {
      return await ask();
    } catch (error) {
      if (this.before === own) this.before = known; // else a hand has begun anew meanwhile
      this.keepInTab();
      throw error;
    }
  }

  /** What is here now is where hands begin. */
  startAnew() {
    this.names.clear();
    this.before = this.known = null;
    this.follow(this.studio.store.get("state"));
    this.keepInTab();
  }

  follow(state) {
    if (!state) return; // nothing is open
    const searching = state.phase === "searching";
    if (searching && !this.searching) this.searchBegins();
    this.searching = searching;
    const { parameters } = this.studio.store.get("document") ?? {};
    if (this.known || parameters?.length !== state.s.length) return;
    this.known = new Map(parameters.map(({ name }, i) => [name, state.s[i]]));
    this.keepInTab();
  }

  value(name) {
    return this.studio.readParameter(name).value;
  }

  /** What was set by hand, is not locked, and no undo has put back. */
  free() {
    return [...this.names].filter((name) => {
      const { value, locked } = this.studio.readParameter(name);
      return !locked && Math.abs(value - (this.known?.get(name) ?? value)) > SAME;
    });
  }

  /** What a search has changed of that. */
  changed() {
    if (!this.studio.store.get("document")) return []; // no value is known yet
    return [...(this.before ?? [])]
      .filter(([name, value]) => Math.abs(this.value(name) - value) > SAME)
      .map(([name]) => name);
  }

  /** Locks what was set; what a search has changed of it is put back first. */
  async keep() {
    const { studio } = this;
    const [changed, before] = [this.changed(), this.before];
    const names = changed.length ? changed : this.free();
    if (this.searching) await studio.stopSearch();
    if (changed.length) {
      const values = Object.fromEntries(changed.map((name) => [name, before.get(name)]));
      await studio.command("edit", { values, goes_on: false });
    }
    await studio.command("freeze", { names, frozen: true });
    this.startAnew();
  }
}
