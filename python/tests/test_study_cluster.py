# SPDX-License-Identifier: Apache-2.0
"""A study on a cluster of separate processes, as Slurm and the like start them: a scheduler and two
workers, of which one dies."""

import json
import os
import signal
import subprocess
import sys
import threading
import time
from contextlib import ExitStack
from pathlib import Path

import legwright as lw
import pytest
from legwright import study
from tiny_study import heights, tiny


def started(stack: ExitStack, *words: str) -> subprocess.Popen:
    """A process of the command `dask` that ends with the test."""
    process = subprocess.Popen(
        [sys.executable, '-m', 'dask', *words],
        env={**os.environ, 'PYTHONPATH': os.pathsep.join(sys.path)},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    stack.callback(process.wait)
    stack.callback(process.kill)
    return process


def address_in(file: Path) -> str:
    """Of the scheduler that writes the file."""
    end = time.monotonic() + 60
    while time.monotonic() < end:
        try:
            return json.loads(file.read_text(encoding='utf-8'))['address']
        except (FileNotFoundError, ValueError):
            time.sleep(0.05)
    raise TimeoutError('no scheduler within a minute')


@pytest.mark.long
def test_a_cluster_of_processes_does_a_study_though_a_worker_dies(tmp_path):
    with ExitStack() as stack:
        file = tmp_path / 'scheduler.json'
        words = ('--host', '127.0.0.1', '--no-dashboard')
        started(stack, 'scheduler', '--port', '0', '--scheduler-file', str(file), *words)
        address = address_in(file)
        workers = [
            started(
                stack,
                'worker',
                address,
                '--nthreads',
                '1',
                '--no-nanny',
                '--no-dashboard',
                '--local-directory',
                str(tmp_path / 'dask'),
            )
            for _ in range(2)
        ]
        ended, other = [], []
        last = {'limits': {'swing_height': heights(12)['limits']['swing_height'][-3:]}}

        def beside():  # the same points for another folder, at the same time
            folder = tmp_path / 'other'
            other.append(study.run(tiny(grid=last), folder, scheduler=address))

        thread = threading.Thread(target=beside)

        def tell(done):
            ended.append(done.number)
            if len(ended) == 1:
                thread.start()
            if len(ended) == 4:
                workers[0].send_signal(signal.SIGKILL)

        found = study.run(
            tiny(grid=heights(12)), tmp_path / 'study', scheduler=address, on_point=tell
        )
        thread.join()
        assert found.complete and ended == list(range(1, 13))
        assert workers[0].wait(10) == -signal.SIGKILL and workers[1].poll() is None
        assert other[0].complete and len(list((tmp_path / 'other/points').iterdir())) == 3


def test_where_no_scheduler_answers_it_says_how_to_start_one(tmp_path, monkeypatch):
    monkeypatch.setattr('legwright.study._cluster._SECONDS', 0.5)
    with pytest.raises(lw.IoError, match='start one by `dask scheduler`'):
        study.run(tiny(), tmp_path / 'study', scheduler='tcp://127.0.0.1:9')
    with pytest.raises(lw.IoError, match='no Dask scheduler answers at nonsense'):
        study.run(tiny(), tmp_path / 'study', scheduler='nonsense')
