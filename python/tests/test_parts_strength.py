# SPDX-License-Identifier: Apache-2.0
"""Screw holes, and parts as beams, against what is known by hand."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from legwright import parts
from legwright.parts._beam import check_beams
from legwright.parts._holes import Fixing, drilled, driver_way, holes_of
from legwright.parts._loads import GaitLoads
from legwright.parts._sections import sections_of
from legwright.parts._tables import check_lines
from legwright.parts._words import Place
from manifold3d import Manifold
from test_parts import build

BAR = Manifold.cube((11, 3, 100)).translate((-5.5, -1.5, 0))


def section_of(shape: Manifold):
    return sections_of(shape, np.zeros(3), np.array([0, 0, 100.0]), np.array([0.5]))[0]


def test_a_flat_bar_is_stressed_as_a_beam_is():
    section = section_of(BAR)
    assert section.area == pytest.approx(33) and np.allclose(section.centre, [0, 0, 50])
    none = np.zeros(3)
    assert section.stress(none, np.array([0, 1000.0, 0])) == pytest.approx(1000 / (3 * 11**2 / 6))
    assert section.stress(none, np.array([1000.0, 0, 0])) == pytest.approx(1000 / (11 * 3**2 / 6))
    assert section.stress(np.array([0, 0, 330.0]), none) == pytest.approx(10)
    assert section.stress(np.array([33.0, 0, 0]), none) == pytest.approx(1.5 * math.sqrt(3))
    # Of a rectangle 11 by 3 (Roark): T / (0.277 a b^2); the ellipse is 8 % off.
    torsion = section.stress(none, np.array([0, 0, 1000.0])) / math.sqrt(3)
    assert torsion == pytest.approx(1000 / (0.277 * 11 * 3**2), rel=0.1)
    rng = np.random.default_rng(2)
    forces, moments = rng.normal(size=(2, 5, 3))
    one_by_one = [section.stress(f, m) for f, m in zip(forces, moments)]
    assert section.stress(forces, moments) == pytest.approx(one_by_one), 'of many at once'


def test_links_that_reach_nothing_are_told_as_not_judged():
    solid = SimpleNamespace(fixings=(), link=SimpleNamespace(servo=object()))
    tray = SimpleNamespace(fixings=(), link=SimpleNamespace(servo=None))
    pair = [SimpleNamespace(name=n, solid=s) for n, s in (('coxa', solid), ('trunk', tray))]
    found = check_beams(SimpleNamespace(), pair, GaitLoads(), parts.PartOptions())
    names = ['bears the gait, not judged', 'bears its servo, not judged']
    assert [(c.part, c.name, c.figure) for c in found] == [('coxa', n, None) for n in names]
    judged = parts.Check('shank', 'bears the gait', True, 3.0, 'times', 'at least 2')
    (line, _) = check_lines([judged, *found])
    assert line.endswith('1 of 1, 3 times, at least 2; 1 of 2 not judged: they do not reach their '
                         'modules')
    assert len(check_beams(SimpleNamespace(), pair, None, parts.PartOptions())) == 1


def test_a_hole_is_not_in_the_section():
    drill = Manifold.cylinder(20, 1.5, -1, 64, True).rotate((90, 0, 0)).translate((0, 0, 50))
    section = section_of(BAR - drill)
    assert section.area == pytest.approx(33 - 9, rel=1e-2)
    expected = 1000 / ((3 * 11**3 / 12 - 3 * 3**3 / 12) / 5.5)
    found = section.stress(np.zeros(3), np.array([0, 1000.0, 0]))
    assert found == pytest.approx(expected, rel=1e-2)


def fixing(*holes: tuple[float, float]) -> Fixing:
    """Screws M2 on a face in the plane z = 0, holes in mm."""
    points = np.array([[x, y, 0] for x, y in holes]) / 1e3
    up = np.array([0, 0, 1.0])
    place = Place('horn', True, np.zeros(3), up, 'M2', points)
    return Fixing(None, place, np.zeros(3), up, points)


def test_a_thin_plate_has_plain_holes_and_a_thick_one_lets_heads_in():
    thin = Manifold.cube((20, 20, 3), False).translate((-10, -10, 1))
    (hole,) = holes_of(fixing((6, 0)), thin, 1.2)
    assert (hole.begins, hole.clamped) == pytest.approx((1, 3), abs=1e-6)
    assert hole.edge == pytest.approx(10 - 6 - 1.2, abs=1e-6)
    plain = math.pi * 1.2**2 * 3
    assert (thin - drilled(hole)).volume() == pytest.approx(1200 - plain, rel=1e-3)
    thick = Manifold.cube((20, 20, 9), False).translate((-10, -10, 1))
    (deep,) = holes_of(fixing((6, 0)), thick, 1.2)
    assert deep.clamped == pytest.approx(2.5)
    let_in = math.pi * 1.2**2 * 2.5 + math.pi * 2.2**2 * 6.5
    assert (thick - drilled(deep)).volume() == pytest.approx(3600 - let_in, rel=1e-3)
    narrow = Manifold.cube((20, 20, 6), False).translate((-10, -10, 1))
    (beside,) = holes_of(fixing((6, 0)), narrow, 1.2)
    assert beside.clamped == pytest.approx(2.5), '1.8 mm stay beside the head'
    assert holes_of(fixing((6, 0)), narrow, 2.0)[0].clamped == pytest.approx(6), 'too little'


def test_a_hole_that_breaks_out_or_misses_has_a_negative_edge():
    plate = Manifold.cube((20, 20, 3), False).translate((-10, -10, 1))
    out, gone = holes_of(fixing((9.5, 0), (15, 0)), plate, 1.2)
    assert out.edge == pytest.approx(0.5 - 1.2, abs=1e-6)
    assert gone.edge < 0 and gone.clamped == 0


def test_holes_are_where_the_module_file_has_them(printed):
    made = printed('puppy')
    thigh = next(part for part in made.parts if part.name == 'FL_thigh')
    places = sorted((round(1e6 * x), round(1e6 * z)) for x, _, z in horn_holes(thigh))
    assert places == [(-8000, 0), (0, -8000), (0, 8000), (8000, 0)]
    mesh = thigh.solid.shape
    for x, _, z in horn_holes(thigh):
        assert not mesh.ray_cast((1e3 * x, -1, 1e3 * z), (1e3 * x, 20, 1e3 * z)), 'free to the end'
        assert mesh.ray_cast((1e3 * x, -1, 1e3 * z + 1.4), (1e3 * x, 20, 1e3 * z + 1.4))
    sizes = [line for line in (made.folder / 'bom.csv').read_text().splitlines() if ',M2,' in line]
    assert [line.split(',')[3] for line in sizes] == ['32']


def horn_holes(part):
    (horn,) = [each for each in part.solid.fixings if each.place.on_horn]
    return horn.holes


def test_pads_that_are_too_small_for_screws_fail_with_the_radius_that_would_do(examples, tmp_path):
    """The example puppy's pads are of 6 mm; the horn's screws are on a circle of 16 mm."""
    robot = build(examples / 'assemblies/puppy.toml', tmp_path / 'small.xml')
    made = parts.make(robot, tmp_path / 'out')
    failed = {check.name: check for check in made.checks if not check.passed}
    edge = failed['edge of holes, FL_hip_servo horn']
    assert edge.figure < 0 and 'radius = 0.0113 or more' in edge.remedy


def test_a_screw_behind_the_part_itself_cannot_be_reached():
    hook = Manifold.cube((20, 20, 3)).translate((-10, -10, 1))
    (hole,) = holes_of(fixing((6, 0)), hook, 1.2)
    assert (driver_way(hole) ^ hook).volume() == pytest.approx(0, abs=1e-9)
    roof = hook + Manifold.cube((20, 20, 3)).translate((-10, -10, 15))
    assert (driver_way(hole) ^ roof).volume() > 1


def test_a_beam_that_is_too_weak_fails(dog, tmp_path):
    weak = parts.make(dog, tmp_path / 'out', parts.PartOptions(strength=2.0))
    failed = {check.name for check in weak.checks if not check.passed}
    assert failed == {'bears its servo'}
