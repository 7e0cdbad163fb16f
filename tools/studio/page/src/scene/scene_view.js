// SPDX-License-Identifier: Apache-2.0
// A robot and its motion as a picture that can be turned, scrubbed and taken hold of. Knows nothing
// of server or session: a report shows its data with the same code.
import { Color, Group, Vector3 } from "three";
import { Arrows } from "./arrows.js";
import { BoundGhosts } from "./bound_ghosts.js";
import { sizeOf, soleFinder } from "./extent.js";
import { Footprints } from "./footprints.js";
import { Handles } from "./handles.js";
import { Hurdles } from "./hurdles.js";
import { Marks } from "./marks.js";
import { MotionPlayer } from "./motion_player.js";
import { NameTag } from "./name_tag.js";
import { RobotBody } from "./robot_body.js";
import { Recording } from "./recording.js";
import { Shadow } from "./shadow.js";
import { SlopeTag } from "./slope_tag.js";
import { Stage } from "./stage.js";

const GHOST = new Color(0x7b8cff);
const LANE = 0.9; // of the robot's size, between designs side by side
const ARROW_SHARE = 0.55; // of the robot's size, for a force as large as its weight

export class SceneView {
  /**
   * @param {HTMLElement} host positioned; filled by the picture
   * @param {{meshSource?: (id: string) => Promise<import("../types.js").Mesh>}} options
   */
  constructor(host, { meshSource } = {}) {
    this.stage = new Stage(host);
    this.labels = document.createElement("div");
    this.labels.className = "scene-labels";
    host.append(this.labels);
    const options = { meshSource, changed: () => this.stage.touch() };
    this.robot = new RobotBody(options);
    this.ghost = new RobotBody({ ...options, ghost: 0.32, tint: GHOST });
    this.neighbour = new RobotBody(options);
    for (const other of [this.ghost, this.neighbour]) other.root.visible = false;
    this.other = this.ghost; // the one of them that is shown, if any
    this.planned = new Arrows(0x1f8a70);
    this.measured = new Arrows(0xe8871e);
    this.pushArrow = new Arrows(0xc2185b);
    this.footprints = new Footprints();
    this.hurdles = new Hurdles();
    this.handles = new Handles();
    this.marks = new Marks(this.labels);
    this.tag = new NameTag(this.labels);
    this.slopeTag = new SlopeTag(this.labels);
    this.bounds = new BoundGhosts(options);
    this.shadow = new Shadow(this.stage.sun);
    this.walker = new Group();
    this.walker.add(this.robot.root, this.footprints.root, this.handles.root);
    this.walker.add(this.ghost.root, this.neighbour.root, this.bounds.root, this.hurdles.root);
    for (const each of [this.planned, this.measured, this.pushArrow, this.marks])
      this.walker.add(each.root);
    this.stage.world.add(this.walker);
    this.stage.tilted.add(this.shadow.root);
    this.show = { forces: true, paths: true, faults: true, follow: true };
    this.margin = 1; // of the robot's size that the picture shows
    this.playing = true;
    this.speed = 1;
    this.time = 0;
    this.live = null; // what physics says, instead of the plan
    this.pointed = []; // what the judge speaks of
    this.recording = new Recording(); // of what physics said
    this.readParameter = () => ({ value: 0, lower: 0, upper: 0, locked: false });
    this.offset = new Vector3();
    this.stage.before.push((now) => this.advance(now));
    this.stage.refine = (pixel) => this.refine(pixel);
  }

  /** @param {"light"|"dark"} theme */
  setTheme(theme) {
    this.shadow.setTheme(theme);
    this.stage.setTheme(theme);
  }

  /** How fast the plan is played, or physics. @param {number} speed of real time */
  setSpeed(speed) {
    this.speed = speed;
    this.onSpeed?.();
  }

  /** @param {import("../types.js").Design} design */
  setDesign(design) {
    this.design = design;
    this.dress();
    this.findSoles = null;
    this.stage.touch();
  }

  /** @param {import("../types.js").Motion} motion that goes on in the phase of the one before */
  setMotion(motion) {
    const phase = this.player ? this.player.at(this.time) : { cycle: 0, phase: 0 };
    this.player = new MotionPlayer(motion);
    this.time = (phase.cycle + phase.phase) * this.player.period;
    this.poses = new Float32Array(7 * this.player.bodyCount);
    this.findSoles = null;
    this.dress();
    this.stage.touch();
  }

  /** Draws the body with what the task adds to it: its payload. */
  dress() {
    if (!this.design) return;
    const extra = this.player?.motion.extra ?? [];
    const { design } = this;
    this.robot.setDesign(extra.length ? { ...design, geoms: [...design.geoms, ...extra] } : design);
  }

