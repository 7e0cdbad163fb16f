# SPDX-License-Identifier: Apache-2.0
"""What a study file says: read strictly, multiplied out, each point addressed by its inputs."""

import shutil
import tomllib
from pathlib import Path

import legwright as lw
import numpy as np
import pytest
from legwright.study._file import read_study
from legwright.study._folder import FolderRobots, StudyFolder
from legwright.study._points import points_of
from tiny_study import PUPPY, tiny

HEAD = f'robot = "{PUPPY}"\n'
BASE = '[base]\ngait = {name = "trot", period = 0.4}\ntravel.velocity = [0.1, 0.0]\n'


def points(study, folder: Path):
    return points_of(read_study(study), FolderRobots(StudyFolder.make(folder)))


def refused(text: str, tmp_path: Path) -> list[str]:
    """What is said of a study file, by line, without the path before it."""
    file = tmp_path / 'study.toml'
    file.write_text(text, encoding='utf-8')
    with pytest.raises(lw.InputError) as caught:
        points(file, tmp_path / 'study')
    lines = str(caught.value).splitlines()
    return [line.removeprefix(f'{file}:') for line in lines]


def test_a_grid_is_multiplied_out_with_the_last_key_fastest(tmp_path):
    grid = {'gait': {'period': [0.4, 0.5]}, 'travel': {'velocity': [[0.1, 0.0], [0.2, 0.0]]}}
    found = points(tiny(grid=grid), tmp_path)
    assert [list(point.settings.values()) for point in found] == [
        [0.4, [0.1, 0.0]],
        [0.4, [0.2, 0.0]],
        [0.5, [0.1, 0.0]],
        [0.5, [0.2, 0.0]],
    ]
    for point in found:
        task = tomllib.loads(point.task)
        assert task['gait']['period'] == point.settings['gait.period']
        assert task['travel']['velocity'] == point.settings['travel.velocity']
        assert task['gait']['knots'] == 12  # of [base]
    assert found[1].name == 'gait.period = 0.4, travel.velocity = [0.2, 0.0]'


def test_each_listed_point_has_the_whole_grid(tmp_path):
    listed = [{'name': 'slow', 'gait': {'period': 0.5}}, {'codesign': {'seed': 7}}]
    found = points(tiny(points=listed), tmp_path)
    assert [point.name for point in found[:2]] == [
        'slow, limits.swing_height = 0.02',
        'slow, limits.swing_height = 0.03',
    ]
    assert [point.settings['limits.swing_height'] for point in found] == [0.02, 0.03] * 2
    assert [tomllib.loads(point.task)['gait']['period'] for point in found] == [0.5] * 2 + [0.4] * 2
    assert [point.codesign['seed'] for point in found] == [1, 1, 7, 7]


def test_robots_base_tasks_and_tasks_of_one_body_vary(tmp_path, examples):
    other = tmp_path / 'robots/long.xml'
    other.parent.mkdir()
    other.write_bytes(PUPPY.read_bytes().replace(b'model="puppy"', b'model="other"'))
    found = points(tiny(grid={'robot': [str(PUPPY), str(other)]}), tmp_path / 'a')
    assert found[0].robot != found[1].robot and found[0].task == found[1].task
    tasks = [str(examples / f'puppy/{name}.toml') for name in ('sideways', 'sideways_trot')]
    found = points({'grid': {'task': tasks}}, tmp_path / 'b')
    assert [tomllib.loads(point.task)['gait']['name'] for point in found] == ['walk', 'trot']
    assert all(Path(point.robot_file).name == 'robot.xml' for point in found)
    joint = {'task': str(examples / 'quadruped/both.toml')}
    found = points(joint | {'grid': {'tasks': {'pace': {'weight': [0.25, 0.75]}}}}, tmp_path / 'c')
    weights = [[each['weight'] for each in tomllib.loads(p.task)['task']] for p in found]
    assert [pair[0] for pair in weights] == [0.25, 0.75] and weights[0][1] == weights[1][1]


def test_without_a_period_it_is_the_first_task_of_the_robot(tmp_path):
    base = {'gait': {'name': 'trot'}, 'travel': {'velocity': [0.1, 0.0]}}
    (point,) = points(tiny(base=base, grid={}, points=[{'name': 'only'}]), tmp_path)
    robot = lw.Robot(PUPPY)
    starter = tomllib.loads(lw.Task('trot', (0.1, 0.0)).text(robot))
    assert tomllib.loads(point.task)['gait'] == starter['gait']


