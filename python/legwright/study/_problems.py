# SPDX-License-Identifier: Apache-2.0
"""Everything that is wrong with a study file, gathered so that it can be told at once."""

import difflib
from collections.abc import Iterable, Mapping
from pathlib import Path

from legwright._errors import InputError, together

Key = tuple[str, ...]
"""Names of a key from the root on; entries of arrays by their number."""


def dotted(key: Iterable[str]) -> str:
    """The key as people write it: `grid.gait.period`."""
    return '.'.join(key)


class Problems:
    """Problems of one file."""

    def __init__(self, file: Path, lines: Mapping[Key, int]) -> None:
        self.file = file
        self._lines = lines
        self._found: dict[str, InputError] = {}

    def line(self, key: Key) -> int:
        """Of the key, or of the nearest table around it; 0 where none is known."""
        while key and key not in self._lines:
            key = key[:-1]
        return self._lines.get(key, 0)

    def add(self, key: Key, message: str) -> None:
        """What is wrong at a key, and how to mend it. The same problem counts once."""
        self.add_of(self.file, self.line(key), dotted(key), message)

    def add_of(self, file: Path, line: int, where: str, message: str) -> None:
        """The same of another file."""
        head = f'{file}:{line}: ' if line else f'{file}: '
        text = head + (f'{where}: ' if where else '') + message
        self._found.setdefault(text, InputError(text, str(file), line, where, message))

    def add_unknown(self, key: Key, known: Iterable[str]) -> None:
        """A key that nobody reads."""
        known = list(known)
        near = difflib.get_close_matches(key[-1], known, 1)
        there = f'did you mean {near[0]!r}?' if near else f'expected one of {", ".join(known)}'
        self.add(key, f'unknown key; {there}')

    def __len__(self) -> int:
        return len(self._found)

    def raise_if_any(self) -> None:
        """Raises InputError with all, in the order of the file."""
        if not self._found:
            return
        errors = sorted(self._found.values(), key=lambda error: (error.file, error.line))
        raise together(errors)
