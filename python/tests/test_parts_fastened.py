# SPDX-License-Identifier: Apache-2.0
"""What is fastened by nothing is told wherever one looks, and fails nothing."""

import json
import re
import subprocess
from types import SimpleNamespace

import pytest
from legwright import parts
from legwright.parts.__main__ import _summary
from legwright.parts._fastened import is_fastened, loose_places
from legwright.parts._tables import check_lines
from test_parts import PROGRAM


def notes(made: parts.Parts) -> list[parts.Check]:
    return [check for check in made.checks if check.is_note]


def test_a_servo_whose_body_has_no_pattern_is_told_in_all_that_is_written(printed):
    made = printed('puppy')
    (note,) = notes(made)
    assert made.passed and note.passed and (note.name, note.figure) == ('not fastened', 4)
    assert note.unit == 'of 16 places' and 'XL430-W250 at its body (bottom)' in note.where
    assert 'module file of XL430-W250: add screws' in note.remedy and 'drill' in note.remedy
    lines = check_lines(made.checks)
    k = next(k for k, line in enumerate(lines) if line.startswith('NOTE'))
    assert re.match(r'NOTE  not fastened +4 of 16 places', lines[k])
    assert '4 places, FL_knee_servo' in lines[k + 1] and 'add screws' in lines[k + 2]
    summary = _summary(made).splitlines()
    assert summary[-2].startswith('PASS') and summary[-2].endswith('; 4 places not fastened')
    assert '4 places not fastened' in repr(made)
    sheet = (made.folder / 'assembly.md').read_text(encoding='utf-8')
    assert sheet.count('**not fastened**, bottom: not known') == 4
    for text in (sheet, (made.folder / 'bom.md').read_text(encoding='utf-8')):
        assert '**Not fastened: 4 of 16 places where links end at modules.**' in text
    document = json.loads((made.folder / 'checks.json').read_text(encoding='utf-8'))
    assert document['not_fastened'] == 4
    assert [check['name'] for check in document['checks'] if check['is_note']] == ['not fastened']


def test_screws_in_the_module_file_fasten_it(examples, tmp_path):
    text = (examples.parent / 'modules/xl430_w250.toml').read_text(encoding='utf-8')
    screwed = text.replace(
        'normal = [0.0, -1.0, 0.0]\n',
        'normal = [0.0, -1.0, 0.0]\nscrews = "M2"\n'
        'holes = [0.006, -0.02325, 0.0, -0.006, -0.02325, 0.0]\n',
    )
    assert screwed != text
    (tmp_path / 'own').mkdir()
    (tmp_path / 'own/servo.toml').write_text(screwed, encoding='utf-8')
    assembly = examples / 'assemblies/printed_puppy.toml'
    robot = tmp_path / 'robot.xml'
    words = [PROGRAM, 'build', assembly, '-o', robot, '--library', tmp_path / 'own']
    subprocess.run(words, check=True, capture_output=True)
    made = parts.make(robot, tmp_path / 'out')
    assert not notes(made) and made.not_fastened == 0
    (held,) = [check for check in made.checks if check.name == 'fastened']
    assert held.where.startswith('all 16 places')
    assert 'not fastened' not in _summary(made) and 'places not' not in repr(made)
    for name in ('assembly.md', 'bom.md'):
        text = (made.folder / name).read_text(encoding='utf-8')
        assert 'Not fastened:' not in text and '**not fastened**' not in text


@pytest.mark.parametrize('screwed', [True, False])
def test_one_attachment_with_screws_holds_a_module(screwed):
    words = SimpleNamespace(name='MY-1')
    module, servo = SimpleNamespace(words=words, of='knee'), SimpleNamespace(words=words, of='hip')
    places = [SimpleNamespace(name=name) for name in ('left', 'back')]
    sides = [SimpleNamespace(module=module, place=place) for place in places]
    holes = [SimpleNamespace(fixing=sides[0])] if screwed else []
    link = SimpleNamespace(servo=servo)
    solid = SimpleNamespace(link=link, fixings=tuple(sides), holes=holes, pegs=())
    assert is_fastened(solid, module) == screwed
    tray = SimpleNamespace(link=SimpleNamespace(servo=None), fixings=tuple(sides))
    loose = loose_places([SimpleNamespace(solids=(solid, solid)), SimpleNamespace(solids=(tray,))])
    if screwed:
        assert not loose
    else:
        (found,) = loose
        assert (found.side, found.attachments) == ('body', ('left', 'back'))
        assert found.of == ('knee', 'knee')
