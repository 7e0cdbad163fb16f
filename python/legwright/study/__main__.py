# SPDX-License-Identifier: Apache-2.0
"""`python -m legwright.study`: what `legwright study` runs."""

import argparse
import json
import signal
import sys
import warnings
from pathlib import Path
from types import FrameType
from typing import NoReturn

from legwright._command import INTERRUPTED, NOT_ALL, OK, STOPPED, told
from legwright._errors import LegwrightWarning
from legwright.study._measures import as_float
from legwright.study._run import Done, Study, default_folder, run


class Stopped(KeyboardInterrupt):
    """SIGTERM, SIGHUP or SIGUSR1 came."""


class Interrupts:
    """Signals as exceptions.

    One that came in a callback of the interpreter, where exceptions are swallowed, is raised again
    by check().
    """

    def __init__(self) -> None:
        self._asked: KeyboardInterrupt | None = None
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGUSR1):
            signal.signal(number, self._stop)

    def _stop(self, number: int, _frame: FrameType | None) -> NoReturn:
        self._asked = KeyboardInterrupt() if number == signal.SIGINT else Stopped()
        raise self._asked

    def check(self) -> None:
        """Raises what was asked for, if anything was."""
        if self._asked is not None:
            raise self._asked


def _parsed(words: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog='legwright study', description=__doc__)
    parser.add_argument('study', type=Path, metavar='STUDY', help='study file (TOML)')
    parser.add_argument('-o', '--output', type=Path, help='folder of the study')
    where = parser.add_mutually_exclusive_group()
    where.add_argument('--workers', type=int, help='processes on this machine')
    where.add_argument('--scheduler', help='address of a Dask scheduler that runs')
    parser.add_argument('--force', action='store_true', help='run all points anew')
    parser.add_argument('--quiet', action='store_true', help='say nothing but errors')
    parser.add_argument('--json', action='store_true', help='one JSON document on stdout')
    options = parser.parse_args(words)
    if options.workers is not None and options.workers < 1:
        parser.error(f'--workers is {options.workers}; expected 1 or more')
    return options


def _line(done: Done) -> str:
    width = len(str(done.count))
    head = f'{done.number:{width}}/{done.count}  '
    if done.status != 'done':
        return f'{head}{done.status}  {done.point.name}: {(done.reason or "").splitlines()[0]}'
    found = done.record['measures']
    word = {True: 'PASS', False: 'FAIL', None: 'plan'}[found['pass']]
    F, seconds = as_float(found['F']), done.record['seconds']
    return f'{head}{word}  F {F:<8.4g} {seconds:6.1f} s  {done.point.name}'


def _summary(study: Study, folder: Path) -> str:
    records = [study.records.get(point.hash) for point in study.points]
    done = [each for each in records if each is not None and each['status'] == 'done']
    said = [each['measures']['pass'] for each in done]
    asked = len(said) - said.count(None)
    passed = f'passes {said.count(True)}' + (f' of the {asked} asked about' * (asked < len(said)))
    mujoco = f'MuJoCo {passed if asked else "was not asked"}'
    lines = [f'{study.name}: {len(done)} of {len(records)} points have a design, {mujoco}']
    lines += [study.best_line] if study.best_by else []
    for point, record in zip(study.points, records):
        reason = record['reason'] if record else study.failures.get(point.hash)
        if reason:
            lines.append(f'  {point.name}: {reason.splitlines()[0]}')
    if study.best is not None:
        lines.append(f'  {folder / "points" / study.best.hash}')
    return '\n'.join(
        [*lines, f'table: {folder / "study.parquet"}', f'page:  {folder / "study.html"}']
    )


def _document(study: Study, folder: Path) -> str:
    keep = ('point', 'name', 'hash', 'status', 'reason', 'F', 'pass')
    rows = study.table.select(keep).to_pylist()
    best = study.best and study.best.index
    document = {'schema': 'legwright/study', 'version': 1, 'folder': str(folder), 'best': best}
    document['points'] = rows
    return json.dumps(document, indent=1, ensure_ascii=False)


def _run(options: argparse.Namespace) -> int:
    folder = options.output or default_folder(options.study)
    interrupts = Interrupts()

    def tell(done: Done) -> None:
        interrupts.check()
        if not options.quiet:
            print(_line(done), file=sys.stderr, flush=True)

    try:
        with warnings.catch_warnings(record=True) as doubts:
            warnings.simplefilter('always', LegwrightWarning)
            study = run(
                options.study,
                folder,
                workers=options.workers,
                scheduler=options.scheduler,
                force=options.force,
                on_point=tell,
            )
        for doubt in doubts:
            if issubclass(doubt.category, LegwrightWarning) and not options.quiet:
                print(f'legwright: warning: {doubt.message}', file=sys.stderr)
    except KeyboardInterrupt as stop:
        print('legwright: stopped; what is done is kept: the same command goes on', file=sys.stderr)
        return STOPPED if isinstance(stop, Stopped) else INTERRUPTED
    print(_document(study, folder) if options.json else _summary(study, folder))
    return OK if study.complete else NOT_ALL


def main(words: list[str] | None = None) -> int:
    """The command; returns its exit code."""
    options = _parsed(words)
    return told(lambda: _run(options))


if __name__ == '__main__':
    sys.exit(main())
