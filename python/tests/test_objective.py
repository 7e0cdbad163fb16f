# SPDX-License-Identifier: Apache-2.0
import json
import signal
import subprocess
import sys
import threading
import time

import legwright as lw
import numpy as np
import pytest

QUICK = {'reasons': False, 'certificate': False, 'plan_only': True}
FEW = {**QUICK, 'max_iterations': 2}


def work(s, motion, epsilon):
    """The term mechanical_work [J]."""
    q, tau = motion.joints, motion.torques[:-1]
    before = np.roll(q[:-1], 1, axis=0)
    x = 0.5 * tau * (q[1:] - before)
    root = np.sqrt(x * x + epsilon * epsilon)
    slope = 0.5 * (1.0 + x / root)
    by_q, by_tau = np.zeros_like(q), np.zeros_like(motion.torques)
    by_tau[:-1] = slope * 0.5 * (q[1:] - before)
    by_q[1:] += 0.5 * slope * tau
    by_q[:-1] -= np.roll(0.5 * slope * tau, -1, axis=0)
    value = float(np.sum(0.5 * (x + root - epsilon)))
    return value, None, {'joints': by_q, 'torques': by_tau}


def peak(s, motion):
    """A smooth maximum of all torques [N m]: their 16-norm."""
    tau = motion.torques[:-1]
    scale = np.max(np.abs(tau))
    value = scale * np.sum((tau / scale) ** 16) ** (1 / 16)
    by_tau = np.zeros_like(motion.torques)
    by_tau[:-1] = (tau / value) ** 15
    return float(value), None, {'torques': by_tau}


def volume(s, motion):
    return motion.printed_volume, None, {'printed_volume': 1.0}


def length(s, motion):
    return float(s[0]), {'front_thigh_length': 1.0}, None


def walk_task(outer=None):
    return lw.Task('walk', (0.1, 0.0), period=1.0, outer=outer, limits={'swing_height': 0.015})


def same(ours, theirs):
    assert pytest.approx(theirs.J, rel=1e-9) == ours.J
    assert pytest.approx(theirs.F, rel=1e-9) == ours.F
    assert ours.s == pytest.approx(theirs.s, rel=1e-9, abs=1e-12)
    plan = ('reference', 'plan_initial', 'plan_final')
    for key in plan:
        assert ours.record['outer'][key] == pytest.approx(theirs.record['outer'][key], rel=1e-9)


def test_a_volume_in_python_is_the_programs(examples):
    robot = lw.Robot(examples / 'printed_quadruped/robot.xml')
    options = {'reasons': False, 'certificate': False}
    theirs = lw.codesign(
        robot, walk_task({'objective': 'printed_volume', 'weight': 2.0}), **options
    )
    mine = lw.Objective(volume, weight=2.0, reference=None, unit='m^3')
    ours = lw.codesign(robot, walk_task(), objective=mine, **options)
    same(ours, theirs)
    assert ours.verdict.line == theirs.verdict.line
    assert 'source' not in theirs.record['outer']
    assert ours.record['outer']['objective'] == 'volume'
    assert ours.record['outer']['source'] == 'Python: test_objective.volume'
    assert ours.record['outer']['unit'] == 'm^3'


def test_work_in_python_is_the_programs(puppy):
    theirs = lw.codesign(puppy, walk_task({'objective': 'mechanical_work'}), **FEW)
    level = lw.codesign(puppy, walk_task({'objective': 'peak_torque'}), motion_only=True, **FEW)
    rounding = 1e-4 * 2.0 * level.record['outer']['reference']  # half of weight times leg
    seen = []

    def mine(s, motion):
        seen.append(motion)
        return work(s, motion, rounding)

    ours = lw.codesign(puppy, walk_task(), objective=lw.Objective(mine, reference=None), **FEW)
    same(ours, theirs)
    motion = seen[-1]
    assert motion.mass == pytest.approx(ours.record['body']['initial']['mass_kg'])
    assert motion.task == 'walk' and motion.foot_names == tuple(puppy.feet)
    # What it was asked last stands in the files of the run, but for torques: these are MuJoCo's.
    for name in ('time', 'joints', 'root', 'com', 'feet', 'forces', 'contact'):
        kept, told = getattr(ours.motion, name), getattr(motion, name)
        assert kept.shape == told.shape
    assert motion.torques.shape == ours.motion.torques.shape
    assert (motion.forces[~motion.contact] == 0.0).all()
    assert motion.torques[0].tolist() == motion.torques[-1].tolist()


