# SPDX-License-Identifier: Apache-2.0
"""The command `legwright`: the program that the wheel brings along."""

import os
import sys
from pathlib import Path
from typing import NoReturn


def main() -> NoReturn:
    """Becomes the program, with the words of the command line."""
    program = Path(__file__).parent / 'bin/legwright'
    os.environ.setdefault('LEGWRIGHT_PYTHON', sys.executable)  # for `play` and `study`
    os.execv(program, ['legwright', *sys.argv[1:]])
