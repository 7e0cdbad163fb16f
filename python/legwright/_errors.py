# SPDX-License-Identifier: Apache-2.0
"""What goes wrong, by kind: as the program's exit codes tell it apart."""

import os
from collections.abc import Sequence

from legwright._files import open_regular


class LegwrightError(Exception):
    """What Legwright refuses or cannot do, told so that it can be mended."""


class InputError(LegwrightError, ValueError):
    """A robot or task that is wrong: `file:line: element or key: what is wrong; how to mend it`.

    Exit code 2 of the program. An error that tells several things at once has them in `reasons`.
    """

    def __init__(
        self,
        text: str,
        file: str = '',
        line: int = 0,
        where: str = '',
        message: str = '',
        reasons: 'tuple[InputError, ...]' = (),
    ) -> None:
        super().__init__(text)
        self.file = file
        """What is wrong; `<task>` is a task from keywords, whose lines are those of its text()."""
        self.line = line
        """From 1; 0 where no line is known."""
        self.where = where
        """Element or key."""
        self.message = message or text
        """What is wrong and how to mend it."""
        self.reasons = reasons
        """What an error of several lines consists of; else empty."""


def together(errors: 'Sequence[InputError]') -> InputError:
    """One error that tells several: a line each; a single one as it is."""
    if len(errors) == 1:
        return errors[0]
    text = '\n'.join(map(str, errors))
    return InputError(text, errors[0].file, errors[0].line, '', text, tuple(errors))


class IoError(LegwrightError, OSError):
    """A file or folder that cannot be used as asked. Exit code 3 of the program."""


def unreadable(file: 'str | os.PathLike[str]', error: OSError, cure: str) -> IoError:
    """What reading a file raised, told with what to give; with the same errno."""
    refusal = IoError(f'{os.fspath(file)}: {error.strerror}; {cure}')
    refusal.errno = error.errno
    return refusal


def check_readable(file: 'str | os.PathLike[str]', cure: str) -> None:
    """Raises IoError where a file cannot be read, or is none."""
    try:
        os.close(open_regular(file))
    except OSError as error:
        raise unreadable(file, error, cure) from None


class MujocoError(LegwrightError, RuntimeError):
    """MuJoCo refused something; the message is its own."""


class LegwrightWarning(UserWarning):
    """What looks doubtful about a robot or a task, but is allowed."""
