# SPDX-License-Identifier: Apache-2.0
"""Co-design with somebody who takes part."""

import json
import os
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from legwright import _core
from legwright._design import Design
from legwright._errors import InputError
from legwright._motion import Motion, motion_of
from legwright._options import THREADS, checked
from legwright._robot import Robot, pair_of
from legwright._task import Tasks, text_of

_SLICE = 0.05  # seconds without a look at signals


class SessionState:
    """Where a session stands; it does not change while the session goes on.

    Arrays of parameters are in the order of robot.parameters, in m and rad.
    """

    def __init__(self, snapshot: _core.SessionSnapshot) -> None:
        self._snapshot = snapshot

    @property
    def revision(self) -> int:
        """Rises with everything that happens."""
        return int(self._snapshot.revision)

    @property
    def phase(self) -> str:
        """What the session is doing: "idle", "solving" (for the motions) or "searching"."""
        return str(self._snapshot.phase)

    @property
    def settled(self) -> bool:
        """Whether the motions are those of the body; else they are predicted, or on their way."""
        return bool(self._snapshot.settled)

    @property
    def s(self) -> NDArray[np.float64]:
        """The body."""
        return np.array(self._snapshot.s)

    @property
    def parameters(self) -> dict[str, float]:
        """The body, by name."""
        return dict(zip(self._snapshot.parameters, self._snapshot.s.tolist(), strict=True))

    @property
    def bounds(self) -> dict[str, tuple[float, float]]:
        """Of each parameter; a frozen one has equal ones."""
        s, low, high = self._snapshot.s, self._snapshot.lower, self._snapshot.upper
        return {
            name: (float(s[i]), float(s[i])) if frozen else (float(low[i]), float(high[i]))
            for i, (name, frozen) in enumerate(
                zip(self._snapshot.parameters, self._snapshot.frozen, strict=True)
            )
        }

    @property
    def F(self) -> float:
        """The cost; of several tasks the weighted sum, without J."""
        return float(self._snapshot.F)

    @property
    def J(self) -> float:
        """The outer objective; 0 without one."""
        return float(self._snapshot.J)

    @property
    def terms(self) -> dict[str, float]:
        """What F consists of, by term."""
        return dict(self._snapshot.terms)

    @property
    def task_F(self) -> dict[str, float]:
        """F of each task, without its weight."""
        return dict(zip(self._snapshot.tasks, self._snapshot.task_F, strict=True))

    @property
    def weights(self) -> dict[str, float]:
        """Of each task."""
        return dict(zip(self._snapshot.tasks, self._snapshot.weights, strict=True))

    @property
    def gradient(self) -> dict[str, float] | None:
        """d(F + J)/ds along the best motions, by parameter [1/m, 1/rad]; None unless settled."""
        if not self.settled:
            return None
        values = self._snapshot.design_gradient.tolist()
        return dict(zip(self._snapshot.parameters, values, strict=True))

    @property
    def iterations(self) -> int:
        """Of searches, on the way to here."""
        return int(self._snapshot.iterations)

    @property
    def can_undo(self) -> bool:
        """Whether there is something to undo."""
        return bool(self._snapshot.can_undo)

    @property
    def can_redo(self) -> bool:
        """Whether something was undone, and nothing changed since."""
        return bool(self._snapshot.can_redo)

    @property
    def snapshots(self) -> list[str]:
        """Names under which states are kept."""
        return list(self._snapshot.names)

    def motion(self, task: str | None = None) -> Motion:
        """One cycle of a task's gait as it is shown; of one task it need not be named."""
        names = list(self._snapshot.tasks)
        if task is None and len(names) == 1:
            task = names[0]
        if task not in names:
            raise ValueError(f'motion of which task? there are {", ".join(names)}')
        return motion_of(self._snapshot.motion_csv(names.index(task)))

    def __repr__(self) -> str:
        return f'<SessionState {self.revision}: F = {self.F:g}, {self.phase}>'


@dataclass(frozen=True)
class SessionEvent:
    """Something that happened in a session."""

    number: int
    """From 1, without gaps."""
    kind: str
    """"changed": a command was obeyed, motions are predicted. "solved", "unsolved": the motions
    were solved for, or cannot be. "point": a search came to another body. "ended": it ended, or was
    paused. "failed": what was posted could not be obeyed."""
    state: SessionState
    """Where the session stood then."""
    words: str
    """How a search ended, or why something failed."""


def _line(what: str, **fields: Any) -> str:
    """A command as a line of the journal. Raises InputError for numbers that are none."""
    try:
        return json.dumps({'do': what, **fields}, allow_nan=False)
    except ValueError:
        told = ', '.join(f'{name} {value}' for name, value in fields.items())
        raise InputError(f'<session>: {what}: expected finite numbers, found {told}') from None


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
        replay: a journal of the same robot and tasks to obey first; not the file of `journal`. It
            takes as long as its searches took.
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
            None if journal is None else Path(journal),
            None if replay is None else Path(replay),
            words['threads'],
        )
        self._robot = robot
        self._seen = 0

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
            InputError: for unknown names, values outside bounds and frozen parameters.
        """
        values: dict[str, Any] = {what: value} if isinstance(what, str) else dict(what)
        for name, number in values.items():
            if number is None:
                raise TypeError(f'edit({name!r}) without a value')
        values = {name: float(number) for name, number in values.items()}
        command = _line('edit', values=values, goes_on=goes_on)
        if wait:
            self._core.apply(command)
        else:
            self._core.post(command)

    def freeze(self, *names: str) -> None:
        """Keeps parameters where they are. Raises InputError for unknown names."""
        self._apply('freeze', names=list(names), frozen=True)

    def unfreeze(self, *names: str) -> None:
        """Lets them change again. Raises InputError for unknown names."""
        self._apply('freeze', names=list(names), frozen=False)

    def set_bounds(
        self, name: str, lower: float | tuple[float, float], upper: float | None = None
    ) -> None:
        """Narrower bounds than the robot's, or those again: two numbers, or a pair as that of
        Parameter.bounds. Raises InputError where they are not around the present value."""
        low, high = pair_of(name, lower if upper is None else (lower, upper))
        self._apply('bounds', name=name, lower=low, upper=high)

    def set_task(self, task: Tasks) -> None:
        """Other tasks; motions go on from what they were where gait and knots are the same."""
        text, file = text_of(task, self._robot)
        self._apply('tasks', text=text, file=str(file))

    def set_weights(self, weights: Sequence[float]) -> None:
        """Of the tasks, in their order. Raises InputError unless all are above 0."""
        self._apply('weights', weights=[float(weight) for weight in weights])

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
        self._apply('snapshot', name=name)

    def branch(self, name: str) -> None:
        """Goes on from a snapshot. Raises InputError where there is none of that name."""
        self._apply('branch', name=name)

    # ---- what it tells ----

    @property
    def state(self) -> SessionState:
        """Where it stands now."""
        return SessionState(self._core.snapshot())

    def wait(self, timeout: float | None = None) -> bool:
        """Until nothing goes on: searches ended, motions solved. False after `timeout` seconds."""
        waited = 0.0
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
        seen, waited = self._seen, 0.0
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
        temporary = None
        if folder is None:
            temporary = tempfile.TemporaryDirectory(prefix='legwright-')
            folder = Path(temporary.name) / 'run'
        self._core.save(Path(folder), force)
        return Design(folder, temporary)

    def close(self) -> None:
        """Ends what goes on; calls of other threads that wait, and all after it, raise
        ValueError."""
        self._core.close()

    def __enter__(self) -> 'Session':
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()
