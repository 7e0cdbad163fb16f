# SPDX-License-Identifier: Apache-2.0
"""Each check of a solid by itself, on one that fails it."""

import dataclasses
import re
from types import SimpleNamespace

import numpy as np
import pytest
from legwright import parts
from legwright.parts._holes import Fixing, fixings_of, holes_of
from legwright.parts._mesh_files import mesh_of
from legwright.parts._reach import reaches
from legwright.parts._robot import Shape
from legwright.parts._screw_checks import check_screws
from legwright.parts._solid_checks import _closed, _wall
from legwright.parts._tables import check_lines
from legwright.parts._words import Place
from manifold3d import Manifold

UP = np.array([0, 0, 1.0])


def part_of(shape: Manifold, pieces: int = 1) -> SimpleNamespace:
    solid = SimpleNamespace(pieces=pieces)
    return SimpleNamespace(name='it', printed=shape, mesh=mesh_of(shape), solid=solid)


def failed(checks) -> dict[str, parts.Check]:
    return {check.name: check for check in checks if not check.passed}


def test_a_thin_wall_fails_and_so_does_one_that_was_not_found():
    plate = part_of(Manifold.cube((30, 30, 0.8)))
    assert not _wall(plate, 1.2).passed and _wall(plate, 0.7).passed
    assert _wall(plate, 1.2).figure == pytest.approx(0.8, abs=2e-3)
    edges = _wall(part_of(Manifold.tetrahedron().scale((9, 9, 9))), 1.2)
    assert not edges.passed and edges.figure is None and 'face each other' in edges.where


def test_what_falls_apart_or_is_open_fails():
    shape = Manifold.cube((9, 9, 9))
    assert not failed(_closed(part_of(shape)))
    assert set(failed(_closed(part_of(shape, 2)))) == {'in one piece'}
    broken = part_of(shape)
    broken.mesh = dataclasses.replace(broken.mesh, triangles=broken.mesh.triangles[1:])
    assert 'watertight and oriented' in failed(_closed(broken))


def test_masses_that_are_not_those_of_the_solids_fail(dog, tmp_path):
    text = dog.read_text(encoding='utf-8')
    heavy = re.sub(
        r'(<body name="FL_thigh_arm">\s*<inertial [^>]*mass=")([^"]*)',
        lambda found: f'{found[1]}{1.01 * float(found[2]):.9g}',
        text,
    )
    assert heavy != text
    robot = tmp_path / 'robot.xml'
    robot.write_text(heavy.replace('trunk trunk 0.25 kg', 'trunk trunk 0.1 kg'), encoding='utf-8')
    found = failed(parts.make(robot, tmp_path / 'out').checks)
    assert set(found) == {'mass of the hulls', 'mass of the trunk'}
    assert found['mass of the trunk'].unit == "of its module's mass"
    assert found['mass of the hulls'].figure == pytest.approx(0.01 / 1.01, rel=1e-3)


@pytest.mark.parametrize(
    'kind, on_trunk, places, remedy',
    [
        ('battery', True, 'bottom', r'position of its [[part]]'),
        ('servo', True, 'back', r'hip or step of its [[limb]]'),
        ('servo', False, 'back', 'turn its servo by roll'),
        ('foot', False, 'top', r'foot_offset of its [[limb]]'),
        ('servo', False, '', 'MY-1 has no attachment on its body: its module file needs'),
    ],
)
def test_what_is_not_reached_is_told_by_what_it_is(kind, on_trunk, places, remedy):
    """Material begins 9.6 mm under it."""
    none = np.zeros((0, 3))
    found = [Place(name, False, np.zeros(3), -UP, None, none) for name in places.split()]
    words = SimpleNamespace(name='MY-1', kind=kind, cable=())
    module = SimpleNamespace(of='it', places=found, words=words, shapes=())
    horn = Place('horn', True, np.zeros(3), UP, None, none)
    servo = SimpleNamespace(
        of='below', places=[horn], words=SimpleNamespace(name='MY-2', kind='servo')
    )
    link = SimpleNamespace(servo=None if on_trunk else servo, modules=(module,))
    plate = Manifold.cube((20, 20, 3)).translate((-10, -10, -12.6))
    solid = SimpleNamespace(
        link=link, shape=plate, fixings=[SimpleNamespace(module=servo, place=horn)]
    )
    checks = reaches(solid, 'part')
    assert set(failed(checks)) == {'reaches it'} and len(checks) == (1 if on_trunk else 2)
    assert remedy in checks[0].remedy
    assert checks[0].where == (f'nearest 9.6 mm before {places}' if places else '')


