# SPDX-License-Identifier: Apache-2.0
"""`python -m legwright.study`, as `legwright study` runs it: exit codes, progress, Ctrl-C."""

import contextlib
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pyarrow.parquet
import pytest
from legwright import _command, _toml
from legwright.study import __main__ as command
from tiny_study import heights, tiny

ENVIRONMENT = {**os.environ, 'PYTHONPATH': os.pathsep.join(sys.path)}


def call(folder: Path, *words: str, **environment: str) -> subprocess.CompletedProcess:
    return subprocess.run(
        [sys.executable, '-m', 'legwright.study', *words],
        cwd=folder,
        env={**ENVIRONMENT, **environment},
        capture_output=True,
        text=True,
        check=False,
    )


def written(folder: Path, **more) -> Path:
    file = folder / 'heights.toml'
    file.write_text(_toml.document(tiny(**more)), encoding='utf-8')
    return file


def test_a_study_ends_with_its_table_and_page(tmp_path):
    written(tmp_path)
    first = call(tmp_path, 'heights.toml', '--workers', '1')
    assert first.returncode == 0, first.stderr
    lines = first.stderr.splitlines()
    assert [line.split()[0] for line in lines] == ['1/2', '2/2']
    assert all('plan  F' in line and 'limits.swing_height' in line for line in lines)
    assert first.stdout.splitlines() == [
        'heights: 2 of 2 points have a design, MuJoCo was not asked',
        'table: runs/heights/study.parquet',
        'page:  runs/heights/study.html',
    ]
    assert (tmp_path / 'runs/heights/study.toml').read_text() == written(tmp_path).read_text()
    before = (tmp_path / 'runs/heights/study.parquet').read_bytes()
    again = call(tmp_path, 'heights.toml', '--json')
    assert again.returncode == 0 and again.stderr == ''
    assert [row['status'] for row in json.loads(again.stdout)['points']] == ['done'] * 2
    assert (tmp_path / 'runs/heights/study.parquet').read_bytes() == before


def test_a_point_without_a_design_is_exit_code_one(tmp_path):
    listed = [{'design': {'freeze': ['no_such_parameter']}}]
    done = call(tmp_path, str(written(tmp_path, grid={}, points=listed)), '-o', 'out', '--quiet')
    assert done.returncode == 1 and done.stderr == ''
    assert '0 of 1 points have a design' in done.stdout and 'no_such_parameter' in done.stdout


@pytest.mark.long
def test_bad_input_is_two_and_leaves_nothing(tmp_path):
    written(tmp_path, grid={'gait': {'period': [-1.0, 0.4]}})
    done = call(tmp_path, 'heights.toml', '-o', 'out')
    assert done.returncode == 2 and 'grid.gait.period: is -1' in done.stderr
    assert not (tmp_path / 'out').exists()
    (tmp_path / 'there').mkdir()
    assert call(tmp_path, 'heights.toml', '-o', 'there').returncode == 2
    assert list((tmp_path / 'there').iterdir()) == []
    assert call(tmp_path, 'heights.toml', '--workers', '0').returncode == 2
    missing = call(tmp_path, 'gone.toml')
    assert missing.returncode == 2 and 'give the path of a study file' in missing.stderr


def test_folders_and_missing_packages_are_three(tmp_path):
    written(tmp_path)
    full = call(tmp_path, 'heights.toml', '-o', '.')
    assert full.returncode == 3 and 'holds something else than a study' in full.stderr
    (tmp_path / 'distributed').mkdir()  # in the place of Dask's
    (tmp_path / 'distributed/__init__.py').write_text("raise ImportError('not here')")
    path = os.pathsep.join([str(tmp_path), ENVIRONMENT['PYTHONPATH']])
    without = call(tmp_path, 'heights.toml', PYTHONPATH=path)
    assert without.returncode == 3 and 'pip install "legwright[study]"' in without.stderr
    assert 'not here' in without.stderr and not (tmp_path / 'runs').exists()


@pytest.mark.long
def test_ctrl_c_keeps_what_is_done_and_the_same_command_goes_on(tmp_path):
    file = written(tmp_path, grid=heights(24))
    words = [sys.executable, '-m', 'legwright.study', str(file), '-o', 'out', '--workers', '2']
    process = subprocess.Popen(
        words,
        cwd=tmp_path,
        env=ENVIRONMENT,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    assert process.stderr.readline().lstrip().startswith('1/24')
    os.killpg(process.pid, signal.SIGINT)  # as a terminal sends it, to workers, too
    _, errors = process.communicate(timeout=60)
    assert process.returncode == _command.INTERRUPTED
    assert 'what is done is kept' in errors and 'Traceback' not in errors
    done = {each.name for each in (tmp_path / 'out/points').iterdir()}
    status = pyarrow.parquet.read_table(tmp_path / 'out/study.parquet')['status'].to_pylist()
    assert 1 <= len(done) < 24 and 'open' in status
    rest = call(tmp_path, *words[3:])
    assert rest.returncode == 0
    assert len(rest.stderr.splitlines()) == 24 - len(done), 'what was done ran again'


def test_sigterm_is_stopped_early(tmp_path):
    file = written(tmp_path, grid=heights(8))
    words = [sys.executable, '-m', 'legwright.study', str(file), '--workers', '1']
    process = subprocess.Popen(
        words, cwd=tmp_path, env=ENVIRONMENT, stderr=subprocess.PIPE, text=True
    )
    assert process.stderr.readline().startswith('1/8')
    process.terminate()
    assert process.wait(60) == _command.STOPPED
    process.stderr.close()


def test_an_interrupt_that_a_callback_swallows_is_raised_again():
    taken = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGUSR1)
    before = {number: signal.getsignal(number) for number in taken}
    try:
        for number, kind in ((signal.SIGINT, KeyboardInterrupt), (signal.SIGTERM, command.Stopped)):
            interrupts = command.Interrupts()
            interrupts.check()
            with contextlib.suppress(KeyboardInterrupt):  # as a callback's
                os.kill(os.getpid(), number)
                time.sleep(1.0)
            with pytest.raises(kind):
                interrupts.check()
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
