# SPDX-License-Identifier: Apache-2.0
"""The run with the masses of its printed parts, and how it walks so."""

from __future__ import annotations

import hashlib
import json
import shutil
import subprocess
from pathlib import Path
from typing import TYPE_CHECKING

import legwright as lw
import numpy as np
import pytest

mujoco = pytest.importorskip('mujoco')
pytest.importorskip('manifold3d')
trimesh = pytest.importorskip('trimesh')

from legwright import parts  # noqa: E402
from legwright.parts._as_printed import as_printed, check_as_printed, unpacked  # noqa: E402
from legwright.parts._folder import check_place  # noqa: E402

if TYPE_CHECKING:
    from collections.abc import Sequence

PROGRAM = Path(lw.__file__).parent / 'bin/legwright'


@pytest.fixture(scope='module')
def run(examples, tmp_path_factory) -> Path:
    """The trot that `build` writes for the printed puppy."""
    folder = tmp_path_factory.mktemp('puppy')
    robot, task, made = folder / 'puppy.xml', folder / 'trot.toml', folder / 'run'
    assembly = examples / 'assemblies/printed_puppy.toml'
    for words in (
        ['build', assembly, '-o', robot, '--task', task],
        ['optimize', task, '-o', made, '--no-pictures', '--no-reasons'],
    ):
        subprocess.run([PROGRAM, *words], check=True, capture_output=True)
    return made


@pytest.fixture(scope='module')
def made(run, tmp_path_factory) -> parts.Parts:
    return parts.make(run, tmp_path_factory.mktemp('made') / 'parts')


def changed(run: Path, place: Path, old: str, new: str) -> Path:
    """A copy of the run, as of a program that knew no sums, with another text in its scene."""
    shutil.copytree(run, place)
    scene = place / 'result/scene.xml'
    text = scene.read_text(encoding='utf-8')
    assert old in text
    scene.write_text(text.replace(old, new), encoding='utf-8')
    record = json.loads((place / 'run.json').read_bytes())
    del record['scenes']
    (place / 'run.json').write_text(json.dumps(record), encoding='utf-8')
    return place


def test_the_result_weighs_and_turns_as_the_solids(made):
    model = mujoco.MjModel.from_xml_path(str(made.folder / 'as_printed/result/robot.xml'))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    linked = [part for part in made.parts if part.solid.link.servo is not None]
    assert len(linked) == 4
    for part in linked:
        stl, solid = trimesh.load(made.folder / f'{part.name}.stl'), part.solid
        bodies = [model.body(hull.words.name).id for hull in solid.link.hulls]
        masses = model.body_mass[bodies]
        assert masses.sum() == pytest.approx(solid.density * stl.volume * 1e-9, rel=1e-5)
        centre = masses @ data.xipos[bodies] / masses.sum()
        inertia = np.zeros((3, 3))
        for body, mass in zip(bodies, masses, strict=True):
            turn, off = data.ximat[body].reshape(3, 3), data.xipos[body] - centre
            inertia += turn @ np.diag(model.body_inertia[body]) @ turn.T
            inertia += mass * (off @ off * np.eye(3) - np.outer(off, off))
        told = np.linalg.eigvalsh(stl.moment_inertia) * solid.density * 1e-15
        assert np.linalg.eigvalsh(inertia) == pytest.approx(told, rel=1e-4)


def test_nothing_else_of_the_run_changes(run, made):
    kept = 'result/motion.csv', 'iterations/0000/scene.xml', 'inputs/task.toml'
    for name in kept:
        assert (made.folder / 'as_printed' / name).read_bytes() == (run / name).read_bytes()
    for name in ('result/robot.xml', 'result/scene.xml'):
        old = (run / name).read_text(encoding='utf-8').splitlines()
        new = (made.folder / 'as_printed' / name).read_text(encoding='utf-8').splitlines()
        differing = [a for a, b in zip(old, new, strict=True) if a != b]
        assert len(differing) == 16
        assert all('<inertial' in line for line in differing)
    old, new = ((place / 'run.json').read_bytes() for place in (run, made.folder / 'as_printed'))
    scenes = json.loads(new)['scenes']
    scene = (made.folder / 'as_printed/result/scene.xml').read_bytes()
    assert scenes['result/scene.xml'] == hashlib.sha256(scene).hexdigest()
    was = json.loads(old)['scenes']['result/scene.xml']
    key = '"result/scene.xml": "%s"'
    assert new == old.replace(
        (key % was).encode(), (key % scenes['result/scene.xml']).encode()
    ), 'the rest of run.json'


