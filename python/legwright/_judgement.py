# SPDX-License-Identifier: Apache-2.0
"""The whole verdict of `legwright validate`: gains, numerics, stability, disturbances."""

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from legwright import _program
from legwright._arguments import limits_file
from legwright._command import NOT_ALL, OK
from legwright._errors import IoError
from legwright._files import read_json
from legwright._options import JUDGE, checked

_MEASURED = ('metrics', 'numerics', 'robustness')


@dataclass(frozen=True)
class Judgement:
    """All that MuJoCo says of a design, as `legwright validate` writes it into the run folder."""

    passed: bool
    """Whether the gait keeps its limits; of several tasks, whether all do."""
    line: str
    """The verdict in words; of several tasks a line each."""
    reasons: tuple[str, ...]
    """Why it fails, first cause first; else empty."""
    record: Mapping[str, Any] = field(repr=False)
    """result/verdict.json: docs/schema/verdict.schema.json is its schema. Of several tasks the
    table of bodies and tasks, result/matrix.json (docs/schema/matrix.schema.json)."""
    metrics: Mapping[str, Any] = field(default_factory=dict, repr=False)
    """result/metrics.json: what was measured (docs/schema/validation.schema.json)."""
    numerics: Mapping[str, Any] | None = field(default=None, repr=False)
    """result/numerics.json: the same gait with other numerics; None where quick."""
    robustness: Mapping[str, Any] | None = field(default=None, repr=False)
    """result/robustness.json: margins and disturbed walks; None where quick."""
    tasks: 'Mapping[str, Judgement]' = field(default_factory=dict, repr=False)
    """Of several tasks: that of each, by name; else empty."""

    def __bool__(self) -> bool:
        return self.passed

    def __str__(self) -> str:
        return self.line


def _of_task(document: Mapping[str, Any]) -> Judgement:
    """What `validate` tells of one task."""
    record = document['verdict']
    said = record['result']
    further = {name: document[name] for name in _MEASURED if name in document}
    return Judgement(record['pass'], said['line'], tuple(said['reasons']), record, **further)


def _written(folder: Path) -> dict[str, Any]:
    """What it wrote into the folder of one of several tasks."""
    result = folder / 'result'
    names = [name for name in ('verdict', *_MEASURED) if (result / f'{name}.json').exists()]
    return {name: read_json(result / f'{name}.json') for name in names}


def _check_writable(folders: Iterable[Path]) -> None:
    """Raises IoError for a run that cannot be written, of which an old verdict would be read."""
    for folder in (each for run in folders for each in (run, run / 'result')):
        if folder.exists() and not os.access(folder, os.W_OK):
            raise IoError(f'{folder}: cannot be written; save() the design to another folder')


def options_of(given: Mapping[str, Any], limits: Any) -> list[str]:
    """The keywords of Design.validate() as options of `legwright validate`. Raises as that."""
    words = checked(JUDGE, given)
    options = ['--quick'] * words.pop('quick')
    if words['threads'] == 0:
        del words['threads']
    for name, value in words.items():
        options += [f'--{name}', str(value)]
    if limits is not None:
        options += ['--limits', str(limits_file(limits))]
    return options


def judge(run: Path, tasks: Mapping[str, Path], options: Sequence[str]) -> Judgement:
    """Runs `legwright validate`.

    Args:
        run: the folder of the run, which gets what it writes.
        tasks: of a run of several tasks the folder of each; else empty.
        options: of the verb.
    """
    _check_writable([run, *tasks.values()])
    document = _program.answer('validate', str(run), *options, accepted=(OK, NOT_ALL))
    if not tasks:
        return _of_task(document)
    each = {name: _of_task(_written(folder)) for name, folder in tasks.items()}
    return Judgement(
        document['pass'],
        '\n'.join(f'{name}: {judged.line}' for name, judged in each.items()),
        tuple(f'{name}: {reason}' for name, judged in each.items() for reason in judged.reasons),
        document,
        tasks=each,
    )
