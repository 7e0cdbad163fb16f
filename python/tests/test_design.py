# SPDX-License-Identifier: Apache-2.0
import dataclasses
import gc
import json
import subprocess
import sys
from pathlib import Path

import legwright as lw
import numpy as np
import pytest


def test_terms_sum_to_the_cost(walk):
    assert sum(walk.terms.values()) == pytest.approx(walk.F, rel=1e-12)
    assert walk.terms['travel'] < 1e-3 and walk.J == 0.0


def test_terms_are_there_after_the_verbs_have_been_at_the_run(walk, tmp_path):
    copy = lw.Design.load(walk.save(tmp_path / 'run'))
    program = Path(lw.__file__).parent / 'bin/legwright'
    subprocess.run([program, 'validate', '--quick', tmp_path / 'run'], check=True)
    validated = lw.Design.load(tmp_path / 'run')
    assert validated.terms == walk.terms and copy.terms == walk.terms
    subprocess.run([program, 'pick', '--iteration', '1', tmp_path / 'run'], check=True)
    picked = lw.Design.load(tmp_path / 'run')
    assert sum(picked.terms.values()) == pytest.approx(picked.F, rel=1e-12)
    assert picked.F > 1.01 * walk.F


def test_motion_keeps_what_a_motion_must(walk, puppy):
    motion = walk.motion
    knots, joints, feet = motion.time.size, 12, 4
    assert motion.joints.shape == motion.torques.shape == (knots, joints)
    assert motion.root.shape == (knots, 6) and motion.com.shape == (knots, 3)
    assert motion.feet.shape == motion.forces.shape == (knots, feet, 3)
    assert motion.contact.shape == (knots, feet) and motion.contact.dtype == bool
    assert motion.foot_names == tuple(puppy.feet) and len(motion.joint_names) == joints
    assert motion.period == pytest.approx(1.0)
    assert motion.travel == pytest.approx([0.0, 0.1, 0.0], abs=1e-3)
    assert np.allclose(motion.joints[0], motion.joints[-1], atol=1e-3)
    assert np.all(motion.forces[~motion.contact] == 0.0)
    weight = 9.81 * walk.record['body']['final']['mass_kg']
    assert motion.forces[:-1, :, 2].sum(axis=1).mean() == pytest.approx(weight, rel=0.01)
    heights = motion.feet[..., 2]
    assert heights[motion.contact].max() < 0.013 < heights[~motion.contact].max()


def test_a_motion_is_shown_in_a_line(walk):
    joints, knots = walk.motion.joints.shape[1], len(walk.motion.time)
    wanted = f'<Motion: {joints} joints, 4 feet over {walk.motion.period:g} s at {knots} knots>'
    assert repr(walk.motion) == str(walk.motion) == wanted


def test_motions_are_compared_by_their_numbers(walk):
    motion = walk.motion
    assert motion == dataclasses.replace(motion, time=motion.time.copy())
    assert motion != dataclasses.replace(motion, time=motion.time + 1e-9)
    assert motion != 'walk' and motion in [motion]
    point = lw.FrontPoint(0.5, 1.0, {'pace': 1.0}, motion.time, 'converged')
    assert point == dataclasses.replace(point) != dataclasses.replace(point, s=motion.time[1:])


def test_verdict_and_certificate_are_those_of_the_run(walk):
    assert walk.verdict and str(walk.verdict).startswith('PASS  walk sideways')
    assert walk.verdict.merit == 0.0
    assert walk.certificate['schema'] == 'legwright/certificate'
    assert walk.certificate['worst_gradient_error'] < 1e-6


def test_why_tells_what_each_change_buys(walk, puppy):
    changed = {n for n, value in walk.parameters.items() if value != puppy.parameters[n].value}
    assert {change.parameter for change in walk.why} == changed
    most = walk.why[0]
    assert most.before == puppy.parameters[most.parameter].value
    assert most.after == walk.parameters[most.parameter]
    assert [c.buys for c in walk.why] == sorted((c.buys for c in walk.why), reverse=True)
    assert most.buys > 0.01 * walk.F and sum(most.terms.values()) == pytest.approx(most.buys)
    assert most.played.startswith(('PASS', 'FAIL')) and most.parameter in str(most)
    text = lw.Design.load(walk.folder).why
    assert text == walk.why