def of_walks(checks: Sequence[parts.Check]) -> parts.Check:
    return next(check for check in checks if check.name == 'walks as printed')


def test_it_walks_and_is_an_ordinary_run(made, tmp_path):
    check = of_walks(made.checks)
    assert check.passed
    assert check.where.startswith('PASS  trot forward at 0.170 m/s')
    assert made.document['passed']
    copy = tmp_path / 'parts'
    shutil.copytree(made.folder, copy)
    words = [PROGRAM, 'validate', copy / 'as_printed', '--quick']
    assert subprocess.run(words, check=False, capture_output=True).returncode == 0
    check_place(copy)  # what was judged in it is no foreign file


def test_parts_bear_what_is_played_and_the_plan_where_nothing_can_be(run, made, tmp_path):
    beams = {check.part: check for check in made.checks if check.name == 'bears the gait'}
    assert len(beams) == 4 and all(check.passed for check in beams.values())
    assert not [check for check in made.checks if 'the plan' in check.name]
    half = tmp_path / 'half'
    shutil.copytree(run, half)
    (half / 'run.json').unlink()
    again = parts.make(half, tmp_path / 'half_parts')
    assert [c.name for c in again.checks].count('bears the gait') == 4, 'the run itself is played'
    (half / 'result/scene.xml').unlink()
    planned = parts.make(half, tmp_path / 'planned')
    told = {check.part: check for check in planned.checks if check.name == 'bears the plan'}
    assert len(told) == 4 and not [c for c in planned.checks if c.name == 'bears the gait']
    assert [c.name for c in planned.checks].count('peg bears the plan') == 2
    thigh = min(beams.values(), key=lambda check: check.figure).part
    assert beams[thigh].figure < 0.8 * told[thigh].figure, 'touch-downs'


def test_the_report_of_the_run_as_printed_has_the_safety_factors(made, tmp_path):
    record = json.loads((made.folder / 'as_printed/result/strength.json').read_bytes())
    loads = [row['load'] for row in record['parts']]
    assert loads.count('bears the gait') == loads.count('bears its servo') == 4
    told = {(check.part, check.name): check for check in made.checks}
    for row in record['parts']:
        assert row['factor'] == told[row['part'], row['load']].figure
        assert row['least_factor'] == (1.0 if row['load'] == 'bears its servo' else 2.0)
    copy = tmp_path / 'parts'
    shutil.copytree(made.folder, copy)
    words = [PROGRAM, 'report', copy / 'as_printed']
    subprocess.run(words, check=True, capture_output=True)
    page = (copy / 'as_printed/report.html').read_text(encoding='utf-8')
    assert 'Printed parts' in page and 'All 10 are strong enough' in page


def test_a_run_that_fails_as_planned_says_so(run, made, tmp_path):
    ice = changed(run, tmp_path / 'ice', 'friction="0.8 ', 'friction="0.01 ')
    with unpacked(as_printed(made.robot, made.parts, ice, made.folder)) as printed:
        check = of_walks(check_as_printed(printed, made.parts, ice))
    assert not check.passed
    assert check.remedy.startswith('as planned it fails, too')
    assert check.where.startswith('FAIL')


def test_a_robot_without_the_inertial_is_refused(run, made, tmp_path):
    bare = changed(run, tmp_path / 'bare', '<inertial pos="0 0.0035 -0.0238"', '<!-- x --><site')
    with pytest.raises(lw.InputError, match='FL_thigh_boss: expected one <inertial>'):
        as_printed(made.robot, made.parts, bare, made.folder)


def test_a_folder_that_is_no_whole_run_has_none(run, made, tmp_path):
    half = tmp_path / 'half'
    shutil.copytree(run, half)
    (half / 'run.json').unlink()
    assert as_printed(made.robot, made.parts, half, made.folder) == {}


def test_parts_in_their_own_run_are_no_part_of_it(run, made, tmp_path):
    whole = tmp_path / 'run'
    shutil.copytree(run, whole)
    first = as_printed(made.robot, made.parts, whole, whole / 'parts')
    shutil.copytree(made.folder, whole / 'parts')
    assert as_printed(made.robot, made.parts, whole, whole / 'parts') == first
