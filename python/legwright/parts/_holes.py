# SPDX-License-Identifier: Apache-2.0
"""Screw holes of a part: where modules say, through what is there, with room for head and driver.

Sizes: ISO 273 (clearance holes, medium) and ISO 4762 (cap heads).
"""

import itertools
import math
from dataclasses import dataclass

import numpy as np
from manifold3d import Manifold

from legwright.parts._robot import BuiltRobot, Link, Module
from legwright.parts._shapes import MM, frame_along, rod
from legwright.parts._words import Array, Place


@dataclass(frozen=True)
class Screw:
    """A cap screw [mm]."""

    nominal: float
    clearance: float
    """Diameter of its hole."""
    head: float
    """Diameter of the head."""
    height: float
    """Of the head."""


SCREWS = {
    'M1.6': Screw(1.6, 1.8, 3.0, 1.6),
    'M2': Screw(2.0, 2.4, 3.8, 2.0),
    'M2.5': Screw(2.5, 2.9, 4.5, 2.5),
    'M2.6': Screw(2.6, 3.0, 4.7, 2.6),
    'M3': Screw(3.0, 3.4, 5.5, 3.0),
    'M4': Screw(4.0, 4.5, 7.0, 4.0),
    'M5': Screw(5.0, 5.5, 8.5, 5.0),
    'M6': Screw(6.0, 6.6, 10.0, 6.0),
}
_SEGMENTS = 32
_HEAD_PLAY = 0.3  # [mm], around a head and its driver
_DRIVER = 80.0  # [mm], how far along its axis a driver must come
_CLAMPED = 1.25  # times the nominal diameter: what a head presses on where it is let in
_DEEP = 4.0  # times the nominal diameter: through more a head is let in wherever it is
REACH = 6.0  # [mm] before an attachment, within which what it holds begins
_SAMPLED = 48  # directions around a hole
_BEHIND = 0.05  # [mm] where a part begins


@dataclass(frozen=True)
class Fixing:
    """An attachment that a part covers, in the frame of the link."""

    module: Module
    place: Place
    position: Array
    normal: Array
    holes: Array
    """N x 3 [m]; none where the pattern is not known."""


@dataclass(frozen=True)
class Hole:
    """A hole for a screw, in the frame of the link [mm]."""

    fixing: Fixing
    screw: Screw
    start: Array
    """On the module's face."""
    axis: Array
    """Towards the head."""
    begins: float
    """How far from there material begins: what the screw has to bridge."""
    clamped: float
    """Thickness under the head; 0 where the part has nothing there."""
    edge: float
    """Least material between hole and edge; negative where the hole breaks out."""
    apart: float
    """Least material to another hole of the attachment, between heads where they are let in."""

    @property
    def seat(self) -> float:
        """From the module's face to the head."""
        return self.begins + self.clamped


def _hits(solid: Manifold, start: Array, axis: Array, length: float) -> list[float]:
    """Distances at which a ray crosses the surface."""
    hits = solid.ray_cast(tuple(start), tuple(start + length * axis))
    return [float(np.dot(np.asarray(hit.position) - start, axis)) for hit in hits]


def is_covered(solid: Manifold, position: Array, normal: Array) -> bool:
    """Whether material begins before an attachment [mm]."""
    return bool(_hits(solid, position - 0.5 * normal, normal, REACH + 0.5))


def gap_before(solid: Manifold, place: Place) -> float:
    """How far before an attachment material begins, also where that is too far [mm]."""
    hits = _hits(solid, MM * place.position, place.normal, 1e3)
    return hits[0] if hits else math.inf


def fixings_of(robot: BuiltRobot, link: Link, solid: Manifold) -> list[Fixing]:
    """The attachments that the solid of a link covers: of modules on it, and of the horn below it.

    At the horn with the joint at zero, as the file draws it.
    """
    out = []
    model = robot.model
    for module in (*link.modules, *([link.servo] if link.servo else [])):
        turns = module is link.servo
        shift = model.body_pos[link.body] if turns else np.zeros(3)
        for place in module.places:
            if place.on_horn != turns:
                continue
            position = place.position - shift
            if is_covered(solid, MM * position, place.normal):
                holes = place.holes - shift
                out.append(Fixing(module, place, position, place.normal, holes))
    return out


