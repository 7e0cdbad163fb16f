# SPDX-License-Identifier: Apache-2.0
"""Whether a closed surface passes through itself: topology does not tell.

Edges that pass through triangles are looked for, and winding numbers beside them: a surface bounds
a solid where all of space is within it once or not at all. Solids that touch pass; what overlaps
does not, nor what is inside out. Of a surface that no edge passes through, one point of each shell
tells of the whole shell.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from legwright.parts._words import Array

Indices = NDArray[np.int64]

_FINE = 1e-3  # [mm]: files are rounded, and details that are finer left out of solids
_BESIDE = (0.5, 0.05, 0.005)  # [mm]: how far beside a crossing space is looked at
_MOST_TERMS = 500_000  # points times triangles at once: 50 MB


@dataclass(frozen=True)
class _Boxes:
    """Around edges or triangles: N x 3 each."""

    low: Array
    high: Array


def _boxes(points: Array) -> _Boxes:
    """@param points N x corners x 3"""
    return _Boxes(points.min(axis=1) - _FINE, points.max(axis=1) + _FINE)


def _expanded(first: Indices, last: Indices) -> tuple[Indices, Indices]:
    """All pairs of a row and a number of its range [first, last)."""
    counts = np.maximum(last - first, 0)
    rows = np.repeat(np.arange(len(counts)), counts)
    starts = np.repeat(first - np.cumsum(counts) + counts, counts)
    return rows, starts + np.arange(len(rows))


def _meeting(a: _Boxes, b: _Boxes) -> tuple[Indices, Indices]:
    """Pairs of boxes that meet: of each axis those whose stretches begin within another's are
    known by sorting, and the axis with the fewest is taken."""
    least, found = None, None
    for axis in range(3):
        low_a, low_b = a.low[:, axis], b.low[:, axis]
        order_a, order_b = np.argsort(low_a), np.argsort(low_b)
        sorted_a, sorted_b = low_a[order_a], low_b[order_b]
        ends_b = (np.searchsorted(sorted_b, low_a), np.searchsorted(sorted_b, a.high[:, axis]))
        after = (
            np.searchsorted(sorted_a, low_b, 'right'),
            np.searchsorted(sorted_a, b.high[:, axis], 'right'),
        )
        total = sum(int(np.maximum(last - first, 0).sum()) for first, last in (ends_b, after))
        if least is None or total < least:
            least, found = total, (axis, order_a, order_b, ends_b, after)
    axis, order_a, order_b, ends_b, after = found
    rows, numbers = _expanded(*ends_b)
    more, others = _expanded(*after)
    one = np.concatenate([rows, order_a[others]])
    other = np.concatenate([order_b[numbers], more])
    for k in {0, 1, 2} - {axis}:
        met = (a.low[one, k] <= b.high[other, k]) & (b.low[other, k] <= a.high[one, k])
        one, other = one[met], other[met]
    return one, other


@dataclass(frozen=True)
class _Surface:
    """Triangles with their normals, and their edges."""

    corners: Array
    """N x 3 x 3 [mm]."""
    triangles: Indices
    normals: Array
    """Of unit length; zero of a triangle without area."""
    edges: Indices
    """E x 2 vertices."""
    outwards: Array
    """E x 3: the mean normal beside an edge."""
    points: Array
    """Of all vertices [mm]."""


def _surface(vertices: Array, triangles: Indices) -> _Surface:
    corners = vertices[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = np.where(lengths > 0, normals / np.where(lengths > 0, lengths, 1), 0.0)
    all_edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    keys, number = np.unique(all_edges[:, 0] * len(vertices) + all_edges[:, 1], return_inverse=True)
    edges = np.column_stack(np.divmod(keys, len(vertices)))
    sums = np.zeros((len(edges), 3))
    np.add.at(sums, number.reshape(-1), np.repeat(normals, 3, axis=0))
    return _Surface(corners, triangles, normals, edges, sums, vertices)


def _passing(surface: _Surface) -> tuple[Indices, Indices, Array, Array]:
    """Edges, the triangles that they pass through, the places, and how far their ends are from the
    triangle's plane: from more than what is fine before it to as far behind it."""
    ends = surface.points[surface.edges]
    edge, face = _meeting(_boxes(ends), _boxes(surface.corners))
    own = (surface.edges[edge][:, :, None] == surface.triangles[face][:, None, :]).any(axis=(1, 2))
    edge, face = edge[~own], face[~own]
    normal, origin = surface.normals[face], surface.corners[face, 0]
    far = np.einsum('pek,pk->pe', ends[edge] - origin[:, None], normal)
    through = (far[:, 0] * far[:, 1] < 0) & (np.abs(far).min(axis=1) > _FINE)
    edge, face, far = edge[through], face[through], far[through]
    share = far[:, 0] / (far[:, 0] - far[:, 1])
    place = ends[edge, 0] + share[:, None] * (ends[edge, 1] - ends[edge, 0])
    inside = np.ones(len(edge), bool)
    for k in range(3):
        side = surface.corners[face, (k + 1) % 3] - surface.corners[face, k]
        across = np.cross(surface.normals[face], side)
        room = np.einsum('pk,pk->p', place - surface.corners[face, k], across)
        inside &= room >= -_FINE * np.linalg.norm(side, axis=1)
    return edge[inside], face[inside], place[inside], far[inside]


