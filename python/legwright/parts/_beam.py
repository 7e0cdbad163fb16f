# SPDX-License-Identifier: Apache-2.0
"""Whether parts bear what a gait asks of them: each as a beam from the horn to what it carries."""

import math
from dataclasses import dataclass
from pathlib import Path

import mujoco
import numpy as np

from legwright._errors import InputError
from legwright._motion import Motion, read_motion
from legwright.parts._checks import Check, at_least
from legwright.parts._gait import PLANNED, results_of
from legwright.parts._options import PartOptions
from legwright.parts._robot import BuiltRobot
from legwright.parts._sections import Section, disc, sections_of
from legwright.parts._shapes import MM
from legwright.parts._solids import Part, Solid
from legwright.parts._words import Array

_SHARES = np.linspace(0.15, 0.85, 29)  # of the way: where loads enter a beam says nothing
_FACTOR = 'times the stress'
_REMEDY = 'a larger radius or wall under [link] of the assembly, or --strength of another material'


@dataclass(frozen=True)
class Load:
    """What a part carries at a moment, in its link's frame: a force at a place, and torque beside.

    [N], [m]; the torque that the force alone does not explain [N m].
    """

    when: str
    """In words."""
    force: Array
    place: Array
    rest: float


def _beam(solid: Solid) -> list[Section]:
    """Sections between the horn and the middle of what is fixed at the other end."""
    horns = [f.position for f in solid.fixings if f.place.on_horn]
    others = [f.position for f in solid.fixings if not f.place.on_horn]
    if not horns or not others:
        return []
    start, end = MM * np.mean(horns, axis=0), MM * np.mean(others, axis=0)
    return sections_of(solid.shape, start, end, _SHARES)


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


def gait_loads(robot: BuiltRobot, motion: Motion, task: str = '') -> dict[int, list[Load]]:
    """Of each link by its body, at each knot: the ground's force on the feet beyond it.

    Raises InputError where the plan is not of this robot.
    """
    of = f'{task}, ' if task else ''
    model = robot.model
    geoms = _feet_of(robot, motion)
    joints = {name: k for k, name in enumerate(motion.joint_names)}
    out: dict[int, list[Load]] = {link.body: [] for link in robot.links}
    for knot in range(len(motion.time) - 1):
        data = _placed(robot, motion, knot)
        when = f'{of}t = {motion.time[knot]:.2f} s'
        for link in robot.links:
            turn = data.xmat[link.body].reshape(3, 3)
            torque = motion.torques[knot, joints[model.joint(link.joint).name]]
            axis = model.jnt_axis[link.joint]
            for foot, geom in enumerate(geoms):
                if not _is_beyond(model, int(model.geom_bodyid[geom]), link.body):
                    continue
                force = turn.T @ motion.forces[knot, foot]
                place = turn.T @ (_contact(data, model, geom) - data.xpos[link.body])
                # The servo holds against the ground: its torque is the opposite of the force's.
                rest = abs(float(torque + axis @ np.cross(place, force)))
                out[link.body].append(Load(when, force, place, rest))
    return out


def _worst(sections: list[Section], loads: list[Load], axis: Array) -> tuple[float, str]:
    """The largest stress of all loads and sections [MPa], and where and when."""
    worst, where = 0.0, ''
    for load in loads:
        for section in sections:
            lever = MM * load.place - section.centre
            moment = np.cross(lever, load.force)
            along = float(axis @ moment)
            moment = moment + math.copysign(MM * load.rest, along) * axis
            stress = section.stress(load.force, moment)
            if stress > worst:
                worst = stress
                where = f'{100 * section.share:.0f} % of the way, {load.when}'
    return worst, where


def _stalled(robot: BuiltRobot, solid: Solid, sections: list[Section]) -> float:
    """The largest stress where the servo gives all that its file lets it, against the far end."""
    model, joint = robot.model, solid.link.joint
    limits = [
        float(np.abs(model.actuator_forcerange[a]).max())
        for a in range(model.nu)
        if model.actuator_trnid[a, 0] == joint
    ]
    moment = MM * max(limits, default=0.0) * model.jnt_axis[joint]
    return max((s.stress(np.zeros(3), (1 - s.share) * moment) for s in sections), default=0.0)


