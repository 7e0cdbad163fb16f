# SPDX-License-Identifier: Apache-2.0
"""Studies over modules: robots are built of assemblies, with servos and limbs that vary."""

import json
import subprocess
import sys
import tomllib
from pathlib import Path

import legwright as lw
import pytest
from legwright import study
from legwright.study._file import read_study
from legwright.study._folder import FolderRobots, StudyFolder
from legwright.study._points import points_of

ASSEMBLIES = Path(__file__).resolve().parents[2] / 'examples/assemblies'
PUPPY = ASSEMBLIES / 'puppy.toml'


def modular(**more):
    """Motions of the puppy at 12 knots, unplayed, of two servos."""
    return {
        'assembly': str(PUPPY),
        'pictures': False,
        'base': {
            'gait': {'name': 'trot', 'knots': 12, 'period': 0.5},
            'travel': {'velocity': [0.1, 0.0]},
        },
        'codesign': {'motion_only': True, 'plan_only': True, 'certificate': False},
        'grid': {'build': {'servo': ['XL430-W250', 'XM430-W350']}},
    } | more


def points(given, folder):
    return points_of(read_study(given), FolderRobots(StudyFolder.make(folder)))


def said_of(given, folder):
    with pytest.raises(lw.InputError) as caught:
        points(given, folder)
    return str(caught.value)


def test_build_writes_the_robot_of_the_program(tmp_path):
    robot = lw.build(PUPPY, tmp_path / 'python.xml')
    program = Path(lw.__file__).parent / 'bin/legwright'
    words = [program, 'build', PUPPY, '-o', tmp_path / 'program.xml']
    subprocess.run(words, check=True, capture_output=True)
    assert (tmp_path / 'python.xml').read_bytes() == (tmp_path / 'program.xml').read_bytes()
    assert 'front_thigh_length' in robot.parameters and 'body_width' in robot.parameters
    with pytest.raises(lw.IoError, match='is there already'):
        lw.build(PUPPY, tmp_path / 'python.xml')
    wrong = tmp_path / 'wrong.toml'
    wrong.write_text(PUPPY.read_text(encoding='utf-8').replace('XL430-W250', 'XL430-W251'))
    said = r'wrong\.toml:3: servo: names .*did you mean "XL430-W250"'
    with pytest.raises(lw.InputError, match=said):
        lw.build(wrong, tmp_path / 'other.xml')
    assert not (tmp_path / 'other.xml').exists()
    with pytest.raises(lw.IoError, match='cannot be written: No such file'):
        lw.build(PUPPY, tmp_path / 'nowhere/robot.xml')
    wrong.write_bytes(b'name = "\xff"\n')
    with pytest.raises(lw.InputError, match='is no UTF-8'):
        lw.build(wrong, tmp_path / 'other.xml')


def test_each_servo_is_a_robot_of_its_own(tmp_path):
    light, strong = points(modular(), tmp_path)
    assert light.robot != strong.robot
    assert light.name == 'build.servo = XL430-W250'
    assert light.settings == {'build.servo': 'XL430-W250'}
    assert Path(light.robot_file).name == 'puppy.toml'
    assert tomllib.loads(light.task)['gait']['name'] == 'trot'
    same = modular(grid={}, points=[{'name': 'only'}], build={'servo': 'XM430-W350'})
    (again,) = points(same, tmp_path / 'again')
    assert again.robot == strong.robot and again.hash == strong.hash
    several = [str(ASSEMBLIES / name) for name in ('puppy.toml', 'quadruped.toml')]
    grid = {'assembly': several, 'build': {'link': {'wall': [0.004]}}}
    listed = modular(grid=grid)
    del listed['assembly']
    two, three = points(listed, tmp_path / 'several')
    assert two.robot != light.robot != three.robot != two.robot


