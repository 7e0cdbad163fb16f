# SPDX-License-Identifier: Apache-2.0
"""The number of each part, engraved where a flat side has room: that of its row in the bill."""

import dataclasses
import functools
import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from manifold3d import Manifold
from numpy.typing import NDArray

from legwright.parts._digits import needs_bar, strokes, width
from legwright.parts._holes import driver_way
from legwright.parts._printing import Faces, turn_down
from legwright.parts._robot import BuiltRobot
from legwright.parts._shapes import MM, joined, outline, placed
from legwright.parts._solids import Mark, Part, Solid
from legwright.parts._words import Array

DEPTH = 0.4
"""Of the strokes [mm]: two layers."""
HEIGHTS = (10.0, 8.0, 6.0, 5.0)
"""Of digits [mm]; the largest that finds room."""
_STROKE = 0.1  # of the height, and at least
_LEAST_STROKE = 0.8  # [mm]: two widths of a nozzle
_RIDGE = 1.1  # times the least wall: between strokes, to the side's edge, and behind the strokes
_GAP = 0.3  # of the height, at least: between the middle lines of two digits
_SIDES = 16  # that are looked at, by area
_LEAST_SIDE = 30.0  # [mm2]
_FLAT = 0.02  # [mm]
_SAME_WAY = 1e-3  # of normals that are one direction
_POINTS = 2500  # at which a side is looked at, at most
_CLEAR = 300.0  # [mm] before a side: whoever reads a number looks from there
_DOWN = 0.7  # cosine: a side that looks down that much is the last choice


@dataclass(frozen=True)
class _Side:
    """A flat side: rows of `turn` are its long direction, the other, and its normal."""

    turn: Array
    height: float
    """Along the normal [mm]."""
    low: Array
    high: Array
    """Of the box around it, in its plane [mm]."""
    area: float


@dataclass(frozen=True)
class _Room:
    """What a number takes on a side [mm]."""

    number: int
    height: float
    ridge: float

    @property
    def stroke(self) -> float:
        return max(_STROKE * self.height, _LEAST_STROKE)

    @property
    def gap(self) -> float:
        return max(_GAP * self.height, self.ridge + self.stroke)

    @property
    def bar(self) -> float:
        """From the lowest stroke to a bar below it; 0 where none is needed."""
        return self.ridge + self.stroke if needs_bar(self.number) else 0.0

    @property
    def size(self) -> Array:
        """With the ridge around it."""
        wide = width(self.number, self.height, self.gap)
        return np.array([wide, self.height + self.bar]) + self.stroke + 2 * self.ridge

    @property
    def stays(self) -> bool:
        """Whether what stays between two strokes of a digit is thick enough."""
        return self.height / 2 - self.stroke >= self.ridge


def _sides(shape: Manifold) -> list[_Side]:
    """The flat sides of a solid, the largest first."""
    faces, out = Faces(shape), []
    left = faces.areas.copy()
    offsets = np.einsum('ij,ij->i', faces.normals, faces.corners[:, 0])
    while left.max() > 1.0:
        k = int(left.argmax())
        normal = faces.normals[k]
        same = np.linalg.norm(faces.normals - normal, axis=1) < _SAME_WAY
        same &= (np.abs(offsets - offsets[k]) < _FLAT) & (left > 0)
        area = float(left[same].sum())
        left[same] = 0.0
        if area < _LEAST_SIDE:
            continue
        corners = faces.corners[same].reshape(-1, 3)
        turn = turn_down(-normal, corners)
        flat = corners @ turn[:2].T
        out.append(_Side(turn, float(offsets[k]), flat.min(axis=0), flat.max(axis=0), area))
    out.sort(key=lambda each: -round(each.area, 3))
    return out[:_SIDES]


def _around(robot: BuiltRobot, solid: Solid) -> Manifold:
    """What hides a side: the part itself, its modules, heads of screws and the drivers' ways."""
    link = solid.link
    things = [solid.shape, *(outline(module) for module in link.modules)]
    if link.servo:
        shift = -MM * robot.model.body_pos[link.body]
        things.append(outline(link.servo).translate(tuple(shift)))
    return joined([*things, *(driver_way(hole) for hole in solid.holes)])


def _free(side: _Side, shape: Manifold, around: Manifold, deep: float) -> tuple[Array, NDArray]:
    """Points of a side as a grid, and at which of them it is there, thick enough and in sight."""
    size = side.high - side.low
    step = max(0.5, math.sqrt(float(size.prod()) / _POINTS))
    counts = np.maximum(1, np.floor(size / step)).astype(int)
    first = (side.low + side.high - step * (counts - 1)) / 2
    axes = [first[k] + step * np.arange(counts[k]) for k in range(2)]
    free = np.zeros(counts, dtype=bool)
    for i, j in itertools.product(*map(range, counts)):
        at = np.array([axes[0][i], axes[1][j], side.height]) @ side.turn
        normal = side.turn[2]
        start = at + _FLAT * normal
        hits = shape.ray_cast(tuple(start), tuple(at - deep * normal))
        if len(hits) == 1 and abs(hits[0].position @ normal - side.height) < _FLAT:
            free[i, j] = not around.ray_cast(tuple(start), tuple(at + _CLEAR * normal))
    return np.array([*first, step]), free


