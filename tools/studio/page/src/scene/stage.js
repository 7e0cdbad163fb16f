// SPDX-License-Identifier: Apache-2.0
// What every picture needs: renderer, camera, lights, ground, orbiting. Pictures are drawn only
// when something has changed; where GL runs in software, thirty a second without antialias, and
// once more finely when the picture rests.
import {
  AmbientLight,
  Color,
  DirectionalLight,
  Fog,
  Group,
  HemisphereLight,
  PerspectiveCamera,
  Quaternion,
  Scene,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Ground } from "./ground.js";
import { lift } from "./paint.js";

const EVERY = 28; // ms between pictures in software: every other of a screen's
const SLOW = 42; // ms between pictures in software, on average of so many, from which on they
const SLOW_COUNT = 12; // are drawn with fewer pixels
const COARSE = 0.75; // pixels for one of the page, then
const HELD = 0.5; // the same while a hand moves the body: each step takes the server's time, too
const REST = 350; // ms without a change after which a picture is drawn finely
const PALETTE = {
  light: { sky: 0xe9ecf0, line: 0xb9c1ca, minor: 0xd5dae0, ambient: 1.15, lift: 0 },
  dark: { sky: 0x1a1e23, line: 0x3c4550, minor: 0x2a3038, ambient: 1.9, lift: 0.07 },
};

/** Whether GL runs on the processor, where every pixel counts. */
function runsInSoftware(gl) {
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : "";
  return /swiftshader|llvmpipe|software|softpipe|basic render/i.test(name);
}

/** A canvas with GL; tells whether GL runs in software. Throws an Error where there is no GL. */
function createRenderer() {
  const canvas = document.createElement("canvas");
  // Without antialias first: in software, where this one stays, another context costs the most.
  const context = canvas.getContext("webgl2", { stencil: true, antialias: false, alpha: false });
  if (!context) throw new Error("This browser shows no 3-D pictures: WebGL 2 is off or missing.");
  const software = runsInSoftware(context);
  if (software) return { renderer: new WebGLRenderer({ canvas, context }), software };
  context.getExtension("WEBGL_lose_context")?.loseContext();
  return { renderer: new WebGLRenderer({ antialias: true, stencil: true }), software };
}

/** The smallest rotation that takes a direction upright. */
const tiltOf = (up) => new Quaternion().setFromUnitVectors(up, new Vector3(0, 0, 1));

export class Stage {
  /** @param {HTMLElement} host is filled by the canvas */
  constructor(host) {
    this.host = host;
    const { renderer, software } = createRenderer();
    this.renderer = renderer;
    this.software = software;
    this.canvas = renderer.domElement;
    host.append(this.canvas);
    this.scene = new Scene();
    this.scene.fog = new Fog(0, 1, 2);
    this.scene.matrixWorldAutoUpdate = false; // draw() does
    this.tilted = new Group(); // the ground's frame, which is not level on a slope
    this.world = new Group(); // moves against the walk, so that the robot stays in the picture
    this.ground = new Ground();
    this.tilted.add(this.world, this.ground.mesh);
    this.scene.add(this.tilted);
    this.up = new Vector3(0, 0, 1); // against gravity, in that frame
    this.addLights();
    this.camera = new PerspectiveCamera(32, 1, 0.01, 200);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enableDamping = false;
    this.controls.maxPolarAngle = Math.PI * 0.495;
    this.controls.addEventListener("change", () => this.touch());
    this.controls.addEventListener("start", () => (this.turned = true));
    this.turned = false; // by hand
    this.before = []; // called before each picture
    this.after = new Set(); // called after each
    this.size = 0.5;
    this.drawnAt = -EVERY;
    this.pace = { count: 0, sum: 0 }; // of pictures one after the other
    this.coarse = false;
    this.held = false;
    this.drawn = 0;
    this.fine = false;
    this.dirty = true;
    this.touched = 0;
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(host);
    this.setTheme("light");
    this.resize();
    this.frame = requestAnimationFrame((now) => this.tick(now));
  }

  addLights() {
    this.ambient = new AmbientLight(0xffffff, 0.5);
    const sky = new HemisphereLight(0xffffff, 0x8890a0, 1.0);
    sky.position.set(0, 0, 1);
    const sun = new DirectionalLight(0xffffff, 1.9);
    sun.position.set(0.35, -0.5, 1.6);
    this.sun = sun.position.clone().normalize();
    this.scene.add(this.ambient, sky, sun);
  }

  /** @param {"light"|"dark"} theme */
  setTheme(theme) {
    const palette = PALETTE[theme];
    this.theme = theme;
    this.scene.background = new Color(palette.sky);
    this.scene.fog.color.set(palette.sky);
    this.ambient.intensity = 0.5 * palette.ambient;
    lift.value = palette.lift;
    this.ground.setColours(palette);
    this.touch();
  }

