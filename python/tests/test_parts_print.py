# SPDX-License-Identifier: Apache-2.0
"""How parts lie on the bed, whether they keep clear of each other, and the exploded view."""

import math
import re
import shutil
from pathlib import Path

import mujoco
import numpy as np
import pytest
from legwright import InputError, _command, parts
from legwright.parts import __main__ as command
from legwright.parts._fit import Distances, free_range, things_of
from legwright.parts._printing import _directions, best_lying, lying_on
from legwright.parts._robot import home_of, read_built
from legwright.parts._solids import solid_of
from manifold3d import Manifold

TABLE = Manifold.cube((40, 20, 4)).translate((0, 0, 16)) + Manifold.cube((4, 20, 16))


@pytest.fixture
def made(printed) -> parts.Parts:
    return printed('puppy')


class _WithFlatTriangle:
    """A hull one of whose triangles has its corners in a row, as hulls of many points have some."""

    def __init__(self) -> None:
        mesh = Manifold.cube((1, 2, 3)).to_mesh64()
        self.vert_properties = np.vstack([mesh.vert_properties, [[0.5, 0, 0]]])
        self.tri_verts = np.vstack([mesh.tri_verts, [[0, 4, len(mesh.vert_properties)]]])

    def hull(self) -> '_WithFlatTriangle':
        return self

    def to_mesh64(self) -> '_WithFlatTriangle':
        return self


def test_triangles_without_area_look_nowhere():
    ways = _directions(_WithFlatTriangle())
    assert len(ways) == 6, 'the sides of a box'
    assert all(np.linalg.norm(way) == pytest.approx(1) for way in ways)


def test_overhang_and_support_are_those_of_a_table_on_one_leg():
    standing = lying_on(TABLE, np.array([0.0, 0.0, -1.0]))
    assert standing.contact == pytest.approx(4 * 20)
    assert standing.overhang == pytest.approx(36 * 20)
    assert standing.support == pytest.approx(0.15 * 36 * 20 * 16)
    assert standing.seconds == pytest.approx((TABLE.volume() + standing.support) / 4 + 3 * 100)
    assert sorted(standing.size) == pytest.approx([20, 20, 40])
    best = best_lying(TABLE)
    assert best.overhang == 0 and best.down[2] == pytest.approx(1), 'on its top'
    assert best.contact == pytest.approx(40 * 20)
    assert np.allclose(best.turn @ best.turn.T, np.eye(3)) and np.linalg.det(best.turn) > 0


def test_what_touches_little_for_its_height_comes_last(built):
    """Of the hexapod's tibia, which has less overhang on a slanted side of 199 mm2."""
    robot = read_built(built('hexapod'))
    link = next(each for each in robot.links if each.name == 'FL_tibia_link')
    shape = solid_of(robot, link, 0.15, 1.2).shape
    best = best_lying(shape)
    assert best.is_firm and best.contact > 400 and best.contact >= 0.5 * best.size[2] ** 2
    others = [lying_on(shape, down) for down in _directions(shape)]
    assert any(e.overhang < best.overhang and 150 < e.contact < 250 for e in others)
    post = Manifold.cube((4, 4, 30)) + Manifold.sphere(9, 32).translate((2, 2, 30))
    assert not lying_on(post, np.array([0.0, 0.0, -1.0])).is_firm


def test_a_part_fits_a_bed_turned_by_a_quarter_but_not_one_that_is_too_low():
    best = best_lying(TABLE)
    assert best.fits((40, 20, 20)) and best.fits((20, 40, 20))
    assert not best.fits((39, 20, 20)) and not best.fits((40, 20, 19))


def test_stl_lies_as_the_sheet_says(made):
    for part in made.parts:
        low, high = part.mesh.vertices.min(axis=0), part.mesh.vertices.max(axis=0)
        assert np.allclose(low, 0, atol=1e-5)
        assert np.allclose(high, part.lying.size, atol=1e-4)
        assert part.lying.size[2] <= max(part.lying.size) / 2
    sheet = (made.folder / 'prints.md').read_text(encoding='utf-8')
    rows = [line.split(' | ') for line in sheet.splitlines() if line.startswith('| ')][1:]
    walls = {check.part: check.figure for check in made.checks if check.name == 'wall'}
    for part, row in zip(made.parts, rows, strict=True):
        assert row[:3] == [f'| {part.number}', part.name, str(part.count)]
        assert float(row[7]) == pytest.approx(walls[part.name], abs=0.051)
        support = 1.24e-3 * part.lying.support
        assert float(row[9]) == pytest.approx(1e3 * part.solid.mass + support, abs=0.051)
        assert float(row[10]) == pytest.approx(part.lying.seconds / 60, abs=0.51)
    grams = sum(part.count * float(row[9]) for part, row in zip(made.parts, rows))
    assert float(re.search(r'h and (\d+) g', sheet)[1]) == pytest.approx(grams, abs=1.0)


