# SPDX-License-Identifier: Apache-2.0
"""Surfaces that pass through themselves, against boxes whose overlap is known."""

from itertools import product
from types import SimpleNamespace

import numpy as np
import pytest
from legwright.parts import _solid_checks
from legwright.parts._crossings import crossing_of, winding_numbers
from legwright.parts._mesh_files import Mesh, mesh_of
from legwright.parts._solid_checks import _closed
from manifold3d import Manifold
from manifold3d import Mesh as ManifoldMesh

AS_DRAWN = np.eye(3)


def box(low, high) -> Manifold:
    return Manifold.cube(tuple(np.subtract(high, low).astype(float))).translate(tuple(low))


def together(*solids: Manifold, turn=AS_DRAWN) -> Mesh:
    """Their triangles as of one surface, with the digits of files; equal corners are one."""
    meshes = [mesh_of(solid.transform(np.column_stack([turn, np.zeros(3)]))) for solid in solids]
    starts = np.cumsum([0] + [len(each.vertices) for each in meshes])
    corners = np.vstack([each.vertices for each in meshes])
    vertices, number = np.unique(corners, axis=0, return_inverse=True)
    triangles = np.vstack([each.triangles + k for each, k in zip(meshes, starts)])
    return Mesh(vertices, number.reshape(-1)[triangles])


def pushed(corner: int, to) -> Mesh:
    """A cube of 10 mm, one of whose corners is elsewhere."""
    mesh = mesh_of(box((0, 0, 0), (10, 10, 10)))
    vertices = mesh.vertices.copy()
    vertices[corner] = to
    return Mesh(vertices, mesh.triangles)


def crosses(mesh: Mesh) -> bool:
    return crossing_of(mesh.vertices, mesh.triangles) is not None


def turned(seed: int) -> np.ndarray:
    return np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))[0]


CUBE = box((0, 0, 0), (10, 10, 10))
OVERLAP = {
    'corners': box((5, 4, 3), (15, 14, 13)),
    'along a diagonal, faces in a plane': box((5, 5, 0), (15, 15, 10)),
    'the same twice': CUBE,
    'one in the other': box((3, 3, 3), (7, 7, 7)),
    'one in the other, walls in a plane': box((0, 0, 2), (10, 10, 8)),
    'by a twentieth of a millimetre': box((9.95, 2, 2), (15, 8, 8)),
}
TOUCH = {
    'by a face': box((10, 0, 0), (20, 10, 10)),
    'by half a face': box((10, 5, 0), (20, 15, 10)),
    'by a smaller face': box((2, 2, 10), (8, 8, 18)),
    'by an edge': box((10, 10, 0), (20, 20, 10)),
    'by a corner': box((10, 10, 10), (20, 20, 20)),
    'not': box((11, 0, 0), (20, 10, 10)),
}


@pytest.mark.parametrize('turn', [np.eye(3), turned(1), turned(2)], ids=['level', 'one', 'two'])
def test_boxes_that_overlap_are_told_from_those_that_touch(turn):
    turn = turn * np.sign(np.linalg.det(turn))
    for words, other in OVERLAP.items():
        assert crosses(together(CUBE, other, turn=turn)), words
    for words, other in TOUCH.items():
        assert not crosses(together(CUBE, other, turn=turn)), words


def test_boxes_of_a_grid_cross_where_they_have_room_in_common():
    rng = np.random.default_rng(3)
    counts = [0, 0]
    for k in range(200):
        low, other = rng.integers(0, 4, (2, 3)), rng.integers(0, 4, (2, 3))
        a, b = low[0], low[0] + rng.integers(1, 4, 3)
        c, d = other[0], other[0] + rng.integers(1, 4, 3)
        turn = turned(k) if k % 2 else np.eye(3)
        turn = turn * np.sign(np.linalg.det(turn))
        in_common = bool(np.all(np.minimum(b, d) > np.maximum(a, c)))
        mesh = together(box(7 * a, 7 * b), box(7 * c, 7 * d), turn=turn)
        assert crosses(mesh) == in_common, (k, a, b, c, d)
        counts[in_common] += 1
    assert min(counts) > 20


def is_solid(mesh: Mesh) -> bool:
    """Whether it goes around each of many points once or not at all."""
    points = np.random.default_rng(1).uniform(-4, 14, (4000, 3))
    numbers = np.round(winding_numbers(points, mesh.vertices.astype(float)[mesh.triangles]))
    return bool(np.all((numbers == 0) | (numbers == 1)))


def test_a_corner_that_is_pushed_through_the_other_side_is_told_with_its_place():
    through = pushed(7, (-4, -5, -3))
    place = crossing_of(through.vertices, through.triangles)
    assert place is not None and np.all(np.abs(place) < 8)
    assert crosses(pushed(7, (-5, -5, -5))), 'along the diagonal, out of a corner'
    assert not crosses(pushed(7, (4, 4.5, 5))), 'a dent'
    assert not crosses(pushed(7, (19, 12, 14)))
    counts = [0, 0]
    for corner, to in product(range(8), [(4, 5, -3), (5, 5, 13), (-3, 4, 5), (5, 13, 4)]):
        mesh = pushed(corner, to)
        assert crosses(mesh) != is_solid(mesh), (corner, to)
        counts[is_solid(mesh)] += 1
    assert min(counts) > 5


def test_what_is_inside_out_is_told_and_a_hollow_is_not():
    cube = mesh_of(CUBE)
    assert crosses(Mesh(cube.vertices, cube.triangles[:, ::-1]))
    assert not crosses(mesh_of(CUBE - box((2, 2, 2), (8, 8, 8))))
    assert not crosses(mesh_of(Manifold.sphere(9, 64) - Manifold.cylinder(30, 3, 3, 48, True)))


def test_winding_numbers_are_those_of_the_solid():
    cube = mesh_of(CUBE)
    points = np.array([[5, 5, 5], [5, 5, 11.0]])
    found = winding_numbers(points, cube.vertices[cube.triangles])
    assert found == pytest.approx([1, 0], abs=1e-12)


@pytest.mark.parametrize('mesh', [pushed(7, (-4, -5, -3)), together(CUBE, OVERLAP['corners'])])
def test_what_topology_does_not_tell_fails(mesh):
    """manifold3d and trimesh take both for solids."""
    shape = Manifold(ManifoldMesh(mesh.vertices, mesh.triangles.astype(np.uint32)))
    solid = SimpleNamespace(pieces=1)
    part = SimpleNamespace(name='it', printed=shape, mesh=mesh, solid=solid)
    failed = [check for check in _closed(part) if not check.passed]
    assert [check.name for check in failed] == ['no self-intersection']
    assert 'of its STL' in failed[0].where and '--fit' in failed[0].remedy


def test_all_parts_of_the_puppy_are_looked_at(printed, monkeypatch):
    made = printed('puppy')
    found = [check for check in made.checks if check.name == 'no self-intersection']
    assert len(found) == len(made.parts) and all(check.passed for check in found)
    monkeypatch.setattr(_solid_checks, 'crossing_of', lambda *_: np.zeros(3))
    again = [c for c in _closed(made.parts[0]) if c.name == 'no self-intersection']
    assert [check.passed for check in again] == [False]
