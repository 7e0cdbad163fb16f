# SPDX-License-Identifier: Apache-2.0
import tomllib

import legwright as lw
import numpy as np
import pytest


def test_keywords_become_the_text_of_a_task_file():
    task = lw.Task(
        {'name': 'walk', 'knots': 24},
        (0.0, 0.1),
        period=1.0,
        style={'com_height': 0.175, 'foot_targets': {'FL': [[0.13, 0.09], [0.11, 0.09]]}},
        limits={'friction': 0.4, 'limb_pairs': [['FL_foot', 'HL_thigh']]},
        weights={'smoothness': 0.3},
        outer={'objective': 'mechanical_work'},
    )
    assert tomllib.loads(task.text()) == {
        'robot': 'robot.xml',
        'name': 'walk',
        'gait': {'name': 'walk', 'knots': 24, 'period': 1.0},
        'travel': {'velocity': [0.0, 0.1]},
        'style': {'com_height': 0.175, 'foot_targets': {'FL': [[0.13, 0.09], [0.11, 0.09]]}},
        'limits': {'friction': 0.4, 'limb_pairs': [['FL_foot', 'HL_thigh']]},
        'weights': {'smoothness': 0.3},
        'outer': {'objective': 'mechanical_work'},
    }


def test_numpy_numbers_and_odd_names_are_written_as_toml():
    task = lw.Task('walk', np.array([0.0, 0.1]), period=np.float64(0.5), name='a "b" c')
    content = tomllib.loads(task.text())
    assert content['travel']['velocity'] == [0.0, 0.1]
    assert content['gait']['period'] == 0.5
    assert content['name'] == 'a "b" c'


def test_a_plan_may_aim_beside_what_is_wanted():
    task = lw.Task('trot', (0.0, 0.1), period=0.4, aim_speed=1.05, aim_turn_rate=-0.02)
    wanted = {'velocity': [0.0, 0.1], 'aim_speed': 1.05, 'aim_turn_rate': -0.02}
    assert tomllib.loads(task.text())['travel'] == wanted
    with pytest.raises(lw.InputError, match=r'travel\.aim_speed'):
        lw.Task('trot', (0.0, 0.1), period=0.4, aim_speed=3.0)


def test_a_robot_may_face_along_another_axis():
    task = lw.Task('walk', (0.1, 0.0), forward='+y', period=1.0)
    assert tomllib.loads(task.text())['travel'] == {'velocity': [0.1, 0.0], 'forward': '+y'}
    with pytest.raises(lw.InputError, match="'north'; expected the axis"):
        lw.Task('walk', (0.1, 0.0), forward='north', period=1.0)


def test_what_is_wrong_is_told_by_line_and_remedy():
    meant = "limits.fricton.*did you mean 'limits.friction'"
    with pytest.raises(lw.InputError, match=meant) as caught:
        lw.Task('walk', (0.0, 0.1), period=1.0, limits={'fricton': 0.4})
    text = lw.Task('walk', (0.0, 0.1), period=1.0, limits={'friction': 0.4}).text()
    line = 1 + text.splitlines().index('friction = 0.4')
    assert str(caught.value).startswith(f'<task>:{line}: ')


def test_a_task_without_a_period_is_checked_at_once_too():
    with pytest.raises(lw.InputError, match='velocity'):
        lw.Task('walk', (0.0, 99.0))


def test_what_toml_has_no_word_for_is_a_type_error():
    with pytest.raises(TypeError, match='not object'):
        lw.Task('walk', (0.0, 0.1), period=1.0, style={'com_height': object()})
    with pytest.raises(TypeError, match='weights: 3 is no name of a key; expected a text'):
        lw.Task('walk', (0.0, 0.1), weights={3: 1.0})
    with pytest.raises(lw.InputError, match='name: is .*, which is no text in UTF-8'):
        lw.Task('walk', (0.0, 0.1), name='\ud800')
    with pytest.raises(lw.InputError, match='weights: .* is no text in UTF-8; expected the name'):
        lw.Task('walk', (0.0, 0.1), weights={'\ud800': 1.0})


def test_a_wrong_file_is_told_by_file_and_line(tmp_path, examples):
    text = (examples / 'puppy/sideways.toml').read_text(encoding='utf-8')
    lines = text.replace('period = 1.0 ', 'period = -1.0').splitlines()
    line = next(i for i, each in enumerate(lines, 1) if each.startswith('period = -1.0'))
    wrong = tmp_path / 'sideways.toml'
    wrong.write_text('\n'.join(lines), encoding='utf-8')
    with pytest.raises(lw.InputError) as caught:
        lw.Task.load(wrong)
    assert f'{wrong}:{line}: gait.period' in str(caught.value)


def test_what_is_no_table_is_told_by_keyword():
    with pytest.raises(TypeError, match='^gait is None; expected its name'):
        lw.Task(None, (0.0, 0.1))
    with pytest.raises(TypeError, match='^weights is an integer; expected a table'):
        lw.Task('walk', (0.0, 0.1), weights=3)
    with pytest.raises(TypeError, match='^travel.velocity: .*not NoneType'):
        lw.Task('walk', None)


