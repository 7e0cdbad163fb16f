# SPDX-License-Identifier: Apache-2.0
"""Slots for cables, where a module of one's own library tells at which sides they leave."""

import subprocess
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from legwright import InputError, parts
from legwright.parts._slots import FAR, WIDE, slots_of
from legwright.parts._words import Place
from test_parts import PROGRAM

NONE = np.zeros((0, 3))


def module(normal: tuple[float, float, float], *cable: str) -> SimpleNamespace:
    place = Place('side', False, np.array([0.01, 0, 0]), np.array(normal), None, NONE)
    return SimpleNamespace(places=(place,), words=SimpleNamespace(cable=cable))


def test_a_slot_is_as_wide_and_as_far_as_the_docs_say():
    (slot,) = slots_of(module((1, 0, 0), 'side'))
    low, high = np.array(slot.bounding_box()).reshape(2, 3)
    assert low == pytest.approx([9, -WIDE / 2, -WIDE / 2])
    assert high == pytest.approx([10 + FAR, WIDE / 2, WIDE / 2])
    assert slots_of(module((1, 0, 0))) == [], 'no cable there'
    (open_above,) = slots_of(module((1, 0, 0), 'side'), 100.0)
    assert open_above.bounding_box()[5] == pytest.approx(100 + WIDE / 2)
    docs = (Path(__file__).resolve().parents[2] / 'docs/parts.md').read_text(encoding='utf-8')
    assert f'{WIDE:.0f} mm square' in docs and f'{FAR:.0f} mm far' in docs


@pytest.fixture(scope='module')
def dog(examples, tmp_path_factory) -> Path:
    """The printable puppy, of servos whose cables leave to the left and below."""
    folder = tmp_path_factory.mktemp('cables')
    text = (examples.parent / 'modules/xl430_w250.toml').read_text(encoding='utf-8')
    text = text.replace('\nmass =', '\ncable = ["left", "bottom"]\nmass =', 1)
    told = text.replace('= ["attachment.screws"]', '= ["attachment.screws", "cable"]')
    assert told != text
    (folder / 'own').mkdir()
    (folder / 'own/servo.toml').write_text(told, encoding='utf-8')
    robot = folder / 'dog.xml'
    assembly = examples / 'assemblies/printed_puppy.toml'
    words = [PROGRAM, 'build', assembly, '-o', robot, '--library', folder / 'own']
    subprocess.run(words, check=True, capture_output=True)
    return robot


def test_parts_and_cradles_leave_the_slots_free(dog, printed, tmp_path):
    made = parts.make(dog, tmp_path / 'out')
    without = printed('puppy')
    for part, whole in zip(made.parts, without.parts, strict=True):
        servos = [m for m in part.solid.link.modules if m.words.kind == 'servo']
        for servo in servos:
            for slot in slots_of(servo, 0.0 if part.solid.link.servo else 100.0):
                assert (slot ^ part.solid.shape).volume() < 1e-6
        lost = whole.solid.shape.volume() - part.solid.shape.volume()
        assert (lost > 100) == bool(servos), part.name
    assert not [c for c in made.checks if c.name in ('in one piece', 'wall') and not c.passed]


def test_a_slot_that_takes_what_holds_a_servo_is_named_as_the_cause(dog, tmp_path):
    """Of the knee's servo, which the thigh holds at its bottom alone."""
    made = parts.make(dog, tmp_path / 'out')
    (failed,) = [c for c in made.checks if c.name == 'reaches FL_knee_servo']
    words = 'at its bottom is cut away by the slot for the cable of FL_knee_servo at its bottom'
    assert not failed.passed and words in failed.where
    assert 'cable in the module file of XL430-W250' in failed.remedy
    assert 'move that joint' not in failed.remedy
    sheet = (tmp_path / 'out/assembly.md').read_text(encoding='utf-8')
    assert f'| nothing: what would hold it {words} |' in sheet


def test_a_cable_at_no_attachment_is_refused(dog, tmp_path):
    text = dog.read_text(encoding='utf-8')
    robot = tmp_path / 'robot.xml'
    robot.write_text(text.replace('| cable left bottom', '| cable nowhere', 1), encoding='utf-8')
    with pytest.raises(InputError, match='legwright_module/'):
        parts.make(robot, tmp_path / 'out')
