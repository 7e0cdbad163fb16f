# SPDX-License-Identifier: Apache-2.0
"""check(): what is asked of a robot and its tasks before a run."""

import json
import subprocess
import tomllib
from pathlib import Path

import legwright as lw
import pytest
from test_html import Page

ROBOTS = Path(__file__).resolve().parents[2] / 'tests/robots'


def of_program(task):
    """What the program says, and its document."""
    words = [Path(lw.__file__).parent / 'bin/legwright', 'check', task]
    said, document = (
        subprocess.run([*words, *more], check=True, capture_output=True, text=True).stdout
        for more in ([], ['--json'])
    )
    return said, json.loads(document)


def test_it_tells_what_the_program_tells(examples):
    robot, task = examples / 'puppy/robot.xml', examples / 'puppy/sideways.toml'
    said, document = of_program(task)
    found = lw.check(robot, task)
    assert found.record == document
    assert said.startswith(str(found)) and 'walk: period 1 s' in str(found)
    assert found.feet == tuple(found.robot.feet) == ('FL', 'FR', 'HL', 'HR')
    assert found.limbs['HR'] == ('HR_hip', 'HR_knee', 'HR_ankle')
    assert found.mass == document['robot']['mass_kg'] and found.warnings == ()
    assert list(found.parameters.values()) == found.robot.s.tolist()
    assert found.tasks == {'sideways': document} and found.task.name == 'sideways'
    assert set(found.free) == set(found.parameters)
    assert repr(found) == (
        '<Findings puppy, sideways: 4 feet, 20 of 20 parameters may change, no warnings>'
    )


def test_what_robot_and_task_keep_is_not_free(puppy, examples):
    puppy.parameters['body_width'].freeze()
    puppy.parameters['body_length'].bounds = (0.2, 0.25)
    found = lw.check(puppy, lw.Task('walk', (0.0, 0.1)))
    assert found.robot is puppy and len(found.free) == 19 and 'body_width' not in found.free
    assert found.bounds['body_width'] == (found.parameters['body_width'],) * 2
    assert found.bounds['body_length'] == (0.2, 0.25)
    tables = tomllib.loads((examples / 'puppy/sideways.toml').read_text(encoding='utf-8'))
    tables['design'] = {'freeze': ['front_*'], 'bounds': {'body_width': [0.12, 0.15]}}
    found = lw.check(examples / 'puppy/robot.xml', tables)
    assert found.bounds['body_width'] == (0.12, 0.15) and list(found.tasks) == ['walk']
    assert not any(name.startswith('front_') for name in found.free)


def test_several_tasks_are_told_each(examples):
    robot = lw.Robot(examples / 'quadruped/robot.xml')
    found = lw.check(robot, examples / 'quadruped/both.toml')
    assert list(found.tasks) == ['pace', 'sideways'] and found.tasks['pace']['weight'] > 0
    assert found.record == of_program(examples / 'quadruped/both.toml')[1]
    each = (lw.Task('trot', (0.2, 0.0), name=name) for name in ('a', 'b'))
    found = lw.check(robot, each)
    assert list(found.tasks) == ['a', 'b'] and len(found.task) == 2


def test_warnings_are_those_of_a_codesign_and_stand_in_the_findings(recwarn):
    robot = lw.Robot(ROBOTS / 'servo_dog/robot.xml')
    task = lw.Task('trot', (0.1, 0.0))
    found = lw.check(robot, task)
    assert not recwarn.list
    assert found.free == () and 'the body stays' in found.summary
    assert any('only its motion' in each for each in found.warnings)
    assert all(each in repr(found) for each in found.warnings)
    warned = []
    with pytest.raises(KeyboardInterrupt), pytest.MonkeyPatch.context() as patch:

        def stop(doubt, *_, **__):
            warned.append(str(doubt))
            if len(warned) == len(found.warnings):
                raise KeyboardInterrupt

        patch.setattr('warnings.warn', stop)
        lw.codesign(robot, task)
    assert tuple(warned) == found.warnings


def test_a_notebook_shows_warnings_limbs_and_bounds(puppy, sideways):
    puppy.parameters['body_width'].freeze()
    page = Page(lw.check(puppy, sideways)._repr_html_())
    assert page.texts[0] == 'ok' and '19 of 20 parameters may change' in page.texts[1]
    assert 'FL_hip → FL_knee → FL_ankle' in page.texts
    at = page.texts.index('body_width')
    assert page.texts[at : at + 4] == ['body_width', '0.14', 'frozen', 'm']
    page = Page(lw.check(ROBOTS / 'servo_dog/robot.xml', lw.Task('trot', (0.1, 0)))._repr_html_())
    assert page.texts[0] == 'doubtful'
    assert any(text.startswith('the robot declares no design') for text in page.texts)


def test_what_a_codesign_would_refuse_is_raised(puppy, sideways, tmp_path):
    with pytest.raises(lw.InputError, match='travel.velocity: out of reach') as refused:
        lw.check(puppy, lw.Task('trot', (9.0, 0.0), period=0.5))
    assert (refused.value.file, refused.value.line) == ('<task>', 9)
    with pytest.raises(lw.InputError, match="gait 'tripod' is not in the library for 4 feet"):
        lw.check(puppy, {'gait': {'name': 'tripod'}, 'travel': {'velocity': [0.1, 0.0]}})
    with pytest.raises(lw.InputError, match='travel.velocity: is missing'):
        lw.check(puppy, {'gait': {'name': 'trot'}})
    for wrong, error, words in (
        (3, TypeError, 'task is an integer; expected a Task'),
        ([3], TypeError, 'task is an integer; expected a Task'),
        ({'task': 3}, TypeError, 'task is an integer; expected a list of tables'),
        ({'task': [3]}, TypeError, 'task is an array; expected a list of tables'),
        ({3: 4}, TypeError, '3 is no name of a key; expected a text'),
        ('', lw.InputError, 'is empty; expected a path'),
        (tmp_path / 'none.toml', lw.IoError, 'none.toml: No such file'),
        (sideways.text(), lw.InputError, '^<text>: is the text of a task'),
    ):
        with pytest.raises(error, match=words):
            lw.check(puppy, wrong)
    with pytest.raises(TypeError, match='a robot is a file or a mujoco.MjSpec, not int'):
        lw.check(3, sideways)
    with pytest.raises(lw.IoError, match='none.xml: No such file'):
        lw.check(tmp_path / 'none.xml', sideways)
