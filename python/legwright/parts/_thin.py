# SPDX-License-Identifier: Apache-2.0
"""What is left thin where a room is cut at a slant beside a side of a solid: taken away."""

from collections.abc import Iterator

import numpy as np
from manifold3d import Manifold

from legwright.parts._shapes import joined, whole
from legwright.parts._words import Array

FACING = 0.9
"""Cosine: two sides that face each other less than that meet in an edge, no wall."""
_BEYOND = 0.1  # [mm]: so much more than what is thin is taken, and no skin is left
_LEAST = 1e-3  # [mm2] of two sides before each other
_DEEP = 1e-3  # [mm]: sides that are nearer are one
_SAME = 1e-4  # [mm]: a wall that is thinner by less is one
_MOST = 0.05  # of a solid: what takes more is no edge, but what the part is made of
_ROUNDS = 4  # at most: what one cuts off may leave another place thin


def _clipped(corners: Array, normal: Array, most: float) -> Array:
    """The part of a convex polygon (N x 3) where normal @ x is at most that."""
    over = corners @ normal - most
    out = []
    for k, here in enumerate(corners):
        last, before = corners[k - 1], over[k - 1]
        if (before > 0) != (over[k] > 0):
            out.append(last + (here - last) * (before / (before - over[k])))
        if over[k] <= 0:
            out.append(here)
    return np.array(out).reshape(-1, 3)


def _area(corners: Array) -> float:
    if len(corners) < 3:
        return 0.0
    fan = np.cross(corners[1:-1] - corners[0], corners[2:] - corners[0])
    return float(np.linalg.norm(fan.sum(axis=0))) / 2


def _facing_pairs(triangles: Array, normals: Array, wall: float) -> Iterator[tuple[int, int]]:
    """Triangles that may lie behind each other within a wall."""
    low, high = triangles.min(axis=1), triangles.max(axis=1)
    for i, (own, normal) in enumerate(zip(triangles, normals)):
        behind = np.vstack([own, own - wall * normal])
        near = normals @ normal < -FACING
        near &= (low <= behind.max(axis=0)).all(axis=1) & (high >= behind.min(axis=0)).all(axis=1)
        found = np.flatnonzero(near)
        deep = (own[0] - triangles[found]) @ normal
        for j in found[(deep.max(axis=1) > _DEEP) & (deep.min(axis=1) < wall)]:
            yield i, int(j)


def thin_places(shape: Manifold, wall: float) -> list[Array]:
    """Where two sides face each other with less than a wall between them: the corners of what is
    between (N x 3) for each two triangles [mm]."""
    mesh = shape.to_mesh64()
    triangles = np.asarray(mesh.vert_properties)[:, :3][np.asarray(mesh.tri_verts)]
    across = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    size = np.linalg.norm(across, axis=1)
    triangles, normals = triangles[size > 0], (across / np.maximum(size, 1e-300)[:, None])[size > 0]
    out = []
    for i, j in _facing_pairs(triangles, normals, wall):
        own, normal = triangles[i], normals[i]
        found = triangles[j]
        for k in range(3):
            side = np.cross(own[(k + 1) % 3] - own[k], normal)
            found = _clipped(found, side, float(side @ own[k]))
        top = float(normal @ own[0])
        found = _clipped(_clipped(found, normal, top - _DEEP), -normal, wall - _SAME - top)
        if _area(found) > _LEAST:
            out.append(np.vstack([found, found + (top - found @ normal)[:, None] * normal]))
    return out


def _zone(places: list[Array]) -> Manifold:
    """Places that are thin, a little larger."""
    corners = np.asarray(Manifold.sphere(_BEYOND, 8).to_mesh64().vert_properties)[:, :3]
    return joined(
        [Manifold.hull_points((each[:, None] + corners).reshape(-1, 3)) for each in places]
    )


def _less(shape: Manifold, zone: Manifold, least: float) -> Manifold | None:
    """What is left of a solid; None where that is cut apart, or less than the least [mm3]."""
    left = shape - zone
    return left if left.volume() >= least and whole(left)[1] <= whole(shape)[1] else None


def without_thin(shape: Manifold, wall: float, fine: float) -> Manifold:
    """A solid less what is thinner than a wall [mm] and holds nothing.

    Rooms that are cut at a slant to a side leave edges like a knife's: they end where the wall
    begins. What would cut the solid apart, or take a good part of it, stays. Details that are finer
    than `fine` [mm] are left out.
    """
    least = (1 - _MOST) * shape.volume()
    for _ in range(_ROUNDS):
        places = thin_places(shape, wall)
        if not places:
            break
        zone = _zone(places)
        left = _less(shape, zone, least)
        if left is None:  # which of them hold something
            left = shape
            for each in zone.decompose():
                less = _less(left, each, least)
                left = left if less is None else less
        if left is shape:
            break
        shape = whole(left.simplify(fine))[0]
    return shape
