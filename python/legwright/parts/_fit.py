# SPDX-License-Identifier: Apache-2.0
"""Whether parts and modules keep clear of each other while joints turn."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import mujoco
import numpy as np
from manifold3d import Manifold

from legwright.parts._checks import Check, at_least
from legwright.parts._robot import BuiltRobot
from legwright.parts._shapes import MM, outline, placed
from legwright.parts._solids import Part
from legwright.parts._words import Array

_ANGLES = 73  # of a range that are looked at: each five degrees of a whole turn
_NARROW = (
    'narrow the range in the assembly (range = [low, high] of the joint), move the joint, or ask '
    'for less clearance: --gap'
)
_OVERLAP = (
    'these two are too near where the joint works, so no range helps: move the joint (offset in '
    'the assembly), turn its servo by roll, or ask for less clearance: --gap'
)
_FAR = 5.0  # [mm]: distances beyond are not measured


@dataclass(frozen=True)
class Thing:
    """A part or a module, on the body that carries it [mm]."""

    name: str
    body: int
    solid: Manifold
    low: Array
    high: Array


@dataclass(frozen=True)
class Nearest:
    """The least distance found [mm], and between what and when."""

    gap: float
    where: str


def _thing(name: str, body: int, solid: Manifold) -> Thing:
    box = np.array(solid.bounding_box())
    return Thing(name, body, solid, box[:3], box[3:])


def things_of(robot: BuiltRobot, parts: Sequence[Part]) -> list[Thing]:
    """All that can touch: parts as they are printed, outlines of modules.

    Of a trunk that is printed the part alone.
    """
    printed = {solid.link.body for part in parts for solid in part.solids}
    out = [
        _thing(module.of, module.body, outline(module))
        for module in robot.modules
        if module.words.kind != 'trunk' or module.body not in printed
    ]
    for part in parts:
        for solid in part.solids:
            out.append(_thing(f'part {solid.link.name}', solid.link.body, solid.shape))
    return out


class Distances:
    """Distances between things of a robot in a pose."""

    def __init__(self, robot: BuiltRobot, things: Sequence[Thing]) -> None:
        self._model = robot.model
        self._data = mujoco.MjData(robot.model)
        self.things = tuple(things)
        self.groups = {
            body: [each for each in things if each.body == body]
            for body in sorted({each.body for each in things})
        }

    def pose(self, qpos: Array) -> None:
        """Puts the robot there."""
        self._data.qpos[:] = qpos
        mujoco.mj_kinematics(self._model, self._data)

    def gap(self, a: Thing, b: Thing, most: float = _FAR) -> float:
        """Between two things [mm]; `most` where they are further apart."""
        data = self._data
        turn = data.xmat[a.body].reshape(3, 3).T
        relative = turn @ data.xmat[b.body].reshape(3, 3)
        shift = MM * turn @ (data.xpos[b.body] - data.xpos[a.body])
        middle = relative @ ((b.low + b.high) / 2) + shift
        half = np.abs(relative) @ ((b.high - b.low) / 2)
        apart = np.maximum(a.low - middle - half, middle - half - a.high)
        if np.linalg.norm(np.maximum(apart, 0.0)) >= most:
            return most
        moved = placed(b.solid, relative, shift)
        return float(a.solid.min_gap(moved, most))

    def nearest(self, pairs: Iterable[tuple[Thing, Thing]]) -> tuple[float, str]:
        """The least distance of pairs, and of which."""
        least, where = _FAR, ''
        for a, b in pairs:
            gap = self.gap(a, b, least)
            if gap < least:
                least, where = gap, f'{a.name} and {b.name}'
        return least, where

    def pairs(self, body: int, other: int) -> list[tuple[Thing, Thing]]:
        """Each of one body with each of another."""
        return [
            (a, b) for a in self.groups.get(body, []) for b in self.groups.get(other, [])
        ]

    def all_pairs(self) -> list[tuple[Thing, Thing]]:
        """Those of different bodies."""
        return [
            (a, b) for k, a in enumerate(self.things) for b in self.things[k + 1 :]
            if a.body != b.body
        ]


def check_poses(
    distances: Distances, poses: Sequence[tuple[str, Array]], least: float, what: str
) -> Check:
    """All pairs in some poses, each with words for where it is."""
    found = Nearest(_FAR, '')
    pairs = distances.all_pairs()
    for words, qpos in poses:
        distances.pose(qpos)
        gap, where = distances.nearest(pairs)
        if gap < found.gap:
            found = Nearest(gap, f'{where}, {words}')
    return at_least(
        '',
        f'gap {what}',
        found.gap,
        least,
        'mm',
        found.where or f'nothing nearer than {_FAR:g} mm',
        'move hips or joints apart in the assembly, or keep limbs apart in the task',
    )


@dataclass(frozen=True)
class FreeRange:
    """How far a joint turns from where it works until something is nearer than the gap [rad]."""

    joint: str
    low: float
    high: float
    declared: tuple[float, float]
    gap: float
    """Least distance within [mm]."""
    where: str
    stops: tuple[str, str]
    """What is in the way below and above; empty: nothing."""


def _angles(model: mujoco.MjModel, joint: int) -> Array:
    low, high = model.jnt_range[joint] if model.jnt_limited[joint] else (-math.pi, math.pi)
    return np.linspace(low, high, _ANGLES)


def free_range(
    robot: BuiltRobot, distances: Distances, joint: int, works: Sequence[float], least: float
) -> FreeRange:
    """Of a joint, about the middle of the angles at which it works: what it carries next, against
    what carries it. Other joints do not matter."""
    model = robot.model
    body = int(model.jnt_bodyid[joint])
    above = int(model.body_parentid[body])
    pairs = distances.pairs(above, body)
    address = int(model.jnt_qposadr[joint])
    angles = _angles(model, joint)
    qpos = model.qpos0.copy()
    found: list[tuple[float, str]] = []
    for angle in angles:
        qpos[address] = angle
        distances.pose(qpos)
        found.append(distances.nearest(pairs))
    middle = int(np.argmin(np.abs(angles - (min(works) + max(works)) / 2)))
    low = high = middle
    while low > 0 and found[low - 1][0] >= least:
        low -= 1
    while high + 1 < len(angles) and found[high + 1][0] >= least:
        high += 1
    gap, where = min(found[low : high + 1], key=lambda each: each[0])
    stops = (
        found[low - 1][1] if low > 0 else '',
        found[high + 1][1] if high + 1 < len(angles) else '',
    )
    declared = (float(angles[0]), float(angles[-1]))
    name = model.joint(joint).name
    return FreeRange(name, float(angles[low]), float(angles[high]), declared, gap, where, stops)


def check_ranges(
    robot: BuiltRobot, distances: Distances, poses: Sequence[Array], least: float
) -> tuple[list[Check], list[FreeRange]]:
    """Each joint: its free range has the angles at which it works."""
    checks, ranges = [], []
    for link in robot.links:
        address = int(robot.model.jnt_qposadr[link.joint])
        works = [float(qpos[address]) for qpos in poses]
        free = free_range(robot, distances, link.joint, works, least)
        ranges.append(free)
        # Limits are soft in MuJoCo: what is played a little beyond them was not looked at.
        first, last = np.clip([min(works), max(works)], *free.declared)
        is_open = free.gap >= least
        good = is_open and free.low <= first and last <= free.high
        words = (
            f'free from {math.degrees(free.low):.0f} to {math.degrees(free.high):.0f} deg of '
            f'{math.degrees(free.declared[0]):.0f} to {math.degrees(free.declared[1]):.0f}; works '
            f'from {math.degrees(min(works)):.0f} to {math.degrees(max(works)):.0f}; {free.where}'
        )
        checks.append(
            Check(
                link.name,
                f'range of {free.joint}',
                good,
                free.gap,
                'mm',
                f'at least {least:g} mm',
                words,
                ''
                if good
                else (_NARROW if is_open else _OVERLAP),
            )
        )
    return checks, ranges
