# SPDX-License-Identifier: Apache-2.0
"""Whether modules keep clear of each other in the home pose, also those of one link."""

import itertools
import math
from dataclasses import dataclass

import mujoco
import numpy as np
from manifold3d import Manifold

from legwright.parts._checks import Check, at_most
from legwright.parts._robot import BuiltRobot, Module, Shape, home_of
from legwright.parts._shapes import MM, grown, outline, placed
from legwright.parts._words import Array

_NAME = 'modules keep clear'
_MOST = 0.5  # [mm] deep: outlines are no more precise, and modules may touch
_UNIT = 'mm deep'
_BALL = 24  # segments
_ALONG = 0.99  # of a direction that is told as that axis


@dataclass(frozen=True)
class _Standing:
    """A module in the home pose: all of it, and each of its shapes by its corners [mm]."""

    module: Module
    solid: Manifold
    corners: tuple[Array, ...]


def _corners(shape: Shape) -> Array:
    """N x 3, of a convex solid [mm]."""
    solid = grown(shape, 0.0)
    if shape.kind == 'sphere':
        ball = Manifold.sphere(MM * float(shape.size[0]), _BALL)
        solid = placed(ball, np.eye(3), MM * shape.position)
    return np.asarray(solid.to_mesh64().vert_properties)[:, :3]


def _standing(robot: BuiltRobot) -> list[_Standing]:
    """All modules but the trunk, whose box has others in it."""
    data = mujoco.MjData(robot.model)
    data.qpos[:] = home_of(robot)
    mujoco.mj_kinematics(robot.model, data)
    out = []
    for module in robot.modules:
        if module.words.kind == 'trunk' or not module.shapes:
            continue
        turn, shift = data.xmat[module.body].reshape(3, 3), MM * data.xpos[module.body]
        corners = tuple(_corners(shape) @ turn.T + shift for shape in module.shapes)
        out.append(_Standing(module, placed(outline(module), turn, shift), corners))
    return out


def depth_of(one: Array, other: Array) -> tuple[float, Array]:
    """How far one of two convex solids must be moved until they are apart [mm], and which way.

    Each is told by its corners: the least distance from the origin to a side of the hull of all
    differences of these. 0 where they are apart.
    """
    mesh = Manifold.hull_points((one[:, None] - other).reshape(-1, 3)).to_mesh64()
    points = np.asarray(mesh.vert_properties)[:, :3]
    a, b, c = points[np.asarray(mesh.tri_verts).astype(int)].transpose(1, 0, 2)
    normals = np.cross(b - a, c - a)
    lengths = np.linalg.norm(normals, axis=1)
    sides = lengths > 1e-9 * lengths.max()
    normals, a = normals[sides] / lengths[sides, None], a[sides]
    far = np.einsum('ij,ij->i', normals, a)
    least = int(np.argmin(np.round(far, 6)))
    return max(0.0, float(far[least])), -normals[least]


def _where_to_move(robot: BuiltRobot, module: Module) -> str:
    """The key of the assembly that moves a module."""
    if module.words.kind == 'foot':
        return 'foot_offset of its [[limb]]'
    if module.body != robot.trunk:
        return 'offset of its joint in its [[limb]]'
    is_servo = module.words.kind == 'servo'
    return 'hip or step of its [[limb]]' if is_servo else 'position of its [[part]]'


def _direction(way: Array) -> str:
    """In words, in the axes of the world."""
    axis = int(np.argmax(np.abs(way)))
    if abs(way[axis]) > _ALONG:
        return f'{"+" if way[axis] > 0 else "-"}{"xyz"[axis]}'
    return ' '.join(f'{value + 0.0:.2f}' for value in way)


def _remedy(robot: BuiltRobot, one: Module, other: Module, depth: float, way: Array) -> str:
    ways = [
        f'{each.of} to {_direction(to)} ({_where_to_move(robot, each)})'
        for each, to in ((one, way), (other, -way))
    ]
    least = math.ceil(10 * depth - 1e-3) / 10
    return (
        f'move {ways[0]} or {ways[1]} in the assembly, by {least:.1f} mm or more, or take smaller '
        'modules'
    )


def check_modules_clear(robot: BuiltRobot) -> list[Check]:
    """A check for each pair whose outlines are more than half a millimetre into each other.

    Where there is none a single one, of the pair that is deepest.
    """
    failed: list[Check] = []
    deepest, where = 0.0, ''
    for one, other in itertools.combinations(_standing(robot), 2):
        common = one.solid ^ other.solid
        if common.is_empty() or common.volume() <= 0:
            continue
        found = [depth_of(a, b) for a in one.corners for b in other.corners]
        depth, way = max(found, key=lambda each: each[0])
        size = np.ptp(np.array(common.bounding_box()).reshape(2, 3), axis=0)
        box = ' x '.join(f'{side:.1f}' for side in size)
        words = f'{one.module.of} and {other.module.of}, {box} mm of them'
        remedy = _remedy(robot, one.module, other.module, depth, way)
        check = at_most('', _NAME, depth, _MOST, _UNIT, words, remedy)
        if not check.passed:
            failed.append(check)
        elif depth > deepest:
            deepest, where = depth, words
    return failed or [at_most('', _NAME, deepest, _MOST, _UNIT, where, '')]