@pytest.mark.parametrize('ribs, stands', [((-12, 10), True), ((6, 10), False), ((), False)])
def test_what_stands_on_ribs_beside_its_middle_is_held(ribs, stands):
    """A battery 30 mm above the floor of the trunk: on two ribs, on two at one side, on none."""
    bottom = Place('bottom', False, np.array([0, 0, -0.005]), -UP, None, np.zeros((0, 3)))
    words = SimpleNamespace(name='MY-1', kind='battery', cable=())
    box = Shape('box', np.array([0.02, 0.01, 0.005]), np.zeros(3), np.eye(3))
    module = SimpleNamespace(of='it', places=[bottom], words=words, shapes=(box,))
    shape = Manifold.cube((60, 60, 3)).translate((-30, -30, -38))
    for x in ribs:
        shape += Manifold.cube((2, 20, 30.85)).translate((x, -10, -36))
    link = SimpleNamespace(servo=None, modules=(module,))
    (check,) = reaches(SimpleNamespace(link=link, shape=shape, fixings=[]), 'trunk')
    assert check.passed == stands
    assert ('stands on' in check.where) == stands
    assert stands or 'right under it at both sides of its middle' in check.remedy


def test_a_head_is_let_in_where_a_slanted_side_comes_near():
    """Through 5 mm of a cone the hole would end 0.1 mm from its side."""
    module = SimpleNamespace(of='servo')
    points = np.array([[0.006, 0, 0], [-0.006, 0, 0]])
    place = Place('horn', True, np.zeros(3), UP, 'M2', points)
    cone = Manifold.cylinder(5, 10, 7).translate((0, 0, 1))
    holes = holes_of(Fixing(module, place, np.zeros(3), UP, points), cone, 1.2)
    assert [hole.clamped for hole in holes] == [2.5, 2.5]
    assert min(hole.edge for hole in holes) > 1.2


def test_figures_say_what_they_are_shares_of():
    """Of a part in one piece, and of one that is not."""
    lines = check_lines([*_closed(part_of(Manifold.cube((9, 9, 9))))])
    assert re.search(r'volume by trimesh +1 of 1, \S+ relative difference, at most 1e-06', lines[1])
    assert lines[2].endswith('in one piece               1 of 1, 1 piece, exactly 1')
    broken = check_lines(_closed(part_of(Manifold.cube((9, 9, 9)), 2)))
    assert '      it: in one piece: 2 pieces, exactly 1' in broken
    walls = [parts.Check('', 'wall', True, mm, 'mm', 'at least 1 mm') for mm in (2.0, 3.0)]
    assert check_lines(walls)[0].endswith('2 of 2, worst 2 mm, at least 1 mm')


@pytest.mark.parametrize(
    'pad, remedy',
    [
        (Manifold.cylinder(3, 7, 7), 'radius = 0.0091 or more'),
        (Manifold.cylinder(3, 10, 6), 'a larger wall'),
    ],
)
def test_holes_near_an_edge_are_told_what_the_pad_lacks(pad, remedy):
    module = SimpleNamespace(of='servo')
    points = np.array([[0.006, 0, 0], [-0.006, 0, 0]])
    place = Place('horn', True, np.zeros(3), UP, 'M2', points)
    shape = pad.translate((0, 0, 1))
    holes = holes_of(Fixing(module, place, np.zeros(3), UP, points), shape, 1.2)
    link = SimpleNamespace(servo=module, modules=())
    solid = SimpleNamespace(link=link, shape=shape, holes=holes)
    found = failed(check_screws([SimpleNamespace(name='it', solid=solid)], 1.2))
    assert remedy in found['edge of holes, servo horn'].remedy


@pytest.mark.parametrize('way', ['free', 'roof', 'module'])
def test_screws_that_cannot_be_reached_fail(way):
    module = SimpleNamespace(of='servo')
    points = np.array([[0.006, 0, 0]])
    place = Place('horn', True, np.zeros(3), UP, 'M2', points)
    plate = Manifold.cube((20, 20, 3)).translate((-10, -10, 1))
    holes = holes_of(Fixing(module, place, np.zeros(3), UP, points), plate, 1.2)
    box = Shape('box', np.full(3, 0.005), np.array([0.006, 0, 0.03]), np.eye(3))
    others = (SimpleNamespace(of='other', shapes=(box,)),) if way == 'module' else ()
    roof = Manifold.cube((20, 20, 3)).translate((-10, -10, 15))
    solid = SimpleNamespace(
        link=SimpleNamespace(servo=module, modules=others),
        shape=plate + roof if way == 'roof' else plate,
        holes=holes,
    )
    found = failed(check_screws([SimpleNamespace(name='it', solid=solid)], 1.2))
    words = {'free': None, 'roof': 'the part itself', 'module': 'other'}[way]
    assert ('screws reached, servo horn' in found) == (words is not None)
    assert words is None or words in found['screws reached, servo horn'].where


@pytest.mark.parametrize('begins, covered', [(5.8, True), (6.2, False)])
def test_an_attachment_holds_what_begins_within_6_mm(begins, covered):
    place = Place('top', False, np.zeros(3), UP, None, np.zeros((0, 3)))
    link = SimpleNamespace(body=0, servo=None, modules=(SimpleNamespace(places=(place,)),))
    robot = SimpleNamespace(model=SimpleNamespace(body_pos=np.zeros((1, 3))))
    plate = Manifold.cube((20, 20, 3)).translate((-10, -10, begins))
    assert bool(fixings_of(robot, link, plate)) == covered
