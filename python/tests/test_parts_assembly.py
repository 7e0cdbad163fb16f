# SPDX-License-Identifier: Apache-2.0
"""The assembly sheet and its pictures: all that a robot has, in order, with readable numbers."""

import csv
import math
import os
import re
import subprocess
import sys
from types import SimpleNamespace

import mujoco
import numpy as np
import pytest
from legwright import parts
from legwright.parts._assembly_sheet import _Sheet
from legwright.parts._drawing import Drawing, spread
from legwright.parts._labels import AWAY, RIGHT, UP, Camera, Thing, clearest_turn, hidden, labels_of
from legwright.parts._robot import read_built
from legwright.parts._tables import Row, screw_of
from test_parts import PROGRAM, build

SIGNS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])


@pytest.fixture(scope='module', params=['puppy', 'hexapod'])
def made(request, printed) -> parts.Parts:
    return printed(request.param)


def sections(made: parts.Parts) -> dict[str, list[list[str]]]:
    """The steps of each: number, row of the bill, what, where it goes, screws."""
    text = (made.folder / 'assembly.md').read_text(encoding='utf-8')
    out = {}
    for section in re.split(r'^## ', text, flags=re.M)[1:]:
        lines = re.findall(r'^\| (\d+ \|.*) \|$', section, re.M)
        out[section.split('\n')[0]] = [[c.strip() for c in line.split('|')] for line in lines]
    return out


def bill(made: parts.Parts) -> dict[str, dict[str, str]]:
    with (made.folder / 'bom.csv').open(encoding='utf-8') as file:
        return {row['no']: row for row in csv.DictReader(file)}


def test_each_limb_is_put_together_from_the_trunk_to_the_foot(made):
    found, rows = sections(made), bill(made)
    feet = [m.of for m in made.robot.modules if m.words.kind == 'foot']
    assert list(found) == ['trunk', *feet]
    for foot in feet:
        steps = found[foot]
        kinds = [rows[step[1]]['kind'] for step in steps]
        joints = (len(kinds) - 1) // 2
        assert kinds == ['servo', 'printed'] * joints + ['foot']
        assert [step[0] for step in steps] == [str(k) for k in range(1, len(steps) + 1)]
        assert steps[-1][3].endswith(f'as {foot}')
        for part in made.parts:
            for step in (step for step in steps if step[1] == str(part.number)):
                assert f'{part.name}.stl' in step[2] and step[2].split(':')[0] in part.links


def test_the_sheet_has_all_of_the_bill_and_as_many_screws(made):
    steps = [step for lines in sections(made).values() for step in lines]
    on_trunk = {step[3].rpartition('as ')[2] for step in sections(made)['trunk']}
    for number, row in bill(made).items():
        if row['kind'] == 'screw':
            cited = [t for s in steps for t in s[4].split('; ')]
            found = [t for t in cited if f'(no. {number})' in t]
            known = row['name'] != 'pattern not known'
            count = sum(int(re.search(r'(\d+) x', t)[1]) if known else 1 for t in found)
            some = [re.search(rf'(\d+) of no\. {number}[,)]', t) for t in cited]
            count += sum(int(each[1]) for each in some if each)
        elif row['kind'] in ('tie', 'tape'):
            count = sum(f'(no. {number})' in s[4] for s in steps)
        elif row['kind'] == 'trunk':
            continue
        else:
            found = [s for s in steps if s[1] == number and ', on the trunk' not in s[3]]
            count = len(found)
        assert count == int(row['count']), row
    hips = {s[3].split(',')[0].removeprefix('is ') for s in steps if ', on the trunk' in s[3]}
    assert hips and hips <= on_trunk


def test_pictures_have_each_thing_once(made):
    for name, steps in sections(made).items():
        model = mujoco.MjModel.from_xml_path(str(made.folder / f'exploded_{name}.xml'))
        meshes = sum(model.geom_type == mujoco.mjtGeom.mjGEOM_MESH)
        assert meshes == sum('.stl' in s[2] or 'cable tie' in s[4] for s in steps)
        boxes = sum(model.geom_type == mujoco.mjtGeom.mjGEOM_BOX)
        assert boxes >= sum('servo ' in step[2] for step in steps)


