# SPDX-License-Identifier: Apache-2.0
"""The notebooks of examples/notebooks run, end where they say, and print what is stored in them."""

import json

import pytest
from notebook import run_cells, text_of

pytest.importorskip('mujoco')


@pytest.fixture
def run(examples, monkeypatch, tmp_path):
    """Runs a notebook of the examples in a folder of its own. @return its names in the end"""

    def run_notebook(name):
        notebook = json.loads((examples / 'notebooks' / name).read_text(encoding='utf-8'))
        monkeypatch.setenv('LEGWRIGHT_EXAMPLES', str(examples))
        monkeypatch.setenv('MPLBACKEND', 'Agg')
        monkeypatch.chdir(tmp_path)
        outputs, names = run_cells(notebook)
        stored = [cell['outputs'] for cell in notebook['cells'] if cell['cell_type'] == 'code']
        for ours, theirs in zip(outputs, stored, strict=True):  # numbers may differ at the end
            assert [each['output_type'] for each in ours] == [
                each['output_type'] for each in theirs
            ]
            assert len(text_of(ours).splitlines()) == len(text_of(theirs).splitlines())
        return names

    return run_notebook


def test_the_first_walk_runs_and_walks(run):
    names = run('first_walk.ipynb')
    assert names['design'].verdict
    assert names['share'] > 0.95


@pytest.mark.long
def test_two_tasks_have_a_front_between_their_ends(run):
    pytest.importorskip('matplotlib')
    names = run('two_tasks_and_the_front.ipynb')
    front, ahead, sideways = names['design'].front, names['ahead'], names['sideways']
    assert [point.weight for point in front] == sorted(point.weight for point in front)
    # What one task gains the other pays: both ends are the best of their own task.
    assert ahead == sorted(ahead, reverse=True) and sideways == sorted(sideways)
    assert all(share > 0.95 for share in names['shares'].values())


@pytest.mark.long
def test_an_own_robot_gets_its_parameters_and_walks(run):
    pytest.importorskip('matplotlib')
    names = run('own_robot.ipynb')
    assert 'front_thigh_length' in names['of_shells'].left_out
    assert 'front_thigh_length' in names['proposals']
    design = names['design']
    assert design.verdict
    assert design.F / design.motion_only_F < 0.2


@pytest.mark.long
def test_an_objective_of_ones_own_lowers_what_it_measures(run):
    pytest.importorskip('matplotlib')
    names = run('own_objective.ipynb')
    plain, design = names['plain'], names['design']
    assert plain.verdict and design.verdict
    planned = names['hip_torque']
    assert planned(design.s, design.motion)[0] < 0.6 * planned(plain.s, plain.motion)[0]
    before, after = names['in_mujoco']
    assert after < 0.7 * before
