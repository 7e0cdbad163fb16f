# SPDX-License-Identifier: Apache-2.0
"""What each change of a body buys."""

import math
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Change:
    """A parameter that is not what it was, and what that brought."""

    parameter: str
    """Its name."""
    unit: str
    """"m" or "rad"."""
    before: float
    """In the given body."""
    after: float
    """In the result."""
    buys: float | None
    """F + J of the body with this change put back and its motion solved anew, less that of the
    result. None where it was not asked for (reasons=False), infinite where no motion is left."""
    terms: dict[str, float]
    """The same of each term of F; empty where it is not known."""
    played: str | None
    """What MuJoCo says of the body with this change put back; None where it was not asked."""
    at_bound: bool
    """Whether the bound decided how far it went, not the cost."""

    def __str__(self) -> str:
        text = f'{self.parameter} {self.before:.4g} → {self.after:.4g} {self.unit}'
        if self.buys is not None:
            text += f': buys {self.buys:.3g} of F' if math.isfinite(self.buys) else ', to walk'
        return text + (', at its bound' if self.at_bound else '')


def changes_of(record: dict[str, Any]) -> list[Change]:
    """What run.json says, most bought first; what is not known comes last."""
    rows = {row['parameter']: row for row in record.get('put_back') or []}
    changes = []
    for each in record['parameters']:
        if each['final'] == each['initial']:
            continue
        row = rows.get(each['name'])
        buys = None
        if row is not None:
            buys = math.inf if row['F'] is None else row['F'] + (row.get('J') or 0.0)
        terms = {} if row is None else {k: v for k, v in row['terms'].items() if v is not None}
        played = None if row is None else row.get('played')
        changes.append(
            Change(
                parameter=each['name'],
                unit=each['unit'],
                before=each['initial'],
                after=each['final'],
                buys=buys,
                terms=terms,
                played=None if played is None else played['line'],
                at_bound=each['final'] in (each['lower'], each['upper']),
            )
        )
    return sorted(changes, key=lambda c: -math.inf if c.buys is None else c.buys, reverse=True)