def test_the_hash_is_that_of_the_inputs_alone(tmp_path):
    first = [point.hash for point in points(tiny(), tmp_path / 'a')]
    assert first == [point.hash for point in points(tiny(), tmp_path / 'b')]
    assert len(set(first)) == 2
    elsewhere = tmp_path / 'robots/mine.xml'
    elsewhere.parent.mkdir()
    shutil.copy(PUPPY, elsewhere)
    assert first == [point.hash for point in points(tiny(elsewhere), tmp_path / 'c')]
    told = tiny()['codesign'] | {'seed': 1, 'few_keeps': 95}  # as they are anyway
    assert first == [point.hash for point in points(tiny(codesign=told), tmp_path / 'd')]
    named = points(tiny(name='other', pictures=True), tmp_path / 'g')
    assert first == [point.hash for point in named]
    seeded = points(tiny(codesign=told | {'seed': 2}), tmp_path / 'e')
    judged = points(tiny(validate={'quick': True}), tmp_path / 'f')
    assert not set(first) & {point.hash for point in seeded + judged}


def test_one_byte_of_a_mesh_makes_another_hash(tmp_path):
    mesh, main = tmp_path / 'robot/meshes/hat.obj', tmp_path / 'robot/puppy.xml'
    mesh.parent.mkdir(parents=True)
    mesh.write_text('v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n')
    asset = '<asset><mesh name="hat" file="meshes/hat.obj"/></asset>\n  <worldbody>'
    main.write_text(PUPPY.read_text(encoding='utf-8').replace('<worldbody>', asset, 1))
    study = tiny(main, grid={}, points=[{'name': 'only'}])
    (before,) = points(study, tmp_path / 'a')
    mesh.write_bytes(mesh.read_bytes().replace(b'v 0 0 1', b'v 0 0 2'))
    (after,) = points(study, tmp_path / 'b')
    assert before.hash != after.hash
    assert [name for name in before.robot if before.robot[name] != after.robot[name]] == [
        'meshes/hat.obj'
    ]


def test_a_mapping_may_hold_what_python_has_in_the_place_of_toml(tmp_path):
    plain = {'task': str(PUPPY.parent / 'sideways_trot.toml'), 'pictures': False}
    listed = plain | {'grid': {'gait': {'period': [0.4, 0.5]}}, 'codesign': {'seed': 3}}
    other = {'task': PUPPY.parent / 'sideways_trot.toml', 'pictures': False}
    other |= {'grid': {'gait': {'period': np.array([0.4, 0.5])}}, 'codesign': {'seed': np.int64(3)}}
    wanted = [point.hash for point in points(listed, tmp_path / 'a')]
    assert [point.hash for point in points(other, tmp_path / 'b')] == wanted
    other['grid']['gait']['period'] = (0.4, 0.5)
    assert [point.hash for point in points(other, tmp_path / 'c')] == wanted
    with pytest.raises(lw.InputError, match='is a set; expected a list of values'):
        points(plain | {'grid': {'gait': {'period': {0.4}}}}, tmp_path / 'd')


def test_what_is_wrong_is_told_by_line_with_a_remedy(tmp_path):
    text = (
        HEAD
        + 'pictrues = false\nname = 3\n[codesign]\nseed = 1.5\nreason = true\n'
        + (
            '[grid]\ngait.period = 0.8\nlimits.friction = []\n"gait.knots" = [8]\n'
            'limits.swing_height = [0.02, 0.03, 0.02]\nvalidate.cycles = [1]\n'
            '[[points]]\nname = 1\nvalidate.cycles = 10\n'
        )
    )
    said = '\n'.join(refused(text, tmp_path))
    for part in (
        "2: pictrues: unknown key; did you mean 'pictures'?",
        '3: name: is an integer; expected a text',
        '5: codesign.seed: is a number; expected an integer',
        "6: codesign.reason: unknown key; did you mean 'reasons'?",
        '8: grid.gait.period: is a number; expected a list of values, like [0.8, 1.0]',
        '9: grid.limits.friction: is an empty list',
        '10: grid.gait.knots.0: has a dot within quotes; write the key without quotes',
        '11: grid.limits.swing_height.2: has 0.02 twice',
        '12: grid.validate.cycles.0: is 1; expected 4 to 10000',
        '14: points.0.name: is an integer; expected a text',
        '15: points.0.validate.cycles: stands in [grid], too (line 12)',
    ):
        assert part in said, part


