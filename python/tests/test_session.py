# SPDX-License-Identifier: Apache-2.0
import json
import os
import re
import signal
import subprocess
import sys
import threading
import time
import warnings

import legwright as lw
import numpy as np
import pytest

THIGH = 'front_thigh_length'


@pytest.fixture
def session(puppy, sideways):
    with lw.Session(puppy, sideways) as opened:
        yield opened


def test_edits_while_paused_are_kept_by_the_search_that_goes_on(session, puppy):
    session.start()
    while session.state.iterations < 10:
        time.sleep(0.01)
    session.edit(THIGH, 0.061)
    assert session.state.phase != 'searching'
    session.freeze(THIGH)
    before = session.state
    session.start()
    assert session.wait(60)
    after = session.state
    assert after.parameters[THIGH] == 0.061 and after.bounds[THIGH] == (0.061, 0.061)
    assert after.F < before.F and after.iterations > before.iterations
    assert before.parameters[THIGH] == 0.061  # a state does not change
    assert after.settled and set(after.gradient) == set(puppy.parameters)
    assert sum(after.terms.values()) == pytest.approx(after.F, rel=1e-9)
    motion = after.motion()
    assert motion.joints.shape[1] == 12 and np.isfinite(motion.joints).all()


def test_events_come_in_order_and_end(session):
    session.start()
    events = list(session.events())
    assert [event.number for event in events] == list(range(1, len(events) + 1))
    kinds = [event.kind for event in events]
    assert kinds.count('ended') == 1 and kinds[-1] == 'solved'
    costs = [event.state.F for event in events if event.kind == 'point']
    assert len(costs) > 20 and costs[-1] < 0.05 * costs[0]


def test_a_journal_leads_to_the_same_bits(puppy, sideways, tmp_path):
    with lw.Session(puppy, sideways, journal=tmp_path / 'a.jsonl') as first:
        first.start()
        while first.state.iterations < 7:
            time.sleep(0.01)
        first.edit({THIGH: 0.061, 'front_shank_length': 0.081})
        first.snapshot('mine')
        assert first.wait(60)
        text, wanted = first.journal(), first.state
    with lw.Session(puppy, sideways, replay=tmp_path / 'a.jsonl', threads=1) as second:
        assert second.state.s.tolist() == wanted.s.tolist()
        assert second.state.F == wanted.F and second.state.snapshots == ['mine']
        assert second.journal() == text
    with pytest.raises(lw.InputError, match='to obey, which it would replace'):
        lw.Session(puppy, sideways, journal=tmp_path / 'a.jsonl', replay=tmp_path / 'a.jsonl')
    with pytest.raises(lw.InputError, match='has other tasks'):
        lw.Session(puppy, lw.Task('trot', (0.1, 0.0)), replay=tmp_path / 'a.jsonl')
    puppy.parameters[THIGH].freeze()
    with pytest.raises(lw.InputError, match='other bounds'):
        lw.Session(puppy, sideways, replay=tmp_path / 'a.jsonl')
    other = lw.Robot(puppy.file.parents[1] / 'quadruped/robot.xml')
    with pytest.raises(lw.InputError, match='another one'):
        lw.Session(other, lw.Task('trot', (0.1, 0.0)), replay=tmp_path / 'a.jsonl')


DIES = """
import os, signal, sys, time
import legwright as lw
session = lw.Session(lw.Robot(sys.argv[1]), lw.Task.load(sys.argv[2]), journal='died.jsonl')
session.edit('front_thigh_length', 0.061)
session.start()
while '"searching"' not in open('died.jsonl').read():
    time.sleep(0.01)
os.kill(os.getpid(), signal.SIGKILL)
"""


