# SPDX-License-Identifier: Apache-2.0
"""Where numbers stand in a picture: beside their things, before all, on nothing else."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import mujoco
import numpy as np
from manifold3d import CrossSection

from legwright.parts._digits import width
from legwright.parts._robot import matrix
from legwright.parts._words import Array

_AZIMUTH, _ELEVATION = math.radians(215.0), math.radians(-16.0)  # of the program's pictures
_FIELD, _MARGIN = math.radians(24.0), 0.12  # vertical; what is left free
_C, _S = math.cos(_ELEVATION), math.sin(_ELEVATION)
AWAY = np.array([_C * math.cos(_AZIMUTH), _C * math.sin(_AZIMUTH), _S])
RIGHT = np.array([math.sin(_AZIMUTH), -math.cos(_AZIMUTH), 0.0])
UP = np.cross(RIGHT, AWAY)
_HALF_HEIGHT = math.tan(_FIELD / 2) * (1.0 - _MARGIN)
_HALF_WIDTH = _HALF_HEIGHT * 4.0 / 3.0
GAP = 0.3  # of a number's height: between its digits
_HEIGHT = 0.055  # of a number, of half the picture's width
_ROOM = 0.35  # of the height: around a number
_BEFORE = 0.7  # of the way to the nearest thing: shadows of numbers fall out of the picture
_PASSES = 3  # numbers move the camera a little, and the camera them
_WAYS = 24  # directions in which a number is looked for
_TILTS, _YAWS = (14.0, 20.0, 26.0, 32.0), (0.0, 8.0, -8.0, 16.0, -16.0, 24.0, -24.0)  # [deg]
_STEPS = 40  # and distances, of half a height each


@dataclass(frozen=True)
class Thing:
    """Something in the picture: its corners (N x 3, in the world) and, perhaps, its number."""

    corners: Array
    number: int | None


@dataclass(frozen=True)
class Label:
    """A number in the world: its lower left corner, and what it points to, before all things."""

    number: int
    height: float
    corner: Array
    target: Array


class Camera:
    """The program's, which stands as near as all points can be seen from."""

    def __init__(self, points: Array) -> None:
        self.look, self.distance = points.mean(axis=0), 1.0
        sides = np.column_stack([RIGHT, UP, AWAY])
        middle = (points @ sides).min(axis=0) + np.ptp(points @ sides, axis=0) / 2
        self.look = sides @ middle
        for _ in range(11):
            u, v, w = ((points - self.look) @ sides).T
            self.distance = max(
                float((np.abs(u) / _HALF_WIDTH - w).max()),
                float((np.abs(v) / _HALF_HEIGHT - w).max()),
            )
            seen = self.seen(points)
            centre = seen.min(axis=0) + np.ptp(seen, axis=0) / 2
            self.look = self.look + self.distance * (centre[0] * RIGHT + centre[1] * UP)

    def depth(self, points: Array) -> Array:
        """How far away points are [m]."""
        return self.distance + (points - self.look) @ AWAY

    def seen(self, points: Array) -> Array:
        """N x 2: to the right and up, as tangents."""
        off = points - self.look
        return np.column_stack([off @ RIGHT, off @ UP]) / self.depth(points)[:, None]

    def lifted(self, place: Array, depth: float) -> Array:
        """The point that is seen there, so far away."""
        away = (depth - self.distance) * AWAY
        return self.look + away + depth * (place[0] * RIGHT + place[1] * UP)


def _box(middle: Array, size: Array) -> CrossSection:
    return CrossSection.square(tuple(size), True).translate(tuple(middle))


def _stick(start: Array, end: Array, thick: float) -> CrossSection:
    along = (end - start) / max(1e-9, float(np.linalg.norm(end - start)))
    side = thick / 2 * np.array([-along[1], along[0]])
    return CrossSection.hull_points(np.vstack([start - side, start + side, end - side, end + side]))


def _touch(one: CrossSection, others: Sequence[CrossSection]) -> bool:
    left, low, right, high = one.bounds()
    for other in others:
        x, y, to_x, to_y = other.bounds()  # most are far away
        if x < right and to_x > left and y < high and to_y > low and (one ^ other).area() > 1e-9:
            return True
    return False


