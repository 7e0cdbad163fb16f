# SPDX-License-Identifier: Apache-2.0
import errno
import re

import legwright as lw
import pytest


def test_parameters_are_as_the_file_declares_them(puppy, examples):
    text = (examples / 'puppy/robot.xml').read_text(encoding='utf-8')
    declared = re.findall(r'<numeric name="legwright/(\w+)"', text)
    assert list(puppy.parameters) == declared
    thigh = puppy.parameters['front_thigh_length']
    assert (thigh.value, thigh.bounds, thigh.unit, thigh.kind) == (
        0.06,
        (0.036, 0.096),
        'm',
        'length',
    )
    assert thigh.sentence == 'Length of the front legs from hip to knee.'
    assert thigh.ties == 2 and not thigh.frozen
    assert puppy.feet == ['FL', 'FR', 'HL', 'HR']
    assert puppy.s.tolist() == [each.value for each in puppy.parameters.values()]


def test_freezing_and_bounds_hold_until_reset(puppy):
    width = puppy.parameters['body_width']
    width.freeze()
    assert width.frozen and width.bounds == (width.value, width.value)
    width.reset()
    assert width.bounds == width.declared_bounds
    width.bounds = (width.value - 0.01, width.value + 0.01)
    assert width.bounds == (width.value - 0.01, width.value + 0.01)


@pytest.mark.parametrize('bounds', [(0.0, 0.07), (0.05, 1.0), (0.061, 0.07), (0.07, 0.05)])
def test_bounds_that_the_robot_does_not_allow_are_refused(puppy, bounds):
    thigh = puppy.parameters['front_thigh_length']
    with pytest.raises(lw.InputError, match="bounds within the robot's, 0.036 to 0.096"):
        thigh.bounds = bounds
    assert thigh.bounds == thigh.declared_bounds


def test_an_unknown_parameter_is_told_with_the_nearest(puppy):
    with pytest.raises(KeyError, match="is 'front_thigh_length' meant"):
        puppy.parameters['front_tigh_length']


def test_a_wrong_robot_is_told_by_file_and_line(tmp_path, examples):
    text = (examples / 'puppy/robot.xml').read_text(encoding='utf-8')
    wrong = tmp_path / 'robot.xml'
    lines = text.splitlines()
    at = next(i for i, line in enumerate(lines) if 'name="legwright/front_thigh_length"' in line)
    lines[at] = re.sub(r'data="[^"]*"', 'data="0.06 0.096"', lines[at])
    wrong.write_text('\n'.join(lines), encoding='utf-8')
    with pytest.raises(lw.InputError) as caught:
        lw.Robot(wrong)
    error = caught.value.reasons[0] if caught.value.reasons else caught.value
    assert (error.file, error.line) == (str(wrong), at + 1)
    assert str(error).startswith(f'{wrong}:{at + 1}: ')
    assert isinstance(error, ValueError) and isinstance(error, lw.LegwrightError)


@pytest.mark.parametrize('read', [lw.Robot, lw.propose, lw.Task.load, lw.Design.load])
def test_a_missing_file_is_an_io_error_whatever_it_is(read, tmp_path):
    with pytest.raises(lw.IoError, match=r'^/.*/gone.xml: .*; give ') as caught:
        read(tmp_path / 'gone.xml')
    if 'give the path' in str(caught.value):  # Design.load has a folder
        assert caught.value.errno == errno.ENOENT
        with pytest.raises(lw.IoError, match='Is a directory; give the path'):
            read(tmp_path)


@pytest.mark.parametrize('read', [lw.Robot, lw.propose])
def test_the_text_of_a_robot_is_told_as_such(read, examples):
    text = (examples / 'puppy/robot.xml').read_text(encoding='utf-8')
    with pytest.raises(lw.InputError, match='^<text>: is the text of a robot; .*MjSpec') as caught:
        read('\n' + text)
    assert 'worldbody' not in str(caught.value)


@pytest.mark.parametrize('name', ['value', 'unit', 'name', 'ties', 'declared_bounds', 'bound'])
def test_what_the_file_says_of_a_parameter_cannot_be_set(puppy, name):
    thigh = puppy.parameters['front_thigh_length']
    with pytest.raises(AttributeError, match=f'front_thigh_length: {name} cannot be set'):
        setattr(thigh, name, 0.07)
    assert thigh.value == 0.06


@pytest.mark.parametrize('bounds', ['ab', (0.05, 0.06, 0.07), 0.05, (None, 0.07)])
def test_bounds_are_two_numbers(puppy, bounds):
    thigh = puppy.parameters['front_thigh_length']
    with pytest.raises(lw.InputError, match='^front_thigh_length: bounds are .*two numbers'):
        thigh.bounds = bounds
