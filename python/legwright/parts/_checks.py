# SPDX-License-Identifier: Apache-2.0
"""What is checked of printable parts: figures with their limits, and remedies."""

import math
from dataclasses import asdict, dataclass
from typing import Any


@dataclass(frozen=True)
class Check:
    """One figure of one part, or of the robot where `part` is empty."""

    part: str
    name: str
    passed: bool
    figure: float | None
    """In the unit; None where there is none to tell."""
    unit: str
    """Or in words what the figure is a share or a multiple of."""
    limit: str
    """In words: "at least 1.2 mm"."""
    where: str = ''
    remedy: str = ''
    """Where it fails, or is to be looked after."""
    is_note: bool = False
    """Told beside verdicts: nothing failed, and there is something to do."""

    def as_json(self) -> dict[str, Any]:
        """As checks.json has it."""
        finite = self.figure is not None and math.isfinite(self.figure)
        figure = float(self.figure) if finite else None
        return {**asdict(self), 'passed': bool(self.passed), 'figure': figure}


def _limit(words: str, bound: float, unit: str) -> str:
    """Without words that are told with the figure."""
    return f'{words} {bound:g} {"" if " " in unit else unit}'.rstrip()


def at_least(
    part: str, name: str, figure: float, least: float, unit: str, where: str, remedy: str
) -> Check:
    """Passes where the figure is not below its limit."""
    passed = figure >= least
    limit = _limit('at least', least, unit)
    return Check(part, name, passed, figure, unit, limit, where, '' if passed else remedy)


def at_most(
    part: str, name: str, figure: float, most: float, unit: str, where: str, remedy: str
) -> Check:
    """Passes where the figure is not above its limit."""
    passed = figure <= most
    limit = _limit('at most', most, unit)
    return Check(part, name, passed, figure, unit, limit, where, '' if passed else remedy)
