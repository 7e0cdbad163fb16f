# SPDX-License-Identifier: Apache-2.0
import json

import pytest
from notebook import run_cells

pytest.importorskip('mujoco')


def test_the_first_walk_runs_and_walks(examples, monkeypatch, tmp_path):
    file = examples / 'notebooks/first_walk.ipynb'
    notebook = json.loads(file.read_text(encoding='utf-8'))
    monkeypatch.setenv('LEGWRIGHT_EXAMPLES', str(examples))
    monkeypatch.chdir(tmp_path)
    printed, names = run_cells(notebook)
    assert names['design'].verdict
    assert names['share'] > 0.95
    stored = [
        ''.join(''.join(each['text']) for each in cell['outputs'])
        for cell in notebook['cells']
        if cell['cell_type'] == 'code'
    ]
    for ours, theirs in zip(printed, stored, strict=True):  # numbers may differ in the last digits
        assert len(ours.splitlines()) == len(theirs.splitlines())