@pytest.mark.long
def test_it_is_lowered_besides_f_with_all_that_a_run_tells(puppy):
    threads = set()

    def told(s, motion):
        threads.add(threading.get_ident())
        return peak(s, motion)

    given = lw.codesign(puppy, walk_task(), motion_only=True, **QUICK)
    design = lw.codesign(
        puppy, walk_task(), objective=lw.Objective(told, weight=0.3, name='torque', unit='N m')
    )
    assert threads == {threading.get_ident()}
    outer = design.record['outer']
    assert (outer['objective'], outer['unit'], outer['reference']) == ('torque', 'N m', 1.0)
    assert outer['plan_final'] < outer['plan_initial']
    assert pytest.approx(0.3 * outer['plan_final']) == design.J
    assert np.max(np.abs(design.motion.torques)) < np.max(np.abs(given.motion.torques))
    assert design.verdict is not None and 'choice' in design.record
    assert design.certificate['worst_gradient_error'] < 1e-4  # of F + J
    assert all('J' in row for row in design.record['put_back'])


def test_several_tasks_and_starts_are_asked_one_at_a_time(puppy):
    few = {'name': 'walk', 'period': 1.0, 'knots': 12}
    slow, fast = (lw.Task(few, (v, 0.0), name=name) for v, name in ((0.05, 'slow'), (0.1, 'walk')))
    tasks = [(fast, 0.25), (slow, 0.75)]
    inside, seen = [0], []

    def counted(s, motion):
        inside[0] += 1
        seen.append((motion.task, inside[0], threading.get_ident()))
        time.sleep(0.0001)  # lets others in
        inside[0] -= 1
        return peak(s, motion)

    options = {**QUICK, 'max_iterations': 1, 'one_start': True, 'starts': 1}
    one, two = (
        lw.codesign(puppy, tasks, objective=counted, threads=threads, **options)
        for threads in (1, 2)
    )
    assert {each[0] for each in seen} == {'walk', 'slow'}
    assert {each[1:] for each in seen} == {(1, threading.get_ident())}
    assert one.s.tolist() == two.s.tolist() and one.J == two.J
    walk, slower = one.tasks.values()
    assert pytest.approx(0.25 * walk.J + 0.75 * slower.J, rel=1e-12) == one.J
    assert walk.J > 0.0 and slower.J > 0.0


def wrong_length(s, motion):
    return float(s[0] ** 2), {'front_thigh_length': s[0]}, None


def wrong_torque(s, motion):
    value, _, gradient = peak(s, motion)
    gradient['torques'][3, 4] += 0.5
    return value, None, gradient


def forgotten(s, motion):
    return float(np.sum(motion.com[:, 2] ** 2) + np.sum(motion.feet[2, 1] ** 2)), None, None


@pytest.mark.parametrize(
    ('function', 'said'),
    [
        (wrong_length, r"wrong_length: dJ_ds\['front_thigh_length'\] is 0\.0\d+, central .* 0\.1"),
        (wrong_torque, r"dJ_dm\['torques'\]\[3, 4\] \(joint FR_knee\) is"),
        (forgotten, r"dJ_dm\['com'\]\[\d+, 2\] is 0, "),
    ],
)
def test_a_wrong_gradient_is_told_by_its_worst_entry(puppy, function, said, tmp_path):
    with pytest.raises(lw.InputError, match=said) as caught:
        lw.codesign(puppy, walk_task(), objective=function, folder=tmp_path / 'run', **FEW)
    assert 'check_gradient=False' in str(caught.value) and "task 'walk'" in str(caught.value)
    assert not (tmp_path / 'run').exists()


def test_a_gradient_is_not_checked_where_told_so(puppy):
    options = {**FEW, 'max_iterations': 1, 'check_gradient': False}
    assert lw.codesign(puppy, walk_task(), objective=wrong_length, **options).J > 0.0


@pytest.mark.parametrize(
    ('answer', 'said'),
    [
        (1.0, r'must return a tuple \(J, dJ_ds, dJ_dm\), returned 1.0'),
        (('much', None, None), "J must be a number, is 'much'"),
        ((float('nan'), None, None), "J is nan for task 'walk'; it must be finite"),
        ((1.0, [0.0], None), r'dJ_ds has the shape \(1,\), must have \(20,\)'),
        ((1.0, {'body_width': 'wide'}, None), r"\['body_width'\] must hold numbers, is 'wide'"),
        ((1.0, {'body_width': [1.0, 2.0]}, None), r"dJ_ds\['body_width'\] has the shape \(2,\)"),
        ((1.0, {'font_thigh_length': 1.0}, None), "'font_thigh_length'; is 'front_thigh_length'"),
        ((1.0, None, {'torque': 0.0}), "dJ_dm has the name 'torque'; is 'torques' meant"),
        ((1.0, None, {'torques': 0.0}), r'the shape \(\), must have \(25, 12\)'),
        ((1.0, None, {'feet': np.zeros((25, 12))}), r'must have \(25, 4, 3\)'),
        ((1.0, None, {'mass': float('inf')}), 'derivative by mass is inf'),
        ((1.0, None, [1.0]), 'dJ_dm must be a dict by name or None, is list'),
    ],
)
def test_what_a_function_may_not_return(puppy, answer, said):
    def mine(s, motion):
        return answer

    with pytest.raises(lw.InputError, match=said) as caught:
        lw.codesign(puppy, walk_task(), objective=mine, **FEW)
    assert str(caught.value).startswith('objective mine: ')


