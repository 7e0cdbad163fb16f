# SPDX-License-Identifier: Apache-2.0
"""A study on two local workers: it goes on where it stopped, a worker's death costs one point."""

import json
import os
import signal
import subprocess
import sys
import threading
import time
import warnings
from pathlib import Path

import dask
import legwright as lw
import numpy as np
import pyarrow.parquet
import pytest
from legwright import study
from legwright.study import _cluster, _measures, _work
from legwright.study._file import read_study
from legwright.study._folder import FolderRobots, StudyFolder
from legwright.study._points import points_of
from tiny_study import heights, tiny


@pytest.fixture(scope='module')
def client():
    """Two workers for all tests of this file."""
    with _cluster.client_of(None, 2) as client:
        yield client


def finished_at(folder: Path) -> dict[str, int]:
    """When each point that is done was written, in ns, by hash."""
    files = (folder / 'points').glob('*/point.json')
    return {file.parent.name: file.stat().st_mtime_ns for file in files}


def test_points_are_runs_of_the_program_with_the_bits_of_codesign(client, tmp_path):
    found = study.run(tiny(), tmp_path / 'study', client=client)
    assert found.complete and repr(found) == '<Study study: 2 of 2 points>'
    for point in found.points:
        robot = lw.Robot(tiny()['robot'])
        task = lw.Task._from_text(point.task, Path('task.toml'))
        options = {'motion_only': True, 'plan_only': True, 'certificate': False, 'reasons': False}
        design = lw.codesign(robot, task, **options)
        assert found.design(point).F == design.F
        ours = found.design(point).folder / 'result/motion.csv'
        assert ours.read_bytes() == (design.folder / 'result/motion.csv').read_bytes()
    assert found.design(1).folder == tmp_path / 'study/points' / found.points[1].hash
    with pytest.raises(IndexError):
        found.design(2)


def test_the_table_has_typed_columns_that_say_what_they_are(client, tmp_path):
    refuses = {'name': 'unknown weight', 'design': {'freeze': ['no_such_parameter']}}
    listed = [{'name': 'good', 'codesign': {'motion_only': False, 'max_iterations': 1}}, refuses]
    told = []
    found = study.run(tiny(grid={}, points=listed), tmp_path, client=client, on_point=told.append)
    assert not found.complete
    assert sorted((done.status, done.point.name) for done in told) == [
        ('done', 'good'),
        ('refused', 'unknown weight'),
    ]
    assert {done.number for done in told} == {1, 2} and told[0].count == 2
    table = pyarrow.parquet.read_table(tmp_path / 'study.parquet')
    assert table.equals(found.table)
    rows = table.to_pylist()
    assert [row['status'] for row in rows] == ['done', 'refused']
    assert rows[0]['reason'] is None and 'no_such_parameter' in rows[1]['reason']
    assert rows[1]['F'] is None and rows[1]['design.freeze'] == '["no_such_parameter"]'
    design = found.design(0)
    assert rows[0]['F'] == design.F and rows[0]['pass'] is None and rows[0]['feasible'] is True
    assert {name: rows[0][f's.{name}'] for name in design.parameters} == design.parameters
    terms = sum(value for name, value in rows[0].items() if name.startswith('term.'))
    assert terms == pytest.approx(design.F, rel=1e-12)
    kinds = {field.name: str(field.type) for field in table.schema}
    kinds_of = {'point': 'int64', 'F': 'double', 'pass': 'bool', 'reason': 'string'}
    kinds_of |= {'codesign.motion_only': 'bool', 's.body_width': 'double'}
    assert {name: kinds[name] for name in kinds_of} == kinds_of
    for field in table.schema:
        assert field.metadata[b'about'], field.name
    assert table.schema.field('s.body_width').metadata[b'unit'] == b'm'
    # A point that its inputs forbid is not tried again: nothing runs.
    before = finished_at(tmp_path)
    study.run(tiny(grid={}, points=listed), tmp_path, client=client)
    assert finished_at(tmp_path) == before


def finished_once_quiet(folder, client):
    """What is finished once nothing is being done: a worker ends the point that it is at, of which
    the scheduler knows no more."""
    quiet, finished = 0, finished_at(folder)
    while quiet < 40:
        time.sleep(0.05)
        busy = any((client.processing() or {}).values()) or any((folder / 'unfinished').iterdir())
        now = finished_at(folder)
        quiet = 0 if busy or now != finished else quiet + 1
        finished = now
    return finished


