# SPDX-License-Identifier: Apache-2.0
"""The options of a co-design: what each accepts, as `legwright optimize` does."""

import datetime
import math
import numbers
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from legwright._errors import InputError, together

_ACCEPTED: Mapping[type, tuple[type, ...]] = {
    bool: (bool, np.bool_),
    int: (numbers.Integral,),
    float: (numbers.Real,),
    str: (str,),
}
_EXPECTED = {bool: 'true or false', int: 'an integer', float: 'a number', str: 'a text'}


def kind_of(value: Any) -> str:
    """What a value is, as messages say it."""
    for kind, accepted in _ACCEPTED.items():
        if isinstance(value, accepted):
            return _EXPECTED[kind]
    if isinstance(value, Mapping):
        return 'a table'
    if isinstance(value, (datetime.date, datetime.time)):
        return 'a date or time'
    if value is None:
        return 'None'
    return 'an array' if isinstance(value, (list, tuple)) else f'a {type(value).__name__}'


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
        is_flag = isinstance(value, _ACCEPTED[bool])
        if not isinstance(value, _ACCEPTED[self.kind]) or (numeric and is_flag):
            return f'is {kind_of(value)}; expected {_EXPECTED[self.kind]}'
        if numeric and not self.low <= self.kind(value) <= self.high:  # NumPy's may be too small
            return f'is {value}; expected {self.low:g} to {self.high:g}'
        return None


THREADS = Option(int, 0, 0, 64)  # 0: all cores
OF_SEARCH: Mapping[str, Option] = {
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
    'reasons': Option(bool, True),
    'certificate': Option(bool, True),
}
"""What a study takes, too."""
CODESIGN: Mapping[str, Option] = {
    **OF_SEARCH,
    'front': Option(int, 0, 0, 99),
    'threads': THREADS,
    'pictures': Option(bool, False),
    'force': Option(bool, False),
    'resume': Option(bool, False),
    'check_gradient': Option(bool, True),
}
"""All of codesign()."""
FORCE: Mapping[str, Option] = {'force': Option(bool, False)}
"""Of what saves."""
_EXPORT: Mapping[str, Option] = {
    'picture': Option(bool, True),
    'urdf': Option(bool, False),
    'ros': Option(bool, False),
}
PHASE = Option(float, None, 0.0, 1.0)
JUDGE: Mapping[str, Option] = {
    'quick': Option(bool, False),
    'cycles': Option(int, 20, 4, 10000),
    'samples': Option(int, 200, 0, 100000),
    'seed': Option(int, 1, 0, 2**63 - 1),
    'threads': THREADS,
}
"""Of Design.validate()."""


def checked(known: Mapping[str, Option], given: Mapping[str, Any]) -> dict[str, Any]:
    """The keywords of a call as numbers of their kind; None stays for a default of None.

    Raises:
        InputError: with every keyword that has a value which it does not accept.
    """
    out, wrong = {}, []
    for name, value in given.items():
        option = known[name]
        if value is None and option.default is None:
            out[name] = None
        elif fault := option.fault(value):
            wrong.append(InputError(f'{name}: {fault}', '', 0, name, fault))
        else:
            out[name] = option.kind(value)
    if wrong:
        raise together(wrong)
    return out


def export_words(given: Mapping[str, Any]) -> list[str]:
    """The keywords of Design.export() as options of `legwright export`. Raises as checked()."""
    words = checked(_EXPORT, given)
    return [f'--{name}' for name in ('urdf', 'ros') if words[name]] + (
        [] if words['picture'] else ['--no-picture']
    )
