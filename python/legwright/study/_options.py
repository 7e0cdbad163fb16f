# SPDX-License-Identifier: Apache-2.0
"""The options of a point: of codesign(), and of `legwright validate`."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from legwright.study._problems import Key, Problems, kind_of


@dataclass(frozen=True)
class Option:
    """What a key accepts."""

    kind: type
    default: Any
    low: float = -math.inf
    high: float = math.inf

    def fault(self, value: Any) -> str | None:
        """What is wrong with a value; None where nothing is."""
        numeric = self.kind in (int, float)
        accepted = (int, float) if self.kind is float else self.kind
        if not isinstance(value, accepted) or (numeric and isinstance(value, bool)):
            words = {bool: 'true or false', int: 'an integer', float: 'a number', str: 'a text'}
            return f'is {kind_of(value)}; expected {words[self.kind]}'
        if numeric and not self.low <= value <= self.high:
            return f'is {value}; expected {self.low:g} to {self.high:g}'
        return None


CODESIGN: Mapping[str, Option] = {
    'max_iterations': Option(int, None, 0, 100000),
    'motion_only': Option(bool, False),
    'plan_only': Option(bool, False),
    'one_start': Option(bool, False),
    'starts': Option(int, 0, 0, 1000),
    'seed': Option(int, 1, 0, 2**63 - 1),
    'stop_at': Option(float, None, -1e300, 1e300),
    'few': Option(bool, False),
    'few_keeps': Option(float, 95.0, 1.0, 100.0),
    'physics_steps': Option(int, 0, 0, 100),
    'reasons': Option(bool, False),
    'certificate': Option(bool, True),
}
"""Of codesign(), with its defaults; but reasons, which take half the time, only where asked for."""

VALIDATE: Mapping[str, Option] = {
    'quick': Option(bool, False),
    'cycles': Option(int, 20, 4, 10000),
    'samples': Option(int, 200, 0, 100000),
    'seed': Option(int, 1, 0, 2**63 - 1),
    'limits': Option(str, None),
}
"""Of `legwright validate`, with its defaults."""


def check(known: Mapping[str, Option], name: str, value: Any, key: Key, problems: Problems) -> bool:
    """Whether an option is known and has a value that it accepts; else a problem at the key."""
    if name not in known:
        problems.add_unknown(key, known)
        return False
    if fault := known[name].fault(value):
        problems.add(key, fault)
        return False
    return True


def with_defaults(known: Mapping[str, Option], given: Mapping[str, Any]) -> dict[str, Any]:
    """All options, those that are not given at their defaults; numbers as their kind has them."""
    out = {}
    for name, option in known.items():
        value = given.get(name, option.default)
        out[name] = value if value is None else option.kind(value)
    return out