def test_screws_of_one_attachment_in_two_rows_of_the_bill_are_told_by_both():
    """Three that bridge 3.5 mm and one that bridges 10.1."""
    module = SimpleNamespace(words=SimpleNamespace(name='MY-1'))
    fixing = SimpleNamespace(module=module, place=SimpleNamespace(name='horn', screw='M2'))
    holes = [SimpleNamespace(fixing=fixing, seat=seat) for seat in (3.5, 10.1, 3.5, 3.5)]
    told = [screw_of(fixing, hole) for hole in holes[:2]]
    rows = [Row('screw', name, 9, None, None, note) for name, note in told]
    words = _Sheet(rows)._of_fixing(SimpleNamespace(holes=holes, pegs=()), fixing)
    assert words == 'horn: 4 x M2, bridging 3.5 to 10.1 mm (3 of no. 1, 1 of no. 2)'


def test_each_servo_shows_its_horn(dog):
    robot = read_built(dog)
    drawing = Drawing(robot)
    for module in robot.modules:
        drawing.module(module, np.zeros(3))
    model = mujoco.MjModel.from_xml_string(drawing.text())
    discs = np.flatnonzero(model.geom_type == mujoco.mjtGeom.mjGEOM_CYLINDER)
    horns = [(m, p) for m in robot.modules for p in m.places if p.on_horn]
    assert len(discs) == len(horns) == 8
    for disc, (module, place) in zip(discs, horns):
        middle = drawing.world(module.body, place.position)
        assert np.linalg.norm(model.geom_pos[disc] - middle) < 0.001
        assert model.geom_size[disc][0] > 0.004


@pytest.mark.long
def test_the_program_draws_each_picture_of_the_sheet(examples, tmp_path):
    robot = build(examples / 'assemblies/printed_puppy.toml', tmp_path / 'robot.xml')
    done = subprocess.run(
        [PROGRAM, 'parts', robot, '-o', tmp_path / 'out', '--quiet'],
        env={**os.environ, 'LEGWRIGHT_PYTHON': sys.executable},
        capture_output=True,
        text=True,
        check=True,
    )
    if 'no exploded' in done.stderr:
        pytest.skip(done.stderr)
    pictures = re.findall(r'\]\((.*)\)', (tmp_path / 'out/assembly.md').read_text())
    assert len(pictures) == 5
    for name in [*pictures, 'exploded.png']:
        assert (tmp_path / 'out' / name).read_bytes()[:4] == b'\x89PNG'


def box(middle: np.ndarray, half: float, number: int | None) -> Thing:
    return Thing(middle + half * SIGNS, number)


def test_numbers_stand_on_no_thing_and_no_other_number():
    things = [
        box(0.1 * i * RIGHT + 0.1 * j * UP + 0.07 * (i + j) * AWAY, 0.03, 10 * i + j)
        for i in range(4)
        for j in range(4)
    ]
    labels = labels_of(things)
    assert sorted(label.number for label in labels) == sorted(t.number for t in things)
    ends = [(e.corner, e.corner + e.height * (UP + RIGHT)) for e in labels]
    camera = Camera(np.vstack([*(t.corners for t in things), *(np.array(e) for e in ends)]))
    boxes = [np.vstack([b.min(axis=0), b.max(axis=0)])
             for b in (camera.seen(np.array(e)) for e in ends)]
    for k, one in enumerate(boxes):
        for other in boxes[:k]:
            assert np.any((one[1] < other[0]) | (other[1] < one[0]))
        inside = camera.seen(np.vstack([t.corners.mean(axis=0) for t in things]))
        assert not np.any(np.all((inside > one[0]) & (inside < one[1]), axis=1))
    nearest = camera.depth(np.vstack([t.corners for t in things])).min()
    assert all(camera.depth(label.corner[None])[0] < nearest for label in labels)


def test_a_picture_is_turned_to_where_less_is_hidden():
    behind = [box(np.zeros(3), 0.03, 1), box(0.3 * AWAY, 0.03, 2)]
    assert hidden(behind) > 0.5
    turn = clearest_turn(behind)
    assert np.allclose(turn @ turn.T, np.eye(3)) and np.linalg.det(turn) > 0
    assert hidden([Thing(t.corners @ turn.T, None) for t in behind]) < 0.1 * hidden(behind)


def test_things_of_a_row_stand_behind_each_other():
    along = np.array([1.0, 0, 0])
    rows = [(box(np.full(3, k * 0.01), 0.02, None).corners, np.zeros(3)) for k in range(3)]
    shifts = spread(rows, 0.005, along)
    ends = [((c + s) @ along).min() for (c, _), s in zip(rows, shifts)]
    assert np.diff(ends) == pytest.approx([0.045, 0.045])
    assert math.isclose(float(shifts[0] @ shifts[0]), 0.0)
