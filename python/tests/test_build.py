# SPDX-License-Identifier: Apache-2.0
"""build(): what is hardly meant about an assembly is a warning, in the program's words."""

import subprocess
import warnings
from pathlib import Path

import legwright as lw
import pytest

ASSEMBLIES = Path(__file__).resolve().parents[2] / 'examples/assemblies'
PUPPY = (ASSEMBLIES / 'puppy.toml').read_text(encoding='utf-8')


def told_by_program(assembly, folder):
    """Lines of `legwright build`, its warnings and notes first."""
    program = Path(lw.__file__).parent / 'bin/legwright'
    words = [program, 'build', assembly, '-o', folder / 'by_program.xml']
    return subprocess.run(words, capture_output=True, text=True).stdout.splitlines()


def warned_of(assembly, robot):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter('always')
        lw.build(assembly, robot)
    for each in caught:
        assert each.category is lw.LegwrightWarning and each.filename == __file__
    return [str(each.message) for each in caught]


def test_a_unit_that_is_hardly_meant_is_warned_of(tmp_path):
    wrong = tmp_path / 'puppy.toml'
    wrong.write_text(PUPPY.replace('mass = 0.25 ', 'mass = 250 '), encoding='utf-8')
    doubts = warned_of(wrong, tmp_path / 'robot.xml')
    lines = told_by_program(wrong, tmp_path)
    assert doubts == [
        line.removeprefix('warning  ') for line in lines if line.startswith('warning ')
    ]
    assert len(doubts) == 1 and doubts[0].startswith(f'{wrong}:7: trunk.mass: is 250 kg')
    assert doubts[0].endswith('250 g are 0.25 kg')
    assert warned_of(ASSEMBLIES / 'puppy.toml', tmp_path / 'plain.xml') == []


def test_modules_inside_each_other_are_warned_of(tmp_path):
    assembly = ASSEMBLIES / 'hexapod.toml'
    doubts = warned_of(assembly, tmp_path / 'robot.xml')
    notes = [line for line in told_by_program(assembly, tmp_path) if line.startswith('note ')]
    assert doubts == [f'{assembly}: {notes[0].removeprefix("note     ")}']
    assert 'mm inside HL_femur_servo' in doubts[0]


def test_a_warning_that_is_an_error_keeps_it_from_being_written(tmp_path):
    with warnings.catch_warnings():
        warnings.simplefilter('error')
        with pytest.raises(lw.LegwrightWarning):
            lw.build(ASSEMBLIES / 'hexapod.toml', tmp_path / 'robot.xml')
    assert list(tmp_path.iterdir()) == []


def test_what_is_refused_is_told_by_lines_and_after_its_doubts(tmp_path):
    deep = tmp_path / 'deep.toml'
    deep.write_text(PUPPY.replace('step = [-0.18,', 'step = [-0.01,'), encoding='utf-8')
    with pytest.raises(lw.InputError, match='the middle of one in the other') as refused:
        lw.build(deep, tmp_path / 'robot.xml')
    assert refused.value.reasons
    for reason in refused.value.reasons:
        assert reason.file == str(deep) and reason.line > 0
        assert str(reason).startswith(f'{deep}:{reason.line}: ')
    lying = tmp_path / 'lying.toml'
    text = PUPPY.replace('-0.09', '0.09').replace('mass = 0.25 ', 'mass = 250 ')
    for joint in ('{ name = "hip"', '{ name = "knee"'):
        text = text.replace(joint, joint.replace('{', '{ range = [-0.1, 0.1],'))
    lying.write_text(text, encoding='utf-8')
    robot = tmp_path / 'robot.xml'
    words = rf'lying\.toml: its robot is refused and not written; of {robot}.*does not stand'
    with (
        pytest.warns(lw.LegwrightWarning, match='250 g are'),
        pytest.raises(lw.InputError, match=words),
    ):
        lw.build(lying, robot)
    assert not robot.exists()


def test_what_is_no_path_and_no_list_of_folders_is_told(tmp_path):
    robot = tmp_path / 'robot.xml'
    for wrong, words in (('mine', 'a text'), (tmp_path, 'a PosixPath'), (None, 'None')):
        with pytest.raises(TypeError, match=f'library is {words}; expected a list of folders'):
            lw.build(ASSEMBLIES / 'puppy.toml', robot, library=wrong)
    with pytest.raises(lw.InputError, match='^<text>: is the text of an assembly; write it into'):
        lw.build(PUPPY, robot)
    assert not robot.exists()
