# SPDX-License-Identifier: Apache-2.0
import threading
import time

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


def test_a_journal_leads_to_the_same_bits_also_after_a_process_died(puppy, sideways, tmp_path):
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
    puppy.parameters[THIGH].freeze()  # no matter: it is the file that counts
    other = lw.Robot(puppy.file.parents[1] / 'quadruped/robot.xml')
    with pytest.raises(lw.InputError, match='another one'):
        lw.Session(other, lw.Task('trot', (0.1, 0.0)), replay=tmp_path / 'a.jsonl')


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


def test_what_does_not_fit_is_refused(session):
    for wrong in (
        lambda: session.edit('front_thigh_lenght', 0.06),
        lambda: session.edit(THIGH, 9.0),
        lambda: session.edit(THIGH, float('nan')),
        lambda: session.set_bounds(THIGH, 0.0, 9.0),
        lambda: session.set_weights([1.0]),
        lambda: session.branch('none'),
        lambda: session.undo(),
    ):
        with pytest.raises(lw.InputError):
            wrong()
    with pytest.raises(TypeError):
        session.edit(THIGH)
    session.edit(THIGH, 9.0, wait=False)
    words = [event.words for event in session.events() if event.kind == 'failed']
    assert len(words) == 1 and 'its bounds' in words[0]
    session.close()
    with pytest.raises(ValueError, match='closed'):
        session.undo()


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