class _Page:
    """The picture while numbers are put on it."""

    def __init__(self, camera: Camera, things: Sequence[Thing]) -> None:
        seen = [camera.seen(thing.corners) for thing in things]
        self._shapes = [CrossSection.hull_points(points) for points in seen]
        self._middles = [(s.min(axis=0) + s.max(axis=0)) / 2 for s in seen]
        self._depths = [float(camera.depth(thing.corners).mean()) for thing in things]
        self._seen = seen
        self._things = things
        self._height = _HEIGHT * _HALF_WIDTH
        self._taken: list[CrossSection] = []
        self._leaders: list[CrossSection] = []

    def run(self) -> list[tuple[int, Array, Array]]:
        """Of each numbered thing its place in `things`, the number's middle and what it shows."""
        order = [k for k, thing in enumerate(self._things) if thing.number is not None]
        order.sort(key=lambda k: (round(-float(self._middles[k][1]), 6), k))
        return [(k, *self._put(k)) for k in order]

    def size(self, number: int) -> Array:
        wide = width(number, self._height, GAP * self._height)
        return np.array([wide, self._height]) + 2 * _ROOM * self._height

    def _target(self, k: int) -> Array:
        """A point of a thing that nothing nearer hides."""
        middle, nearer, own = self._middles[k], [], 0.5 * self._shapes[k].area()
        for j, shape in enumerate(self._shapes):
            if j != k and (self._depths[j] < self._depths[k] or shape.area() < own):
                nearer.append(shape)  # or something that may stand in it
        corners = self._seen[k][:200]
        points = [middle, *(middle + s * (p - middle) for s in (0.7, 0.92) for p in corners)]
        dot = np.full(2, 0.1 * self._height)
        for point in points:
            if not _touch(_box(point, dot), nearer):
                return point
        return middle

    def _candidates(self, k: int, target: Array, size: Array) -> Iterator[Array]:
        for step in range(_STEPS):
            for way in range(_WAYS):
                turn = math.pi / 3 + (-1) ** way * (way + 1) // 2 * 2 * math.pi / _WAYS
                along = np.array([math.cos(turn), math.sin(turn)])
                edge = float(((self._seen[k] - target) @ along).max())
                reach = edge + float(np.abs(along) @ size) / 2 + (step + 0.6) * self._height / 2
                yield target + reach * along

    def _put(self, k: int) -> tuple[Array, Array]:
        target = self._target(k)
        size = self.size(self._things[k].number or 0)
        others = [shape for j, shape in enumerate(self._shapes) if j != k]
        chosen = None
        for place in self._candidates(k, target, size):
            box = _box(place, size)
            leader = _stick(place, target, 0.2 * self._height)
            if _touch(box, [*self._shapes, *self._taken, *self._leaders]):
                continue
            if _touch(leader, [*self._taken, *self._leaders]):
                continue
            if not _touch(leader, others):
                chosen = place
                break
            chosen = place if chosen is None else chosen
        if chosen is None:
            chosen = next(self._candidates(k, target, size))
        self._taken.append(_box(chosen, size))
        self._leaders.append(_stick(chosen, target, 0.2 * self._height))
        return chosen, target


def hidden(things: Sequence[Thing]) -> float:
    """How much of things others hide, or hide each other's outlines: a sum of shares."""
    points = np.vstack([thing.corners for thing in things])
    camera = Camera(points)
    shapes = [CrossSection.hull_points(camera.seen(thing.corners)) for thing in things]
    areas = [shape.area() for shape in shapes]
    out = 0.0
    for one in range(len(things)):
        for other in range(one):
            both = (shapes[one] ^ shapes[other]).area()
            out += both / max(min(areas[one], areas[other]), 1e-12)
    return out


def clearest_turn(things: Sequence[Thing]) -> Array:
    """Of turns about the vertical and tilts towards the reader the one that hides least (3 x 3)."""
    best, least = np.eye(3), math.inf
    for tilt in _TILTS:
        for yaw in _YAWS:
            turn = _about(RIGHT, tilt) @ _about(np.array([0.0, 0.0, 1.0]), yaw)
            turned = [Thing(thing.corners @ turn.T, None) for thing in things]
            cost = round(hidden(turned), 6)
            if cost < least:
                best, least = turn, cost
    return best


def _about(axis: Array, degrees: float) -> Array:
    quat = np.zeros(4)
    mujoco.mju_axisAngle2Quat(quat, axis, math.radians(degrees))
    return matrix(quat)


def labels_of(things: Sequence[Thing]) -> list[Label]:
    """A label for each thing that has a number.

    Numbers stand in a plane before all things, so that nothing hides them, on no thing and no other
    number; lines to what they are of cross none, and no other thing where that is possible.
    """
    extra = np.zeros((0, 3))
    out: list[Label] = []
    for _ in range(_PASSES):
        points = np.vstack([*(thing.corners for thing in things), extra])
        camera = Camera(points)
        page = _Page(camera, things)
        depth = _BEFORE * float(camera.depth(np.vstack([t.corners for t in things])).min())
        height, out, corners = page._height * depth, [], []
        for k, place, target in page.run():
            number = things[k].number or 0
            size = page.size(number)
            corner = place - size / 2 + _ROOM * page._height
            out.append(
                Label(number, height, camera.lifted(corner, depth), camera.lifted(target, depth))
            )
            corners += [camera.lifted(place + s * size / 2, depth) for s in (-1, 1)]
        extra = np.array(corners).reshape(-1, 3)
    return out
