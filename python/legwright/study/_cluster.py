# SPDX-License-Identifier: Apache-2.0
"""The Dask cluster that a study runs on: processes of this machine, or one that runs already."""

import logging
import os
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import Any

from legwright._errors import IoError

_SECONDS = 15  # within which a scheduler answers


def _cores() -> int:
    return len(os.sched_getaffinity(0))


@contextmanager
def _local(workers: int) -> Iterator[Any]:
    """Worker processes of one thread each; one that dies is started anew."""
    import dask
    import distributed

    # A worker gets the next point as it ends the last: who waits does not count as who killed it.
    saturation = dask.config.set({'distributed.scheduler.worker-saturation': 1.0})
    # Workers that end, or die, are told of as points, not as log lines of Dask.
    with (
        saturation,
        distributed.LocalCluster(
            n_workers=workers,
            threads_per_worker=1,
            processes=True,
            dashboard_address='127.0.0.1:0',
            silence_logs=logging.CRITICAL,
            preload='legwright.study._preload',
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        yield client


@contextmanager
def _running(address: str) -> Iterator[Any]:
    import distributed

    try:
        client = distributed.Client(address, timeout=_SECONDS)
    except (OSError, ValueError) as error:
        raise IoError(
            f'no Dask scheduler answers at {address} ({error}); start one by `dask scheduler`, '
            'which prints its address, and workers by `dask worker ADDRESS --nthreads 1`'
        ) from None
    with client:
        yield client


@contextmanager
def client_of(scheduler: str | None, workers: int | None) -> Iterator[Any]:
    """A distributed.Client. Raises IoError where no scheduler answers at the address."""
    opened = _running(scheduler) if scheduler else _local(workers or _cores())
    with opened as client:
        yield client


def carry_out(
    client: Any,
    work: Callable[[Any], object],
    jobs: Iterable[tuple[str, Any]],
    told: Callable[[str, str | None], None],
) -> None:
    """Has the cluster do jobs; Dask alone says where and in which order.

    What a job does is looked for where it leaves it, never fetched from its worker: that may be
    dead by then.

    Args:
        client: of client_of().
        work: does a job.
        jobs: each with a key of its own.
        told: called with the key of each job as it ends, and with why it failed or None.
    """
    import distributed

    jobs = list(jobs)
    run = os.urandom(4).hex()  # a running scheduler may know the same points of another folder
    keys = [f'legwright-{key}-{run}' for key, _ in jobs]
    futures = client.map(work, [job for _, job in jobs], key=keys, batch_size=1000)
    key_of = {future.key: key for future, (key, _) in zip(futures, jobs)}
    try:
        for future in distributed.as_completed(futures):
            told(key_of[future.key], None if future.status == 'finished' else _why(future))
            future.release()
    except BaseException:
        client.cancel(futures)
        raise


def _why(future: Any) -> str:
    import distributed

    if future.status != 'error':
        return 'the scheduler gave it up; run the study again'
    error = future.exception()
    if isinstance(error, distributed.KilledWorker):
        return 'each worker that took it died; the machine may have killed it for its memory'
    return f'{type(error).__name__}: {error}'
