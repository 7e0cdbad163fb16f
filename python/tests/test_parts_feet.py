# SPDX-License-Identifier: Apache-2.0
"""Ball feet: a peg on the part, a socket in the foot, and what the papers say of both."""

import csv
import math
import re
from types import SimpleNamespace

import numpy as np
import pytest
import trimesh
from legwright import InputError, parts
from legwright.parts._beam import pegs_bear
from legwright.parts._feet import foot_solid, peg_of, peg_solid, socket_size
from legwright.parts._holes import Fixing
from legwright.parts._loads import GaitLoads, Loads
from legwright.parts._robot import Shape
from legwright.parts._words import Place

UP = np.array([0, 0, 1.0])


def fixing(kind: str = 'sphere', of: str = 'foot', screw: str | None = None) -> Fixing:
    """A ball of 12 mm radius about the origin, with an attachment on its top."""
    size = np.full(3, 0.012) if kind == 'box' else np.array([0.012])
    shape = Shape(kind, size, np.zeros(3), np.eye(3))
    words = SimpleNamespace(kind=of, name='ball')
    module = SimpleNamespace(shapes=(shape,), words=words, of='FL')
    place = Place('top', False, 0.012 * UP, UP, screw, np.zeros((0, 3)))
    return Fixing(module, place, 0.012 * UP, UP, place.holes)


def test_a_peg_reaches_the_middle_of_the_ball_and_the_socket_is_narrower():
    peg = peg_of(fixing(), 0.15)
    assert (peg.radius, peg.length) == pytest.approx((3.6, 12.0))
    low, high = np.array(peg_solid(peg).bounding_box()).reshape(2, 3)
    assert low[2] == pytest.approx(0) and high[2] == pytest.approx(12 + 0.15 + 1.5)
    assert socket_size(peg, 0.1) == pytest.approx((7.1, 13.0))
    foot = foot_solid(peg, 0.1)
    assert foot.bounding_box()[5] < 24.0, 'the mouth is open above'
    taken = 4 / 3 * math.pi * 12**3 - foot.volume()
    assert taken == pytest.approx(math.pi * 3.55**2 * 12.7, rel=0.05)


@pytest.mark.parametrize('how', [{'kind': 'box'}, {'of': 'servo'}, {'screw': 'M2'}])
def test_other_feet_and_those_with_screws_get_no_peg(how):
    assert peg_of(fixing(**how), 0.15) is None


def test_a_peg_that_is_too_weak_for_the_ground_s_force_fails():
    solid = SimpleNamespace(pegs=(peg_of(fixing(), 0.15),), link=SimpleNamespace(body=1))
    part = SimpleNamespace(name='shank', solid=solid, solids=(solid,))
    force = np.array([4.0, 0, 10])
    rows = np.vstack([0.1 * force, force])
    loads = Loads('', np.array([0.0, 0.1]), rows, np.cross([0, 0, -0.012], rows))
    foot = GaitLoads({}, {'FL': [loads]}, False)
    bending = 4 * 24.15 / (math.pi * 3.6**3 / 4)
    normal, shear = 10 / (math.pi * 3.6**2), 1.5 * 4 / (math.pi * 3.6**2)
    stress = math.sqrt((bending + normal) ** 2 + 3 * shear**2)
    (check,) = pegs_bear(part, foot, parts.PartOptions(strength=3 * stress))
    assert check.passed and check.figure == pytest.approx(3, rel=2e-3)
    assert check.name == 'peg bears the plan'
    (check,) = pegs_bear(part, foot, parts.PartOptions(strength=1.5 * stress))
    assert not check.passed and 't = 0.100 s' in check.where and 'larger foot' in check.remedy
    (check,) = pegs_bear(part, GaitLoads(), parts.PartOptions())
    assert check.name == 'peg bears the gait'
    assert not check.passed, 'what has no load was not looked at'


def test_each_foot_of_the_puppy_stands_on_a_peg_of_its_shank(dog, tmp_path):
    made = parts.make(dog, tmp_path / 'out', parts.PartOptions(press=0.2))
    assert made.passed, [check for check in made.checks if not check.passed]
    for part in made.parts:
        assert len(part.solid.pegs) == part.name.endswith('shank')
        assert (part.solid.peg_volume > 0.95 * math.pi * 3.6**2 * 12) == bool(part.solid.pegs)
        assert len(part.solid.shape.decompose()) == 1
    foot = trimesh.load(made.folder / 'foot_ball_foot_12.stl')
    assert foot.is_watertight and foot.is_winding_consistent
    x, y, z = foot.vertices.T
    beside = np.hypot(x - foot.bounds[:, 0].mean(), y - foot.bounds[:, 1].mean())
    floor = beside[(beside < 6) & (abs(z - 11) < 0.2)]
    assert len(floor) >= 64 and floor == pytest.approx(3.5, abs=0.02)
    with (made.folder / 'bom.csv').open(encoding='utf-8') as file:
        rows = list(csv.DictReader(file))
    (note,) = [row['note'] for row in rows if row['kind'] == 'foot']
    assert note == 'socket of 7.00 mm, 13.0 mm deep, at its top'
    assert not [row for row in rows if row['kind'] == 'screw' and 'foot' in row['note']]
    sheet = (made.folder / 'assembly.md').read_text(encoding='utf-8')
    assert len(re.findall('top: none, it is pressed on its peg', sheet)) == 4


def test_a_press_beyond_a_millimetre_is_refused(dog, tmp_path):
    with pytest.raises(InputError, match='press is 2; expected -1 to 1'):
        parts.make(dog, tmp_path / 'out', parts.PartOptions(press=2.0))
