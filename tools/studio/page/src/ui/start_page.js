// SPDX-License-Identifier: Apache-2.0
// The first page: examples as pictures, a path, what was open before, a robot of one's own by drop.
import { fill, h, setText } from "../dom.js";
import { StillPictures } from "../scene/still.js";
import { get, post } from "../session/api.js";
import { words } from "../units.js";
import { theme } from "./theme.js";

const FEW = 3; // sessions that were not saved, before the others are folded

/** All files of what was dropped, with folders gone through. @returns {Promise<File[]>} */
export async function droppedFiles(transfer) {
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.()).filter(Boolean);
  if (!entries.length) return [...transfer.files].map((file) => ({ file, path: file.name }));
  const found = [];
  const walk = async (entry, path) => {
    if (entry.isFile) {
      const file = await new Promise((resolve, reject) => entry.file(resolve, reject));
      found.push({ file, path: path + entry.name });
      return;
    }
    const reader = entry.createReader();
    for (;;) {
      const some = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
      if (!some.length) break;
      for (const each of some) await walk(each, `${path}${entry.name}/`);
    }
  };
  for (const entry of entries) await walk(entry, "");
  return found;
}

const base64 = (file) =>
  new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(reader.result.split(",")[1] ?? "");
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(file);
  });

/** Sends files of a robot to be opened. @param {{file: File, path: string}[]} files */
export async function openFiles(files) {
  const sent = [];
  for (const { file, path } of files) sent.push({ name: path, base64: await base64(file) });
  return post("/api/open", { files: sent });
}

/** Takes robots that are dropped onto an element. */
export function takeDrops(element, studio) {
  const mark = (on) => element.classList.toggle("dropping", on);
  element.addEventListener("dragover", (event) => {
    event.preventDefault();
    mark(true);
  });
  element.addEventListener("dragleave", (event) => event.relatedTarget || mark(false));
  element.addEventListener("drop", async (event) => {
    event.preventDefault();
    mark(false);
    const files = await droppedFiles(event.dataTransfer);
    if (files.length) studio.open(() => openFiles(files));
  });
}

/** Where something is from; of a robot that was dropped onto the page its file's name. */
const placeOf = (path) => {
  const dropped = /-dropped-\d+\/(.+)$/.exec(path ?? "");
  return dropped ? `dropped: ${dropped[1]}` : path;
};

export class StartPage {
  constructor(studio) {
    this.studio = studio;
    this.examples = h("div.examples");
    this.recent = h("ul.recent");
    this.assemblies = h("ul.recent");
    this.unsaved = h("div", { hidden: true });
    this.back = h("button", { type: "button", onClick: () => studio.showOpen() });
    this.path = h("input.wide", {
      type: "text",
      placeholder: "ROBOT.xml or .urdf, TASK.toml or a run's folder",
      aria: { label: "Path" },
      spellcheck: false,
    });
    this.element = h(
      "main.start",
      {},
      h("h1", {}, "Legwright Studio"),
      h(
        "p.lead",
        {},
        "Change the body and the gait of a legged robot together, and see what it does.",
      ),
      h(
        "div.start-columns",
        {},
        h("section", { aria: { label: "Examples" } }, h("h2", {}, "Examples"), this.examples),
        h(
          "section.start-side",
          {},
          this.back,
          h("h2", {}, "Your own robot"),
          this.ownRobot(),
          this.unsaved,
          h("h2", {}, "Of modules"),
          h(
            "p",
            {},
            h("button", { type: "button", onClick: () => this.openNew() }, "New robot…"),
          ),
          h("details", {}, h("summary", {}, "Examples of modules"), this.assemblies),
          h("h2", {}, "Open"),
          h(
            "form.open-path",
            { onSubmit: (event) => this.openPath(event) },
            this.path,
            h("button", { type: "submit" }, "Open"),
          ),
          h("h2", {}, "Recent"),
          this.recent,
        ),
      ),
    );
  }

  /** Where a robot is dropped, or chosen. */
  ownRobot() {
    const chooser = (how) => {
      const input = h("input", { type: "file", hidden: true, ...how });
      input.addEventListener("change", () => this.chosen(input));
      return input;
    };
    const [files, folder] = [chooser({ multiple: true }), chooser({ webkitdirectory: true })];
    return h(
      "div.drop",
      {},
      h("p", {}, "Drop an MJCF file here, with its meshes, or its folder."),
      h(
        "div.button-row",
        {},
        h("button", { type: "button", onClick: () => files.click() }, "Files…"),
        h("button", { type: "button", onClick: () => folder.click() }, "Folder…"),
      ),
      files,
      folder,
    );
  }

