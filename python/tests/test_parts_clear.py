# SPDX-License-Identifier: Apache-2.0
"""Modules that stand inside each other fail, also on one link."""

import json
from types import SimpleNamespace

import numpy as np
import pytest
from legwright import _command
from legwright.parts import __main__ as command
from legwright.parts._clear import _corners, check_modules_clear, depth_of
from legwright.parts._robot import Shape, read_built
from legwright.parts._tables import check_lines
from test_parts import build


def box(x: float, half: float = 0.005) -> np.ndarray:
    return _corners(Shape('box', np.full(3, half), np.array([x, 0, 0]), np.eye(3)))


def test_a_depth_is_the_least_way_out():
    depth, way = depth_of(box(0.0), box(0.008))
    assert depth == pytest.approx(2.0) and way == pytest.approx([-1, 0, 0])
    depth, _ = depth_of(box(0.0), box(0.001, 0.002))
    assert depth == pytest.approx(6.0), 'the inner one comes out on the side that is nearer'
    assert depth_of(box(0.0), box(0.0101))[0] == 0
    ball = _corners(Shape('sphere', np.array([0.01]), np.array([0, 0, 0.012]), np.eye(3)))
    assert depth_of(box(0.0), ball)[0] == pytest.approx(3.0, abs=0.1)


def dog_with(examples, tmp_path, position: str):
    """The printable puppy with its battery elsewhere, where `build` refuses it with [print]."""
    text = (examples / 'assemblies/printed_puppy.toml').read_text(encoding='utf-8')
    text = text.replace('[print]', '#')
    moved = text.replace('"lipo_3s_2200"', f'"lipo_3s_2200"\nposition = {position}')
    assert moved != text
    assembly = tmp_path / 'moved.toml'
    assembly.write_text(moved, encoding='utf-8')
    return build(assembly, tmp_path / 'robot.xml')


def test_a_battery_inside_a_servo_fails_with_both_names_and_the_key(examples, tmp_path, capsys):
    robot = dog_with(examples, tmp_path, '[0.01, 0.021, 0.0]')
    out = tmp_path / 'out'
    assert command.main([str(robot), '-o', str(out), '--json']) == _command.NOT_ALL
    document = json.loads(capsys.readouterr().out)
    failed = [c for c in document['checks'] if c['name'] == 'modules keep clear']
    (check,) = failed
    assert not check['passed'] and check['unit'] == 'mm deep'
    assert check['figure'] == pytest.approx(2.25, abs=0.01)
    assert check['where'].startswith('part_1_lipo_3s_2200 and FL_hip_servo, ')
    assert 'part_1_lipo_3s_2200 to -y (position of its [[part]])' in check['remedy']
    assert 'FL_hip_servo to +y (hip or step of its [[limb]])' in check['remedy']
    assert 'by 2.3 mm or more' in check['remedy']


def test_modules_of_one_link_and_of_two_are_told_by_their_keys(dog):
    robot = read_built(dog)
    (passed,) = check_modules_clear(robot)
    assert passed.passed and passed.figure == 0
    foot = next(m for m in robot.modules if m.words.kind == 'foot')
    knee = next(m for m in robot.modules if m.words.joint == 'FL_knee')
    away = robot.modules[0].shapes[0]

    def at(module, shape):
        return SimpleNamespace(of=module.of, words=module.words, body=module.body, shapes=(shape,))

    on_one = (at(foot, away), at(SimpleNamespace(of='it', words=foot.words, body=foot.body), away))
    (failed,) = check_modules_clear(SimpleNamespace(model=robot.model, modules=on_one, trunk=1))
    assert 'foot_offset of its [[limb]]' in failed.remedy and f'{foot.of} and it, ' in failed.where
    own = SimpleNamespace(of='it', words=knee.words, body=knee.body)
    on_one = (at(knee, away), at(own, away))
    (failed,) = check_modules_clear(SimpleNamespace(model=robot.model, modules=on_one, trunk=1))
    assert 'offset of its joint in its [[limb]]' in failed.remedy
    assert 'mm deep, at most 0.5 (' in check_lines([failed])[1]


@pytest.mark.parametrize('name', ['puppy', 'quadruped', 'hexapod'])
def test_modules_of_printable_examples_keep_clear(built, name):
    assert all(check.passed for check in check_modules_clear(read_built(built(name))))
