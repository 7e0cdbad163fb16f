// SPDX-License-Identifier: Apache-2.0
// Buttons at the edge of the picture: cameras, what is drawn besides the robot, recording.
import { h, icon } from "../dom.js";
import { canFilm, Film } from "../scene/film.js";

const VIEWS = [
  ["corner", "Corner"],
  ["side", "Side"],
  ["front", "Front"],
  ["top", "Top"],
];
const SHOWN = [
  ["forces", "Forces"],
  ["paths", "Paths"],
  ["faults", "Faults"],
  ["follow", "Follow"],
];

/** Buttons of the cameras. @param {import("../scene/scene_view.js").SceneView} view */
export const cameraButtons = (view) =>
  h(
    "div.segmented",
    { role: "group", aria: { label: "Camera" } },
    VIEWS.map(([name, label]) =>
      h("button", { type: "button", onClick: () => view.stage.view(name) }, label),
    ),
  );

/** Switches of what is drawn. */
export const shownSwitches = (view, names = SHOWN) =>
  h(
    "div.segmented",
    { role: "group", aria: { label: "Shown in the picture" } },
    names.map(([key, label]) => {
      const button = h(
        "button",
        { type: "button", aria: { pressed: String(view.show[key]) } },
        label,
      );
      button.addEventListener("click", () => {
        view.show[key] = !view.show[key];
        button.setAttribute("aria-pressed", String(view.show[key]));
        view.pose();
      });
      return button;
    }),
  );

/** Saves something under a name in the browser's own way. */
export function download(name, blob) {
  const url = URL.createObjectURL(blob);
  h("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

/** Records the picture as an animated WebP; pressed again it ends and saves it. */
export class RecordButton {
  constructor(studio) {
    this.studio = studio;
    this.element = h(
      "button",
      {
        type: "button",
        aria: { pressed: "false" },
        title: "Record the picture as an animated WebP, a minute at most",
        onClick: () => (this.film ? this.end() : this.begin()),
      },
      icon("record"),
      "Record",
    );
    if (canFilm()) return;
    this.element.disabled = true;
    this.element.title = "This browser writes no WebP, so it records no films";
  }

  begin() {
    this.film = new Film(this.studio.view.stage, () => this.end());
    this.element.setAttribute("aria-pressed", "true");
  }

  async end() {
    const { film } = this;
    this.film = null;
    this.element.setAttribute("aria-pressed", "false");
    const bytes = await this.studio.act(() => film.end());
    if (bytes) download(`${this.studio.name()}.webp`, new Blob([bytes], { type: "image/webp" }));
  }
}

/** Saves the picture as PNG. */
export const pictureButton = (studio) =>
  h(
    "button",
    {
      type: "button",
      title: "Save the picture as PNG",
      onClick: async () => {
        const bytes = Uint8Array.from(atob(studio.view.stage.picture().split(",")[1]), (c) =>
          c.charCodeAt(0),
        );
        download(`${studio.name()}.png`, new Blob([bytes], { type: "image/png" }));
      },
    },
    "Picture",
  );
