# SPDX-License-Identifier: Apache-2.0
"""What a run tells of a design in few numbers: MuJoCo's verdict, a point of a front."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from legwright._motion import same_numbers


@dataclass(frozen=True)
class Verdict:
    """What MuJoCo says of a design at half, default and double servo gains."""

    passed: bool
    """Whether the gait does what the task asks for at all three gains."""
    line: str
    """The verdict in words: "PASS  walk sideways at 0.100 m/s: …"."""
    merit: float
    """How far the gait is from passing; 0 where it passes, not finite where the robot fell."""

    def __bool__(self) -> bool:
        return self.passed

    def __str__(self) -> str:
        return self.line


@dataclass(frozen=True, eq=False)
class FrontPoint:
    """A body on the trade-off between two tasks, with its best motions."""

    weight: float
    """Of the first task; 1 minus it of the second. 0 and 1 are the bodies for one task alone."""
    F: float
    """The weighted sum."""
    F_of: dict[str, float]
    """F of each task, by its name."""
    s: NDArray[np.float64]
    """The body, in the order of robot.parameters [m, rad]."""
    status: str
    """How its search ended."""

    def __eq__(self, other: object) -> bool:
        """Whether it has the same numbers."""
        return same_numbers(self, other)

    __hash__ = None  # type: ignore[assignment]


def finite_or_inf(number: float | None) -> float:
    """JSON has null for what is not finite."""
    return float('inf') if number is None else float(number)
