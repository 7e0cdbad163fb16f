# SPDX-License-Identifier: Apache-2.0
"""Edges like a knife's end where the wall begins; what is thin all over, or holds, stays."""

import dataclasses
import math

import numpy as np
import pytest
from legwright.parts._robot import read_built
from legwright.parts._shapes import whole
from legwright.parts._solids import _cut
from legwright.parts._thin import thin_places, without_thin
from manifold3d import Manifold

WALL, FINE = 1.2, 1e-3
SLANT = math.tan(math.radians(10))
BLOCK = Manifold.cube((40, 20, 12))


def above(height: float) -> Manifold:
    """A room over a plane that rises along x from that height, at x = 0."""
    return Manifold.cube((400, 400, 90)).translate((-200, -200, 0)).rotate((0, -10, 0)).translate(
        (0, 0, height)
    )


def thickness(shape: Manifold, x: float) -> float:
    hits = shape.ray_cast((x, 10.1, 90), (x, 10.1, -90))
    return abs(hits[0].position[2] - hits[-1].position[2]) if hits else 0.0


def test_an_edge_like_a_knifes_ends_where_the_wall_begins():
    wedge = BLOCK - above(-0.2)
    assert thin_places(wedge, WALL)
    left = without_thin(wedge, WALL, FINE)
    assert not thin_places(left, WALL)
    ends = (WALL + 0.2) / SLANT
    assert left.bounding_box()[0] == pytest.approx(ends, abs=0.6)
    for x in (ends + 1, 20, 39):
        assert thickness(left, x) == pytest.approx(thickness(wedge, x), abs=1e-3)
    assert (left - wedge).volume() < 1e-6


def test_what_is_thick_enough_stays_as_it_is():
    for shape in (BLOCK, Manifold.cube((30, 30, WALL)), Manifold.sphere(5, 64)):
        assert without_thin(shape, WALL, FINE) is shape
    edge = BLOCK - above(-0.2).rotate((0, -20, 0))  # of 30 degrees: sides that do not face
    assert without_thin(edge, WALL, FINE) is edge


def test_what_is_thin_all_over_or_holds_two_pieces_together_stays():
    plate = Manifold.cube((30, 30, 0.8))
    assert without_thin(plate, WALL, FINE) is plate
    both = BLOCK + BLOCK.translate((42, 0, 0)) + Manifold.cube((4, 20, 0.8)).translate((39, 0, 5))
    held = without_thin(both - above(-0.2), WALL, FINE)
    assert whole(held)[1] == 1 and thickness(held, 41) == pytest.approx(0.8, abs=1e-6)
    assert held.bounding_box()[0] > 6, 'the edge of the first is taken all the same'


def test_of_many_thin_places_no_more_than_a_twentieth_is_taken():
    fins = [Manifold.cube((0.8, 20, 12)).translate((2 + 4 * k, 0, 12)) for k in range(9)]
    comb = sum(fins, BLOCK)
    left = without_thin(comb, WALL, FINE)
    assert 0.95 * comb.volume() <= left.volume() < comb.volume()


def test_parts_are_cut_so_beside_what_is_taken_away(dog):
    robot = read_built(dog)
    link = dataclasses.replace(robot.links[0], modules=(), servo=None)
    told = {'hull_volume': BLOCK.volume(), 'density': 1240.0, 'file_mass': 1.0}
    solid = _cut(robot, link, BLOCK, above(-0.2), WALL, told)
    assert not thin_places(solid.shape, WALL) and solid.pieces == 1
    assert solid.seat_volume == pytest.approx(BLOCK.volume() - solid.shape.volume(), rel=1e-6)
    assert np.isfinite(solid.mass)
