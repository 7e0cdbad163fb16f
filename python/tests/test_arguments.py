# SPDX-License-Identifier: Apache-2.0
"""What calls refuse before they do anything: paths, texts, times."""

import copy
import pickle
import shutil

import legwright as lw
import numpy as np
import pytest

QUICK = {'reasons': False, 'certificate': False, 'plan_only': True, 'max_iterations': 1}


def nothing(s, motion):
    return 1.0, None, None


@pytest.mark.parametrize('key', ['unit', 'name'])
def test_an_objective_is_named_by_texts(key):
    for wrong, words in ((None, 'None'), (3, 'an integer'), (b'N', 'a bytes')):
        with pytest.raises(TypeError, match=f'{key} is {words}; expected a text'):
            lw.Objective(nothing, **{key: wrong})
    with pytest.raises(lw.InputError, match='no text in UTF-8'):
        lw.Objective(nothing, **{key: '\ud800'})


def test_what_cannot_be_told_of_an_objective_is_raised_and_nothing_ends(puppy, sideways):
    objective = lw.Objective(nothing)
    object.__setattr__(objective, 'unit', None)
    with pytest.raises(TypeError, match='another kind'):
        lw.codesign(puppy, sideways, objective=objective, **QUICK)


@pytest.mark.parametrize('wrong', ['', 'a\0b', '\ud800'])
def test_paths_that_are_none_are_refused(wrong, puppy, sideways, walk, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with lw.Session(puppy, sideways) as session:
        for call in (
            lambda: lw.codesign(puppy, sideways, folder=wrong, **QUICK),
            lambda: walk.save(wrong),
            lambda: session.save(wrong),
            lambda: lw.Design.load(wrong),
            lambda: lw.Session(puppy, sideways, journal=wrong),
            lambda: lw.Session(puppy, sideways, replay=wrong),
            lambda: lw.Robot(wrong),
            lambda: lw.propose(wrong),
            lambda: lw.Task.load(wrong),
            lambda: lw.check(puppy, wrong),
            lambda: lw.build(wrong, 'robot.xml'),
            lambda: lw.validate(walk, limits=wrong),
        ):
            with pytest.raises(lw.InputError, match='expected a path|no path can have'):
                call()
    with pytest.raises(TypeError, match='folder is an integer; expected a path'):
        lw.Design.load(3)
    for no_path, words in ((3, 'an integer'), (None, 'None'), (b'a.toml', 'a bytes')):
        with pytest.raises(TypeError, match=f'file is {words}; expected a path'):
            lw.Task.load(no_path)
    with pytest.raises(lw.InputError, match='^<text>: is the text of a task; write it into a file'):
        lw.Task.load(sideways.text())
    assert list(tmp_path.iterdir()) == []


def test_a_relative_folder_stays_where_it_was_named(puppy, sideways, tmp_path, monkeypatch):
    for name in ('here', 'there'):
        (tmp_path / name).mkdir()
    monkeypatch.chdir(tmp_path / 'here')

    def leave(iteration):
        monkeypatch.chdir(tmp_path / 'there')

    design = lw.codesign(puppy, sideways, folder='run', on_iteration=leave, **QUICK)
    assert design.folder == tmp_path / 'here/run' and design.motion.period > 0.0
    monkeypatch.chdir(tmp_path / 'here')
    loaded = lw.Design.load('run')
    with lw.Session(puppy, sideways, journal='a.jsonl') as session:
        monkeypatch.chdir(tmp_path / 'there')
        session.freeze('body_width')
    assert loaded.motion.period > 0.0
    assert '"body_width"' in (tmp_path / 'here/a.jsonl').read_text(encoding='utf-8')
    assert list((tmp_path / 'there').iterdir()) == []


def test_a_design_in_a_temporary_folder_is_not_pickled(walk, tmp_path):
    with pytest.raises(TypeError, match='temporary folder.*folder=.*save'):
        pickle.dumps(walk)
    saved = lw.Design.load(walk.save(tmp_path / 'run'))
    assert pickle.loads(pickle.dumps(saved)).F == walk.F


@pytest.mark.parametrize('copied', [copy.copy, copy.deepcopy])
def test_a_copy_keeps_the_temporary_folder(copied, puppy, sideways):
    design = lw.codesign(puppy, sideways, **QUICK)
    other = copied(design)
    del design
    assert other.motion.period > 0.0


def test_a_run_without_an_end_is_no_design(walk, tmp_path):
    run = walk.save(tmp_path / 'run')
    shutil.rmtree(run / 'result')
    record = (run / 'run.json').read_text(encoding='utf-8')
    for found, words in (
        ('"status": "running"', r'has not ended: .*resume=True'),
        ('"status": "failed", "failure": "no memory"', 'failed .no memory.; .*force=True'),
    ):
        text = record.replace('"status": "converged"', found).replace('"final_F"', '"other"')
        (run / 'run.json').write_text(text, encoding='utf-8')
        with pytest.raises(lw.InputError, match=words):
            lw.Design.load(run)


def test_a_design_whose_folder_has_another_run_reads_nothing_of_it(puppy, sideways, tmp_path):
    run = tmp_path / 'run'
    old = lw.codesign(puppy, sideways, folder=run, **QUICK)
    kept = lw.codesign(puppy, sideways, folder=tmp_path / 'kept', **QUICK)
    new = lw.codesign(puppy, lw.Task('trot', (0.1, 0.0)), folder=run, force=True, **QUICK)
    assert new.motion.period != kept.motion.period
    calls = (
        lambda: old.motion,
        lambda: old.certificate,
        lambda: old.front,
        lambda: old.save(tmp_path / 'saved'),
        lambda: old.validate(quick=True),
        lambda: old.report(),
        lambda: lw.validate(old),
    )
    for call in calls:
        with pytest.raises(lw.InputError, match=r'run: has another run, .*; Design\.load\('):
            call()
    assert old.F == kept.F and lw.Design.load(run).motion.period == new.motion.period
    shutil.rmtree(run)
    for call in calls:
        with pytest.raises(lw.IoError, match='run: holds no run'):
            call()
    (kept.folder / 'result/motion.csv').unlink()
    with pytest.raises(lw.IoError, match=r'motion\.csv: No such file'):
        lw.Design.load(kept.folder).motion  # noqa: B018


def test_flags_are_true_or_false_pythons_or_numpys(walk, puppy, sideways, tmp_path):
    run = walk.save(tmp_path / 'run')
    assert walk.save(run, force=np.True_) == run
    words = 'is a text; expected true or false'
    with lw.Session(puppy, sideways) as session:
        session.save(run, force=np.bool_(True))
        session.edit('body_width', 0.15, goes_on=np.False_)
        for call, key in (
            (lambda: walk.save(run, force='yes'), 'force'),
            (lambda: session.save(run, force='yes'), 'force'),
            (lambda: session.edit('body_width', 0.15, goes_on='no'), 'goes_on'),
            (lambda: walk.export(tmp_path / 'out', urdf='no'), 'urdf'),
            (lambda: walk.export(tmp_path / 'out', picture='no'), 'picture'),
        ):
            with pytest.raises(lw.InputError, match=f'{key}: {words}'):
                call()
    assert walk.export(tmp_path / 'out', picture=np.False_, urdf=np.True_).is_dir()
    assert list((tmp_path / 'out/urdf').glob('*.urdf'))
    with pytest.raises(TypeError, match='phases is a number; expected a list of numbers'):
        walk.render(phases=0.5)


def test_a_number_of_numpys_small_kinds_is_taken_without_a_warning(puppy, sideways, recwarn):
    quick = QUICK | {'max_iterations': np.int8(1)}
    design = lw.codesign(puppy, sideways, stop_at=np.float32(1e9), seed=np.uint8(1), **quick)
    assert design.status == 'stopped' and not recwarn.list
    assert lw.gaits(np.int64(4)) == lw.gaits(4)


def test_weights_are_numbers(puppy, sideways):
    for wrong, words in (('a', 'a text'), ([2], 'an array'), (True, 'true or false')):
        with pytest.raises(lw.InputError, match=f'weight of task sideways: is {words}; expected a'):
            lw.codesign(puppy, [(sideways, wrong)], **QUICK)


def test_copies_of_a_robot_have_bounds_of_their_own(puppy):
    puppy.parameters['body_width'].freeze()
    for made in (copy.copy(puppy), copy.deepcopy(puppy)):
        assert made.parameters['body_width'].frozen and made.feet == puppy.feet
        made.parameters['body_width'].reset()
        made.parameters['body_length'].freeze()
    assert puppy.parameters['body_width'].frozen and not puppy.parameters['body_length'].frozen
    with pytest.raises(TypeError, match=r'cannot be pickled: read it .* by Robot\(.*robot\.xml'):
        pickle.dumps(puppy)


def test_calls_of_a_session_tell_what_they_expect(puppy, sideways):
    with lw.Session(puppy, sideways) as session:
        for call, words in (
            (lambda: session.freeze(['body_width']), 'freeze is given an array; expected names'),
            (lambda: session.unfreeze(3), 'unfreeze is given an integer; expected names'),
            (lambda: session.set_bounds(3, 0.1, 0.2), 'name is an integer; expected a text'),
            (lambda: session.snapshot(3), 'name is an integer; expected a text'),
            (lambda: session.branch(None), 'name is None; expected a text'),
            (lambda: session.edit(3, 0.1), 'edit is given an integer; expected the name'),
            (lambda: session.wait('a'), 'timeout is a text; expected seconds'),
            (lambda: session.edit({'body_width': 0.15}, 0.16), 'values by name and another value'),
            (lambda: session.set_weights(2), 'weights is an integer; expected a list of numbers'),
            (lambda: session.set_weights({'a': 1}), 'weights is a table; expected a list'),
        ):
            with pytest.raises(TypeError, match=words):
                call()
        for call, words in (
            (lambda: session.edit('body_width', 'a'), 'body_width: is a text; expected a number'),
            (lambda: session.edit('body_width', [0.1]), 'body_width: is an array; expected a'),
            (lambda: session.set_weights(['a']), 'weights: is a text; expected a number'),
        ):
            with pytest.raises(lw.InputError, match=words):
                call()
        with pytest.raises(lw.InputError, match='timeout: is no number'):
            next(session.events(float('nan')))
        with pytest.raises(lw.InputError, match='timeout: is no number'):
            session.wait(float('nan'))
        assert repr(session).startswith(f'<Session of {puppy.name}, <SessionState')
    assert 'closed' in repr(session)


def test_parameters_are_a_mapping_for_any_key(puppy):
    for key in (0, None, ('a',)):
        with pytest.raises(KeyError):
            puppy.parameters[key]
        assert key not in puppy.parameters and puppy.parameters.get(key) is None


def test_numpys_false_ends_the_search_and_iterations_have_a_line(puppy, sideways):
    lines = []

    def ask(iteration):
        lines.append(repr(iteration))
        return iteration.s[0] > 10

    design = lw.codesign(puppy, sideways, on_iteration=ask, **{**QUICK, 'max_iterations': 5})
    assert design.status == 'stopped' and len(lines) == 1
    assert lines[0].startswith('<Iteration 0 from initial: F = ')
    goes_on = lw.codesign(puppy, sideways, on_iteration=lambda each: np.True_, **QUICK)
    assert goes_on.status == 'iteration_limit'
