# SPDX-License-Identifier: Apache-2.0
"""A study from its file to its table and page."""

import numbers
import os
import time
import warnings
from collections.abc import Callable, Mapping
from contextlib import nullcontext
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from legwright._arguments import path_of
from legwright._design import Design
from legwright._errors import LegwrightWarning
from legwright._options import Option, checked, kind_of
from legwright.study._extra import require_extra
from legwright.study._file import MADE, StudyFile, read_study
from legwright.study._folder import FolderRobots, StudyFolder, write_text
from legwright.study._measures import KNOWN, as_float
from legwright.study._points import Point, points_of
from legwright.study._work import Job, work

_LATE = 30.0  # [s]
_WORKERS = Option(int, None, 1, 100000)


@dataclass(frozen=True)
class Done:
    """A point that has ended: what `on_point` is called with."""

    point: Point
    status: str
    """"done", "refused" (its inputs are to blame) or "failed" (worker, files or cluster are)."""
    reason: str | None
    """Why it has no design; else None."""
    record: Mapping[str, Any]
    """point.json; empty where it failed."""
    number: int
    """How many points have ended, with those that were done before."""
    count: int
    """Of the study."""


@dataclass
class Study:
    """What a study found: a view of its folder."""

    folder: Path
    name: str
    points: list[Point]
    failures: dict[str, str] = field(default_factory=dict)
    """Why points failed that run again next time, by hash."""
    best_by: str | None = None
    """`best` of the study file."""

    @cached_property
    def _folder(self) -> StudyFolder:
        return StudyFolder(self.folder)

    @cached_property
    def records(self) -> dict[str, dict[str, Any]]:
        """point.json of each point that is done or refused, by hash."""
        found = {point.hash: self._folder.record(point.hash) for point in self.points}
        return {hash_: record for hash_, record in found.items() if record is not None}

    @cached_property
    def table(self) -> Any:
        """A pyarrow.Table with a row for each point: study.parquet. `.to_pandas()` where pandas
        is there."""
        from legwright.study._table import table_of

        return table_of(self)

    def design(self, point: Point | int) -> Design:
        """The design of a point, or of the point with this number.

        Raises IndexError where there is no such point, IoError where it has no design, TypeError
        for what is neither.
        """
        if isinstance(point, numbers.Integral) and not isinstance(point, bool):
            point = self.points[int(point)]
        if not isinstance(point, Point):
            raise TypeError(f'point is {kind_of(point)}; expected a number or one of `points`')
        return Design.load(self._folder.point(point.hash))

    @property
    def best(self) -> Point | None:
        """Of the designs that pass in MuJoCo the one with the least of `best` of the study file; of
        equals the first. None where none passes, or the file asks for nothing."""
        if self.best_by is None:
            return None
        found = []
        for point in self.points:
            measures = self.records.get(point.hash, {}).get('measures', {})
            value = measures.get(self.best_by)
            passes = measures.get('pass') and measures.get('validated', True)
            if passes and value is not None:
                found.append((as_float(value), point))
        return min(found, key=lambda each: each[0])[1] if found else None

    @property
    def best_line(self) -> str:
        """The same in words; empty where the file asks for nothing."""
        if self.best_by is None:
            return ''
        best = self.best
        if best is None:
            return f'least {self.best_by}: no design passes that has it'
        value = as_float(self.records[best.hash]['measures'][self.best_by])
        words = f'{value:.4g} {KNOWN[self.best_by].unit}'.rstrip()
        return f'least {self.best_by} that passes: {words}, {best.name}'

    @property
    def complete(self) -> bool:
        """Whether every point has a design."""
        status = [self.records.get(point.hash, {}).get('status') for point in self.points]
        return all(each == 'done' for each in status)

    def __repr__(self) -> str:
        return f'<Study {self.name}: {len(self.records)} of {len(self.points)} points>'


def default_folder(study: str | os.PathLike[str] | Mapping[str, Any]) -> Path:
    """runs/NAME, NAME that of the study file."""
    name = MADE.name.strip('<>') if isinstance(study, Mapping) else Path(study).stem
    return Path('runs') / name


