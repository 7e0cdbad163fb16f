# SPDX-License-Identifier: Apache-2.0
"""Solids of simple shapes, in millimetres: manifold3d's. All of them are closed and oriented."""

import math

import numpy as np
from manifold3d import Manifold, OpType

from legwright.parts._robot import Hull, Module, Shape
from legwright.parts._words import Array

MM = 1e3
"""Millimetres of a metre."""
_ROUND = 64
"""Segments of a circle of the modules."""
_CHIP = 0.01  # of a solid; what falls off and is smaller is left out


def placed(solid: Manifold, turn: Array, position: Array) -> Manifold:
    """A solid that is turned (3 x 3), then moved [mm]."""
    return solid.transform(np.column_stack([turn, position]))


def frame_along(axis: Array) -> Array:
    """A right-handed frame (3 x 3) whose z is that unit vector."""
    other = np.eye(3)[np.argmin(np.abs(axis))]
    x = np.cross(other, axis)
    x /= np.linalg.norm(x)
    return np.column_stack([x, np.cross(axis, x), axis])


def rod(start: Array, axis: Array, length: float, radius: float, segments: int) -> Manifold:
    """A cylinder from a point along a unit vector, whose facets touch the circle from outside."""
    outside = radius / math.cos(math.pi / segments)
    return placed(Manifold.cylinder(length, outside, -1.0, segments), frame_along(axis), start)


def grown(shape: Shape, by: float) -> Manifold:
    """A shape of an outline, larger by a clearance on all sides; round ones from outside [mm]."""
    size = MM * shape.size + by
    if shape.kind == 'box':
        solid = Manifold.cube(2 * size, True)
    elif shape.kind == 'cylinder':
        outside = size[0] / math.cos(math.pi / _ROUND)
        solid = Manifold.cylinder(2 * size[1], outside, -1.0, _ROUND, True)
    else:
        solid = Manifold.sphere(size[0] / math.cos(math.pi / _ROUND) ** 2, _ROUND)
    return placed(solid, shape.turn, MM * shape.position)


def outline(module: Module, by: float = 0.0) -> Manifold:
    """A module's outline in the frame of what carries it [mm]."""
    return Manifold.batch_boolean([grown(shape, by) for shape in module.shapes], OpType.Add)


def hull(of: Hull) -> Manifold:
    """A connector's hull in the frame of its link [mm]."""
    return Manifold.hull_points(MM * of.points)


def joined(solids: list[Manifold]) -> Manifold:
    """Their union."""
    return Manifold.batch_boolean(solids, OpType.Add)


def whole(shape: Manifold) -> tuple[Manifold, int]:
    """A solid without its chips, and how many pieces it has then."""
    pieces = shape.decompose()
    if len(pieces) <= 1:
        return shape, len(pieces)
    least = _CHIP * shape.volume()
    kept = [piece for piece in pieces if piece.volume() >= least]
    return joined(kept), len(kept)
