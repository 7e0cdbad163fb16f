# SPDX-License-Identifier: Apache-2.0
import json
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import legwright as lw
import numpy as np
import pytest
from legwright._options import CODESIGN

PROGRAM = Path(lw.__file__).parent / 'bin/legwright'
QUICK = {'reasons': False, 'certificate': False, 'plan_only': True}


def run_program(*words):
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, check=False)


def test_body_cost_and_files_are_those_of_the_program(walk, examples, tmp_path):
    task = examples / 'puppy/sideways.toml'
    done = run_program('optimize', task, '-o', tmp_path / 'run', '--no-pictures', '--quiet')
    assert done.returncode == 0, done.stderr
    record = json.loads((tmp_path / 'run/run.json').read_text(encoding='utf-8'))
    assert record['final_F'] == walk.F  # the same bits: JSON has the shortest text of each number
    assert [each['final'] for each in record['parameters']] == walk.s.tolist()
    assert walk.feasible and walk.reasons == [] and walk.status == record['status']
    for name in ('robot.xml', 'scene.xml', 'motion.csv', 'metrics.json', 'certificate.json'):
        ours = (walk.folder / 'result' / name).read_bytes()
        assert ours == (tmp_path / 'run/result' / name).read_bytes(), name
    ours = sorted(path.relative_to(walk.folder) for path in walk.folder.rglob('*'))
    theirs = sorted(path.relative_to(tmp_path / 'run') for path in tmp_path.glob('run/**/*'))
    assert ours == theirs


def test_iterations_are_told_on_the_calling_thread_and_fall(puppy, sideways):
    seen, threads = [], set()

    def show(iteration):
        seen.append(iteration)
        threads.add(threading.get_ident())

    design = lw.codesign(puppy, sideways, on_iteration=show, **QUICK)
    assert threads == {threading.get_ident()}
    assert [each.index for each in seen] == list(range(len(seen)))
    costs = [each.F for each in seen]
    assert costs == sorted(costs, reverse=True) and costs[0] > 50 * costs[-1]
    assert seen[0].s.tolist() == puppy.s.tolist() and design.motion_only_F == seen[0].F
    assert seen[-1].s.tolist() == design.s.tolist() and seen[-1].F == design.F
    assert sum(seen[-1].terms.values()) == pytest.approx(design.F, rel=1e-12)
    assert seen[0].start == 'initial' and seen[0].tasks == ['sideways']


def test_false_ends_the_search_with_the_best_so_far(puppy, sideways):
    design = lw.codesign(puppy, sideways, on_iteration=lambda each: each.index < 3, **QUICK)
    assert design.status == 'stopped'
    assert design.record['design_iterations'] == 3
    assert design.motion_only_F > design.F


def test_what_the_callback_raises_stops_the_run_and_arrives(puppy, sideways, tmp_path):
    def fail(iteration):
        raise ZeroDivisionError(f'at {iteration.index}')

    with pytest.raises(ZeroDivisionError, match='at 0'):
        lw.codesign(puppy, sideways, on_iteration=fail, folder=tmp_path / 'run')
    record = json.loads((tmp_path / 'run/run.json').read_text(encoding='utf-8'))
    assert record['status'] == 'interrupted'


def test_an_interrupted_search_goes_on_to_the_same_bytes(puppy, sideways, tmp_path):
    def stop(iteration):
        if iteration.index == 2:
            raise KeyboardInterrupt

    whole = lw.codesign(puppy, sideways, **QUICK)
    run = tmp_path / 'run'
    with pytest.raises(KeyboardInterrupt):
        lw.codesign(puppy, sideways, folder=run, on_iteration=stop, **QUICK)
    assert (run / 'checkpoint/states.bin').stat().st_size > 0
    assert b'Python' in run_program('optimize', '--resume', run).stderr.encode()
    with pytest.raises(lw.InputError, match='other options.*seed = 1'):
        lw.codesign(puppy, sideways, folder=run, resume=True, seed=2, **QUICK)
    with pytest.raises(lw.InputError, match='resume: .*folder'):
        lw.codesign(puppy, sideways, resume=True, **QUICK)
    design = lw.codesign(puppy, sideways, folder=run, resume=True, **QUICK)
    assert design.F == whole.F and design.s.tolist() == whole.s.tolist()
    for name in ('robot.xml', 'scene.xml', 'motion.csv'):
        ours = (run / 'result' / name).read_bytes()
        assert ours == (whole.folder / 'result' / name).read_bytes()
    with pytest.raises(lw.IoError, match='came to its end'):
        lw.codesign(puppy, sideways, folder=run, resume=True, **QUICK)


