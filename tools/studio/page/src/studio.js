// SPDX-License-Identifier: Apache-2.0
// The page's own state and what can be done to it: all panels read from here and act through here.
import { Edits } from "./session/edits.js";
import { ApiError, command, get, meshSource, post, remove } from "./session/api.js";
import { follow } from "./session/events.js";
import { Latest } from "./session/latest.js";
import { SetByHand } from "./session/set_by_hand.js";
import { Store } from "./session/store.js";
import { ask, Notices } from "./ui/dialogs.js";
import { Selection } from "./ui/selection.js";

export class Studio {
  constructor() {
    this.store = new Store({ connected: false });
    this.selection = new Selection();
    this.notices = new Notices();
    this.motions = new Map(); // by task
    const fail = (error) => this.fail(error);
    this.edits = new Edits(fail, () => this.store.touch("state"));
    this.sender = new Latest(fail);
    this.beside = new Latest(fail);
    this.turn = Promise.resolve(); // done when the last command is answered
    this.meshSource = meshSource;
    this.hand = new SetByHand(this);
    this.store.on("task", () => this.showMotion());
  }

  /** @param {number=} heard as an event "opened" tells it: notices from then on are told */
  start(heard) {
    this.stopFollowing = follow(
      (kind, data) => this.take(kind, data),
      (connected, why) => {
        this.store.set("connected", connected);
        this.store.set("trouble", connected ? "" : why || "Connection lost, trying again …");
      },
      heard,
    );
  }

  /** Takes an event of the server. */
  take(kind, data) {
    const acts = {
      opened: () => this.opened(data),
      state: () => this.takeState(data),
      motion: () => {
        this.motions.set(data.task ?? 0, data);
        if ((data.task ?? 0) === (this.store.get("task") ?? 0)) this.store.set("motion", data);
      },
      alternatives: () => this.store.set(`alternatives ${data.what}`, data),
      notice: () => this.notices.show(data.level, data.words),
    };
    (acts[kind] ?? (() => this.store.set(kind, data)))();
  }

  takeState(state) {
    this.edits.settle(state.revision);
    this.store.set("state", state);
    if (state.document !== undefined && state.document !== this.known) {
      this.known = state.document;
      this.loadDocument();
    }
  }

  /** Something else is open: what the stream told before is of the old one, so it begins anew. */
  async opened(opened) {
    const session = `${opened.path} ${opened.kept}`;
    const other = this.session !== undefined && this.session !== session;
    this.session = session;
    if (other) {
      this.forget();
      this.stopFollowing();
      this.start(opened.heard);
      return;
    }
    this.store.set("opened", opened);
    const robot = opened.path || opened.of_modules;
    if (!opened.proposes && !opened.assembles && robot) await this.loadDocument();
  }

  forget() {
    this.known = undefined;
    this.motions.clear();
    this.store.values["alternatives fewest"] = this.store.values["alternatives front"] = null;
    const keys = ["opened", "state", "motion", "design", "document", "judge", "physics", "assembly"];
    for (const key of keys) this.store.values[key] = null;
    this.store.set("paused", false);
    this.store.set("task", 0);
    this.selection.hovered = null;
    this.selection.set([]);
    this.store.touch("forgotten");
    this.store.touch("searchCleared");
  }

  async loadDocument() {
    if (this.loading) return (this.again = true);
    this.loading = true;
    const { session } = this;
    try {
      const document = await get("/api/document");
      if (session !== this.session) return void (this.again = true); // of what was open before
      this.known ??= document.document; // no state has told it yet
      this.again &&= document.document !== this.known;
      if ((this.store.get("task") ?? 0) >= document.tasks.length) this.store.set("task", 0);
      this.store.set("document", document);
      this.showMotion();
    } catch (error) {
      error.message = `What is open cannot be worked on: ${error.message}. Open another (File).`;
      if (session === this.session) this.fail(error);
    } finally {
      this.loading = false;
      if (this.again) {
        this.again = false;
        this.loadDocument();
      }
    }
  }

  isOpen() {
    return Boolean(this.store.get("document"));
  }

  /** A name for files. */
  name() {
    const { label, name } = this.store.get("document") ?? {};
    return (label || name || "legwright").replaceAll(/\W+/g, "_");
  }

  showMotion() {
    const motion = this.motions.get(this.store.get("task") ?? 0);
    if (motion) this.store.set("motion", motion);
  }

