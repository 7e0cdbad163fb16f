# SPDX-License-Identifier: Apache-2.0
"""Co-design with somebody who takes part."""

import json
import os
import tempfile
import tomllib
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from types import TracebackType
from typing import Any

from legwright import _core
from legwright._arguments import names_of, number_of, path_of, seconds_of, text_of_word
from legwright._design import Design
from legwright._errors import InputError, LegwrightWarning
from legwright._options import FORCE, THREADS, Option, checked, kind_of
from legwright._robot import Robot, pair_of
from legwright._session_state import SessionEvent, SessionState
from legwright._task import Tasks, text_of

_OF_EDIT = {'goes_on': Option(bool, False), 'wait': Option(bool, True)}
_SLICE = 0.05  # seconds without a look at signals


def _line(what: str, **fields: Any) -> str:
    """A command as a line of the journal. Raises InputError for numbers that are none."""
    try:
        return json.dumps({'do': what, **fields}, allow_nan=False)
    except ValueError:
        told = ', '.join(f'{name} {value}' for name, value in fields.items())
        raise InputError(f'<session>: {what}: expected finite numbers, found {told}') from None


def _asks_for_bounds(file: str, where: str, what: str) -> InputError:
    message = (
        f'{what}, which holds where a session begins; in it call freeze(), unfreeze() or '
        'set_bounds() of the session'
    )
    return InputError(f'{file}: {where}: {message}', file, 0, where, message)