def _bears_servo(robot: BuiltRobot, part: Part, sections: list[Section], strength: float) -> Check:
    """Fails where the servo has no limit: nothing was looked at."""
    name, stress = 'bears its servo', _stalled(robot, part.solid, sections)
    if stress <= 0:
        joint = robot.model.joint(part.solid.link.joint).name
        where = f'no actuator of {joint} has a forcerange'
        cure = 'the file is not as `legwright build` writes it: build the robot anew'
        return Check(part.name, name, False, None, '', 'at least 1', where, cure)
    where = f'{stress:.1f} of {strength:g} MPa, all of the torque limit, against the far end'
    return at_least(part.name, name, strength / stress, 1.0, _FACTOR, where, _REMEDY)


def _bears_gait(
    robot: BuiltRobot,
    part: Part,
    sections: list[Section],
    loads: dict[int, list[Load]],
    options: PartOptions,
) -> Check:
    """Under another name where the gait's forces say nothing of a part."""
    if not any(loads[each.link.body] for each in part.solids):
        where = 'no foot of the plan is beyond it: what it carries is not looked at'
        return Check(part.name, 'no foot beyond, not checked', True, None, '', '', where)
    name = 'bears the gait'
    stress, where = max(
        _worst(sections, loads[each.link.body], robot.model.jnt_axis[each.link.joint])
        for each in part.solids
    )
    if stress <= 0:
        limit, where = f'at least {options.safety:g}', 'the plan has no force on a foot beyond it'
        return Check(part.name, name, False, None, '', limit, where, 'optimize the robot anew')
    words = f'{stress:.1f} of {options.strength:g} MPa, {where}'
    factor = options.strength / stress
    return at_least(part.name, name, factor, options.safety, _FACTOR, words, _REMEDY)


def pegs_bear(part: Part, loads: dict[int, list[Load]], options: PartOptions) -> list[Check]:
    """Each peg where it leaves the part, under the ground's force on its foot."""
    out = []
    for k in range(len(part.solid.pegs)):
        stress, when = 0.0, 'the plan has no force on its foot'
        for solid in part.solids:
            own = solid.pegs[k]
            root = disc(own.start - own.begins * own.axis, own.axis, own.radius)
            for load in loads[solid.link.body]:
                found = root.stress(load.force, np.cross(MM * load.place - root.centre, load.force))
                if found > stress:
                    stress, when = found, load.when
        words = f'{stress:.1f} of {options.strength:g} MPa, {when}'
        factor = options.strength / stress if stress > 0 else 0.0
        cure = 'a larger foot, one whose module file has screws, or --strength of another material'
        name, least = 'peg bears the gait', options.safety
        out.append(at_least(part.name, name, factor, least, _FACTOR, words, cure))
    return out


def run_loads(robot: BuiltRobot, run: Path) -> dict[int, list[Load]]:
    """What the plans of a run put on each link, by its body."""
    loads: dict[int, list[Load]] = {}
    for task, result in results_of(run).items():
        for body, found in gait_loads(robot, read_motion(result / PLANNED), task).items():
            loads.setdefault(body, []).extend(found)
    return loads


def _not_judged(part: Part, name: str) -> Check:
    """Of a link that does not reach both its horn and what it carries, which fails by itself."""
    where = 'it does not reach both its horn and what it carries: see "reaches"'
    return Check(part.name, f'{name}, not judged', True, None, '', '', where)


def check_beams(
    robot: BuiltRobot, parts: list[Part], loads: dict[int, list[Load]], options: PartOptions
) -> list[Check]:
    """Safety factors of all parts: under loads, where there are any, and their servo's torque."""
    out = []
    for part in parts:
        sections = _beam(part.solid)
        if not sections:
            if part.solid.link.servo:
                names = ['bears the gait', 'bears its servo'] if loads else ['bears its servo']
                out += [_not_judged(part, name) for name in names]
            continue
        if loads:
            out.append(_bears_gait(robot, part, sections, loads, options))
            out += pegs_bear(part, loads, options)
        out.append(_bears_servo(robot, part, sections, options.strength))
    return out
