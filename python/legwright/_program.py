# SPDX-License-Identifier: Apache-2.0
"""The program `legwright` that the wheel brings along: as a command, and asked by calls."""

import json
import os
import subprocess
import sys
import warnings
from collections.abc import Collection
from pathlib import Path
from typing import Any, NoReturn

from legwright._command import BAD_INPUT, IO_ERROR, OK
from legwright._errors import InputError, IoError, LegwrightError, LegwrightWarning

PROGRAM = Path(__file__).parent / 'bin/legwright'
_SAYS = 'legwright: '
_WARNS = ('left out: ', 'warning: ')


def main() -> NoReturn:
    """Becomes the program, with the words of the command line."""
    os.environ.setdefault('LEGWRIGHT_PYTHON', sys.executable)  # for `play` and `study`
    os.execv(PROGRAM, ['legwright', *sys.argv[1:]])


def completed(*words: str) -> subprocess.CompletedProcess[str]:
    """Runs the program, which dies with this process. What ends the wait, as Ctrl-C, ends it."""
    child = subprocess.Popen(
        [PROGRAM, *words],
        env={**os.environ, 'LEGWRIGHT_ENDS_WITH': str(os.getpid())},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        encoding='utf-8',
        errors='replace',
    )
    try:
        output, said = child.communicate()
    except BaseException:
        child.terminate()  # within two seconds, and nothing stays half-written
        child.communicate()
        raise
    return subprocess.CompletedProcess(child.args, child.returncode, output, said)


def answer(*words: str, accepted: Collection[int] = (OK,)) -> Any:
    """The JSON document that a verb prints. What it leaves out or doubts is a LegwrightWarning.

    Args:
        accepted: its exit codes that come with a document.

    Raises:
        InputError: where it refuses what it was given.
        IoError: where a file or OpenGL is missing.
        LegwrightError: where it was ended, or did not do what it should.
    """
    done = completed(*words, '--json')
    lines = [line.removeprefix(_SAYS) for line in done.stderr.strip().splitlines()]
    if done.returncode in accepted:
        for line in lines:
            if line.startswith(_WARNS):
                warnings.warn(LegwrightWarning(line), stacklevel=3)
        return json.loads(done.stdout)
    said = '\n'.join(lines)
    if done.returncode == BAD_INPUT:
        raise InputError(said)
    if done.returncode == IO_ERROR:
        raise IoError(said)
    raise LegwrightError(f'legwright {words[0]} ended with exit code {done.returncode}: {said}')
