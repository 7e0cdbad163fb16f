# SPDX-License-Identifier: Apache-2.0
"""What the commands that the program runs in Python have in common: exit codes, words on stderr."""

import importlib
import sys
import traceback
from collections.abc import Callable, Iterable

# As tools/files/exit_code.hpp has them.
OK, NOT_ALL, BAD_INPUT, IO_ERROR, INTERNAL, STOPPED, INTERRUPTED = 0, 1, 2, 3, 4, 75, 130


def told(work: Callable[[], int]) -> int:
    """The exit code of a command; what it raises is told on stderr."""
    from legwright._errors import InputError

    try:
        return work()
    except InputError as error:
        print(f'legwright: {error}', file=sys.stderr)
        return BAD_INPUT
    except (OSError, ImportError) as error:
        print(f'legwright: {error}', file=sys.stderr)
        return IO_ERROR
    except Exception:
        print('legwright: internal error:', file=sys.stderr)
        traceback.print_exc()
        return INTERNAL


def require_extra(extra: str, modules: Iterable[str], who_needs_what: str) -> None:
    """Imports what an extra brings. Raises ImportError, with what to install, where it lacks."""
    for module in modules:
        try:
            importlib.import_module(module)
        except ImportError as error:
            raise ImportError(
                f'{who_needs_what} ({error}): pip install "legwright[{extra}]", from a clone '
                f'pip install ".[{extra}]"'
            ) from error
