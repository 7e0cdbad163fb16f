# SPDX-License-Identifier: Apache-2.0
"""What links and feet carry over the gaits of a run: as MuJoCo plays them, or as planned."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import mujoco
import numpy as np

from legwright._errors import InputError
from legwright._motion import Motion, read_motion
from legwright._plugin import served_mujoco
from legwright.parts._gait import PLANNED, results_of
from legwright.parts._robot import BuiltRobot
from legwright.parts._words import Array

SCENE = 'scene.xml'
CYCLES = 20  # as many as a verdict is of
_FALLEN = math.cos(1.0)  # of the trunk's z axis: what comes then is no gait


@dataclass(frozen=True)
class Loads:
    """What acts on a body at moments of a gait, in the frame of a link. N rows each."""

    task: str
    """Whose gait; empty where a run has one."""
    times: Array
    """[s]"""
    forces: Array
    """[N]"""
    moments: Array
    """About the link's origin [N m]."""

    def when(self, k: int) -> str:
        """In words."""
        of = f'{self.task}, ' if self.task else ''
        return f'{of}t = {self.times[k]:.3f} s'


@dataclass(frozen=True)
class GaitLoads:
    """Of all gaits of a run."""

    links: Mapping[int, Sequence[Loads]] = field(default_factory=dict)
    """What each carries, with all beyond it, by its body; none of a link of which the plan, which
    has no forces but those on feet, tells nothing."""
    feet: Mapping[str, Sequence[Loads]] = field(default_factory=dict)
    """What the ground does to each, in the frame of the link that it is on, by its name."""
    is_played: bool = True
    """In MuJoCo; else it is the plan."""

    @property
    def gait(self) -> str:
        """What a part bears, for names of checks."""
        return 'the gait' if self.is_played else 'the plan'


def _joined(found: Sequence[GaitLoads], is_played: bool) -> GaitLoads:
    links: dict[int, list[Loads]] = {}
    feet: dict[str, list[Loads]] = {}
    for each in found:
        for body, loads in each.links.items():
            links.setdefault(body, []).extend(loads)
        for name, loads in each.feet.items():
            feet.setdefault(name, []).extend(loads)
    return GaitLoads(links, feet, is_played)


def _placed(robot: BuiltRobot, motion: Motion, knot: int) -> mujoco.MjData:
    """The robot at a knot of its plan."""
    model = robot.model
    data = mujoco.MjData(model)
    data.qpos[:3] = motion.root[knot, :3]
    turn = motion.root[knot, 3:]
    angle = float(np.linalg.norm(turn))
    axis = turn / angle if angle > 0 else np.array([1.0, 0, 0])
    mujoco.mju_axisAngle2Quat(data.qpos[3:7], axis, angle)
    for name, value in zip(motion.joint_names, motion.joints[knot]):
        data.qpos[model.joint(name).qposadr[0]] = value
    mujoco.mj_kinematics(model, data)
    return data


def _is_beyond(model: mujoco.MjModel, body: int, link: int) -> bool:
    while body > 0 and body != link:
        body = int(model.body_parentid[body])
    return body == link


def _contact(data: mujoco.MjData, model: mujoco.MjModel, geom: int) -> Array:
    """The lowest point of a foot's ball, else its middle."""
    place = data.geom_xpos[geom].copy()
    if model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_SPHERE:
        place[2] -= model.geom_size[geom][0]
    return place


def _feet_of(robot: BuiltRobot, motion: Motion) -> list[int]:
    """The geoms of a plan's feet. Raises InputError where the plan is of another robot."""
    kinds = (
        ('foot', 'geom', mujoco.mjtObj.mjOBJ_GEOM, motion.foot_names),
        ('joint', 'joint', mujoco.mjtObj.mjOBJ_JOINT, motion.joint_names),
    )
    for what, kind, of, names in kinds:
        for name in names:
            if mujoco.mj_name2id(robot.model, of, name) < 0:
                raise InputError(
                    f'{robot.file}: has no {kind} {name}, which the plan has as its {what}; the '
                    'plan is of another robot: optimize this one'
                )
    if missing := {robot.model.joint(e.joint).name for e in robot.links} - {*motion.joint_names}:
        raise InputError(
            f'{robot.file}: the plan ({PLANNED}) does not have its joint {min(missing)}; optimize '
            'this robot'
        )
    if len(motion.time) < 2:
        raise InputError(
            f'{robot.file}: its plan ({PLANNED}) has a single row; expected a cycle of two or '
            'more: `legwright optimize` makes it anew'
        )
    return [robot.model.geom(name).id for name in motion.foot_names]


