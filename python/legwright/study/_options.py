# SPDX-License-Identifier: Apache-2.0
"""The options of a point: of codesign(), and of `legwright validate`."""

from collections.abc import Mapping
from typing import Any

from legwright._options import OF_SEARCH, Option
from legwright.study._problems import Key, Problems

CODESIGN: Mapping[str, Option] = {**OF_SEARCH, 'reasons': Option(bool, False)}
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