def test_other_threads_go_on_meanwhile(puppy, sideways):
    counts, done = [0], threading.Event()

    def count():
        while not done.is_set():
            counts[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    start = time.monotonic()
    before = counts[0]
    lw.codesign(puppy, sideways, **QUICK)
    counted, seconds = counts[0] - before, time.monotonic() - start
    done.set()
    thread.join()
    assert counted > 100 * seconds, f'{counted} counts in {seconds:.1f} s'


# In the search; and behind its last iterate, where MuJoCo plays the designs for some seconds.
@pytest.mark.parametrize(('index', 'seconds'), [(0, 0.2), (3, 1.0)])
def test_ctrl_c_stops_within_two_seconds(examples, tmp_path, index, seconds):
    code = (
        'import signal, sys, legwright as lw\n'
        'signal.signal(signal.SIGINT, signal.default_int_handler)\n'
        f'robot = lw.Robot({str(examples / "quadruped/robot.xml")!r})\n'
        f'task = lw.Task.load({str(examples / "quadruped/both.toml")!r})\n'
        'def show(each):\n'
        f'    if each.index == {index}: print("here", flush=True)\n'
        'lw.codesign(robot, task, on_iteration=show, one_start=True, max_iterations=3,\n'
        f'            folder={str(tmp_path / "run")!r})\n'
    )
    process = subprocess.Popen(
        [sys.executable, '-c', code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    assert process.stdout.readline() == 'here\n'
    time.sleep(seconds)
    start = time.monotonic()
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=60)
    assert time.monotonic() - start < 2.0
    assert errors.rstrip().endswith('KeyboardInterrupt')
    assert process.returncode == -signal.SIGINT
    record = json.loads((tmp_path / 'run/run.json').read_text(encoding='utf-8'))
    assert record['status'] == 'interrupted'
    assert (record['design_iterations'] == 3) == (index == 3)
    assert 'seconds' in record and 'certificate' not in record


def test_what_is_frozen_or_bounded_stays_so(puppy, sideways):
    puppy.parameters['front_thigh_length'].freeze()
    puppy.parameters['hind_foot_length'].bounds = (0.06, 0.08)
    design = lw.codesign(puppy, sideways, **QUICK)
    assert design.parameters['front_thigh_length'] == 0.06
    assert 0.06 <= design.parameters['hind_foot_length'] <= 0.08
    assert 'freeze = ["front_thigh_length"]' in (design.folder / 'inputs/task.toml').read_text()
    # The run can be told again from its inputs, by the program.
    folder = design.folder.parent / 'again'
    words = ('--plan-only', '--no-reasons', '--no-certificate', '--no-pictures', '--quiet')
    done = run_program('optimize', design.folder / 'inputs/task.toml', '-o', folder, *words)
    assert done.returncode in (0, 1), done.stderr
    assert lw.Design.load(folder).s.tolist() == design.s.tolist()


def test_a_task_from_keywords_walks(puppy):
    design = lw.codesign(puppy, lw.Task('trot', velocity=(0.1, 0.0)), reasons=False)
    assert design.verdict and design.verdict.line.startswith('PASS')
    assert str(design.record['task']['gait']) == 'trot'


def test_a_robot_without_parameters_keeps_its_body_and_gets_a_gait(examples):
    robot = lw.Robot(examples.parent / 'tests/robots/servo_dog/robot.xml')
    assert len(robot.parameters) == 0
    with pytest.warns(lw.LegwrightWarning, match='declares no design parameters'):
        design = lw.codesign(robot, lw.Task('trot', (0.1, 0.0)), **QUICK)
    assert design.s.size == 0 and design.motion_only_F == design.F
    assert design.status == 'converged' and design.motion.travel[0] > 0.0


def test_several_tasks_share_one_body(examples):
    robot = lw.Robot(examples / 'quadruped/robot.xml')
    pace = lw.Task('pace', (0.5, 0.0), name='fast')
    crawl = lw.Task('crawl', (0.1, 0.0))
    design = lw.codesign(
        robot, [(pace, 0.25), (crawl, 0.75)], max_iterations=2, one_start=True, **QUICK
    )
    assert design.joint and list(design.tasks) == ['fast', 'crawl']
    fast, slow = design.tasks.values()
    assert fast.s.tolist() == slow.s.tolist() == design.s.tolist()
    assert pytest.approx(0.25 * fast.F + 0.75 * slow.F, rel=1e-12) == design.F
    assert sum(design.terms.values()) == pytest.approx(design.F, rel=1e-12)
    assert fast.motion.period < slow.motion.period
    assert design.J == 0.0 and design.front == []
    with pytest.raises(ValueError, match=r"NAME of 'fast', 'crawl'"):
        _ = design.motion


def test_a_front_needs_two_tasks(puppy, sideways):
    with pytest.raises(lw.InputError, match='needs two') as caught:
        lw.codesign(puppy, sideways, front=3)
    assert '--' not in str(caught.value)  # words of the command line


def test_options_are_checked_before_the_search_all_at_once(puppy, sideways):
    wrong = {'max_iterations': 1.5, 'front': -2, 'starts': '3', 'threads': -1, 'few_keeps': 500}
    with pytest.raises(lw.InputError) as caught:
        lw.codesign(puppy, sideways, **wrong, few=1)
    assert {each.where for each in caught.value.reasons} == {*wrong, 'few'}
    told = str(caught.value).splitlines()
    assert 'max_iterations: is a number; expected an integer' in told
    assert 'threads: is -1; expected 0 to 64' in told
    with pytest.raises(TypeError, match='^on_iteration is an integer; expected a function'):
        lw.codesign(puppy, sideways, on_iteration=3)
    with pytest.raises(lw.InputError, match='^threads: is -1'):
        lw.Session(puppy, sideways, threads=-1)
    words = {'max_iterations': np.int64(0), 'few_keeps': np.float64(90.0), 'stop_at': 1}
    assert lw.codesign(puppy, sideways, **words, **QUICK).record['design_iterations'] == 0


def test_the_ranges_of_options_are_those_of_the_program(examples, tmp_path):
    task = examples / 'puppy/sideways.toml'
    for name, option in CODESIGN.items():
        if option.kind is bool or option.high > 1e9:
            continue
        for value in (option.low - 1, option.high + 1):
            word = f'--{name.replace("_", "-")}={value:g}'
            done = run_program('optimize', task, '-o', tmp_path / 'run', word)
            assert done.returncode == 2 and f'{option.high:g}' in done.stderr, (word, done.stderr)


def test_what_is_no_robot_or_task_is_told_by_name(puppy, sideways):
    for call in (lw.codesign, lw.Session):
        with pytest.raises(TypeError, match='^robot is a text; expected a legwright.Robot'):
            call('robot.xml', sideways)
        for wrong in ('trot', 3, None, [sideways, 'trot'], [(sideways, 1.0, 2.0)], [()], {'a': 1}):
            with pytest.raises(TypeError, match='^task is .*; expected a Task'):
                call(puppy, wrong)
    with pytest.raises(TypeError, match='^robot is a Task'):
        lw.codesign(sideways, puppy)


def test_what_does_not_fit_is_told_by_file_and_line(examples, tmp_path):
    robot = lw.Robot(examples / 'hexapod/robot.xml')
    with pytest.raises(lw.InputError) as caught:
        lw.codesign(robot, lw.Task.load(examples / 'puppy/sideways_trot.toml'))
    error = caught.value
    text = (examples / 'puppy/sideways_trot.toml').read_text(encoding='utf-8').splitlines()
    assert Path(error.file) == examples / 'puppy/sideways_trot.toml'
    assert text[error.line - 1].startswith('name = "trot"')


def test_a_folder_that_holds_a_run_is_refused(walk, puppy, sideways):
    with pytest.raises(lw.IoError, match='already holds a run') as caught:
        lw.codesign(puppy, sideways, folder=walk.folder)
    assert isinstance(caught.value, OSError)


def test_a_run_prints_nothing_and_leaves_no_log(examples, tmp_path):
    code = (
        'import legwright as lw\n'
        f'robot = lw.Robot({str(examples / "puppy/robot.xml")!r})\n'
        f'task = lw.Task.load({str(examples / "puppy/sideways_trot.toml")!r})\n'
        'lw.codesign(robot, task, folder="run")\n'
    )
    done = subprocess.run(
        [sys.executable, '-W', 'ignore', '-c', code],
        cwd=tmp_path,
        env={**os.environ, 'PYTHONPATH': os.pathsep.join(sys.path)},
        capture_output=True,
        text=True,
        check=True,
    )
    assert (done.stdout, done.stderr) == ('', '')
    assert os.listdir(tmp_path) == ['run']