@pytest.mark.long
def test_a_part_that_is_larger_than_the_bed_fails(dog, tmp_path):
    text = dog.read_text(encoding='utf-8')
    own = tmp_path / 'own.xml'
    told = '"bed 0.22 0.22 m margin 0.004 m"'
    assert told in text
    own.write_text(text.replace(told, '"bed 0.06 0.07 m margin 0.002 m"'), encoding='utf-8')
    found = [c for c in parts.make(own, tmp_path / 'out').checks if c.name == 'size on the bed']
    limit = 'in 60.0 x 70.0 x 250.0 mm, 2 mm left free at each side'
    assert {c.limit for c in found} == {limit} and not found[-1].passed
    own.write_text(text.replace(told, '"bed 0.22 0.22 m"'), encoding='utf-8')
    assert read_built(own).margin is None, 'as older programs wrote it'
    for wrong in ('"bed 0.22 m"', '"bed 0.22 0.22 m margin -1 m"', '"bed 0.22 0.22 m margin 4 mm"'):
        own.write_text(text.replace(told, wrong), encoding='utf-8')
        with pytest.raises(InputError, match='text legwright_print: '):
            parts.make(own, tmp_path / 'out')
    small = parts.make(dog, tmp_path / 'out', parts.PartOptions(bed=(60, 60, 60)))
    failed = {check.name for check in small.checks if not check.passed}
    assert failed == {'size on the bed'} and '| NO |' in (tmp_path / 'out/prints.md').read_text()


def test_a_joint_is_free_until_something_is_in_its_way(dog, made):
    robot = read_built(dog)
    distances = Distances(robot, things_of(robot, made.parts))
    joint = robot.model.joint('FL_knee').id
    free = free_range(robot, distances, joint, [-1.0], 0.5)
    assert free.gap == pytest.approx(1.0, abs=1e-6) and 'FL_knee_servo' in free.where
    assert -math.pi < free.low < -2.0 and 2.0 < free.high < math.pi
    assert 'part FL_shank' in free.stops[0] and 'part FL_thigh' in free.stops[0]
    wide = free_range(robot, distances, joint, [-1.0], 1.5)
    assert wide.gap < 1.5, 'what is nearer at all angles is told'


def test_distances_are_those_of_a_pose(dog):
    """Two feet, whose centres MuJoCo knows."""
    robot = read_built(dog)
    distances = Distances(robot, things_of(robot, []))
    left, right = (next(t for t in distances.things if t.name == n) for n in ('FL', 'FR'))
    data = mujoco.MjData(robot.model)
    data.qpos[:] = home_of(robot)
    mujoco.mj_kinematics(robot.model, data)
    distances.pose(data.qpos)
    ways = data.geom('FL').xpos - data.geom('FR').xpos
    expected = 1e3 * (np.linalg.norm(ways) - 0.024)
    assert distances.gap(left, right, 1e3) == pytest.approx(expected, abs=0.1)


@pytest.fixture
def run(dog, tmp_path) -> Path:
    """A folder like that of a run, whose gait the test writes."""
    result = tmp_path / 'run/result'
    result.mkdir(parents=True)
    shutil.copy(dog, result / 'robot.xml')
    return tmp_path / 'run'


def plan(run: Path, names: list[str], angles: np.ndarray) -> None:
    """A motion.csv that stands still and presses with 4 N on each foot."""
    row = {'time_s': 0.0}
    row |= {f'q:{name}_rad': angle for name, angle in zip(names, angles)}
    row |= {f'tau:{name}_Nm': 0.0 for name in names}
    row |= {f'root_{a}_m': 0.0 for a in 'xyz'} | {f'root_r{a}_rad': 0.0 for a in 'xyz'}
    row |= {f'com_{a}_m': 0.0 for a in 'xyz'}
    for foot in ('FL', 'FR', 'HL', 'HR'):
        row |= {f'foot:{foot}_{a}_m': 0.0 for a in 'xyz'}
        row |= {f'foot:{foot}_f{a}_N': 4.0 * (a == 'z') for a in 'xyz'} | {f'contact:{foot}': 1}
    lines = [','.join(row), *(','.join(map(str, row.values())) for _ in range(2))]
    (run / 'result/motion.csv').write_text('\n'.join(lines) + '\n')


def gait(run: Path, knee: float) -> None:
    robot = read_built(run / 'result/robot.xml')
    names = [robot.model.joint(j).name for j in range(1, robot.model.njnt)]
    home = home_of(robot)
    rows = ['time_s,' + ','.join(f'{name}_rad' for name in names)]
    for k, share in enumerate((0.0, 0.5, 1.0)):
        angles = dict(zip(names, home[7:]))
        angles['FL_knee'] += share * (knee - angles['FL_knee'])
        rows.append(f'{0.1 * k},' + ','.join(f'{angles[name]}' for name in names))
    plan(run, names, home[7:])
    (run / 'result/playback_result.csv').write_text('\n'.join(rows) + '\n')


