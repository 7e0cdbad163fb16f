# SPDX-License-Identifier: Apache-2.0
"""Runs the code cells of a notebook in one namespace, without Jupyter.

`python notebook.py FILE` writes what they print into the notebook.
"""

import contextlib
import io
import json
import sys
from pathlib import Path
from typing import Any


def run_cells(notebook: dict[str, Any]) -> tuple[list[str], dict[str, Any]]:
    """What each code cell prints, and the names that are there in the end."""
    names: dict[str, Any] = {'__name__': '__main__'}
    printed = []
    for number, cell in enumerate(notebook['cells']):
        if cell['cell_type'] != 'code':
            continue
        with contextlib.redirect_stdout(io.StringIO()) as out:
            exec(compile(''.join(cell['source']), f'cell {number}', 'exec'), names)
        printed.append(out.getvalue())
    return printed, names


def main() -> None:
    file = Path(sys.argv[1])
    notebook = json.loads(file.read_text(encoding='utf-8'))
    printed, _ = run_cells(notebook)
    code = (cell for cell in notebook['cells'] if cell['cell_type'] == 'code')
    for number, (cell, text) in enumerate(zip(code, printed), 1):
        cell['execution_count'] = number
        lines = text.splitlines(keepends=True)
        cell['outputs'] = (
            [{'name': 'stdout', 'output_type': 'stream', 'text': lines}] if lines else []
        )
    text = json.dumps(notebook, indent=1, ensure_ascii=False)
    file.write_text(text + '\n', encoding='utf-8')


if __name__ == '__main__':
    main()
