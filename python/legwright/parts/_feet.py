# SPDX-License-Identifier: Apache-2.0
"""How a ball foot is held: a peg of the part, on which the foot is pressed with its socket."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from manifold3d import Manifold

from legwright.parts._holes import Fixing
from legwright.parts._shapes import MM, frame_along, outline, placed, rod
from legwright.parts._words import Array

_THICK = 0.3  # of the ball's radius: that of the peg
_BEYOND = 1.0  # [mm]: so much deeper than the peg is long the socket is
_IN_THE_PART = 1.5  # [mm]: where a peg begins, behind the seat
_SEGMENTS = 64


@dataclass(frozen=True)
class Peg:
    """A peg, in the frame of the link [mm]."""

    fixing: Fixing
    start: Array
    """The foot's attachment: the middle of the socket's mouth."""
    axis: Array
    """Into the foot."""
    radius: float
    length: float
    """Beyond the mouth: to the ball's middle."""
    begins: float
    """How far before the mouth the part begins."""


def peg_of(fixing: Fixing, begins: float) -> Peg | None:
    """The peg for a foot that is one ball and has no screws; None for all others.

    @param begins how far before the attachment the part begins [mm]
    """
    shapes = fixing.module.shapes
    is_ball = len(shapes) == 1 and shapes[0].kind == 'sphere'
    if fixing.module.words.kind != 'foot' or not is_ball or fixing.place.screw is not None:
        return None
    ball = MM * float(shapes[0].size[0])
    start, middle = MM * fixing.position, MM * shapes[0].position
    way = middle - start
    if abs(float(np.linalg.norm(way)) - ball) > 0.1 * ball:
        return None  # an attachment that is not on the ball
    return Peg(fixing, start, way / np.linalg.norm(way), _THICK * ball, ball, begins)


def peg_solid(peg: Peg) -> Manifold:
    """What a part has more."""
    before = peg.begins + _IN_THE_PART
    start = peg.start - before * peg.axis
    return rod(start, peg.axis, before + peg.length, peg.radius, _SEGMENTS)


def socket_size(peg: Peg, press: float) -> tuple[float, float]:
    """Diameter and depth of a socket: narrower than the peg by the press, and deeper [mm]."""
    return 2 * peg.radius - press, peg.length + _BEYOND


def foot_solid(peg: Peg, press: float) -> Manifold:
    """A foot with its socket, which opens upwards; its lowest point at zero [mm]."""
    wide, deep = socket_size(peg, press)
    socket = rod(peg.start - peg.axis, peg.axis, deep + 1.0, wide / 2, _SEGMENTS)
    shape = outline(peg.fixing.module) - socket
    upright = placed(shape, frame_along(-peg.axis).T, np.zeros(3))
    return upright.translate(tuple(-np.array(upright.bounding_box()[:3])))


def feet_of(pegs: Sequence[Peg]) -> dict[str, Peg]:
    """One peg for each module that is a foot, by its name."""
    out: dict[str, Peg] = {}
    for peg in pegs:
        out.setdefault(peg.fixing.module.words.name, peg)
    return out