def _windows(free: NDArray, cells: Sequence[int]) -> list[tuple[int, int]]:
    """Where a window of so many cells is free, those nearest to the middle of all that is first."""
    if any(cells[k] > free.shape[k] for k in range(2)) or not free.any():
        return []
    sums = np.zeros(np.array(free.shape) + 1, dtype=int)
    sums[1:, 1:] = free.cumsum(axis=0).cumsum(axis=1)
    a, b = cells
    inside = sums[a:, b:] - sums[:-a, b:] - sums[a:, :-b] + sums[:-a, :-b]
    found = np.argwhere(inside == a * b)
    middle = np.argwhere(free).mean(axis=0)
    far = np.linalg.norm(found + (np.array(cells) - 1) / 2 - middle, axis=1)
    return [tuple(found[k]) for k in np.argsort(np.round(far, 6), kind='stable')[:8]]


def _is_whole(mark: Mark, room: _Room, shape: Manifold, deep: float) -> bool:
    """Whether a number's box has material all behind it, and none before it."""
    wide, high = room.size - 0.01
    behind = Manifold.cube((wide, high, deep - 0.01), True).translate((0, 0, -deep / 2 - 0.005))
    before = Manifold.cube((wide, high, 1.0), True).translate((0, 0, 0.5 + _FLAT))
    frame = np.column_stack([mark.along, mark.up, mark.normal])
    lacks = placed(behind, frame, mark.centre) - shape
    return lacks.volume() < 0.01 and (placed(before, frame, mark.centre) ^ shape).volume() < 0.01


def _places(
    room: _Room, side: _Side, grid: Array, free: NDArray, wall: float
) -> Iterator[Mark]:
    """Where a number finds room, along a side and across it."""
    x, y, normal = side.turn
    for across in (False, True):
        size = room.size[::-1] if across else room.size
        cells = [math.ceil(float(each) / grid[2]) + 1 for each in size]
        for window in _windows(free, cells):
            at = grid[:2] + grid[2] * (np.array(window) + (np.array(cells) - 1) / 2)
            centre = np.array([*at, side.height]) @ side.turn
            along, up = (y, -x) if across else (x, y)
            yield Mark(room.number, room.height, wall, centre, normal, along, up)


def find_mark(robot: BuiltRobot, part: Part, number: int, wall: float) -> Mark | None:
    """Where a number has room on a part; None where nowhere.

    On a flat side that is in sight once all is put together, with so much material behind and
    around that the least wall stays. Sides that do not look down on the bed come first, then larger
    digits, then larger sides.
    """
    solid, down = part.solid, part.lying.down
    ridge = _RIDGE * wall
    deep = DEPTH + ridge
    around = _around(robot, solid)
    sides = _sides(solid.shape)

    @functools.cache  # most numbers are on one of the first sides that are asked
    def free_of(k: int) -> tuple[Array, NDArray]:
        return _free(sides[k], solid.shape, around, deep)

    for looks_down, height in itertools.product((False, True), HEIGHTS):
        room = _Room(number, height, ridge)
        for k, side in enumerate(sides):
            if not room.stays or (side.turn[2] @ down > _DOWN) != looks_down:
                continue
            for mark in _places(room, side, *free_of(k), wall):
                if _is_whole(mark, room, solid.shape, deep):
                    return mark
    return None


def engraving(mark: Mark) -> Manifold:
    """What a number takes away, in the frame of the link."""
    room = _Room(mark.number, mark.height, _RIDGE * mark.wall)
    wide = width(mark.number, mark.height, room.gap)
    lines = [(s.start, s.end) for s in strokes(mark.number, mark.height, room.gap)]
    if room.bar:
        lines.append(((0.0, -room.bar), (wide, -room.bar)))
    middle = np.array([wide, mark.height - room.bar]) / 2
    boxes = []
    for start, end in lines:
        a, b = np.array(start) - middle, np.array(end) - middle
        size = np.abs(b - a) + room.stroke
        box = Manifold.cube((*size, 1.0 + DEPTH), True)
        boxes.append(box.translate((*((a + b) / 2), (1.0 - DEPTH) / 2)))
    return placed(
        joined(boxes), np.column_stack([mark.along, mark.up, mark.normal]), mark.centre
    )


def _engraved(robot: BuiltRobot, part: Part, number: int, wall: float) -> Part:
    mark = find_mark(robot, part, number, wall)
    numbered = dataclasses.replace(part, number=number, mark=mark, down=part.lying.down)
    if mark is None:
        return numbered
    cutter = engraving(mark)
    solids = []
    for solid in part.solids:
        shape = solid.shape - cutter
        taken = solid.shape.volume() - shape.volume()
        solids.append(dataclasses.replace(solid, shape=shape, number_volume=taken))
    return dataclasses.replace(numbered, solids=tuple(solids))


def numbered_parts(
    robot: BuiltRobot, parts: Sequence[Part], first: int, wall: float
) -> list[Part]:
    """The parts with their numbers from `first` on, engraved where there is room."""
    return [_engraved(robot, part, first + k, wall) for k, part in enumerate(parts)]