def test_a_cost_that_is_none_is_infinite(walk, tmp_path):
    design = lw.Design.load(walk.save(tmp_path / 'run'))
    for key in ('final_F', 'final_J', 'motion_only_F'):
        design.record[key] = None
    design.record['final_terms'] = {'smoothness': None}
    assert design.F == design.J == design.motion_only_F == float('inf')
    assert design.terms == {'smoothness': float('inf')} and 'inf' in design._repr_html_()


def test_what_fails_is_handed_back_with_reasons(puppy):
    coarse = lw.Task({'name': 'walk', 'period': 1.0, 'knots': 12}, (0.0, 0.1))  # few motions
    design = lw.codesign(puppy, coarse, motion_only=True, reasons=False, certificate=False)
    assert not design.feasible and design.reasons
    assert not design.verdict and 'FAIL' in design.verdict.line
    assert design.s.tolist() == puppy.s.tolist()
    assert design.certificate is None and design.why == []


def test_saved_runs_are_loaded_as_they_were(walk, tmp_path):
    folder = walk.save(tmp_path / 'mine')
    saved = sorted(path.relative_to(folder) for path in folder.rglob('*') if path.is_file())
    for path in saved:
        assert (folder / path).read_bytes() == (walk.folder / path).read_bytes()
    again = lw.Design.load(folder)
    assert again.F == walk.F and again.s.tolist() == walk.s.tolist()
    with pytest.raises(lw.IoError, match='already holds a run'):
        walk.save(folder)
    assert walk.save(folder, force=True) == folder


def test_saving_where_it_lies_loses_nothing(walk, tmp_path):
    design = lw.Design.load(walk.save(tmp_path / 'mine'))
    before = sorted(tmp_path.rglob('*'))
    assert design.save(tmp_path / 'mine', force=True) == tmp_path / 'mine'
    with pytest.raises(lw.IoError, match='name another folder'):
        design.save(tmp_path / 'mine/result/inside', force=True)
    assert sorted(tmp_path.rglob('*')) == before


def test_another_design_that_was_picked_has_its_own_verdict(walk, tmp_path):
    """An iterate that nobody played has none."""
    folder = walk.save(tmp_path / 'mine')
    program = Path(sys.executable).parent / 'legwright'
    done = subprocess.run([program, 'pick', folder, '--iteration', '1'], check=False)
    assert done.returncode in (0, 1)
    assert lw.Design.load(folder).verdict is None


@pytest.fixture(scope='module')
def two(examples):
    """A body as given that does two tasks, of which MuJoCo does not pass the coarse one."""
    coarse = lw.Task({'name': 'walk', 'period': 1.0, 'knots': 12}, (0.0, 0.1), name='coarse')
    slow = lw.Task('walk', (0.0, 0.05), name='slow')
    quick = {'motion_only': True, 'reasons': False, 'certificate': False, 'one_start': True}
    return lw.codesign(lw.Robot(examples / 'puppy/robot.xml'), [coarse, slow], **quick)


def test_each_of_several_tasks_has_its_verdict(two):
    verdicts = {name: design.verdict for name, design in two.tasks.items()}
    assert list(verdicts) == ['coarse', 'slow'] and None not in verdicts.values()
    assert not verdicts['coarse'] and 'at 0.050 m/s' in verdicts['slow'].line
    assert not two.verdict and verdicts['coarse'].line in two.verdict.line
    merits = sum(verdict.merit for verdict in verdicts.values())
    assert two.verdict.merit == pytest.approx(merits)
    assert two.tasks['coarse'].tasks['coarse'].verdict == verdicts['coarse']


def test_what_the_optimum_costs_is_told_where_another_was_handed_back(walk):
    assert walk.optimum_F == walk.record['choice']['candidates'][0]['F']
    other = lw.Design.load(walk.folder)
    other.record['final_F'] = 2.0 * walk.optimum_F
    assert 2.0 * other.optimum_F == other.F
    del other.record['choice']  # plan_only: nothing was played
    assert other.optimum_F == other.F


def test_a_folder_without_a_run_is_refused(tmp_path):
    with pytest.raises(lw.IoError, match='holds no run'):
        lw.Design.load(tmp_path)


def test_a_temporary_run_goes_with_its_design(puppy, sideways):
    design = lw.codesign(
        puppy, sideways, max_iterations=1, plan_only=True, reasons=False, certificate=False
    )
    folder = design.folder
    assert json.loads((folder / 'run.json').read_text())['schema'] == 'legwright/run'
    del design
    gc.collect()
    assert not folder.exists()