@pytest.mark.parametrize(
    'text, said',
    [
        (HEAD + BASE, 'neither [grid] nor [[points]] is there; add for instance'),
        (HEAD + '[grid]\ngait.period = [0.4]\n', 'names no task; add for instance: task ='),
        (BASE + '[grid]\ngait.period = [0.4]\n', 'names no robot; add for instance: robot ='),
        ('robot = "gone.xml"\n' + BASE + '[grid]\ngait.knots = [8]\n', '1: robot: names the robot'),
        (HEAD + 'task = "gone.toml"\n[grid]\ngait.knots = [8]\n', '2: task: '),
        (HEAD + BASE + '[grid]\ngait.knots = [8, 4]\n', '6: grid.gait.knots: is 4; expected'),
        (HEAD + BASE + '[grid]\ngait.perod = [0.4]\n', '6: grid.gait.perod: unknown key; did you'),
        (HEAD + BASE + '[grid]\ntasks.a.weight = [1]\n', 'expected tasks.NAME.KEY'),
        (HEAD + BASE + '[grid]\ngait.period.x = [1]\n', 'sets a key of period, which is a number'),
        (HEAD + BASE + '[[points]]\npictures = false\n', '6: points.0.pictures: cannot vary'),
        (HEAD + BASE + '[grid\n', 'mend the TOML there'),
        (HEAD.replace('robot', 'task').replace('.xml"', '.toml"') + '[grid]\nx = [1]\n', 'task'),
    ],
)
def test_what_cannot_run_is_refused(text, said, tmp_path):
    assert said in '\n'.join(refused(text, tmp_path))


def test_what_is_wrong_with_file_and_points_is_told_at_once(tmp_path):
    text = (
        HEAD
        + 'nme = 3\n[base]\ngait.name = "trot"\ntravel.velocity = [0.1, 0.0]\n'
        + '[codesign]\nseed = 1.5\n[grid]\ngait.perid = [0.5]\nlimits.friction = [-1.0]\n'
        + 'validate.cycles = [1, 8]\n'
    )
    said = refused(text, tmp_path)
    assert [line.split(': ')[1] for line in said] == [
        'nme',
        'codesign.seed',
        'grid.gait.perid',
        'grid.limits.friction',
        'grid.validate.cycles.0',
    ]
    assert [line.split(':')[0] for line in said] == ['2', '7', '9', '10', '11']


def test_a_gait_that_is_not_there_is_told_by_line_and_key(tmp_path):
    base = '[base]\ntravel.velocity = [0.1, 0.0]\ngait.name = "trott"\n'
    (said,) = refused(HEAD + base + '[grid]\ngait.duty = [0.6]\n', tmp_path)
    assert said.startswith("4: base.gait.name: gait 'trott' is not in the library")
    (said,) = refused(HEAD + '[base]\ngait.name = "trot"\n[grid]\ngait.duty = [0.6]\n', tmp_path)
    assert said.startswith('2: base: travel.velocity: is missing')
    study = tiny(base={'gait': {'name': 'trott'}, 'travel': {'velocity': [0.1, 0.0]}})
    with pytest.raises(lw.InputError, match='^<study>: base.gait.name: .*did you mean'):
        points(study, tmp_path / 'mapping')


def test_too_many_points_are_refused(tmp_path):
    text = (
        HEAD
        + BASE
        + '[grid]\n'
        + ''.join(
            f'weights.{term} = {list(range(50))}\n'
            for term in ('smoothness', 'travel', 'style_foot')
        )
    )
    (said,) = refused(text, tmp_path)
    assert 'makes 125000 points; a study has 100000 at most' in said


def test_a_fault_of_the_base_task_is_told_of_its_file(tmp_path, examples):
    base = tmp_path / 'base.toml'
    text = (examples / 'puppy/sideways_trot.toml').read_text(encoding='utf-8')
    base.write_text(text.replace('period = 0.4 ', 'perod = 0.4 '), encoding='utf-8')
    said = refused(HEAD + 'task = "base.toml"\n[grid]\ngait.knots = [8, 12]\n', tmp_path)
    assert any(line.startswith(f'{base}: gait.perod: unknown key') for line in said)
    assert len(said) == len(set(said))
