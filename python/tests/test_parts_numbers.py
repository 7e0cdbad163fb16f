# SPDX-License-Identifier: Apache-2.0
"""Numbers that are engraved: read back from the solids, where they are, and where there is none."""

import csv
from types import SimpleNamespace

import numpy as np
import pytest
from legwright import parts
from legwright.parts._digits import needs_bar
from legwright.parts._numbers import DEPTH, HEIGHTS, engraving, find_mark
from legwright.parts._printing import lying_on
from legwright.parts._robot import Shape
from legwright.parts._shapes import outline
from legwright.parts._solids import Mark
from manifold3d import Manifold

# Of a digit that is 1 wide and 2 high: the middles of its seven segments, clockwise from the top.
MIDDLES = [(0.5, 2), (1, 1.5), (1, 0.5), (0.5, 0), (0, 0.5), (0, 1.5), (0.5, 1)]
READ = {
    '1111110': '0', '0110000': '1', '1101101': '2', '1111001': '3', '0110011': '4',
    '1011011': '5', '1011111': '6', '1110000': '7', '1111111': '8', '1111011': '9',
}  # fmt: skip


@pytest.fixture(scope='module', params=['puppy', 'hexapod'])
def made(request, printed) -> parts.Parts:
    return printed(request.param)


def is_cut(shape: Manifold, mark: Mark, x: float, y: float) -> bool:
    """Whether material is missing there, half as deep as strokes are; x to the reader's right."""
    right = np.cross(mark.up, mark.normal)
    at = mark.centre + x * right + y * mark.up
    hits = shape.ray_cast(tuple(at + mark.normal), tuple(at - 0.5 * DEPTH * mark.normal))
    return len(hits) % 2 == 0


def read(shape: Manifold, mark: Mark, count: int) -> str:
    """The digits of an engraving, as someone sees them who looks at its side."""
    half = mark.height / 2
    for advance in np.arange(0.8, 1.4, 0.05) * mark.height:
        for rise in (0.0, 1.0, 2.0, 2.5):  # half of what a bar below takes
            left = -(half + (count - 1) * advance) / 2
            digits = ''
            for k in range(count):
                points = [
                    (left + k * advance + half * x, half * (y - 1) + rise / 2 + 0.06)
                    for x, y in MIDDLES
                ]
                found = ''.join('01'[is_cut(shape, mark, *point)] for point in points)
                digits += READ.get(found, '?')
            if '?' not in digits:
                return digits
    return '?'


def test_the_number_on_each_part_is_that_of_its_row_in_the_bill(made):
    with (made.folder / 'bom.csv').open(encoding='utf-8') as file:
        rows = {row['name']: row['no'] for row in csv.DictReader(file) if row['kind'] == 'printed'}
    for part in made.parts:
        assert part.mark is not None and part.mark.height in HEIGHTS
        assert np.allclose(np.cross(part.mark.along, part.mark.up), part.mark.normal)
        for solid in part.solids:
            assert read(solid.shape, part.mark, len(rows[part.name])) == rows[part.name]


def test_numbers_take_little_and_are_where_they_can_be_seen(made):
    assert made.passed, [check for check in made.checks if not check.passed]
    for part in made.parts:
        cutter = engraving(part.mark)
        for solid in part.solids:
            assert 0 < solid.number_volume < 60
            assert (solid.shape ^ cutter).volume() < 1e-6
        for module in part.solid.link.modules:
            assert (outline(module) ^ cutter).volume() == 0
        assert part.mark.normal @ part.lying.down < 0.7, 'not on the bed'


def plate(thick: float, modules: tuple = ()) -> SimpleNamespace:
    shape = Manifold.cube((30, 20, thick), True)
    solid = SimpleNamespace(
        shape=shape, link=SimpleNamespace(modules=modules, servo=None, body=0), holes=()
    )
    return SimpleNamespace(solid=solid, lying=lying_on(shape, np.array([0, 0, -1.0])))


def test_a_number_has_a_wall_behind_it_and_the_largest_digits_that_find_room():
    mark = find_mark(None, plate(2.0), 7, 1.2)
    assert mark.height == 10.0 and mark.normal == pytest.approx([0, 0, 1])
    assert mark.centre == pytest.approx([0, 0, 1.0], abs=1.0)
    assert find_mark(None, plate(1.6), 7, 1.2) is None, '1.2 mm behind 0.4'
    assert find_mark(None, plate(2.0), 7777, 1.2).height == 8.0
    assert find_mark(None, plate(2.0), 7777777, 1.2) is None


def test_a_side_that_a_module_hides_gets_no_number():
    box = Shape('box', np.array([0.02, 0.02, 0.005]), np.array([0, 0, 0.02]), np.eye(3))
    hidden = plate(4.0, (SimpleNamespace(shapes=(box,)),))
    mark = find_mark(None, hidden, 7, 1.2)
    assert mark.normal == pytest.approx([0, 0, -1]), 'the side on the bed is the last choice'


def test_numbers_that_read_otherwise_upside_down_have_a_bar():
    assert [n for n in range(5, 22) if needs_bar(n)] == [6, 9, 10, 12, 15, 16, 18, 19, 20, 21]
    assert not needs_bar(69)
    with_bar, without = (
        engraving(Mark(n, 10.0, 1.2, np.zeros(3), *np.eye(3)[[2, 0, 1]])) for n in (6, 8)
    )
    assert np.ptp(np.array(with_bar.bounding_box()).reshape(2, 3)[:, 1]) == pytest.approx(
        np.ptp(np.array(without.bounding_box()).reshape(2, 3)[:, 1]) + 1.1 * 1.2 + 1.0
    )