def test_what_it_raises_stops_the_run_and_arrives(puppy, tmp_path):
    calls = []

    def fails(s, motion):
        calls.append(s.tolist())
        if s.tolist() != calls[0]:
            raise ZeroDivisionError('another body')
        return length(s, motion)

    with pytest.raises(ZeroDivisionError, match='another body'):
        lw.codesign(
            puppy,
            walk_task(),
            objective=fails,
            folder=tmp_path / 'run',
            check_gradient=False,
            **QUICK,
        )
    record = json.loads((tmp_path / 'run/run.json').read_text(encoding='utf-8'))
    assert record['status'] == 'failed'
    assert record['failure'] == 'objective fails: ZeroDivisionError: another body'


def test_that_of_the_readme_lowers_what_it_says(puppy, examples):
    readme = (examples.parent / 'python/README.md').read_text(encoding='utf-8')
    start = readme.index('def heat')
    names = {'np': np}
    exec(readme[start : readme.index('\n\n', start)], names)
    mine = lw.Objective(names['heat'], weight=20.0, unit='N^2 m^2')
    design = lw.codesign(puppy, walk_task(), objective=mine, **{**QUICK, 'max_iterations': 6})
    outer = design.record['outer']
    assert outer['plan_final'] < 0.8 * outer['plan_initial']
    mean = np.mean(design.motion.torques[:-1] ** 2)
    assert mean == pytest.approx(outer['plan_final'], rel=0.05)  # MuJoCo's torques and the plan's


def test_one_objective_is_enough(puppy):
    with pytest.raises(lw.InputError, match=r"asks for 'mechanical_work', and an objective was"):
        lw.codesign(puppy, walk_task({'objective': 'mechanical_work'}), objective=length)


def test_an_objective_says_what_it_needs():
    with pytest.raises(TypeError, match='an objective is a function, not int'):
        lw.Objective(3)
    with pytest.raises(lw.InputError, match='length: weight must be a positive number, is 0'):
        lw.Objective(length, weight=0)
    for key, wrong in (('weight', 'a'), ('weight', None), ('weight', [1.0]), ('reference', 'a')):
        with pytest.raises(lw.InputError, match=f'length: {key} must be a positive number, is '):
            lw.Objective(length, **{key: wrong})
    assert lw.Objective(length, weight=np.float32(2.0), reference=None).weight == 2.0


def test_a_first_guess_without_any_of_it_has_no_reference(puppy):
    def nothing(s, motion):
        return 0.0, None, None

    with pytest.raises(lw.InputError, match='nothing: its reference must be positive'):
        lw.codesign(puppy, walk_task(), objective=lw.Objective(nothing, reference=None))


def test_ctrl_c_within_it_stops_within_two_seconds(examples, tmp_path):
    code = (
        'import signal, time, legwright as lw\n'
        'signal.signal(signal.SIGINT, signal.default_int_handler)\n'
        f'robot = lw.Robot({str(examples / "puppy/robot.xml")!r})\n'
        'def slow(s, motion):\n'
        '    print("here", flush=True)\n'
        '    time.sleep(0.1)\n'
        '    return 1.0, None, None\n'
        'task = lw.Task("walk", (0.1, 0.0))\n'
        f'lw.codesign(robot, task, objective=slow, check_gradient=False, folder={str(tmp_path)!r} +'
        ' "/run")\n'
    )
    process = subprocess.Popen(
        [sys.executable, '-c', code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    for _ in range(4):
        assert process.stdout.readline() == 'here\n'
    start = time.monotonic()
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=60)
    assert time.monotonic() - start < 2.0
    assert errors.rstrip().endswith('KeyboardInterrupt')
    assert process.returncode == -signal.SIGINT
    assert lw.Design.load(tmp_path / 'run').status == 'interrupted'