def planned_loads(robot: BuiltRobot, motion: Motion, task: str = '') -> GaitLoads:
    """The ground's planned forces at each knot on feet, and on each link those of all beyond it.

    What the plan's torque has besides (weight and inertia of the leg) is a moment about the joint,
    once in each direction: two rows a knot. Raises InputError where the plan is not of this robot.
    """
    model = robot.model
    geoms = _feet_of(robot, motion)
    joints = {name: k for k, name in enumerate(motion.joint_names)}
    knots = len(motion.time) - 1
    placed = [_placed(robot, motion, knot) for knot in range(knots)]

    def on(body: int, feet: Sequence[int]) -> Array:
        """Force and moment in the frame of a body: 2 x knots x 3."""
        out = np.zeros((2, knots, 3))
        for knot, data in enumerate(placed):
            turn = data.xmat[body].reshape(3, 3)
            for foot in feet:
                force = turn.T @ motion.forces[knot, foot]
                place = turn.T @ (_contact(data, model, geoms[foot]) - data.xpos[body])
                out[:, knot] += force, np.cross(place, force)
        return out

    links, feet = {}, {}
    for link in robot.links:
        bodies = [int(model.geom_bodyid[geom]) for geom in geoms]
        beyond = [k for k, body in enumerate(bodies) if _is_beyond(model, body, link.body)]
        if not beyond:
            continue
        forces, moments = on(link.body, beyond)
        axis = model.jnt_axis[link.joint]
        # The servo holds against the ground: its torque is the opposite of the force's.
        rest = motion.torques[:knots, joints[model.joint(link.joint).name]] + moments @ axis
        both = np.concatenate([moments + np.outer(rest, axis), moments - np.outer(rest, axis)])
        times = np.tile(motion.time[:knots], 2)
        links[link.body] = [Loads(task, times, np.tile(forces, (2, 1)), both)]
    for k, name in enumerate(motion.foot_names):
        forces, moments = on(int(model.geom_bodyid[geoms[k]]), [k])
        feet[name] = [Loads(task, motion.time[:knots], forces, moments)]
    return GaitLoads(links, feet, False)


def run_plan_loads(robot: BuiltRobot, run: Path) -> GaitLoads:
    """Of the plans of a run."""
    found = [
        planned_loads(robot, read_motion(result / PLANNED), task)
        for task, result in results_of(run).items()
    ]
    return _joined(found, False)


@dataclass
class _Record:
    """What a scene was seen to do: a row a step, world frame, forces before moments."""

    on_links: list[Array] = field(default_factory=list)
    """Links x 6, about the middle of the robot's mass: MuJoCo's cfrc_int, moments first."""
    middles: list[Array] = field(default_factory=list)
    on_feet: list[Array] = field(default_factory=list)
    """Feet x 6, about the world's origin."""
    places: list[Array] = field(default_factory=list)
    """Bodies x 3."""
    turns: list[Array] = field(default_factory=list)
    """Bodies x 3 x 3."""


