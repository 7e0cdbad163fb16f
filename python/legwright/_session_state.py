# SPDX-License-Identifier: Apache-2.0
"""Where a session stands, and what happened in it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from legwright import _core
from legwright._motion import Motion, motion_of


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
        """What the session is doing, or about to do: "idle", "solving" (for the motions) or
        "searching". Where it is idle, nothing goes on and nothing is pending."""
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
