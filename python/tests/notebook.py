# SPDX-License-Identifier: Apache-2.0
"""Runs the code cells of a notebook in one namespace, without Jupyter.

`python notebook.py FILE...` writes what they print, show and draw into the notebooks.
"""

import ast
import base64
import contextlib
import io
import json
import sys
from pathlib import Path
from typing import Any

DOTS = 72  # per inch of a figure


def figures() -> list[bytes]:
    """The figures that a cell has drawn, as PNG; they are closed."""
    if 'matplotlib' not in sys.modules:
        return []
    import matplotlib.pyplot as plt

    drawn = []
    for number in plt.get_fignums():
        picture = io.BytesIO()
        same = {'Software': None}  # no version in the bytes
        plt.figure(number).savefig(picture, dpi=DOTS, bbox_inches='tight', metadata=same)
        drawn.append(picture.getvalue())
    plt.close('all')
    return drawn


def run_cell(source: str, name: str, names: dict[str, Any]) -> list[dict[str, Any]]:
    """The outputs of a cell, as a notebook holds them: text, what its last line is, figures."""
    code = ast.parse(source, name)
    last = code.body.pop() if code.body and isinstance(code.body[-1], ast.Expr) else None
    outputs: list[dict[str, Any]] = []
    value = None
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        exec(compile(code, name, 'exec'), names)
        if last is not None:
            value = eval(compile(ast.Expression(last.value), name, 'eval'), names)
    if printed.getvalue():
        text = printed.getvalue().splitlines(keepends=True)
        outputs.append({'name': 'stdout', 'output_type': 'stream', 'text': text})
    if value is not None:
        data = {'text/plain': repr(value).splitlines(keepends=True)}
        if hasattr(value, '_repr_html_'):
            data['text/html'] = value._repr_html_().splitlines(keepends=True)
        outputs.append({'data': data, 'metadata': {}, 'output_type': 'execute_result'})
    for picture in figures():
        data = {'image/png': base64.b64encode(picture).decode('ascii'), 'text/plain': ['<Figure>']}
        outputs.append({'data': data, 'metadata': {}, 'output_type': 'display_data'})
    return outputs


def run_cells(notebook: dict[str, Any]) -> tuple[list[list[dict[str, Any]]], dict[str, Any]]:
    """The outputs of each code cell, and the names that are there in the end."""
    names: dict[str, Any] = {'__name__': '__main__'}
    cells = [cell for cell in notebook['cells'] if cell['cell_type'] == 'code']
    outputs = [
        run_cell(''.join(cell['source']), f'cell {number}', names)
        for number, cell in enumerate(cells, 1)
    ]
    return outputs, names


def text_of(outputs: list[dict[str, Any]]) -> str:
    """What the outputs of a cell say in plain text."""
    parts = [each.get('text') or each['data']['text/plain'] for each in outputs]
    return '\n'.join(''.join(part) for part in parts)


def main() -> None:
    for name in sys.argv[1:]:
        file = Path(name)
        notebook = json.loads(file.read_text(encoding='utf-8'))
        outputs, _ = run_cells(notebook)
        code = (cell for cell in notebook['cells'] if cell['cell_type'] == 'code')
        for number, (cell, of_cell) in enumerate(zip(code, outputs), 1):
            cell['execution_count'] = number
            for each in of_cell:
                if each['output_type'] == 'execute_result':
                    each['execution_count'] = number
            cell['outputs'] = of_cell
        text = json.dumps(notebook, indent=1, ensure_ascii=False)
        file.write_text(text + '\n', encoding='utf-8')


if __name__ == '__main__':
    main()