class _Player:
    """A scene with its gait, and what its bodies carry at each step."""

    def __init__(self, robot: BuiltRobot, scene: Path) -> None:
        self._foot_names = [each.of for each in robot.modules if each.words.kind == 'foot']
        try:
            self._model = mujoco.MjModel.from_xml_path(str(scene))
            key = self._model.key('gait').id
            self._links = [self._model.body(link.name).id for link in robot.links]
            feet = [self._model.geom(name).id for name in self._foot_names]
        except (ValueError, KeyError) as error:
            cure = '`legwright optimize` makes it anew'
            raise InputError(f'{scene}: no gait of this robot ({error}); {cure}') from None
        self._feet = {geom: k for k, geom in enumerate(feet)}
        self._bodies = [*self._links, *(int(self._model.geom_bodyid[geom]) for geom in feet)]
        self._data = mujoco.MjData(self._model)
        mujoco.mj_resetDataKeyframe(self._model, self._data, key)
        self._trunk = int(self._model.body_rootid[self._links[0]])

    def _on_feet(self) -> Array:
        """Of each what touches it."""
        data, out, found = self._data, np.zeros((len(self._feet), 6)), np.zeros(6)
        geoms, frames, places = data.contact.geom, data.contact.frame, data.contact.pos
        for k, pair in enumerate(geoms.tolist()):
            for sign, geom in zip((-1, 1), pair):
                foot = self._feet.get(geom)
                if foot is not None:
                    mujoco.mj_contactForce(self._model, data, k, found)
                    force = sign * (found[:3] @ frames[k].reshape(3, 3))
                    out[foot, :3] += force
                    out[foot, 3:] += np.cross(places[k], force)
        return out

    def _watched(self, seconds: float) -> _Record:
        """Until it falls. All that is derived at a step is of the state before it."""
        model, data, out = self._model, self._data, _Record()
        for _ in range(round(seconds / model.opt.timestep)):
            mujoco.mj_step(model, data)
            mujoco.mj_rnePostConstraint(model, data)
            out.on_links.append(data.cfrc_int[self._links])
            out.middles.append(data.subtree_com[self._trunk].copy())
            out.on_feet.append(self._on_feet())
            out.places.append(data.xpos[self._bodies])
            out.turns.append(data.xmat[self._bodies])
            if not np.isfinite(out.on_links[-1]).all() or data.xmat[self._trunk, 8] < _FALLEN:
                break
        return out

    def play(self, seconds: float, task: str) -> tuple[list[Loads], dict[str, list[Loads]]]:
        """What each link carries, and each foot, until it falls."""
        seen = self._watched(seconds)
        times = self._model.opt.timestep * np.arange(len(seen.places))
        places, turns = np.array(seen.places), np.array(seen.turns)
        turns = turns.reshape(*places.shape, 3)
        # What the body above does to each: the opposite of what it carries. MuJoCo has in it
        # inertia, weight and contacts of all beyond.
        links = -np.array(seen.on_links)
        feet = np.array(seen.on_feet)
        forces = np.concatenate([links[..., 3:], feet[..., :3]], axis=1)
        moments = np.concatenate([links[..., :3], feet[..., 3:]], axis=1)
        about = np.zeros_like(places)
        about[:, : len(self._links)] = np.array(seen.middles)[:, None]
        moments = moments + np.cross(about - places, forces)
        own = [np.einsum('tbji,tbj->bti', turns, each) for each in (forces, moments)]
        found = [Loads(task, times, *both) for both in zip(*own)]
        count = len(self._links)
        of_feet = {name: [loads] for name, loads in zip(self._foot_names, found[count:])}
        return found[:count], of_feet


def played_loads(robot: BuiltRobot, run: Path) -> GaitLoads | None:
    """Of a run's results as their scenes play them, at the gains of the file; None where one has no
    scene. Raises InputError where a scene is not of this robot, ImportError, with what to install,
    where there is no plugin for the MuJoCo that is imported."""
    results = results_of(run)
    if not all((result / SCENE).is_file() for result in results.values()):
        return None
    served_mujoco()
    found = []
    for task, result in results.items():
        seconds = CYCLES * read_motion(result / PLANNED).period
        links, feet = _Player(robot, result / SCENE).play(seconds, task)
        bodies = {link.body: [loads] for link, loads in zip(robot.links, links)}
        found.append(GaitLoads(bodies, feet))
    return _joined(found, True)
