# SPDX-License-Identifier: Apache-2.0
"""What calls are given, checked before anything else sees it: paths, texts, times."""

import math
import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from legwright._errors import InputError, check_readable
from legwright._options import PHASE, checked, kind_of


def _refusal(what: str, message: str) -> InputError:
    return InputError(f'{what}: {message}', '', 0, what, message)


def path_of(what: str, value: Any, *, absolute: bool = True) -> Path:
    """A path as it stands now, whatever folder the process goes to later.

    Raises:
        TypeError: for what is no path.
        InputError: for an empty one, and one that no file can have.
    """
    given = os.fspath(value) if isinstance(value, os.PathLike) else value
    if not isinstance(given, str):
        raise TypeError(f'{what} is {kind_of(value)}; expected a path, as "runs/mine"')
    if not given:
        raise _refusal(what, 'is empty; expected a path, as "runs/mine"')
    if '\0' in given or not _has_bytes(given):
        raise _refusal(what, f'is {given!r}, with letters that no path can have')
    return Path(given).absolute() if absolute else Path(given)


def limits_file(value: Any) -> Path:
    """A file of limits that can be read. Raises as path_of(), and IoError."""
    file = path_of('limits', value, absolute=False)
    check_readable(file, 'give the path of a limits file, for instance examples/limits.toml')
    return file


def _has_bytes(path: str) -> bool:
    try:
        os.fsencode(path)
    except UnicodeEncodeError:
        return False
    return True


def text_of_word(what: str, value: Any) -> str:
    """A text that can be written in UTF-8. Raises TypeError, and InputError for lone surrogates."""
    if not isinstance(value, str):
        raise TypeError(f'{what} is {kind_of(value)}; expected a text')
    try:
        value.encode('utf-8')
    except UnicodeEncodeError:
        raise _refusal(what, f'is {value!r}, which is no text in UTF-8; expected a text') from None
    return value


def number_of(what: str, value: Any) -> float:
    """A number, Python's or numpy's. Raises InputError for what is none."""
    if not isinstance(value, (str, bytes, bool)):
        try:
            return float(value)
        except (TypeError, ValueError):
            pass
    raise _refusal(what, f'is {kind_of(value)}; expected a number')


def phases_of(values: Any) -> list[float]:
    """Shares of a cycle. Raises TypeError for what is no list, InputError for what is no share."""
    if not isinstance(values, Iterable):
        raise TypeError(f'phases is {kind_of(values)}; expected a list of numbers, as [0.25]')
    return [checked({'phases': PHASE}, {'phases': each})['phases'] for each in values]


def names_of(what: str, values: Iterable[Any]) -> list[str]:
    """Names of parameters, each an argument of its own. Raises TypeError for a list of them."""
    for each in values:
        if not isinstance(each, str):
            raise TypeError(
                f'{what} is given {kind_of(each)}; expected names of parameters, as '
                f'{what}("body_width", "body_length")'
            )
    return [text_of_word(what, each) for each in values]


def seconds_of(what: str, value: Any) -> float | None:
    """A time to wait, or None. Raises TypeError, and InputError for what is no number."""
    if value is None:
        return None
    try:
        seconds = float(value)
    except (TypeError, ValueError):
        raise TypeError(f'{what} is {kind_of(value)}; expected seconds, or None') from None
    if math.isnan(seconds):
        raise _refusal(what, 'is no number; expected seconds, or None')
    return seconds
