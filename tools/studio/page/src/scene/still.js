// SPDX-License-Identifier: Apache-2.0
// Pictures of robots that stand still, one after the other, by one renderer.
import { floatsOf } from "../decode.js";
import { SceneView } from "./scene_view.js";

export class StillPictures {
  /** @param {{width: number, height: number, theme: string, meshSource: Function}} options */
  constructor({ width, height, theme, meshSource }) {
    this.host = document.createElement("div");
    this.host.className = "still-host";
    Object.assign(this.host.style, { width: `${width}px`, height: `${height}px` });
    document.body.append(this.host);
    this.meshSource = meshSource;
    this.theme = theme;
  }

  /**
   * @param {import("../types.js").Design & {poses: string}} robot with the poses of its bodies
   * @returns {Promise<string>} data URL of a PNG
   */
  async draw(robot) {
    this.view ??= new SceneView(this.host, { meshSource: this.meshSource });
    const { view } = this;
    view.setTheme(this.theme);
    view.framed = false;
    view.setDesign(robot);
    await view.robot.complete();
    view.setLive({ poses: floatsOf(robot.poses), feet: [] });
    return view.stage.picture();
  }

  dispose() {
    this.view?.dispose();
    this.host.remove();
  }
}