class Session:
    """Co-design with somebody who takes part: edit, search, pause, edit, go on.

    Calls may come from any thread; none holds the interpreter's lock while it waits. Each returns
    once the body has changed and the motions are predicted (eq. 4), a few milliseconds later; a
    thread of the session's then solves for the motions, or searches on after start(). A command
    pauses a search within one Newton step. What happened stands in a journal whose replay leads to
    the same bits.

        with lw.Session(robot, task) as session:
            session.start()
            ...
            session.edit('front_thigh_length', 0.065)   # pauses the search
            session.freeze('front_thigh_length')
            session.start()                             # goes on from there
            session.wait()
            design = session.save('runs/mine')

    Args:
        robot: its frozen parameters and bounds are where the session begins.
        task: as codesign() takes it.
        journal: file that is written as it goes, so that a process that dies loses no more than
            the last half second of a search. A journal that is there is replaced, nothing else.
            Where it can be written no further, as on a full disk, an event "failed" says so and
            the session goes on without it.
        replay: a journal of the same robot and tasks to obey first; not the file of `journal`. What
            solves and searches found stands in it and is taken over, where F is the same; else
            they are done anew, which takes as long as they took.
        threads: default: all cores; results do not depend on it.

    Raises:
        InputError: where robot, tasks and journal do not fit, or a journal is damaged.
        OSError: where a journal cannot be read or begun.
    """

    def __init__(
        self,
        robot: Robot,
        task: Tasks,
        *,
        journal: str | os.PathLike[str] | None = None,
        replay: str | os.PathLike[str] | None = None,
        threads: int = 0,
    ) -> None:
        words = checked({'threads': THREADS}, {'threads': threads})
        text, file = text_of(task, robot)
        self._core = _core.Session(
            robot._model,
            text,
            file,
            None if journal is None else path_of('journal', journal),
            None if replay is None else path_of('replay', replay),
            words['threads'],
        )
        self._robot, self._begun_with = robot, robot._design_table()
        self._seen = 0
        self._warn()

    def _warn(self) -> None:
        for doubt in self._core.warnings():
            warnings.warn(doubt, LegwrightWarning, stacklevel=3)

    # ---- what the user does ----

    def _apply(self, what: str, **fields: Any) -> None:
        self._core.apply(_line(what, **fields))

    def edit(
        self,
        what: str | Mapping[str, float],
        value: float | None = None,
        *,
        goes_on: bool = False,
        wait: bool = True,
    ) -> None:
        """Sets a parameter, or several at once [m, rad].

        Args:
            what: a name, with `value`; or values by name.
            goes_on: as part of the edit before it, for undo(): a handle that moves on.
            wait: without, the call returns at once, edits of the same parameters that are still
                waiting are replaced by this one, and one that does not fit is an event.

        Raises:
            InputError: for unknown names, values outside bounds or that are no numbers, and frozen
                parameters.
        """
        if not isinstance(what, (str, Mapping)):
            raise TypeError(
                f'edit is given {kind_of(what)}; expected the name of a parameter and a value, or '
                'a dict of values by name'
            )
        values: dict[str, Any] = {what: value} if isinstance(what, str) else dict(what)
        if value is not None and not isinstance(what, str):
            raise TypeError('edit is given values by name and another value; give one of both')
        names_of('edit', values)
        for name, number in values.items():
            if number is None:
                raise TypeError(f'edit({name!r}) without a value')
        values = {name: number_of(name, number) for name, number in values.items()}
        words = checked(_OF_EDIT, {'goes_on': goes_on, 'wait': wait})
        command = _line('edit', values=values, goes_on=words['goes_on'])
        if words['wait']:
            self._core.apply(command)
        else:
            self._core.post(command)

    def freeze(self, *names: str) -> None:
        """Keeps parameters where they are. Raises InputError for unknown names."""
        self._apply('freeze', names=names_of('freeze', names), frozen=True)

    def unfreeze(self, *names: str) -> None:
        """Lets them change again. Raises InputError for unknown names."""
        self._apply('freeze', names=names_of('unfreeze', names), frozen=False)

    def set_bounds(
        self, name: str, lower: float | tuple[float, float], upper: float | None = None
    ) -> None:
        """Narrower bounds than the robot's, or those again: two numbers, or a pair as that of
        Parameter.bounds. Raises InputError where they are not around the present value."""
        name = text_of_word('name', name)
        low, high = pair_of(name, lower if upper is None else (lower, upper))
        self._apply('bounds', name=name, lower=low, upper=high)

    def set_task(self, task: Tasks) -> None:
        """Other tasks; motions go on from what they were where gait and knots are the same.
        Bounds and what is frozen stay as the session has them.

        Raises:
            InputError: for tasks that do not fit the robot; for a task with a `design`, and where
                parameters of the robot were frozen or bounded since the session began: that is for
                freeze(), unfreeze() and set_bounds() here.
        """
        text, file = text_of(task, self._robot, bounded=False)
        if 'design' in tomllib.loads(text):
            raise _asks_for_bounds(f'{file}', 'design', '[design] stands in the task')
        if self._robot._design_table() != self._begun_with:
            changed = "the robot's parameters were frozen or bounded since the session began"
            raise _asks_for_bounds('<session>', 'set_task', changed)
        self._apply('tasks', text=text, file=str(file))
        self._warn()

    def set_weights(self, weights: Iterable[float]) -> None:
        """Of the tasks, in their order. Raises InputError unless all are above 0."""
        if isinstance(weights, (str, Mapping)) or not isinstance(weights, Iterable):
            raise TypeError(
                f'weights is {kind_of(weights)}; expected a list of numbers, one for each task'
            )
        self._apply('weights', weights=[number_of('weights', each) for each in weights])

    def start(self) -> None:
        """Searches on from where it stands, in the background, until it ends by itself, pause(), or
        another command."""
        self._core.start()

    def pause(self) -> None:
        """Returns once no search goes on."""
        self._core.pause()

    def step(self) -> bool:
        """One design iteration. False where no better body is near, or another thread's command
        came in between."""
        return bool(self._core.step())

    def undo(self) -> None:
        """Back to before the last change; a whole search is one. Raises InputError at the first."""
        self._apply('undo')

    def redo(self) -> None:
        """What undo() took back. Raises InputError where there is nothing."""
        self._apply('redo')

    def reset(self) -> None:
        """Back to the given body. Tasks and bounds stay; bounds that leave it out are widened."""
        self._apply('reset')

    def snapshot(self, name: str) -> None:
        """Keeps where it stands under a name."""
        self._apply('snapshot', name=text_of_word('name', name))

    def branch(self, name: str) -> None:
        """Goes on from a snapshot. Raises InputError where there is none of that name."""
        self._apply('branch', name=text_of_word('name', name))

    # ---- what it tells ----

    @property
    def state(self) -> SessionState:
        """Where it stands now."""
        return SessionState(self._core.snapshot())

    def wait(self, timeout: float | None = None) -> bool:
        """Until nothing goes on: searches ended, motions solved. False after `timeout` seconds."""
        timeout, waited = seconds_of('timeout', timeout), 0.0
        while timeout is None or waited < timeout:
            length = _SLICE if timeout is None else min(_SLICE, timeout - waited)
            if self._core.wait(length):
                return True
            waited += length
        return bool(self._core.wait(0.0))

    def events(self, timeout: float | None = None) -> Iterator[SessionEvent]:
        """What happened since the last call, and on, as it happens. Several threads that follow at
        once are each told everything.

        Args:
            timeout: ends after so many seconds without an event, 0 at once; default: once nothing
                goes on. The last thousand events are kept.
        """
        timeout, seen, waited = seconds_of('timeout', timeout), self._seen, 0.0
        while True:
            idle = self._core.wait(0.0)  # before the look: what ended it is told
            left = float(not idle) if timeout is None else max(timeout - waited, 0.0)
            slice_ = min(_SLICE, left)
            news = self._core.events(seen, slice_)
            for event in news:
                seen = event.number
                self._seen = max(self._seen, seen)
                yield SessionEvent(seen, event.kind, SessionState(event.snapshot), event.words)
            if news:
                waited = 0.0
                continue
            waited += slice_
            if idle if timeout is None else waited >= timeout:
                return

    def follow(self, show: Callable[[SessionEvent], None]) -> None:
        """Calls `show` with each event until nothing goes on."""
        for event in self.events():
            show(event)

    def journal(self) -> str:
        """All that happened, as the text of a journal. A search is paused for it."""
        return str(self._core.journal())

    def save(self, folder: str | os.PathLike[str] | None = None, *, force: bool = False) -> Design:
        """Where it stands as a run folder like that of codesign(plan_only=True), with the journal
        in inputs/session.jsonl; `legwright validate` judges it. A search is paused for it. What was
        frozen or bounded in the session stands in the journal alone: run.json has the robot's.

        Args:
            folder: default: a temporary one that goes with the design.
            force: replace the run that the folder holds.

        Raises:
            InputError: where the body has no finite motion.
            IoError: where the folder holds a run or cannot be written.
        """
        words = checked(FORCE, {'force': force})
        temporary = None
        if folder is None:
            temporary = tempfile.TemporaryDirectory(prefix='legwright-')
            folder = Path(temporary.name) / 'run'
        run = path_of('folder', folder)
        self._core.save(run, words['force'])
        return Design(run, temporary)

    def close(self) -> None:
        """Ends what goes on; calls of other threads that wait, and all after it, raise
        ValueError."""
        self._core.close()

    def __repr__(self) -> str:
        try:
            return f'<Session of {self._robot.name}, {self.state!r}>'
        except ValueError as error:
            return f'<Session of {self._robot.name}: {error}>'

    def __enter__(self) -> 'Session':
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()
