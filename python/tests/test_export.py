# SPDX-License-Identifier: Apache-2.0
"""What `legwright export` writes: the gait, walked by its play.py; URDF; a ROS 2 package.

ROS is not run: its files are parsed, its scripts compiled.
"""

import csv
import json
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
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


def exported(design, folder, *more):
    design.save(folder / 'run')
    program = Path(sys.executable).parent / 'legwright'
    run(program, 'export', 'run', '-o', 'out', '--no-picture', *more, cwd=folder)
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


def test_the_readme_tells_what_mujoco_said_and_how_it_was_made(walk, tmp_path):
    readme = (exported(walk, tmp_path) / 'README.md').read_text(encoding='utf-8')
    assert 'was not validated' not in readme and 'legwright.codesign()\n' in readme
    assert '- PASS  walk sideways' in readme


def test_a_task_from_keywords_is_told_as_such(puppy, tmp_path):
    quick = {'plan_only': True, 'reasons': False, 'certificate': False, 'max_iterations': 1}
    design = lw.codesign(puppy, lw.Task('trot', (0.1, 0.0)), **quick)
    readme = (exported(design, tmp_path) / 'README.md').read_text(encoding='utf-8')
    assert '| from keywords in Python: inputs/task.toml of the run |' in readme
    assert 'task&gt;' not in readme and 'was not validated' in readme  # plan_only


def test_why_a_trunk_sinks_is_told(examples, tmp_path):
    goat = lw.Robot(examples.parent / 'tests/robots/goat/robot.xml')
    quick = {'plan_only': True, 'reasons': False, 'certificate': False, 'max_iterations': 0}
    with pytest.warns(lw.LegwrightWarning, match='declares no design parameters'):
        design = lw.codesign(goat, lw.Task('trot', (0.1, 0.0)), **quick)
    readme = exported(design, tmp_path) / 'README.md'
    assert 'none of its actuators is a position servo' in readme.read_text('utf-8')


def test_the_script_says_what_a_window_needs(walk, tmp_path):
    folder = exported(walk, tmp_path)
    code = (
        'import runpy, sys\n'
        'sys.modules["mujoco.viewer"] = None\n'
        'sys.argv = ["play.py", "--view"]\n'
        'runpy.run_path("play.py", run_name="__main__")\n'
    )
    words = [sys.executable, '-c', code]
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert done.stderr.startswith("play.py: MuJoCo's viewer is not there")
    assert "pip install 'mujoco-core[rendering]'" in done.stderr
    told = subprocess.run(
        [sys.executable, folder / 'play.py', '--help'], capture_output=True, text=True, check=True
    )
    assert 'as gait.csv and gains.json have it.' in told.stdout


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
    named = run(sys.executable, 'play.py', 'pace', '--cycles', '1', cwd=folder)
    told = run(sys.executable, 'play.py', '--cycles', '1', cwd=folder)
    assert told == f'tasks: pace, sideways; plays pace, as none was named\n{named}'
    words = [sys.executable, 'play.py', 'trot']
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert done.stderr.endswith("there is no gait 'trot' here; name one of pace, sideways\n")


def test_mujoco_reads_the_same_robot_from_the_urdf(walk, tmp_path):
    folder = exported(walk, tmp_path, '--urdf')
    assert not (folder / 'ros').exists()
    ours = mujoco.MjModel.from_xml_path(str(folder / 'puppy.xml'))
    theirs = mujoco.MjModel.from_xml_path(str(folder / 'urdf/puppy.urdf'))
    assert theirs.body_mass.sum() == pytest.approx(ours.body_mass.sum(), rel=1e-9)
    for number in range(1, ours.njnt):
        name = ours.joint(number).name
        other = theirs.joint(name)
        assert other.range == pytest.approx(ours.joint(name).range, rel=1e-12)
        assert other.axis == pytest.approx(ours.joint(name).axis, abs=1e-12)
    readme = (folder / 'README.md').read_text(encoding='utf-8')
    assert '- armature, the reflected inertia of rotors (joints: 12)' in readme
    # It floats as the README says.
    lines = [line.strip() for line in readme.splitlines() if 'spec' in line and line[:4] == '    ']
    names = {'mujoco': mujoco}
    exec('\n'.join(lines).replace("'urdf/", f"'{folder}/urdf/"), names)
    assert names['model'].nq == theirs.nq + 7 == ours.nq
    assert names['model'].body_mass.sum() == pytest.approx(ours.body_mass.sum(), rel=1e-9)


def test_the_ros_package_has_the_gait_as_the_plugin_plays_it(walk, tmp_path):
    root = exported(walk, tmp_path, '--ros') / 'ros/puppy'
    package = ElementTree.parse(root / 'package.xml').getroot()
    assert package.findtext('name') == 'puppy' and package.get('format') == '3'
    assert package.findtext('license') == 'TODO: License declaration'  # as ROS's own tools write
    assert 'project(puppy NONE)' in (root / 'CMakeLists.txt').read_text()
    for script in ('launch/walk.launch.py', 'scripts/play_gait.py'):
        compile((root / script).read_text(encoding='utf-8'), script, 'exec')
    assert (root / 'scripts/play_gait.py').stat().st_mode & 0o111
    urdf = ElementTree.parse(root / 'urdf/robot.urdf').getroot()
    joints = {each.get('name') for each in urdf.iter('joint') if each.get('type') == 'revolute'}
    files = {each.get('filename') for each in urdf.iter('mesh')}
    assert all((root / file.removeprefix('package://puppy/')).exists() for file in files)
    gait = json.loads((root / 'config/gait.yaml').read_text())
    assert set(gait['joint_names']) == joints
    with (root.parents[1] / 'gait.csv').open(newline='') as file:
        rows = list(csv.DictReader(file))
    assert len(gait['points']) == len(rows) + 1
    q = np.array([[float(row[f'q:{name}_rad']) for name in gait['joint_names']] for row in rows])
    wanted = (np.roll(q, 1, axis=0) + 4 * q + np.roll(q, -1, axis=0)) / 6
    points = gait['points']
    assert [each['positions'] for each in points[:-1]] == pytest.approx(wanted, abs=1e-12)
    for field in ('positions', 'velocities', 'effort'):
        assert points[0][field] == points[-1][field]
    last = points[-1]['time_from_start']
    assert last['sec'] + 1e-9 * last['nanosec'] == pytest.approx(walk.motion.period)
    # In between positions and velocities belong together.
    times = np.arange(len(points)) * walk.motion.period / len(rows)
    speeds = np.gradient(np.array([each['positions'] for each in points]), times, axis=0)
    planned = np.array([each['velocities'] for each in points])
    assert np.abs(speeds - planned)[1:-1].max() < 0.25 * np.abs(planned).max()
