# SPDX-License-Identifier: Apache-2.0
"""How a part lies on the printer's bed, and what that costs: overhang, supports, time."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from manifold3d import Manifold

from legwright.parts._words import Array

_STEEP = math.cos(math.radians(45.0))  # a face that looks down more than that needs support
_ON_THE_BED = 0.02  # [mm] above the lowest point
_ONE_FACE = 1e-3  # of normals that are one direction
_MOST_FACES = 40  # directions that are tried, by area
_LEAST_CONTACT = 0.05  # of its box: what touches less of the bed comes loose
_FIRM = 0.5  # of the square of its height: what touches less tips when the nozzle pushes
_LOW = 0.5  # of the length: so high a part lies, higher ones stand
_SUPPORT_FILL = 0.15  # of the room below an overhang
_LAYER = 0.2  # [mm]
_FLOW = 4.0  # [mm3/s], filled, as a slicer with its own defaults came to
_LAYER_CHANGE = 3.0  # [s]


@dataclass(frozen=True)
class Lying:
    """A part as it is printed: which of its directions looks down, and what comes of it."""

    turn: Array
    """3 x 3: bed from link."""
    size: Array
    """Of its box on the bed [mm]."""
    contact: float
    """Area on the bed [mm2]."""
    overhang: float
    """Area that looks down steeper than 45 degrees, off the bed [mm2]."""
    support: float
    """Volume of support [mm3]: the room below overhangs down to the bed, filled by 15 %."""
    seconds: float
    """(volume + support) / 4 mm3/s, and 3 s for each layer of 0.2 mm."""

    @property
    def down(self) -> Array:
        """The direction of the link that looks down."""
        return -self.turn[2]

    @property
    def is_firm(self) -> bool:
        """Whether it touches so much of the bed that it neither comes loose nor tips."""
        least = max(_LEAST_CONTACT * self.size[0] * self.size[1], _FIRM * self.size[2] ** 2)
        return bool(self.contact >= least)

    def fits(self, bed: Sequence[float], margin: float = 0.0) -> bool:
        """Whether the box fits the bed with that margin, turned by a quarter if need be."""
        size = self.size - 1e-6
        flat, room = sorted(size[:2]), sorted(side - 2 * margin for side in bed[:2])
        return bool(flat[0] <= room[0] and flat[1] <= room[1] and size[2] <= bed[2])

    def room(self, bed: Sequence[float]) -> float:
        """How much of the bed is left at each side of the box, in its middle [mm]."""
        flat, room = sorted(self.size[:2]), sorted(bed[:2])
        return float(min(room[0] - flat[0], room[1] - flat[1])) / 2


class Faces:
    """Triangles of a solid: normals, areas and corners."""

    def __init__(self, shape: Manifold) -> None:
        mesh = shape.to_mesh64()
        points = np.asarray(mesh.vert_properties)[:, :3]
        self.corners = points[np.asarray(mesh.tri_verts).astype(int)]
        a, b, c = self.corners.transpose(1, 0, 2)
        across = np.cross(b - a, c - a)
        twice = np.linalg.norm(across, axis=1)
        self.areas = twice / 2
        self.normals = across / np.where(twice > 0, twice, 1)[:, None]


def _directions(shape: Manifold) -> list[Array]:
    """Those that may look down: normals of the flat sides of the hull, the largest first."""
    faces = Faces(shape.hull())
    found: list[tuple[float, Array]] = []
    for k in np.argsort(-faces.areas, kind='stable'):
        if faces.areas[k] == 0:
            break  # triangles of three points in a row: they look nowhere
        normal = faces.normals[k]
        for at, (area, other) in enumerate(found):
            if np.linalg.norm(normal - other) < _ONE_FACE:
                found[at] = (area + faces.areas[k], other)
                break
        else:
            found.append((float(faces.areas[k]), normal))
    found.sort(key=lambda each: -round(each[0], 6))
    return [normal for _, normal in found[:_MOST_FACES]]


def turn_down(down: Array, corners: Array) -> Array:
    """The turn that brings a direction down, and the longer side of what lies there along x.

    Of boxes that are turned by whole degrees the one of the least area. Corners are N x 3.
    """
    side = np.eye(3)[np.argmin(np.abs(down))]
    x = np.cross(side, -down)
    x /= np.linalg.norm(x)
    turn = np.stack([x, np.cross(-down, x), -down])
    angles = np.radians(np.arange(90))
    c, s = np.cos(angles), np.sin(angles)
    flat = turn[:2] @ corners.T
    sizes = np.ptp(np.stack([[c, s], [-s, c]]).transpose(2, 0, 1) @ flat, axis=2)
    best = int(np.argmin(np.round(sizes.prod(axis=1), 6)))
    chosen = angles[best] + (0.0 if sizes[best, 0] >= sizes[best, 1] else math.pi / 2)
    c, s = math.cos(chosen), math.sin(chosen)
    return np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) @ turn


def lying_on(shape: Manifold, down: Array) -> Lying:
    """A solid with that direction down."""
    faces = Faces(shape)
    turn = turn_down(down, np.asarray(shape.hull().to_mesh64().vert_properties)[:, :3])
    corners = faces.corners @ turn.T
    heights = corners[:, :, 2]
    lowest = float(heights.min())
    flat = np.maximum(0.0, faces.normals @ down) * faces.areas
    is_down = faces.normals @ down > _STEEP
    on_bed = is_down & (heights.max(axis=1) < lowest + _ON_THE_BED)
    hangs = is_down & ~on_bed
    support = _SUPPORT_FILL * float((flat * (heights.mean(axis=1) - lowest))[hangs].sum())
    size = np.ptp(corners.reshape(-1, 3), axis=0)
    seconds = (shape.volume() + support) / _FLOW + _LAYER_CHANGE * math.ceil(size[2] / _LAYER)
    return Lying(
        turn, size, float(flat[on_bed].sum()), float(faces.areas[hangs].sum()), support, seconds
    )


def best_lying(shape: Manifold) -> Lying:
    """Of the flat sides of its hull on which a solid stands firm, the one with the least overhang.

    Firm is what touches at least a twentieth of its box, and half the square of its height. Those
    come first on which it is at most half as high as long, as layers that run along a part bear
    more. Of equal ones the one that touches most of the bed; where none is firm, the one that
    touches most by the square of its height.
    """
    found = [lying_on(shape, down) for down in _directions(shape)]
    firm = [each for each in found if each.is_firm]
    if not firm:
        return max(found, key=lambda each: round(each.contact / each.size[2] ** 2, 6))
    low = [each for each in firm if each.size[2] <= _LOW * max(each.size[:2])]
    return min(low or firm, key=lambda each: (round(each.overhang, 3), -round(each.contact, 3)))