def run(
    study: str | os.PathLike[str] | Mapping[str, Any],
    folder: str | os.PathLike[str] | None = None,
    *,
    workers: int | None = None,
    scheduler: str | None = None,
    client: Any = None,
    force: bool = False,
    on_point: Callable[[Done], None] | None = None,
) -> Study:
    """Co-designs every point of a study, as `legwright study`, and writes its table and page.

    Each point is a run folder that the hash of its inputs addresses: what is done is not done
    again, so that a study that was stopped goes on, and one that has grown does what is new. Dask
    schedules the points.

    Args:
        study: a study file (docs/studies.md), or a mapping with its keys.
        folder: of the study; default: runs/NAME.
        workers: processes on this machine; default: one for each core.
        scheduler: address of a Dask scheduler that runs, in the place of own processes.
        client: a distributed.Client, in the place of both; its workers see the folder.
        force: run all points anew.
        on_point: called with each point as it ends.

    A worker that died at a point which another one did is a LegwrightWarning.

    Raises:
        ImportError: without the extra `study`, with what to install.
        InputError: for a study, task or robot that is wrong, by file, line and key, and for workers
            that are no number from 1 on; nothing runs.
        IoError: where the folder holds something else, or no scheduler answers.
        TypeError: for a study, folder or on_point that is something else.
        KeyboardInterrupt: on Ctrl-C; what is done is kept, table and page tell of it.
    """
    workers = checked({'workers': _WORKERS}, {'workers': workers})['workers']
    if on_point is not None and not callable(on_point):
        raise TypeError(f'on_point is {kind_of(on_point)}; expected a function of a Done')
    named = None if folder is None else path_of('folder', folder, absolute=False)
    read = read_study(study)
    require_extra()
    place = StudyFolder.make(named or default_folder(study))
    with place.locked():
        place.sweep()
        try:
            points = points_of(read, FolderRobots(place))
        except BaseException:
            place.unmake()
            raise
        write_text(place.study_file, _text_of(read))
        found = Study(place.root, read.name, points, best_by=read.best)
        try:
            _carry_out(found, place, read, force, _opener(scheduler, workers, client), on_point)
            _tell_of_the_killed(place.sweep(), found)
        finally:
            _write_results(found, place)
    return found


def _opener(scheduler: str | None, workers: int | None, client: Any) -> Callable[[], Any]:
    from legwright.study._cluster import client_of

    return (lambda: nullcontext(client)) if client else (lambda: client_of(scheduler, workers))


def _text_of(study: StudyFile) -> str:
    """What study.toml of the folder says; of a mapping only its name."""
    return study.text or f'# {study.name}: given as a mapping\n'


def _carry_out(
    found: Study,
    place: StudyFolder,
    read: StudyFile,
    force: bool,
    opened: Callable[[], Any],
    on_point: Callable[[Done], None] | None,
) -> None:
    """Does what is not done."""
    from legwright.study._cluster import carry_out

    by_hash: dict[str, Point] = {}
    for point in found.points:
        by_hash.setdefault(point.hash, point)
    if force:
        for hash_ in by_hash:
            place.forget(hash_)
    records = {hash_: place.record(hash_) for hash_ in by_hash}
    wanted = [hash_ for hash_, record in records.items() if _to_do(record, read.pictures)]
    ended = len(by_hash) - len(wanted)

    def told(hash_: str, why: str | None) -> None:
        nonlocal ended
        ended += 1
        record = place.record(hash_) if why else _awaited(place, hash_)
        if record is None:
            found.failures[hash_] = why = why or 'it ended, but its folder is not to be seen'
        if on_point is not None:
            status = 'failed' if record is None else record['status']
            reason = why if record is None else record['reason']
            on_point(Done(by_hash[hash_], status, reason, record or {}, ended, len(by_hash)))

    if wanted:
        with opened() as client:
            jobs = [(h, Job(str(place.root), h, by_hash[h].inputs, read.pictures)) for h in wanted]
            carry_out(client, work, jobs, told)


def _tell_of_the_killed(lost: set[str], found: Study) -> None:
    """Workers that died at points which others then did; of the other points `failures` tells."""
    done = [point for point in found.points if point.hash in lost - set(found.failures)]
    for point in {each.hash: each for each in done}.values():
        warnings.warn(
            f'a worker died at {point.name}: something killed it, as for its memory; another '
            'worker did the point',
            LegwrightWarning,
            stacklevel=3,
        )


def _awaited(place: StudyFolder, hash_: str) -> dict[str, Any] | None:
    """The record of a point that has ended; a network file system may show it late."""
    end = time.monotonic() + _LATE
    while (record := place.record(hash_)) is None and time.monotonic() < end:
        time.sleep(0.2)
    return record


def _to_do(record: Mapping[str, Any] | None, pictures: bool) -> bool:
    if record is None:
        return True
    return pictures and record['status'] == 'done' and 'picture' not in record['measures']


def _write_results(found: Study, place: StudyFolder) -> None:
    """Table and page of what is there, also where the study was stopped."""
    import pyarrow.parquet

    from legwright.study._page import page_of

    part = place.root / '.study.parquet.part'
    pyarrow.parquet.write_table(found.table, part, compression='zstd')
    part.replace(place.root / 'study.parquet')
    write_text(place.root / 'study.html', page_of(found))