  /** Index and what is known of a parameter, with what is under the user's hand. */
  readParameter(name) {
    const state = this.store.get("state");
    const document = this.store.get("document");
    const i = document?.parameters.findIndex((p) => p.name === name) ?? -1;
    // The state of a robot that is being opened comes before its document.
    const known = i >= 0 && i < (state?.s.length ?? 0);
    if (!known) return { value: 0, lower: 0, upper: 0, locked: true, gradient: null };
    const parameter = document.parameters[i];
    return {
      value: this.edits.value(name, state.s[i]),
      lower: state.lower?.[i] ?? parameter.robot_lower,
      upper: state.upper?.[i] ?? parameter.robot_upper,
      locked: Boolean(state.frozen?.[i]),
      gradient: state.gradient?.[i] ?? null,
    };
  }

  /**
   * Sets a parameter. A hand that takes hold of it and does not move changes nothing.
   * @param {"begin"|"drag"|"end"|"once"} phase
   */
  edit(name, value, phase) {
    this.store.set("held", { name, phase });
    const moves = this.phaseOnceMoved(name, value, phase);
    if (!moves) return;
    if (this.store.get("state")?.phase === "searching") this.store.set("paused", true);
    this.hand.note(name);
    this.edits.set({ [name]: value }, moves);
  }

  /** The phase of an edit, which begins when the hand moves; null as long as it rests. */
  phaseOnceMoved(name, value, phase) {
    const from = { begin: this.readParameter(name).value, once: undefined };
    const rests = phase in from ? from[phase] : this.resting;
    const still = value === rests;
    this.resting = still && phase !== "end" ? value : undefined;
    if (still) return null;
    return phase === "drag" && rests !== undefined ? "begin" : phase;
  }

  lock(name, frozen) {
    return this.command("freeze", { names: [name], frozen });
  }

  /** Gives a parameter its given value again, and keeps it there. */
  async putBack(name, given) {
    await this.command("edit", { values: { [name]: given }, goes_on: false });
    await this.lock(name, true);
  }

  /** Works out other designs: "fewest" changes, or the "front" of the tasks. */
  workOut(what) {
    return this.command("work_out", { what });
  }

  /** Takes one of them in the place of what stands; `goes_on`: as one step with the one before. */
  choose(what, design, goes_on) {
    this.latest(`choose ${what}`, () => this.commandQuietly("choose", { what, design, goes_on }));
  }

  setBounds(name, lower, upper) {
    if (Number.isFinite(lower) && Number.isFinite(upper))
      this.command("bounds", { name, lower, upper });
  }

  /** Runs what may fail; a failure is told, and undefined comes back. */
  async act(run) {
    try {
      return await run();
    } catch (error) {
      this.fail(error);
      return undefined;
    }
  }

  fail(error) {
    if (error.name === "AbortError") return;
    if (!(error instanceof ApiError)) console.error(error);
    this.notices.show("error", error.message);
  }

  /** Waits until all that the hand asked for is answered: requests may overtake each other. */
  answered() {
    return Promise.all([this.turn, this.edits.sent(), this.sender.sent()]);
  }

  /** Runs what the hand asks for after all that it asked for before; see `act`. */
  inOrder(run) {
    const before = this.answered();
    this.turn = before.then(() => this.act(run));
    return this.turn;
  }

  command(name, fields) {
    const searches = name === "start" || name === "step";
    const ask = () => command(name, fields);
    return this.inOrder(searches ? () => this.hand.aroundSearch(ask) : ask);
  }

  /** For what is sent often: the caller keeps one on its way. */
  commandQuietly(name, fields) {
    return command(name, fields);
  }

  /** Sends what changes the robot or its tasks, the latest of each kind, one at a time. */
  latest(kind, make) {
    this.sender.send(kind, make);
  }

  /** As `latest`, for what no command has to wait for. */
  latestBeside(kind, make) {
    this.beside.send(kind, make);
  }

  setTask(task, changes) {
    this.latest("task", async () => {
      try {
        await post("/api/task", { task, changes });
      } catch (error) {
        this.store.touch("taskRefused");
        throw error;
      }
    });
  }

  showTask(index) {
    this.store.set("task", index);
  }

  startSearch() {
    if (!this.store.get("paused")) this.store.touch("searchCleared");
    this.store.set("paused", false);
    return this.command("start");
  }