  /**
   * Shows another design within this one as a ghost, or beside it; null takes it away.
   * @param {?{design, motion, name}} other
   */
  setGhost(other, { beside = false } = {}) {
    const moved = this.besides() !== (beside && Boolean(other));
    this.other.root.visible = false;
    this.other = beside ? this.neighbour : this.ghost;
    this.other.root.visible = Boolean(other);
    this.ghostPlayer = null;
    this.tagged = (beside && other?.name) || "";
    if (other) {
      this.other.setDesign(other.design);
      if (other.motion) {
        this.ghostPlayer = new MotionPlayer(other.motion);
        this.ghostPoses = new Float32Array(7 * this.ghostPlayer.bodyCount);
      }
    }
    if (moved && this.framed && !this.stage.turned) this.fit();
    this.pose();
  }

  /** Shows the bodies at both bounds of a parameter, as ghosts; null takes them away. */
  setBounds(bounds) {
    this.bounds.set(bounds);
    this.pose();
  }

  /** Whether two designs walk side by side. */
  besides() {
    return this.other === this.neighbour && this.neighbour.root.visible;
  }

  /** How far apart they walk [m]. */
  lane() {
    return this.besides() ? LANE * this.size : 0;
  }

  /**
   * Shows what physics says instead of the plan; null shows the plan again.
   * @param {?{poses: Float32Array, feet: object[]}} live poses of all bodies, and of each foot where
   * it is, its force and the planned one
   */
  setLive(live) {
    this.live = live;
    this.pose();
  }

  /**
   * Marks parts of the robot, whatever it does, until others are pointed at.
   * @param {{body: number, where: ?string, words: string}[]} parts of a body, or at the foot `where`
   */
  pointAt(parts) {
    this.pointed = parts;
    this.pose();
  }

  /** @param {number} phase of the cycle, 0 to 1 */
  seekPhase(phase) {
    if (!this.player) return;
    const { cycle } = this.player.at(this.time);
    this.seek((cycle + Math.min(Math.max(phase, 0), 0.999999)) * this.player.period);
  }

  /** @param {number} time [s] */
  seek(time) {
    this.time = time;
    this.pose();
  }

  setPlaying(playing) {
    this.playing = playing;
    this.last = null;
    this.onPlaying?.(playing);
  }

  /** Plays on in what physics did, to its end. @param {number} passed [s] */
  playRecording(passed) {
    const { recording } = this;
    const time = Math.min(recording.end, recording.at + passed);
    this.seekRecording(time);
    if (time === recording.end) this.setPlaying(false);
  }

  /** Shows what physics did at a time [s] of the recorded run; what goes on there is held. */
  seekRecording(time) {
    const began = !this.recording.shown;
    this.setLive(this.recording.show(time));
    if (began) this.onRecording?.();
  }

  /** Leaves the recorded run. */
  leaveRecording() {
    this.recording.shown = false;
    this.setLive(null);
  }

  phase() {
    return this.player ? this.player.at(this.time).phase : 0;
  }

  advance(now) {
    const passed = this.last ? Math.min((now - this.last) / 1000, 0.2) : 0;
    if (this.playing && this.recording.shown) this.playRecording(passed * this.speed);
    else if (this.playing && this.player && !this.live) {
      this.time += passed * this.speed;
      this.pose();
    } else if (this.stage.dirty) this.pose();
    this.last = now;
  }

  /** Shapes robots as finely as is seen, and their shadow. @param {number} pixel its size [m] */
  refine(pixel) {
    for (const each of [this.robot, this.other, this.bounds]) each.setPixel(pixel);
    const beside = this.besides() ? this.neighbour.meshes : [];
    this.shadow.follow([...this.robot.meshes, ...beside]);
  }

  /** Puts everything where it is at the present time. */
  pose() {
    this.stage.touch();
    if (!this.design || !(this.player || this.live)) return;
    const poses = this.live?.poses ?? this.player.sample(this.time, this.poses);
    this.robot.setPoses(poses);
    this.stage.setUp(this.live?.up ?? this.player?.motion.up ?? [0, 0, 1]);
    if (!this.framed) this.frame();
    this.follow(poses);
    this.poseGhost();
    this.bounds.pose(this.live ? null : this.player, this.time);
    this.drawForces(poses);
    this.drawFeet(poses);
    this.stage.scene.updateMatrixWorld();
    const { camera, tall } = this.stage;
    this.handles.update(this.robot, camera, tall, this.size, this.readParameter);
    this.drawFaults();
    this.tagNeighbour(camera);
    this.slopeTag.show(this.stage.up, this.player?.advance ?? [1, 0, 0]);
    this.onPose?.();
  }