def test_what_is_wrong_is_told_where_it_was_set(tmp_path):
    file = tmp_path / 'study.toml'
    head = f'assembly = "{PUPPY}"\nbase = {{ gait.name = "trot", travel.velocity = [0.1, 0.0] }}\n'
    cases = {
        'grid.build.servo = ["XL430-W251"]': '3: grid.build.servo: names "XL430-W251", which',
        'grid.build.link.wal = [0.003]': '3: grid.build.link.wal: unknown key',
        'grid.build.servo.x = [1]': '3: grid.build.servo.x: sets a key of servo, which is a text',
        'build.torque_share = 2.0\ngrid.build.servo = ["AX-12A"]': '3: build.torque_share: is 2',
        'robot = "robot.xml"\ngrid.gait.knots = [12]': '1: assembly: stands beside a robot',
        'best = "beauty"\ngrid.gait.knots = [12]': "3: best: is 'beauty'; expected one of F, J",
        'grid.build.armature = [2026-01-01]': 'expected numbers, texts, lists and tables',
        'grid.build = [1]': '3: grid.build.0: cannot vary',
        'library = ["gone"]\ngrid.gait.knots = [12]': '3: library: ',
    }
    for number, (text, said) in enumerate(cases.items()):
        file.write_text(head + text + '\n', encoding='utf-8')
        assert said in said_of(file, tmp_path / f'study{number}').replace(f'{file}:', ''), text
    file.write_text('\n' + head.partition('\n')[2] + 'grid.build.servo = ["AX-12A"]\n')
    assert 'grid.build.servo: sets a key of an assembly, and none' in said_of(file, tmp_path / 'n')


def test_modules_that_make_no_robot_are_a_point_that_is_refused(tmp_path):
    # Legs that point up, with joints that turn by a tenth of a radian.
    limb = tomllib.loads(PUPPY.read_text(encoding='utf-8'))['limb'][0]
    limb['foot_offset'] = [0.0, 0.0, 0.09]
    limb['joint'] = [each | {'range': [-0.1, 0.1]} for each in limb['joint']]
    limb['joint'][1]['offset'] = [0.0, 0.0, 0.09]
    listed = [{'name': 'as drawn'}, {'name': 'upwards', 'build': {'limb': [limb]}}]
    given = modular(grid={}, points=listed, best='mass')
    found = study.run(given, tmp_path / 'study', workers=1)
    rows = found.table.to_pylist()
    assert [row['status'] for row in rows] == ['done', 'refused']
    assert rows[0]['joints'] == 8 and 'does not stand' in rows[1]['reason']
    assert found.best is None  # none was played
    assert found.best_line == 'least mass: no design passes that has it'


def test_a_module_file_that_is_wrong_is_told_by_its_own_name(tmp_path):
    own = tmp_path / 'own'
    own.mkdir()
    (own / 'x.toml').write_text('name = "X"\nkind = "foot"\nmasss = 1.0\n', encoding='utf-8')
    said = said_of(modular(library=[str(own)]), tmp_path / 'study')
    assert f'{own}/x.toml:3: masss: unknown key' in said.splitlines()[0]


@pytest.mark.long
def test_the_lightest_that_passes_is_named(tmp_path):
    file = tmp_path / 'study.toml'
    file.write_text(
        f'assembly = "{PUPPY}"\nbest = "mass"\npictures = false\n'
        '[base]\ngait = { name = "trot", period = 0.5 }\ntravel.velocity = [0.1, 0.0]\n'
        '[codesign]\nmotion_only = true\ncertificate = false\n'
        '[grid]\nbuild.servo = ["XM430-W350", "XL430-W250"]\nbuild.armature = [0.004]\n',
        encoding='utf-8',
    )
    words = [sys.executable, '-m', 'legwright.study', file, '-o', tmp_path / 'study', '--json']
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    document = json.loads(done.stdout)
    assert [row['pass'] for row in document['points']] == [True, True]
    assert document['best'] == 1
    words.remove('--json')
    said = subprocess.run(words, capture_output=True, text=True, check=True).stdout
    assert 'least mass that passes: 0.9' in said and 'XL430-W250' in said
    assert 'Least mass that passes: 0.9' in (tmp_path / 'study/study.html').read_text('utf-8')
    other = file.read_text(encoding='utf-8').replace('"mass"', '"J"')
    file.write_text(other, encoding='utf-8')
    again = study.run(file, tmp_path / 'study', workers=1)  # nothing is done anew
    assert again.best is not None and again.best_line.startswith('least J that passes: 0')
    record = again.records[again.points[1].hash]
    del record['measures']['J']  # as of a study that an older version began
    assert again.best.index == 0