  /** Tilts the ground so that up in the picture is against gravity. @param {number[]} up unit */
  setUp([x, y, z]) {
    if (x === this.up.x && y === this.up.y && z === this.up.z) return;
    this.up.set(x, y, z);
    this.tilted.quaternion.copy(tiltOf(this.up));
    this.touch();
  }

  /** Looks at a robot of this size [m] from ahead, its left and above. */
  frameRobot(size, height) {
    this.size = size;
    this.home = new Vector3(0, 0, height * 0.4);
    this.ground.setCell(size > 1.5 ? 0.5 : size > 0.6 ? 0.25 : 0.1);
    this.scene.fog.near = size * 2.5;
    this.scene.fog.far = size * 9;
    this.camera.near = size / 60;
    this.camera.far = size * 60;
    this.controls.minDistance = size * 0.3;
    this.controls.maxDistance = size * 14;
    this.view("corner");
  }

  /** @param {"corner"|"side"|"front"|"top"} name */
  view(name) {
    const from = {
      corner: [1.25, 1.15, 0.8],
      side: [0, 1.9, 0.25],
      front: [1.9, 0, 0.25],
      top: [-0.01, 0, 2.1],
    }[name];
    this.controls.target.copy(this.home ?? new Vector3());
    this.camera.position
      .fromArray(from)
      .multiplyScalar(this.size * 1.45 * Math.max(1, 1.15 / this.camera.aspect))
      .add(this.controls.target);
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.touch();
  }

  /** Turns the camera about its target by angles [rad], as the keyboard does. */
  orbit(right, up) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const r = offset.length();
    const azimuth = Math.atan2(offset.y, offset.x) + right;
    const least = Math.PI / 2 - this.controls.maxPolarAngle;
    const elevation = Math.min(1.55, Math.max(least, Math.asin(offset.z / r) + up));
    offset.set(
      r * Math.cos(elevation) * Math.cos(azimuth),
      r * Math.cos(elevation) * Math.sin(azimuth),
      r * Math.sin(elevation),
    );
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.touch();
  }

  zoom(factor) {
    const offset = this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.touch();
  }

  /** Asks for a picture. */
  touch() {
    this.dirty = true;
    this.touched = performance.now();
  }

  ratio() {
    if (!this.software) return Math.min(devicePixelRatio, 2);
    if (this.fine) return 2;
    if (this.held) return HELD;
    return this.coarse ? COARSE : 1;
  }

  /** Says whether a hand moves the body at present. */
  setHeld(held) {
    if (this.held === held) return;
    this.held = held;
    if (this.software && !this.fine) this.setFine(false);
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.host;
    [this.wide, this.tall] = [width, height]; // kept, as asking for them lays the page out
    this.shown = width > 0;
    if (!width || !height) return;
    this.renderer.setPixelRatio(this.ratio());
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.touch();
  }

  tick(now) {
    this.frame = requestAnimationFrame((next) => this.tick(next));
    if (!this.shown || (this.software && now - this.drawnAt < EVERY)) return;
    for (const each of this.before) each(now);
    if (this.dirty) {
      if (this.fine) this.setFine(false);
      else if (this.software && !this.coarse) this.watchPace(now - this.drawnAt);
      this.drawnAt = now;
      this.draw();
    } else if (this.software && !this.fine && now - this.touched > REST) {
      this.setFine(true);
      this.draw();
    }
  }

  /** Where pictures come too slowly one after the other, the next ones have fewer pixels. */
  watchPace(passed) {
    const { pace } = this;
    if (passed > REST) pace.count = pace.sum = 0; // the picture had rested
    else {
      pace.count++;
      pace.sum += passed;
    }
    if (pace.count < SLOW_COUNT) return;
    this.coarse = pace.sum > SLOW * pace.count;
    pace.count = pace.sum = 0;
    if (this.coarse) this.setFine(false);
  }

  setFine(fine) {
    this.fine = fine;
    this.renderer.setPixelRatio(this.ratio());
  }

  /** How large a pixel is where the camera looks at [m]. */
  pixel() {
    const { camera, controls } = this;
    const tall = 2 * Math.tan((camera.fov * Math.PI) / 360);
    return (tall * camera.position.distanceTo(controls.target)) / Math.max(1, this.canvas.height);
  }

  draw() {
    this.dirty = false;
    this.refine?.(this.pixel());
    this.scene.updateMatrixWorld();
    this.camera.updateMatrixWorld();
    this.ground.cutFor(this.camera, this.scene.fog);
    this.renderer.render(this.scene, this.camera);
    this.drawn++;
    this.onDrawn?.();
    for (const each of this.after) each();
  }

  /** The present picture as a data URL of a PNG. */
  picture() {
    for (const each of this.before) each(performance.now());
    if (this.software && !this.fine) this.setFine(true);
    this.draw();
    return this.canvas.toDataURL("image/png");
  }

  dispose() {
    cancelAnimationFrame(this.frame);
    this.observer.disconnect();
    this.controls.dispose();
    this.renderer.dispose();
    this.canvas.remove();
  }
}
