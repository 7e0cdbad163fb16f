# SPDX-License-Identifier: Apache-2.0
"""Cross-sections of a part across a line through it, and the stress that loads make there."""

import math
from dataclasses import dataclass

import numpy as np
from manifold3d import Manifold

from legwright.parts._shapes import frame_along, placed
from legwright.parts._words import Array

_EMPTY = 0.1  # [mm2]: less is no section


@dataclass(frozen=True)
class Section:
    """A cross-section in the frame of the part [mm]."""

    share: float
    """Along the line, from 0 to 1."""
    centre: Array
    frame: Array
    """3 x 3: two directions in the plane, then that across it."""
    area: float
    moments: Array
    """2 x 2: integrals of u u, u v and v v about the centre [mm4]."""
    corners: Array
    """N x 2, from the centre: of the section's hull, as stress is largest at one of them."""

    def stress(self, forces: Array, moments: Array) -> Array:
        """Largest equivalent stress (von Mises) [MPa], of one load or of each of N.

        Of forces through the centre [N] and moments about it [N mm], 3 or N x 3, as of a beam:
        normal force and bending about both axes; torsion as of an ellipse with the area's moments;
        one and a half times the mean shear.
        """
        own_forces, own_moments = forces @ self.frame, moments @ self.frame
        bent = np.stack([-own_moments[..., 1], own_moments[..., 0]], axis=-1)
        slopes = bent @ np.linalg.inv(self.moments)
        normal = np.abs(own_forces[..., 2, None] / self.area + slopes @ self.corners.T).max(axis=-1)
        half = 2 * np.sqrt(np.linalg.eigvalsh(self.moments) / self.area)
        torsion = 2 * np.abs(own_moments[..., 2]) / (math.pi * half[1] * half[0] ** 2)
        shear = 1.5 * np.hypot(own_forces[..., 0], own_forces[..., 1]) / self.area
        return np.sqrt(normal**2 + 3 * (torsion + shear) ** 2)


def _polygon_moments(points: Array) -> tuple[float, Array, Array]:
    """Signed area, first and second moments of a polygon about the origin (Green)."""
    nexts = np.roll(points, -1, axis=0)
    cross = points[:, 0] * nexts[:, 1] - nexts[:, 0] * points[:, 1]
    first = ((points + nexts) * cross[:, None]).sum(axis=0) / 6
    second = np.zeros((2, 2))
    for i in range(2):
        for j in range(2):
            a, b, c, d = points[:, i], points[:, j], nexts[:, i], nexts[:, j]
            second[i, j] = (cross * (2 * a * b + a * d + c * b + 2 * c * d)).sum() / 24
    return float(cross.sum() / 2), first, second


def disc(centre: Array, axis: Array, radius: float, corners: int = 64) -> Section:
    """The section of a round rod at a point of it [mm]."""
    angles = 2 * math.pi * np.arange(corners) / corners
    rim = radius * np.column_stack([np.cos(angles), np.sin(angles)])
    moments = math.pi * radius**4 / 4 * np.eye(2)
    return Section(0.0, centre, frame_along(axis), math.pi * radius**2, moments, rim)


def sections_of(shape: Manifold, start: Array, end: Array, shares: Array) -> list[Section]:
    """The sections of a solid across the line from one point to another, where there are some."""
    way = end - start
    length = float(np.linalg.norm(way))
    frame = frame_along(way / length)
    level = placed(shape, frame.T, -frame.T @ start)
    out = []
    for share in shares:
        cut = level.slice(float(share * length))
        polygons = [np.asarray(each) for each in cut.to_polygons()]
        if not polygons:
            continue
        sums = [_polygon_moments(each) for each in polygons]
        area = sum(each[0] for each in sums)
        if area < _EMPTY:
            continue
        centre = sum(each[1] for each in sums) / area
        moments = sum(each[2] for each in sums) - area * np.outer(centre, centre)
        place = start + frame @ np.array([centre[0], centre[1], share * length])
        corners = np.vstack([np.asarray(each) for each in cut.hull().to_polygons()]) - centre
        out.append(Section(float(share), place, frame, area, moments, corners))
    return out