def test_a_table_of_the_design_holds_as_in_a_task_file(puppy):
    task = lw.Task('walk', (0.0, 0.1), period=1.0, design={'freeze': ['body_width']})
    assert tomllib.loads(task.text())['design'] == {'freeze': ['body_width']}
    quick = {'reasons': False, 'certificate': False, 'plan_only': True}
    design = lw.codesign(puppy, task, max_iterations=2, **quick)
    assert design.parameters['body_width'] == puppy.parameters['body_width'].value
    assert design.parameters['body_length'] != puppy.parameters['body_length'].value
    with pytest.raises(lw.InputError, match=r'\[design\] holds for all tasks'):
        lw.codesign(puppy, [task, lw.Task('trot', (0.1, 0.0))])
    with pytest.raises(lw.InputError, match='design.freze'):
        lw.Task('walk', (0.0, 0.1), design={'freze': []})


def test_without_a_period_it_is_the_first_task_of_the_robot(puppy):
    task = lw.Task('trot', (0.1, 0.0))
    with pytest.raises(ValueError, match='needs the robot'):
        task.text()
    with pytest.raises(TypeError, match='expected a legwright.Robot'):
        task.text(3)
    content = tomllib.loads(task.text(puppy))
    starter = tomllib.loads(puppy._model.starter_text('trot'))
    assert content['gait'] == starter['gait']
    assert content['travel'] == {'velocity': [0.1, 0.0]}
    own = lw.Task({'name': 'trot', 'duty': 0.7}, (0.1, 0.0), limits={'swing_height': 0.03})
    content = tomllib.loads(own.text(puppy))
    assert content['gait']['duty'] == 0.7 and content['limits']['swing_height'] == 0.03
    assert content['gait']['period'] == starter['gait']['period']


def test_a_gait_that_the_robot_has_not_is_told_with_the_nearest(puppy):
    with pytest.raises(lw.InputError, match="did you mean 'trot'"):
        lw.Task('trott', (0.1, 0.0)).text(puppy)


def test_bounds_in_two_places_are_refused(puppy, examples, tmp_path):
    text = (examples / 'puppy/sideways.toml').read_text(encoding='utf-8')
    file = tmp_path / 'frozen.toml'
    file.write_text(text + '\n[design]\nfreeze = ["body_width"]\n', encoding='utf-8')
    puppy.parameters['body_length'].freeze()
    with pytest.raises(lw.InputError, match='in one place'):
        lw.codesign(puppy, lw.Task.load(file))


def test_patterns_freeze_what_they_meet(puppy, examples, tmp_path):
    text = (examples / 'puppy/sideways.toml').read_text(encoding='utf-8')
    file = tmp_path / 'frozen.toml'
    file.write_text(text + '\n[design]\nfreeze = ["*_axis_*"]\n', encoding='utf-8')
    quick = {'reasons': False, 'certificate': False, 'plan_only': True}
    design = lw.codesign(puppy, lw.Task.load(file), max_iterations=2, **quick)
    given = dict(zip(puppy.parameters, puppy.s, strict=True))
    moved = [name for name, value in design.parameters.items() if value != given[name]]
    assert moved and not any('_axis_' in name for name in moved)


def test_lists_take_no_tables_that_hold_for_all(puppy):
    efficient = lw.Task('walk', (0.0, 0.1), period=1.0, outer={'objective': 'mechanical_work'})
    with pytest.raises(lw.InputError, match='outer'):
        lw.codesign(puppy, [efficient, lw.Task('trot', (0.1, 0.0))])
    with pytest.raises(lw.InputError, match='empty list'):
        lw.codesign(puppy, [])


@pytest.mark.parametrize('named', [{}, {'name': 'mine'}])
def test_a_pattern_of_its_own_has_the_period_of_the_first_task(named, puppy):
    pattern = {**named, 'touchdown': [0, 0.5, 0.75, 0.25], 'duty': 0.7}
    gait = tomllib.loads(lw.Task(pattern, (0.1, 0.0)).text(puppy))['gait']
    starter = tomllib.loads(puppy._model.starter_text(None))['gait']
    assert gait == {'period': starter['period'], **pattern}
    quick = {'plan_only': True, 'reasons': False, 'certificate': False, 'max_iterations': 0}
    design = lw.codesign(puppy, lw.Task(pattern, (0.1, 0.0)), **quick)
    assert design.motion.period == starter['period']


def test_gaits_are_listed_for_a_robot(puppy):
    known = lw.gaits(puppy)
    assert list(known)[:3] == ['walk', 'amble', 'trot'] and all(known.values())
    assert known == lw.gaits(4) != lw.gaits(6) and lw.gaits(3) == lw.gaits(-1) == {}
    for name in known:
        lw.Task(name, (0.1, 0.0)).text(puppy)
    with pytest.raises(TypeError, match='robot is a text; expected a Robot or a number of feet'):
        lw.gaits('puppy')