  /** Puts the whole robot into the picture; again when its meshes are here, if nobody has turned it. */
  frame() {
    this.framed = true;
    this.stage.turned = false;
    this.fit();
    this.robot.complete().then(() => this.stage.turned || this.fit());
  }

  /** Sets the camera and all that goes by the robot's size. */
  fit() {
    const { size, height } = sizeOf(this.robot);
    this.size = size;
    this.height = height;
    for (const each of [this.planned, this.measured, this.pushArrow]) each.thickness = size * 0.011;
    this.stage.frameRobot(this.margin * size + 0.6 * this.lane(), height);
  }

  follow(poses) {
    if (!this.show.follow) this.offset.set(0, 0, 0);
    else if (this.live) this.offset.set(poses[7] ?? 0, poses[8] ?? 0, 0);
    else this.player.path(this.time, this.offset);
    this.walker.position.copy(this.offset).negate();
    this.walker.position.y += this.lane() / 2;
    this.stage.ground.moveTo(-this.offset.x, -this.offset.y);
  }

  poseGhost() {
    const { other } = this;
    if (!other.root.visible) return;
    const root = other.root.position.set(0, -this.lane(), 0);
    if (!this.ghostPlayer) return other.setPoses(this.live?.poses ?? this.poses);
    const { cycle, phase } = this.player?.at(this.time) ?? { cycle: 0, phase: 0 };
    const time = (cycle + phase) * this.ghostPlayer.period;
    other.setPoses(this.ghostPlayer.sample(time, this.ghostPoses));
    root.add(this.offset).sub(this.ghostPlayer.path(time, new Vector3()));
  }

  /** Says which of two robots is the other one. */
  tagNeighbour(camera) {
    if (!this.besides()) return this.tag.show("");
    const trunk = this.neighbour.groups[1] ?? this.neighbour.root;
    this.tag.show(this.tagged, trunk, 0.4 * this.height, camera);
  }

  drawForces(poses) {
    this.planned.clear();
    this.measured.clear();
    this.pushArrow.clear();
    if (this.push) {
      this.robot.place(this.push.body, this.push.at, (this.pushFrom ??= new Vector3()));
      this.pushArrow.add(this.pushFrom, this.push.along);
    }
    if (!this.show.forces || !this.player) return;
    const scale = this.forceScale();
    const [from, along] = [new Vector3(), new Vector3()];
    if (this.live) {
      for (const { at, force, planned } of this.live.feet ?? []) {
        this.measured.add(from.fromArray(at), along.fromArray(force).multiplyScalar(scale));
        if (planned) this.planned.add(from, along.fromArray(planned).multiplyScalar(scale));
      }
      return;
    }
    this.player.feet.forEach((_, i) => {
      this.soles()(poses, i, from);
      this.planned.add(from, this.player.force(this.time, i, along).multiplyScalar(scale));
    });
  }

  /** Metres of an arrow for a newton. */
  forceScale() {
    const { player } = this;
    if (player.weight === undefined) {
      let sum = 0;
      for (let i = 2; i < player.forces.length; i += 3) sum += player.forces[i];
      player.weight = sum / Math.max(player.frames, 1);
    }
    return player.weight > 0 ? (ARROW_SHARE * this.size) / player.weight : 0;
  }

  soles() {
    if (!this.findSoles) {
      this.findSoles = soleFinder(this.design, this.player);
      this.footprints.setMotion(this.player, this.findSoles);
      this.hurdles.setMotion(this.player, this.findSoles, this.size);
    }
    return this.findSoles;
  }

  drawFeet(poses) {
    const { root } = this.footprints;
    root.visible = Boolean(this.show.paths && this.player && !this.live);
    this.hurdles.root.visible = root.visible;
    if (!root.visible) return;
    this.soles();
    this.footprints.update(this.player, this.time, poses, this.size * 0.032);
    this.hurdles.update(this.player, this.time);
  }

  drawFaults() {
    const plan = this.show.faults && this.player && !this.live && !this.pointed.length;
    const faults = plan ? this.player.faultsAt(this.time) : this.pointed;
    const marks = faults.map((each) => ({
      at: this.placeOf(each, new Vector3()),
      words: each.words,
    }));
    this.marks.show(marks, this.size * 0.045, this.stage);
  }

  /** Where a fault is drawn: at the point of a body or at the foot that it names. */
  placeOf({ body, at, where }, out) {
    const measured = this.live?.feet?.find((each) => each.name === where);
    if (measured) return out.fromArray(measured.at);
    const foot = this.live ? -1 : this.player.feet.findIndex((each) => each.name === where);
    if (foot >= 0) return this.soles()(this.poses, foot, out);
    return this.robot.place(typeof body === "number" ? body : 1, at ?? [0, 0, 0], out);
  }

  dispose() {
    this.stage.dispose();
    this.labels.remove();
  }
}
