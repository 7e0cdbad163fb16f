# SPDX-License-Identifier: Apache-2.0
"""What links carry over a gait, planned and played, against what is known by hand."""

import math
from types import SimpleNamespace

import mujoco
import numpy as np
import pytest
from legwright import InputError
from legwright._motion import Motion
from legwright.parts._loads import _Player, planned_loads, played_loads
from legwright.parts._robot import read_built

TIP, FOOT, WEIGHT = 0.5, 0.02, 9.81
"""[kg], [m]: at the end of a link of 0.2 m."""


def test_planned_loads_are_the_ground_s_force_in_the_axes_of_each_link(dog):
    robot = read_built(dog)
    model = robot.model
    names = tuple(model.joint(j).name for j in range(1, model.njnt))
    joints = np.zeros((2, len(names)))
    joints[:, names.index('FL_hip')] = 0.5
    root = np.zeros((2, 6))
    root[:, 5] = math.pi / 2  # the trunk looks to the left
    feet = ('FL', 'FR', 'HL', 'HR')
    forces = np.zeros((2, 4, 3))
    forces[:, 0] = [3.0, 0.0, 10.0]
    data = mujoco.MjData(model)
    data.qpos[3:7] = [math.cos(math.pi / 4), 0, 0, math.sin(math.pi / 4)]
    data.qpos[model.joint('FL_hip').qposadr[0]] = 0.5
    mujoco.mj_kinematics(model, data)
    hip = data.body('FL_thigh').xpos
    contact = data.geom('FL').xpos - [0, 0, 0.012]
    axis = data.body('FL_thigh').xmat.reshape(3, 3) @ [0, 1, 0]
    torques = np.zeros((2, len(names)))
    torques[:, names.index('FL_hip')] = -axis @ np.cross(contact - hip, forces[0, 0])
    torques[:, names.index('FL_knee')] = 7.0
    nothing = np.zeros((2, 4, 3))
    motion = Motion(
        np.array([0.0, 0.4]), joints, torques, root, root[:, :3], nothing, forces,
        np.ones((2, 4), bool), names, feet,
    )  # fmt: skip
    found = planned_loads(robot, motion)
    assert found.gait == 'the plan'
    loads = {robot.model.body(body).name: each[0] for body, each in found.links.items()}
    thigh, turn = loads['FL_thigh'], data.body('FL_thigh').xmat.reshape(3, 3)
    arm = np.cross(contact - hip, forces[0, 0])
    for force, moment in zip(thigh.forces, thigh.moments):
        assert np.allclose(turn @ force, [3, 0, 10])
        assert np.allclose(turn @ moment, arm), 'the torque is all of the force'
    assert np.allclose(loads['FR_thigh'].forces, 0)
    both = loads['FL_shank'].moments
    rest = 7.0 + axis @ np.cross(contact - data.body('FL_shank').xpos, forces[0, 0])
    assert len(both) == 2 and both[0, 1] - both[1, 1] == pytest.approx(2 * rest), 'either way'
    assert np.allclose(turn @ found.feet['FL'][0].forces[0], [3, 0, 10]), 'no turn of the knee'


def player(tmp_path, height: float, key: str = 'gait') -> _Player:
    """A heavy trunk on the ground that holds a link level, with a foot at its end."""
    text = f"""
        <mujoco>
          <option timestep="0.001" cone="elliptic"/>
          <worldbody>
            <geom type="plane" size="1 1 1"/>
            <body name="trunk" pos="0 0 {height}">
              <freejoint/>
              <geom type="box" size="0.2 0.2 {height}" mass="50"/>
              <body name="link" pos="0.25 0 0">
                <joint name="knee" axis="0 1 0" stiffness="3e4" damping="300"/>
                <geom name="foot" type="sphere" size="{FOOT}" pos="0.2 0 0" mass="{TIP}"/>
              </body>
            </body>
          </worldbody>
          <keyframe><key name="{key}" qpos="0 0 {height} 1 0 0 0 0"/></keyframe>
        </mujoco>"""
    scene = tmp_path / 'scene.xml'
    scene.write_text(text, encoding='utf-8')
    foot = SimpleNamespace(of='foot', words=SimpleNamespace(kind='foot'))
    robot = SimpleNamespace(links=(SimpleNamespace(name='link'),), modules=(foot,))
    return _Player(robot, scene)


def test_a_link_in_the_air_carries_its_weight(tmp_path):
    (link,), feet = player(tmp_path, 0.1).play(2.0, 'walk')
    assert len(link.times) == 2000 and link.when(0) == 'walk, t = 0.000 s'
    assert np.allclose(link.forces[-1], [0, 0, -TIP * WEIGHT], atol=1e-2)
    assert np.allclose(link.moments[-1], [0, 0.2 * TIP * WEIGHT, 0], atol=1e-2)
    assert not feet['foot'][0].forces.any()


def test_a_link_on_a_foot_carries_what_the_ground_does_to_it_less_its_weight(tmp_path):
    (link,), feet = player(tmp_path, FOOT - 1e-4).play(2.0, '')
    foot = feet['foot'][0]
    assert link.when(-1) == 't = 1.999 s'
    assert 1 < foot.forces[-1, 2] < 60 * WEIGHT
    weight = np.array([0, 0, -TIP * WEIGHT])
    assert np.allclose(link.forces[-1], foot.forces[-1] + weight, atol=1e-2)
    place = np.cross([0.2, 0, 0], weight)
    assert np.allclose(link.moments[-1], foot.moments[-1] + place, atol=1e-2)
    assert foot.moments[-1, 1] == pytest.approx(-0.2 * foot.forces[-1, 2], rel=1e-2)


def test_loads_have_the_peak_of_a_touch_down(tmp_path):
    falling = player(tmp_path, FOOT + 0.01)
    falling._model.geom_size[1, 2] = 0.001  # the trunk does not touch before the foot does
    (_,), feet = falling.play(0.5, '')
    up = feet['foot'][0].forces[:, 2]
    assert not up[:40].any() and up.max() > 1.5 * up[-1] > 0


def test_a_mujoco_without_a_plugin_is_told(tmp_path, monkeypatch):
    (tmp_path / 'result').mkdir()
    for name in ('motion.csv', 'scene.xml'):
        (tmp_path / 'result' / name).write_text('', encoding='utf-8')
    monkeypatch.setattr(mujoco, 'mj_versionString', lambda: '3.0.0')
    with pytest.raises(ImportError, match=r'MuJoCo 3.0.0 is installed.*pip install'):
        played_loads(SimpleNamespace(), tmp_path)


def test_a_scene_of_another_robot_is_refused(tmp_path):
    with pytest.raises(InputError, match=r'scene.xml: no gait of this robot.*optimize'):
        player(tmp_path, 0.1, 'home')