def test_a_study_goes_on_and_nothing_runs_twice(client, tmp_path):
    ended = []

    def stop_after_two(done):
        ended.append(done.point.hash)
        if len(ended) == 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        study.run(tiny(grid=heights(6)), tmp_path, client=client, on_point=stop_after_two)
    partial = pyarrow.parquet.read_table(tmp_path / 'study.parquet')
    status = partial.column('status').to_pylist()
    assert status.count('open') + status.count('done') == 6 and status.count('open') >= 1
    assert (tmp_path / 'study.html').exists()
    before = finished_once_quiet(tmp_path, client)
    assert set(ended) <= set(before)
    again = []
    found = study.run(tiny(grid=heights(8)), tmp_path, client=client, on_point=again.append)
    assert found.complete and len(found.points) == 8  # two more than before
    after = finished_at(tmp_path)
    assert {done.point.hash for done in again} == set(after) - set(before)
    assert all(after[hash_] == written for hash_, written in before.items())
    third = []
    study.run(tiny(grid=heights(8)), tmp_path, client=client, on_point=third.append)
    assert third == []
    forced = []
    study.run(tiny(), tmp_path, client=client, force=True, on_point=forced.append)
    assert len(forced) == 2 and finished_at(tmp_path) != after


@pytest.mark.long
def test_kill_9_of_workers_loses_the_points_they_were_at_alone(tmp_path):
    log, kills = tmp_path / 'starts', 2
    log.touch()

    def logged(job):  # goes to the workers by value
        if not StudyFolder(Path(job.study)).point(job.hash).exists():
            with log.open('a') as file:
                file.write(f'{job.hash} {os.getpid()}\n')
        _work.work(job)

    def killer():
        for kill in range(kills):
            while len(log.read_text().splitlines()) < 3 * (kill + 1):
                time.sleep(0.002)
            os.kill(int(log.read_text().splitlines()[-1].split()[1]), signal.SIGKILL)

    thread = threading.Thread(target=killer)
    thread.start()
    real, study._run.work = study._run.work, logged
    try:
        options = {'motion_only': False, 'max_iterations': 1, 'plan_only': True}
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter('always', lw.LegwrightWarning)
            found = study.run(
                tiny(grid=heights(10), codesign=options), tmp_path / 'study', workers=2
            )
    finally:
        study._run.work = real
        thread.join()
    assert found.complete and not found.failures
    starts = [line.split()[0] for line in log.read_text().splitlines()]
    assert set(starts) == {point.hash for point in found.points}
    assert len(starts) <= len(found.points) + kills  # a kill may come as its point is done
    assert os.listdir(tmp_path / 'study/unfinished') == []
    twice = {point.name for point in found.points if starts.count(point.hash) > 1}
    said = [str(each.message) for each in told if each.category is lw.LegwrightWarning]
    assert all('another worker did the point' in each for each in said) and len(said) <= kills
    assert {each.split(': ')[0].removeprefix('a worker died at ') for each in said} <= twice
    assert said or len(starts) == len(found.points)


@pytest.mark.long
def test_a_point_that_kills_its_workers_is_told_and_the_others_are_done(tmp_path):
    robots = FolderRobots(StudyFolder.make(tmp_path / 'first'))
    deadly = points_of(read_study(tiny()), robots)[0].hash

    def work(job):
        if job.hash == deadly:
            os.kill(os.getpid(), signal.SIGKILL)
        _work.work(job)

    real, study._run.work = study._run.work, work
    try:
        with dask.config.set({'distributed.scheduler.allowed-failures': 0}):
            found = study.run(tiny(grid=heights(3)), tmp_path / 'study', workers=1)
    finally:
        study._run.work = real
    (point,) = (each for each in found.points if each.hash not in found.records)
    assert 'each worker that took it died' in found.failures[point.hash]
    row = found.table.to_pylist()[point.index]
    assert row['status'] == 'failed' and row['reason'] == found.failures[point.hash]
    assert study.run(tiny(grid=heights(3)), tmp_path / 'study', workers=1).complete


def test_a_point_that_is_done_is_not_done_again_though_dask_asks_for_it(client, tmp_path):
    point = study.run(tiny(), tmp_path, client=client).points[0]
    before = finished_at(tmp_path)
    (tmp_path / 'unfinished').rmdir()  # where it would be made
    (tmp_path / 'unfinished').touch()
    _work.work(_work.Job(str(tmp_path), point.hash, point.inputs, False))
    assert finished_at(tmp_path) == before


