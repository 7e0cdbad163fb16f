# SPDX-License-Identifier: Apache-2.0
"""Robots whose files were changed by hand, or that fail one check: what `parts` says of each."""

import math
import re
from pathlib import Path

import numpy as np
import pytest
from legwright import InputError, Robot, parts
from legwright.parts._fit import Distances, check_ranges, things_of
from legwright.parts._robot import home_of, read_built


def changed(dog: Path, folder: Path, old: str, new: str) -> Path:
    """The robot with one place of its file changed."""
    text = dog.read_text(encoding='utf-8')
    assert old in text
    robot = folder / 'changed.xml'
    robot.write_text(text.replace(old, new, 1), encoding='utf-8')
    return robot


THIGH = '<body name="FL_thigh"'
HIP = '<joint name="FL_hip" axis="0 1 0"'


@pytest.mark.parametrize(
    'old, new, words',
    [
        (THIGH, f'{THIGH} quat="0.9848 0 0.1736 0"', 'body FL_thigh: is turned against'),
        (HIP, f'{HIP} ref="0.1"', 'body FL_thigh: has a joint with ref'),
        ('trunk trunk 0.25 kg', 'trunk trunk 0 kg', 'text legwright_module/trunk: '),
    ],
)
def test_frames_and_masses_are_not_taken_on_trust(dog, tmp_path, old, new, words):
    with pytest.raises(InputError, match=words):
        parts.make(changed(dog, tmp_path, old, new), tmp_path / 'out')


def test_a_connector_without_mass_is_refused(dog, tmp_path):
    text = dog.read_text(encoding='utf-8')
    arm = r'(<body name="FL_thigh_arm">\s*<inertial [^>]*mass=")[^"]*'
    robot = tmp_path / 'changed.xml'
    robot.write_text(re.sub(arm, r'\g<1>0', text), encoding='utf-8')
    with pytest.raises(InputError, match='legwright_connector/FL_thigh_arm: is of a body without'):
        parts.make(robot, tmp_path / 'out')


def test_an_axis_beside_its_horn_fails(dog, tmp_path):
    robot = changed(dog, tmp_path, HIP, f'{HIP} pos="0 0.02 0.01"')
    checks = parts.make(robot, tmp_path / 'out').checks
    (failed,) = [check for check in checks if not check.passed and 'horn' in check.name]
    assert failed.name == 'middle of FL_hip on the horn'
    assert failed.figure == pytest.approx(10.0, abs=1e-6), 'along the axis does not count'


@pytest.mark.long
def test_walls_between_holes_count_as_edges(dog, tmp_path):
    """16 screws M2 on a circle of 16 mm: 16 sin(pi / 16) - 2.4 = 0.72 mm between two holes."""
    turns = 2 * math.pi * np.arange(16) / 16
    holes = ' '.join(f'{0.008 * math.cos(t):.9f} 0 {0.008 * math.sin(t):.9f}' for t in turns)
    text = dog.read_text(encoding='utf-8')
    new = re.sub(r'(FL_hip \| horn horn M2: 0 0 0 0 1 0) [^|]*', rf'\1 {holes} ', text, count=1)
    robot = tmp_path / 'changed.xml'
    robot.write_text(new, encoding='utf-8')
    checks = parts.make(robot, tmp_path / 'out').checks
    (failed,) = [check for check in checks if not check.passed and 'edge' in check.name]
    assert failed.name == 'edge of holes, FL_hip_servo horn'
    assert failed.figure == pytest.approx(16 * math.sin(math.pi / 16) - 2.4, abs=1e-3)
    assert failed.where == 'between two of them' and 'fewer' in failed.remedy


def test_options_that_leave_nothing_are_refused(dog, tmp_path):
    with pytest.raises(InputError, match='wall is 0; expected 0.1'):
        parts.make(dog, tmp_path / 'out', parts.PartOptions(wall=0.0))
    with pytest.raises(InputError, match='nothing of FL_thigh is left.*smaller --fit'):
        parts.make(dog, tmp_path / 'out', parts.PartOptions(fit=200.0))


def test_what_is_no_path_and_no_options_is_told(dog, tmp_path):
    for call, words in (
        (lambda: parts.make(Robot(dog), tmp_path / 'out'), 'robot is a Robot; expected a path'),
        (lambda: parts.make(dog, 3), 'folder is an integer; expected a path'),
        (lambda: parts.make(dog, tmp_path / 'out', {'fit': 0.2}), 'options is a table; expected'),
    ):
        with pytest.raises(TypeError, match=words):
            call()
    with pytest.raises(InputError, match='folder: is empty; expected a path'):
        parts.make(dog, '')
    assert not (tmp_path / 'out').exists()


def test_what_is_played_a_little_beyond_a_limit_is_no_fault_of_the_range(dog, printed, tmp_path):
    robot = read_built(
        changed(dog, tmp_path, f'{HIP} range="-3.14159 3.14159"', f'{HIP} range="-1.5 1.5"')
    )
    made = printed('puppy')
    distances = Distances(robot, things_of(robot, made.parts))
    pose = home_of(robot)
    pose[robot.model.joint('FL_hip').qposadr[0]] = -1.502
    checks, _ = check_ranges(robot, distances, [home_of(robot), pose], 0.5)
    hip = next(check for check in checks if check.name == 'range of FL_hip')
    assert hip.passed and 'works from -86' in hip.where
    near, _ = check_ranges(robot, distances, [home_of(robot)], 4.9)
    shut = [check for check in near if not check.passed]
    assert shut and all('narrow' not in check.remedy for check in shut if check.figure < 4.9)
