# SPDX-License-Identifier: Apache-2.0
"""Whether parts bear what a gait asks of them: each as a beam from the horn to what it carries."""

import math
from dataclasses import dataclass
from pathlib import Path

import mujoco
import numpy as np

from legwright._motion import Motion, read_motion
from legwright.parts._checks import Check, at_least
from legwright.parts._gait import PLANNED, results_of
from legwright.parts._options import PartOptions
from legwright.parts._robot import BuiltRobot
from legwright.parts._sections import Section, sections_of
from legwright.parts._shapes import MM
from legwright.parts._solids import Part, Solid
from legwright.parts._words import Array

_SHARES = np.linspace(0.15, 0.85, 29)  # of the way: where loads enter a beam says nothing


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


def gait_loads(robot: BuiltRobot, motion: Motion, task: str = '') -> dict[int, list[Load]]:
    """Of each link by its body, at each knot: the ground's force on the feet beyond it."""
    of = f'{task}, ' if task else ''
    model = robot.model
    geoms = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_GEOM, n) for n in motion.foot_names]
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
                if geom < 0 or not _is_beyond(model, int(model.geom_bodyid[geom]), link.body):
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


def check_beams(
    robot: BuiltRobot, parts: list[Part], run: Path | None, options: PartOptions
) -> list[Check]:
    """Safety factors of all parts: under a run's planned forces, and under their servo's torque."""
    loads: dict[int, list[Load]] = {}
    for task, result in results_of(run).items() if run is not None else ():
        for body, found in gait_loads(robot, read_motion(result / PLANNED), task).items():
            loads.setdefault(body, []).extend(found)
    out = []
    remedy = (
        'a larger radius or wall under [link] of the assembly, or --strength of another material'
    )
    for part in parts:
        sections = _beam(part.solid)
        if not sections:
            continue
        stalled = _stalled(robot, part.solid, sections)
        cases = [('bears its servo', stalled, 1.0, 'all of the torque limit, against the far end')]
        if loads:
            worst = [
                _worst(sections, loads[each.link.body], robot.model.jnt_axis[each.link.joint])
                for each in part.solids
            ]
            stress, where = max(worst)
            cases.insert(0, ('bears the gait', stress, options.safety, where))
        for name, stress, least, where in cases:
            factor = options.strength / stress if stress > 0 else math.inf
            words = f'{stress:.1f} of {options.strength:g} MPa, {where}'
            out.append(at_least(part.name, name, factor, least, '', words, remedy))
    return out