def test_what_a_killed_worker_left_counts_for_nothing(client, tmp_path):
    folder = StudyFolder.make(tmp_path)
    found = study.run(tiny(), tmp_path, client=client)
    done = folder.point(found.points[0].hash)
    half = folder.scratch(done.name)
    done.rename(half)
    (half / 'point.json').unlink()
    again = []
    study.run(tiny(), tmp_path, client=client, on_point=again.append)
    assert [each.point.hash for each in again] == [done.name]
    assert not half.exists() and json.loads((done / 'point.json').read_text())['status'] == 'done'


def test_a_damaged_record_is_told_and_a_folder_without_one_is_no_point(client, tmp_path):
    found = study.run(tiny(), tmp_path, client=client)
    file = tmp_path / 'points' / found.points[0].hash / 'point.json'
    for damaged in (b'', b'{"status": "done"', b'[]', b'\xff', b'{"status": "done"}'):
        file.write_bytes(damaged)
        with pytest.raises(lw.IoError, match='is damaged; remove the folder'):
            study.run(tiny(), tmp_path, client=client)
    file.unlink()
    again = []
    assert study.run(tiny(), tmp_path, client=client, on_point=again.append).complete
    assert [each.point.hash for each in again] == [found.points[0].hash]


def test_a_worker_whose_folder_is_swept_away_leaves_no_half_point(tmp_path, monkeypatch):
    point = points_of(read_study(tiny()), FolderRobots(StudyFolder.make(tmp_path)))[0]

    def swept(job, folder, made):  # as by the same command on another machine
        folder.sweep()
        (made / 'result').mkdir(parents=True)  # as a run does that goes on
        return {'F': 1.0}, []

    monkeypatch.setattr(_work, '_design', swept)
    with pytest.raises(lw.IoError, match='another `legwright study` removed it'):
        _work.work(_work.Job(str(tmp_path), point.hash, point.inputs, False))
    assert os.listdir(tmp_path / 'points') == os.listdir(tmp_path / 'unfinished') == []


def test_the_program_of_a_worker_dies_with_it(walk, tmp_path):
    run = walk.save(tmp_path / 'run')
    code = 'from legwright.study import _work; _work._validate({"quick": False, "limits": None, '
    code += f'"cycles": 10000, "samples": 100000, "seed": 1}}, {str(run)!r})'
    environment = {**os.environ, 'PYTHONPATH': os.pathsep.join(sys.path)}
    worker = subprocess.Popen([sys.executable, '-c', code], env=environment)
    children = Path(f'/proc/{worker.pid}/task/{worker.pid}/children')
    while not (child := children.read_text().split()):
        time.sleep(0.01)
    status = Path(f'/proc/{child[0]}/stat')
    time.sleep(0.3)  # it has begun
    assert status.read_text().split(') ')[1][0] in 'RSD'
    worker.kill()
    worker.wait()
    end = time.monotonic() + 10
    while runs_on := status.exists() and status.read_text().split(') ')[1][0] != 'Z':
        if time.monotonic() > end:
            os.kill(int(child[0]), signal.SIGKILL)
            break
        time.sleep(0.01)
    assert not runs_on


@pytest.mark.long
def test_validation_by_limits_and_pictures_are_kept(client, tmp_path):
    limits = tmp_path / 'limits.toml'
    limits.write_text('[tilt]\nhigh = 1e-6\n', encoding='utf-8')
    played = {'motion_only': True, 'plan_only': False, 'certificate': False}
    judged = {'quick': True, 'cycles': 4, 'limits': str(limits)}
    more = {'validate': judged, 'pictures': True, 'codesign': played}
    one = {'grid': {}, 'points': [{'name': 'one'}]}
    found = study.run(tiny(**one, **more), tmp_path / 'study', client=client)
    (row,) = found.table.to_pylist()
    run = found.design(0).folder
    assert (
        row['validated'] is False is json.loads((run / 'result/verdict.json').read_text())['pass']
    )
    assert row['validated_verdict'].startswith('FAIL') and row['limit.tilt'] > 1e-6
    assert (run / 'inputs/limits.toml').read_text() == limits.read_text()
    assert row['pass'] is not None and row['verdict'] and row['merit'] >= 0.0
    assert found.records[row['hash']]['measures']['picture'] == 'result/small.webp'
    motion = run / 'result/motion.csv'
    motion.write_text(motion.read_text() + '\n')  # another result than the judged one
    assert _measures.of_validation(found.design(0)) == {
        'validated': None,
        'validated_verdict': 'not of this result: judge again',
    }
    assert 'data:image/webp;base64,' in (tmp_path / 'study/study.html').read_text()
    limits.write_text('[tilt]\nhigh = 0.2\n', encoding='utf-8')  # the bytes count, not the path
    again = study.run(tiny(**one, **more), tmp_path / 'study', client=client)
    assert again.points[0].hash != row['hash']