@pytest.mark.long
def test_a_gait_in_which_parts_meet_fails_and_says_where(run, tmp_path):
    gait(run, -1.5)
    good = parts.make(run, tmp_path / 'good')
    assert good.passed, [check for check in good.checks if not check.passed]
    assert any(check.name == 'gap in the gait as played' for check in good.checks)
    beams = [check for check in good.checks if check.name == 'bears the plan']
    assert len(beams) == 4 and all(2.0 < check.figure < 50.0 for check in beams)
    gait(run, -math.pi)
    bad = parts.make(run, tmp_path / 'bad')
    failed = {check.name: check for check in bad.checks if not check.passed}
    assert set(failed) == {'gap in the gait as played', 'range of FL_knee'}
    assert 't = 0.20 s' in failed['gap in the gait as played'].where
    assert 'works from -180 to -60' in failed['range of FL_knee'].where


@pytest.mark.parametrize('file', ['playback_result.csv', 'motion.csv'])
def test_a_damaged_file_of_a_run_is_bad_input(run, file, tmp_path, capsys):
    gait(run, -1.5)
    table = run / 'result' / file
    good = table.read_text()
    head, *rows = good.splitlines()
    columns = head.split(',')
    at = columns.index('FL_knee_rad' if file.startswith('playback') else 'q:FL_knee_rad')
    cells = rows[1].split(',')
    cells[at] = 'nan'
    damaged = {
        'it is empty': '',
        'it has no rows': head + '\n',
        f'line {len(rows) + 1} has 2 values': good[: good.rindex('\n', 0, -1)] + '\n0.2,0.1',
        f'{columns[at]} is nan': f'{head}\n{",".join(cells)}',
        'could not convert': good.replace('0.0', 'O.0', 1),
        'has no column': good.replace('time_s', 'other', 1),
    }
    for words, text in damaged.items():
        table.write_text(text)
        assert command.main([str(run), '-o', str(tmp_path / 'out')]) == _command.BAD_INPUT, words
        said = capsys.readouterr().err
        assert words in said and 'makes it anew' in said and file in said
    assert not (tmp_path / 'out').exists()


def test_a_column_that_the_loads_need_is_missed_by_name(run, tmp_path):
    gait(run, -1.5)
    table = run / 'result/motion.csv'
    table.write_text(table.read_text().replace('tau:FL_knee_Nm', 'other', 1))
    with pytest.raises(InputError, match="motion.csv: .*'tau:FL_knee_Nm'.*optimize"):
        parts.make(run, tmp_path / 'out')


def test_loads_that_are_not_there_do_not_pass(run, tmp_path):
    gait(run, -1.5)
    table = run / 'result/motion.csv'
    good = table.read_text()
    table.write_text(good.replace(':FL', ':foot_a'))
    with pytest.raises(InputError, match='has no geom foot_a'):
        parts.make(run, tmp_path / 'out')
    table.write_text('\n'.join(good.splitlines()[:2]))
    with pytest.raises(InputError, match='single row'):
        parts.make(run, tmp_path / 'out')
    table.write_text(good.replace('4.0', '0.0'))
    made = parts.make(run, tmp_path / 'out')
    failed = [check for check in made.checks if not check.passed]
    assert [check.name for check in failed].count('bears the plan') == 4
    assert [check.name for check in failed].count('peg bears the plan') == 2
    assert len(failed) == 6


def test_a_servo_without_a_limit_does_not_pass(dog, tmp_path):
    robot = tmp_path / 'robot.xml'
    robot.write_text(dog.read_text().replace(' forcerange="-1.4 1.4"', ''))
    failed = [check for check in parts.make(robot, tmp_path / 'out').checks if not check.passed]
    assert len(failed) == 4 and 'has a forcerange' in failed[0].where


@pytest.mark.long
def test_of_a_run_for_several_tasks_all_gaits_count(run, tmp_path):
    gait(run, -1.5)
    for task in ('trot', 'sideways'):
        (run / f'tasks/{task}').mkdir(parents=True)
        shutil.copytree(run / 'result', run / f'tasks/{task}/result')
    (run / 'result/motion.csv').unlink()
    (run / 'result/playback_result.csv').unlink()
    assert parts.make(run, tmp_path / 'good').passed
    gait(run, -math.pi)
    shutil.copy(run / 'result/playback_result.csv', run / 'tasks/trot/result')
    (run / 'result/motion.csv').unlink()
    bad = parts.make(run, tmp_path / 'bad')
    (failed,) = [check for check in bad.checks if check.name == 'gap in the gaits as played']
    assert not failed.passed and 'trot, t = 0.20 s' in failed.where
    beams = [check for check in bad.checks if check.name == 'bears the plan']
    assert beams and all(', t = ' in check.where for check in beams)
    shutil.rmtree(run / 'tasks')
    with pytest.raises(InputError, match='has no gait'):
        parts.make(run, tmp_path / 'none')


def test_the_exploded_view_has_each_thing_once(made):
    model = mujoco.MjModel.from_xml_path(str(made.folder / 'exploded.xml'))
    meshes = sum(model.geom_type == mujoco.mjtGeom.mjGEOM_MESH)
    boxes = sum(model.geom_type == mujoco.mjtGeom.mjGEOM_BOX)
    balls = sum((model.geom_type == mujoco.mjtGeom.mjGEOM_SPHERE) & (model.geom_size[:, 0] > 0.01))
    assert (meshes, boxes, balls) == (9, 9, 4)