def winding_numbers(points: Array, corners: Array) -> Array:
    """How often a closed surface goes around each point: the sum of its triangles' solid angles
    (Van Oosterom and Strackee 1983) over that of the sphere."""
    out = np.empty(len(points))
    step = max(1, _MOST_TERMS // max(1, len(corners)))
    for first in range(0, len(points), step):
        some = points[first : first + step]
        a, b, c = (corners[None, :, k] - some[:, None] for k in range(3))
        la, lb, lc = (np.sqrt(np.einsum('pnk,pnk->pn', each, each)) for each in (a, b, c))
        volume = np.einsum('pnk,pnk->pn', a, np.cross(b, c))
        ab, bc, ca = (np.einsum('pnk,pnk->pn', x, y) for x, y in ((a, b), (b, c), (c, a)))
        angles = np.arctan2(volume, la * lb * lc + ab * lc + bc * la + ca * lb)
        out[first : first + step] = angles.sum(axis=1) / (2 * np.pi)
    return out


def _beside(surface: _Surface) -> Iterator[Array]:
    """Points around each crossing: before and behind the triangle, each on both sides of the
    surface that the edge is of."""
    for edge, face, place, far in zip(*_passing(surface)):
        ends = surface.points[surface.edges[edge]]
        along, normal = ends[1] - ends[0], surface.normals[face]
        along = along / (along @ normal)  # one millimetre away from the triangle's plane
        out = surface.outwards[edge]
        out = out - (out @ normal) * along
        length = np.linalg.norm(out)
        if length < 1e-9:
            continue
        for beside in _BESIDE:
            least = min(beside, float(np.abs(far).min()) / 2)
            for way in (least, -least):
                yield place + way * along + least * out / length
                yield place + way * along - least * out / length


def _shells(surface: _Surface) -> list[int]:
    """The largest triangle of each shell: of triangles that hang together by vertices."""
    labels = np.arange(len(surface.points))
    while True:
        least = labels[surface.triangles].min(axis=1)
        new = labels.copy()
        np.minimum.at(new, surface.triangles.reshape(-1), np.repeat(least, 3))
        new = new[new]
        if np.array_equal(new, labels):
            break
        labels = new
    of = labels[surface.triangles[:, 0]]
    sides = surface.corners[:, 1:] - surface.corners[:, :1]
    areas = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)
    return [int(np.flatnonzero(of == s)[np.argmax(areas[of == s])]) for s in np.unique(of)]


def _first_wrong(points: Array, corners: Array) -> Array | None:
    """The first point around which the surface does not go once or not at all."""
    chunk = 48
    for first in range(0, len(points), chunk):
        some = points[first : first + chunk]
        numbers = np.round(winding_numbers(some, corners))
        wrong = np.flatnonzero((numbers < 0) | (numbers > 1))
        if len(wrong):
            return some[wrong[0]]
    return None


def crossing_of(vertices: Array, triangles: Indices) -> Array | None:
    """A place [mm] that a closed surface bounds twice, or from the wrong side; None: it bounds a
    solid, to some micrometres.

    Args:
        vertices: N x 3 [mm]; what is at one place is one vertex.
        triangles: M x 3 of their indices, counter-clockwise from outside.
    """
    surface = _surface(np.asarray(vertices, float), np.asarray(triangles, np.int64))
    middles = surface.corners.mean(axis=1)
    largest = _shells(surface)
    sides = _BESIDE[-1] * surface.normals[largest]
    shells = np.concatenate([middles[largest] + sides, middles[largest] - sides])
    found = _first_wrong(shells, surface.corners)
    if found is not None:
        return found
    return _first_wrong(np.array(list(_beside(surface))).reshape(-1, 3), surface.corners)