  /** Ends what the server works at; unlike other commands it waits for nothing. */
  halt() {
    return this.act(() => command("pause"));
  }

  pauseSearch() {
    this.store.set("paused", true);
    return this.halt();
  }

  stopSearch() {
    this.store.set("paused", false);
    return this.halt();
  }

  /** What goes on, as Stop ends it: a search, other designs, the judge, long work. */
  atWork() {
    const { store } = this;
    const runs = (name) => Boolean(store.get(name)?.running);
    return {
      search: store.get("paused") || ["searching", "working out"].includes(store.get("state")?.phase),
      judge: runs("judge"),
      job: runs("job"),
    };
  }

  async stopAll() {
    const { search, judge, job } = this.atWork();
    if (search) await this.stopSearch();
    if (judge) await this.act(() => remove("/api/judge"));
    if (job) await this.act(() => remove("/api/job"));
  }

  /** Opens something else, with the page dimmed while the server reads it. */
  async open(request) {
    this.store.set("opening", true);
    await this.answered();
    await this.act(request);
    this.store.set("opening", false);
  }

  /** Asks for a folder, and proposes one where nothing is yet. */
  async toFolder(title, action, suggestion, request, words = "", more = {}) {
    const free = await this.act(() => get(`/api/free?path=${encodeURIComponent(suggestion)}`));
    const path = await ask(title, free?.path ?? suggestion, {
      label: "Folder",
      action,
      hint: `${words}The folder is below those that the studio was started with.`,
    });
    if (!path) return undefined;
    await this.answered();
    return this.act(() => post(request, { path, ...more }));
  }

  /** Done once it is answered; what goes on in the background tells its own end. */
  async save() {
    const name = `runs/${this.name()}`;
    const done = await this.toFolder("Save as a run", "Save", name, "/api/save");
    if (done) this.notices.show("done", `Saved: ${done.path}`);
  }

  /** `optimize` from the present body: what MuJoCo passes, as a run of its own. */
  optimize() {
    return this.toFolder(
      "Search with MuJoCo's verdicts",
      "Search",
      `runs/${this.name()}_found`,
      "/api/optimize",
      "Searches from this body within its bounds, with what is locked as it is, plays what it " +
        "finds in MuJoCo and writes the best as a run: half a minute as a rule, up to some " +
        "minutes. Then open that run. ",
    );
  }

  /** From a robot that was built of modules back to them. */
  backToModules() {
    return this.open(() => post("/api/assembly/bench"));
  }

  report() {
    return this.toFolder(
      "Write the report of a run",
      "Report",
      `runs/${this.name()}_report`,
      "/api/report",
      "Saves what stands as a run, plays it and writes its report. The run that it was saved as " +
        "can be named, too. ",
    );
  }

  /** @param {string=} run a run that is exported as it is, in the place of what stands */
  exportRobot(run) {
    const refused = !run && this.store.get("refused");
    return this.toFolder(
      "Export robot and gait",
      "Export",
      `exports/${this.name()}`,
      "/api/export",
      refused ? "MuJoCo fails what stands: see Simulate, Verdict. " : "",
      run ? { run } : {},
    );
  }

  /** Jumps to the worst moment of a fault. */
  showFault({ from, to }) {
    this.view.setPlaying(false);
    this.view.seekPhase(from <= to ? (from + to) / 2 : from);
  }

  /** Plays to a moment of the verdict, and marks on the robot what its line is about. */
  showMoment({ task, time }, gains, marks = []) {
    this.showTask(task ?? 0);
    this.showWorkspace("simulate");
    this.physics.playUntil(time, gains);
    this.view.pointAt(marks.map((mark) => this.partOf(mark)));
  }

  /** The body, or the foot, that a mark of the verdict is at. */
  partOf({ kind, name, words }) {
    const { joints = [] } = this.store.get("document") ?? {};
    const { bodies = [] } = this.store.get("design") ?? {};
    const at = {
      joint: () => joints.find((joint) => joint.name === name)?.body,
      body: () => bodies.findIndex((body) => body.name === name),
    };
    const body = at[kind]?.() ?? -1;
    const trunk = this.view.player?.root ?? 1;
    return { body: body > 0 ? body : trunk, where: kind === "foot" ? name : undefined, words };
  }
}
