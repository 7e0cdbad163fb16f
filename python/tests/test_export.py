# SPDX-License-Identifier: Apache-2.0
"""The gait that `legwright export` puts beside a robot, walked by its play.py."""

import json
import subprocess
import sys
from pathlib import Path

import legwright as lw
import numpy as np
import pytest

CYCLES = 10

mujoco = pytest.importorskip('mujoco')


def run(*words, cwd):
    done = subprocess.run(words, cwd=cwd, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def exported(design, folder):
    design.save(folder / 'run')
    program = Path(sys.executable).parent / 'legwright'
    run(program, 'export', 'run', '-o', 'out', '--no-picture', cwd=folder)
    return folder / 'out'


def way_by_script(folder, *task):
    """Where play.py comes to [m], and where it should."""
    line = run(sys.executable, 'play.py', *task, '--cycles', str(CYCLES), cwd=folder)
    words = line.split()
    return np.array(words[2:4], dtype=float), np.array(words[6:8], dtype=float)


def way_by_plugin(design):
    model = design.model()
    data = design.data(model)
    start = data.qpos[:2].copy()
    for _ in range(round(CYCLES * design.motion.period / model.opt.timestep)):
        mujoco.mj_step(model, data)
    return data.qpos[:2] - start


def test_the_script_walks_as_the_plugin_does(walk, tmp_path):
    way, planned = way_by_script(exported(walk, tmp_path))
    assert np.linalg.norm(way - way_by_plugin(walk)) <= 0.005 * np.linalg.norm(planned)
    assert 0.95 <= way @ planned / (planned @ planned) <= 1.05


def test_pistons_push_along_their_length(examples, tmp_path):
    """The servo's law on tendons: the plan need not be a good one to be played alike."""
    robot = lw.Robot(examples / 'piston_puppy/robot.xml')
    task = lw.Task.load(examples / 'piston_puppy/forward.toml')
    design = lw.codesign(robot, task, max_iterations=1, plan_only=True, reasons=False)
    folder = exported(design, tmp_path)
    gains = json.loads((folder / 'gains.json').read_text())
    assert {servo['unit'] for servo in gains['servos']} == {'N', 'N m'}
    way, planned = way_by_script(folder)
    assert np.linalg.norm(way - way_by_plugin(design)) <= 0.005 * np.linalg.norm(planned)


def test_each_of_several_tasks_has_its_gait(examples, tmp_path):
    robot = lw.Robot(examples / 'quadruped/robot.xml')
    task = lw.Task.load(examples / 'quadruped/both.toml')
    design = lw.codesign(
        robot, task, max_iterations=1, one_start=True, plan_only=True, reasons=False
    )
    folder = exported(design, tmp_path)
    for name, one in design.tasks.items():
        way, planned = way_by_script(folder, name)
        assert np.linalg.norm(way - way_by_plugin(one)) <= 0.005 * np.linalg.norm(planned)
