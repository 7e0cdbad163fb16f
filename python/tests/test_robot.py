# SPDX-License-Identifier: Apache-2.0
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


def test_a_missing_robot_is_an_input_error(tmp_path):
    with pytest.raises(lw.InputError, match='gone.xml'):
        lw.Robot(tmp_path / 'gone.xml')