def test_a_study_without_pictures_gets_them_later_without_a_search(client, tmp_path):
    study.run(tiny(), tmp_path, client=client)
    motions = {
        file: file.stat().st_mtime_ns for file in tmp_path.glob('points/*/result/motion.csv')
    }
    found = study.run(tiny(pictures=True), tmp_path, client=client)
    assert len(motions) == 2 and all(each.stat().st_mtime_ns == at for each, at in motions.items())
    assert all('picture' in record['measures'] for record in found.records.values())
    assert (tmp_path / 'study.html').read_text().count('"data:image/webp;base64,') == 2


def test_folders_that_cannot_serve_are_refused(client, tmp_path):
    (tmp_path / 'other').mkdir()
    (tmp_path / 'other/file').touch()
    with pytest.raises(lw.IoError, match='holds something else than a study'):
        study.run(tiny(), tmp_path / 'other', client=client)
    assert os.listdir(tmp_path / 'other') == ['file']
    with pytest.raises(ValueError, match='workers: is 0; expected 1 to'):
        study.run(tiny(), tmp_path / 'new', workers=0)
    with pytest.raises(lw.IoError, match='is a file'):
        study.run(tiny(), tmp_path / 'other/file', client=client)
    folder = StudyFolder.make(tmp_path / 'busy')
    with folder.locked(), pytest.raises(lw.IoError, match='another `legwright study`'):
        study.run(tiny(), tmp_path / 'busy', client=client)


def test_what_a_study_cannot_be_asked_is_told_before_it_begins(tmp_path):
    folder = tmp_path / 'study'
    for call, error, words in (
        (lambda: study.run(3, folder), TypeError, 'study is an integer; expected a path'),
        (lambda: study.run('', folder), lw.InputError, 'study: is empty; expected a path'),
        (lambda: study.run(tiny(), 3), TypeError, 'folder is an integer; expected a path'),
        (lambda: study.run(tiny(), ''), lw.InputError, 'folder: is empty; expected a path'),
        (lambda: study.run(tiny(), folder, workers='a'), lw.InputError, 'workers: is a text'),
        (lambda: study.run(tiny(), folder, workers=1.5), lw.InputError, 'workers: is a number'),
        (lambda: study.run(tiny(), folder, on_point=3), TypeError, 'on_point is an integer; exp'),
        (
            lambda: study.run(tiny(grid={'gait.period': [0.4]}), folder),
            lw.InputError,
            r"gait\.period.*: has a dot; give a table in its table: {'gait': {'period': ",
        ),
    ):
        with pytest.raises(error, match=words):
            call()
    assert not any(folder.rglob('point.json'))


def test_a_design_is_asked_for_by_any_integer(client, tmp_path):
    found = study.run(tiny(), tmp_path / 'study', client=client)
    assert found.design(np.int64(1)).F == found.design(1).F == found.design(found.points[1]).F
    for wrong, words in (('a', 'a text'), (True, 'true or false'), (0.0, 'a number')):
        with pytest.raises(TypeError, match=f'point is {words}; expected a number or one of'):
            found.design(wrong)


def test_a_worker_that_does_not_see_the_folder_fails_the_point_alone(client, tmp_path):
    jobs = [('a', _work.Job(str(tmp_path / 'gone'), 'a', {'legwright': lw.__version__}, False))]
    jobs += [('b', _work.Job(str(tmp_path), 'b', {'legwright': '0.0.1'}, False))]
    (tmp_path / 'study.toml').touch()
    told = {}
    _cluster.carry_out(client, _work.work, jobs, told.__setitem__)
    assert 'a folder that all of them share' in told['a']
    assert 'install the same on both' in told['b']