  /** The way back to what is open still, with all that was done there. */
  showBack() {
    const { store } = this.studio;
    const opened = store.get("opened");
    this.back.hidden = !opened?.kept && !opened?.proposes;
    const name = store.get("assembly")?.name ?? store.get("document")?.label ?? "the new robot";
    setText(this.back, `Back to ${name}`);
  }

  async load() {
    this.showBack();
    const found = await this.studio.act(() => get("/api/start"));
    if (!found) return;
    this.showExamples(found.examples ?? []);
    const made = (found.assemblies ?? []).map(({ path, name, words: about }) =>
      this.link(path, words(name), about),
    );
    fill(this.assemblies, made);
    const recent = (found.recent ?? []).map(({ path, words, opened }) =>
      this.link(path, words || path, [opened, placeOf(path)].filter(Boolean).join(", ")),
    );
    fill(this.recent, recent.length ? recent : h("li.empty", {}, "Nothing yet."));
    const unsaved = (found.unsaved ?? []).map(({ path, name, origin, begun }) =>
      this.link(path, name, [begun, placeOf(origin)].filter(Boolean).join(", ")),
    );
    this.unsaved.hidden = !unsaved.length;
    const [latest, older] = [unsaved.slice(0, FEW), unsaved.slice(FEW)];
    fill(
      this.unsaved,
      h("h2", {}, "Not saved"),
      h("ul.recent", {}, latest),
      older.length
        ? h("details", {}, h("summary", {}, `${older.length} older`), h("ul.recent", {}, older))
        : "",
    );
    if (found.roots?.length) this.path.title = `Below ${found.roots.join(", ")}`;
  }

  link(path, words, below) {
    const open = () => this.open(path);
    return h(
      "li",
      {},
      h("button.link", { type: "button", title: path, onClick: open }, words),
      h("span.path", { title: below }, below),
    );
  }

  /** A card for each robot, with its tasks. */
  showExamples(examples) {
    const robots = new Map();
    for (const example of examples) {
      const robot = example.name.split("/")[0];
      robots.set(robot, [...(robots.get(robot) ?? []), example]);
    }
    fill(
      this.examples,
      [...robots].map(([robot, tasks]) => this.card(robot, tasks)),
    );
    this.drawPictures();
  }

  card(robot, tasks) {
    const image = h("img", { alt: `The robot ${words(robot)}`, data: { example: tasks[0].name } });
    const open = ({ name }) => this.studio.open(() => post("/api/open", { example: name }));
    return h(
      "article.example",
      {},
      image,
      h("strong", {}, words(robot)),
      h(
        "ul",
        {},
        tasks.map((task) =>
          h(
            "li",
            {},
            h(
              "button.link",
              { type: "button", title: task.words ?? "", onClick: () => open(task) },
              words(task.name.split("/")[1] ?? task.name),
            ),
          ),
        ),
      ),
    );
  }

  /** One after the other, so that the page answers meanwhile. */
  async drawPictures() {
    const images = [...this.examples.querySelectorAll("img")];
    const { meshSource } = this.studio;
    const pictures = new StillPictures({ width: 300, height: 170, theme: theme(), meshSource });
    for (const image of images) {
      const name = encodeURIComponent(image.dataset.example);
      try {
        image.src = await pictures.draw(await get(`/api/example?name=${name}`));
      } catch {
        image.classList.add("no-picture");
      }
      if (this.element.hidden) break;
      await new Promise((resolve) => setTimeout(resolve));
    }
    pictures.dispose();
  }

  openNew() {
    this.studio.open(() => post("/api/open", { new_assembly: true }));
  }

  open(path) {
    this.studio.open(() => post("/api/open", { path }));
  }

  openPath(event) {
    event.preventDefault();
    if (this.path.value.trim()) this.open(this.path.value.trim());
  }

  chosen(input) {
    const files = [...input.files].map((file) => ({
      file,
      path: file.webkitRelativePath || file.name,
    }));
    input.value = "";
    if (files.length) this.studio.open(() => openFiles(files));
  }
}