def test_the_journal_of_a_process_that_died_leads_to_where_it_was(examples, sideways, tmp_path):
    robot = examples / 'quadruped/robot.xml'
    words = [sys.executable, '-c', DIES, robot, examples / 'quadruped/both.toml']
    environment = {**os.environ, 'PYTHONPATH': os.pathsep.join(sys.path)}
    done = subprocess.run(words, cwd=tmp_path, env=environment, timeout=120, check=False)
    assert done.returncode == -signal.SIGKILL
    task = lw.Task.load(examples / 'quadruped/both.toml')
    with lw.Session(lw.Robot(robot), task, replay=tmp_path / 'died.jsonl') as session:
        told = [json.loads(line) for line in session.journal().splitlines()]
        assert [line['do'] for line in told][:3] == ['begin', 'edit', 'searched']
        assert told[2]['points'] == session.state.iterations > 0


def test_threads_that_follow_are_each_told_everything(session):
    seen: list[list[int]] = [[], []]

    def follow(numbers):
        for event in session.events(timeout=60.0):
            numbers.append(event.number)
            if event.kind == 'ended':
                return

    threads = [threading.Thread(target=follow, args=(numbers,)) for numbers in seen]
    for thread in threads:
        thread.start()
    session.start()
    while session.state.iterations < 5:
        time.sleep(0.01)
    session.pause()
    for thread in threads:
        thread.join()
    assert seen[0] == seen[1] == list(range(1, len(seen[0]) + 1)) and len(seen[0]) > 5
    session.wait()
    assert [event.kind for event in session.events(timeout=0)] == ['solved']
    assert list(session.events(timeout=0)) == []


def test_close_ends_the_calls_of_other_threads(session):
    closed = threading.Event()

    def wait():
        with pytest.raises(ValueError, match='closed'):
            session.wait()
        closed.set()

    session.start()
    thread = threading.Thread(target=wait)
    thread.start()
    while session.state.iterations < 1:
        time.sleep(0.01)
    session.close()
    thread.join()
    assert closed.is_set()


def test_undo_redo_reset_branch(session):
    given = session.state.parameters
    session.snapshot('given')
    session.edit(THIGH, 0.061)
    session.edit(THIGH, 0.062, goes_on=True)
    session.undo()
    assert session.state.parameters == given and session.state.can_redo
    session.redo()
    assert session.state.parameters[THIGH] == 0.062
    session.reset()
    assert session.state.parameters == given
    session.undo()
    session.branch('given')
    assert session.state.parameters == given and session.state.snapshots == ['given']


def test_bounds_are_two_numbers_or_a_pair(session):
    session.set_bounds(THIGH, 0.05, 0.07)
    assert session.state.bounds[THIGH] == (0.05, 0.07)
    session.set_bounds(THIGH, (0.04, 0.08))
    assert session.state.bounds[THIGH] == (0.04, 0.08)
    with pytest.raises(lw.InputError, match='expected two numbers'):
        session.set_bounds(THIGH, 0.05)
    session.freeze(THIGH)
    with pytest.raises(lw.InputError, match='unfreeze it first'):
        session.edit(THIGH, 0.05)


def test_what_does_not_fit_is_refused(session):
    for wrong in (
        lambda: session.edit('front_thigh_lenght', 0.06),
        lambda: session.edit(THIGH, 9.0),
        lambda: session.edit(THIGH, float('nan')),
        lambda: session.set_bounds(THIGH, 0.0, 9.0),
        lambda: session.set_bounds(THIGH, float('nan'), 0.1),
        lambda: session.set_weights([1.0]),
        lambda: session.set_weights([float('inf')]),
        lambda: session.branch('none'),
        lambda: session.undo(),
    ):
        with pytest.raises(lw.InputError, match='^<session>: '):
            wrong()
    with pytest.raises(TypeError):
        session.edit(THIGH)
    with pytest.raises(lw.InputError, match='^<task>:.* travel.velocity'):  # names the new one
        session.set_task(lw.Task('trot', (9.0, 0.0)))
    session.edit(THIGH, 9.0, wait=False)
    words = [event.words for event in session.events() if event.kind == 'failed']
    assert len(words) == 1 and 'its bounds' in words[0]
    session.close()
    with pytest.raises(ValueError, match='closed'):
        session.undo()