def begins_at(solid: Manifold, fixing: Fixing) -> float:
    """How far before an attachment that it covers a part begins [mm]."""
    hits = _hits(solid, MM * fixing.position - 0.5 * fixing.normal, fixing.normal, REACH + 0.5)
    return max(0.0, hits[0] - 0.5) if hits else 0.0


def _edge(solid: Manifold, start: Array, axis: Array, clamped: float, radius: float) -> float:
    """From a hole's rim to the nearest side of what it goes through [mm]."""
    frame = frame_along(axis)
    least = math.inf
    for share in (0.1, 0.5, 0.9):
        centre = start + share * clamped * axis
        for k in range(_SAMPLED):
            turn = 2 * math.pi * k / _SAMPLED
            way = math.cos(turn) * frame[:, 0] + math.sin(turn) * frame[:, 1]
            hits = _hits(solid, centre, way, 1e3)
            least = min(least, hits[0] if len(hits) % 2 else 0.0)
    return least - radius


def reach_at_face(solid: Manifold, fixing: Fixing, begins: float) -> float:
    """How far a part reaches around an attachment, where it begins; the least of all directions."""
    frame = frame_along(fixing.normal)
    centre = MM * fixing.position + (begins + _BEHIND) * fixing.normal
    least = math.inf
    for k in range(_SAMPLED):
        turn = 2 * math.pi * k / _SAMPLED
        way = math.cos(turn) * frame[:, 0] + math.sin(turn) * frame[:, 1]
        least = min(least, max(_hits(solid, centre, way, 1e3), default=0.0))
    return least


def _lets_in(
    solid: Manifold, first: Array, axis: Array, thick: float, screw: Screw, wall: float
) -> bool:
    """Whether a head finds room in what a screw goes through, with a wall around it."""
    under = _CLAMPED * screw.nominal
    if thick < under + 0.5 * screw.height:
        return False
    room = _edge(solid, first + under * axis, axis, thick - under, screw.head / 2 + _HEAD_PLAY)
    return room >= wall


def holes_of(fixing: Fixing, solid: Manifold, wall: float) -> list[Hole]:
    """The holes of an attachment through a solid that has none yet.

    Heads are let in where all of them find room; those that go through much, or through a slanted
    side, are let in anyway.
    """
    if fixing.place.screw is None:
        return []
    screw, axis = SCREWS[fixing.place.screw], fixing.normal
    ways: list[tuple[Array, float, float]] = []  # of each hole start, where material begins, ends
    for point in fixing.holes:
        start = MM * point
        hits = [hit - 0.01 for hit in _hits(solid, start - 0.01 * axis, axis, 1e3)]
        is_there = len(hits) >= 2 and hits[0] <= REACH
        ways.append((start, max(0.0, hits[0]), hits[1]) if is_there else (start, 0.0, 0.0))
    pairs = itertools.combinations(MM * fixing.holes, 2)
    spacing = min((math.dist(one, other) for one, other in pairs), default=math.inf)
    around_head = screw.head + 2 * _HEAD_PLAY
    sunk = spacing - around_head >= wall and all(
        _lets_in(solid, start + begins * axis, axis, ends - begins, screw, wall)
        for start, begins, ends in ways
    )
    out = []
    for start, begins, ends in ways:
        clamped, width, radius = ends - begins, screw.clearance, screw.clearance / 2
        first, seat = start + begins * axis, _CLAMPED * screw.nominal
        edge = _edge(solid, first, axis, clamped, radius) if clamped else -radius
        is_slanted = edge < wall and clamped > seat  # a side comes near above where a head may sit
        if sunk or clamped > _DEEP * screw.nominal or is_slanted:
            width, clamped = around_head, seat
            edge = _edge(solid, first, axis, clamped, radius)
        out.append(Hole(fixing, screw, start, axis, begins, clamped, edge, spacing - width))
    return out


def drilled(hole: Hole) -> Manifold:
    """What a hole takes away: the shank's way, and the head's and its driver's from the seat on."""
    below = 1.0  # [mm] into the module, so that no skin is left
    shank = rod(
        hole.start - below * hole.axis,
        hole.axis,
        hole.seat + 2 * below,
        hole.screw.clearance / 2,
        _SEGMENTS,
    )
    return shank + driver_way(hole)


def driver_way(hole: Hole) -> Manifold:
    """What head and driver need, from the seat on."""
    radius = hole.screw.head / 2 + _HEAD_PLAY
    return rod(hole.start + hole.seat * hole.axis, hole.axis, _DRIVER, radius, _SEGMENTS)