def test_its_phase_tells_what_is_pending(session):
    assert session.state.phase == 'solving'
    for _ in range(20):
        assert session.wait(60) and session.state.phase == 'idle'
        session.start()
        assert session.state.phase == 'searching'
        session.pause()
    session.edit(THIGH, 0.061)
    assert session.state.phase == 'solving'
    while session.state.phase != 'idle':
        time.sleep(0.001)
    assert session.state.settled


def test_other_tasks_leave_the_bounds_to_the_session(puppy, tmp_path):
    frozen = {'freeze': ['body_width'], 'bounds': {'body_length': [0.23, 0.25]}}
    begun = lw.Task('walk', (0.0, 0.1), design=frozen)
    with lw.Session(puppy, begun) as session:
        bounds = session.state.bounds
        with pytest.raises(lw.InputError, match=r'^<task>: design: .*call freeze\(\), unf'):
            session.set_task(lw.Task('trot', (0.0, 0.1), design={'freeze': ['body_length']}))
        session.set_task(lw.Task('trot', (0.0, 0.1)))
        assert session.state.bounds == bounds and bounds['body_length'] == (0.23, 0.25)
        design = session.save(tmp_path / 'run')
        assert 'freeze' not in (design.folder / 'inputs/task.toml').read_text(encoding='utf-8')
        puppy.parameters['body_length'].freeze()
        with pytest.raises(lw.InputError, match=r'^<session>: set_task: .*session began'):
            session.set_task(lw.Task('walk', (0.0, 0.1)))
    with lw.Session(puppy, lw.Task('walk', (0.0, 0.1))) as session:
        session.set_task(lw.Task('trot', (0.0, 0.1)))  # the robot is as it was at the beginning
        given = puppy.parameters['body_length'].value
        assert session.state.bounds['body_length'] == (given, given)


def test_what_is_doubtful_is_told_before_a_search(examples, sideways, tmp_path):
    text = (examples / 'puppy/robot.xml').read_text(encoding='utf-8')
    bare = tmp_path / 'bare.xml'
    bare.write_text(re.sub('<custom>.*</custom>', '', text, flags=re.S), encoding='utf-8')
    robot = lw.Robot(bare)
    with pytest.warns(lw.LegwrightWarning, match='no design parameters') as told:
        session = lw.Session(robot, sideways)
    with session:
        assert told[0].filename == __file__ and session.state.iterations == 0
        with pytest.warns(lw.LegwrightWarning, match='no design parameters') as told:
            session.set_task(sideways)
        assert told[0].filename == __file__
    run = tmp_path / 'run'
    with warnings.catch_warnings():
        warnings.simplefilter('error', lw.LegwrightWarning)
        with pytest.raises(lw.LegwrightWarning, match='no design parameters'):
            lw.codesign(robot, sideways, folder=run)
    assert not run.exists()


def test_saves_a_run_that_the_verbs_take(session, tmp_path):
    session.start()
    session.wait()
    design = session.save(tmp_path / 'run')
    assert design.s.tolist() == session.state.s.tolist()
    assert pytest.approx(session.state.F, rel=1e-6) == design.F
    assert design.motion_only_F > design.F and design.verdict is None
    assert 'searched' in (tmp_path / 'run/inputs/session.jsonl').read_text(encoding='utf-8')
    with pytest.raises(lw.IoError, match='already holds a run'):
        session.save(tmp_path / 'run')


def test_other_threads_go_on_meanwhile(session):
    counts, done = [0], threading.Event()

    def count():
        while not done.is_set():
            counts[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    start = time.monotonic()
    session.start()
    session.wait()
    seconds = time.monotonic() - start
    done.set()
    thread.join()
    assert counts[0] > 100 * seconds
