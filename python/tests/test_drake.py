# SPDX-License-Identifier: Apache-2.0
"""The second engine: its plant is the model, its servos are the plugin's, and gaits walk in it."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import legwright as lw
import numpy as np
import pytest
from legwright import _core

mujoco = pytest.importorskip('mujoco')
pytest.importorskip('pydrake', reason='Drake is not installed: pip install "legwright[drake]"')

from legwright.drake.bodies import add_tree  # noqa: E402
from legwright.drake.ground import add_ground, friction_of, shapes_of  # noqa: E402
from legwright.drake.plant import build  # noqa: E402
from legwright.drake.player import Player  # noqa: E402
from legwright.drake.state import StateMap  # noqa: E402
from pydrake.multibody.plant import AddMultibodyPlantSceneGraph, MultibodyPlant  # noqa: E402
from pydrake.systems.analysis import Simulator  # noqa: E402
from pydrake.systems.framework import DiagramBuilder  # noqa: E402


def gait_of(design):
    """The ServoGait of a design at default gains."""
    found = []

    def start(gait):
        found.append(gait)
        raise StopIteration

    with pytest.raises(StopIteration):
        _core.validate_in_engine(design.folder, 'none', '', start, 4, [1.0], '', False)
    return found[0]


def with_scene(design, folder, change):
    """A copy of a design, as of a program that knew no sums, whose scene is changed."""
    folder = design.save(folder)
    record = json.loads((folder / 'run.json').read_bytes())
    del record['scenes']
    (folder / 'run.json').write_text(json.dumps(record))
    scene = folder / 'result/scene.xml'
    scene.write_text(change(scene.read_text()))
    return lw.Design.load(folder)


TWO_HINGES = """<mujoco><compiler angle="radian"/><worldbody>
  <body name="post" pos="1 2 3"><geom size="0.1"/></body>
  <body name="trunk" pos="0.1 0.2 0.5" quat="0.9 0.1 -0.3 0.2"><freejoint/>
    <geom type="box" size="0.1 0.2 0.05" pos="0.02 0 0.01" euler="0.1 0.2 0.3"/>
    <body name="arm" pos="0.1 0.2 0" euler="0.3 -0.2 0.5">
      <joint name="yaw" axis="0 0 1" pos="0 0.02 0" ref="0.3" range="-1 1" armature="0.01"/>
      <joint name="roll" axis="1 0.2 0" pos="0.01 0 0.03" damping="0.1"/>
      <geom type="capsule" size="0.03" fromto="0 0 0 0.2 0 0.05"/>
      <body pos="0 0 -0.1"><geom size="0.04" pos="0.01 0.02 0"/>
        <body name="rod" pos="0 0 -0.2"><joint name="slide" type="slide" axis="0 1 1" ref="0.05"/>
          <geom type="cylinder" size="0.02 0.1"/></body></body></body></body>
</worldbody></mujoco>"""


def random_state(model, random):
    qpos = model.qpos0.copy()
    mujoco.mj_integratePos(model, qpos, random.normal(size=model.nv), 0.5)
    return qpos, random.normal(size=model.nv)


@pytest.mark.parametrize('robot', ['two hinges', 'biped'])
def test_the_plant_has_the_models_masses_frames_and_joints(robot, examples):
    """Energy at random states is that of all masses, inertias, frames, axes and offsets at once."""
    model = (
        mujoco.MjModel.from_xml_string(TWO_HINGES)
        if robot == 'two hinges'
        else mujoco.MjModel.from_xml_path(str(examples / 'biped/robot.xml'))
    )
    model.dof_armature[:] = 0.0  # in the plant that of the servos
    plant = MultibodyPlant(1e-3)
    tree = add_tree(plant, plant.AddModelInstance('robot'), model)
    plant.mutable_gravity_field().set_gravity_vector(model.opt.gravity)
    plant.Finalize()
    states, context = StateMap(model, plant, tree), plant.CreateDefaultContext()
    for j, joint in tree.joints.items():  # the plant's angles count from qpos0
        limits = model.jnt_range[j] if model.jnt_limited[j] else np.array([-np.inf, np.inf])
        limits = limits - model.qpos0[model.jnt_qposadr[j]]
        assert [joint.position_lower_limit(), joint.position_upper_limit()] == limits.tolist()
        assert joint.default_damping() == model.dof_damping[model.jnt_dofadr[j]]
    assert plant.CalcTotalMass(context) == pytest.approx(model.body_mass.sum(), rel=1e-12)
    data, random, levels = mujoco.MjData(model), np.random.default_rng(1), []
    model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
    for _ in range(5):
        data.qpos, data.qvel = random_state(model, random)
        mujoco.mj_forward(model, data)
        q, v = states.to_drake(data.qpos, data.qvel)
        plant.SetPositions(context, q)
        plant.SetVelocities(context, v)
        kinetic = plant.CalcKineticEnergy(context)
        assert kinetic == pytest.approx(data.energy[1], rel=1e-9)
        levels.append(plant.CalcPotentialEnergy(context) - data.energy[0])
        for body in range(1, model.nbody):
            placed = plant.EvalBodyPoseInWorld(context, tree.bodies[body])
            assert placed.translation() == pytest.approx(data.xpos[body], abs=1e-9)
            assert placed.rotation().matrix() == pytest.approx(
                data.xmat[body].reshape(3, 3), abs=1e-9
            )
        back = states.to_mujoco(q, v)
        assert back[1] == pytest.approx(data.qvel, abs=1e-12)
        assert back[0] == pytest.approx(data.qpos, abs=1e-12)
    assert np.ptp(levels) < 1e-9


def test_limits_damping_and_rotors_are_the_models(walk):
    model, gait = walk.model(), gait_of(walk)
    robot = build(model, gait)
    plant, tree = robot.plant, robot.tree
    assert sorted(tree.joints) == sorted(gait.joints)
    for k, j in enumerate(gait.joints):
        joint = tree.joints[j]
        actuator = plant.get_joint_actuator(plant.GetJointActuatorIndices()[k])
        assert joint.position_lower_limit() == pytest.approx(model.jnt_range[j, 0])
        assert actuator.effort_limit() == gait.limit[k] == 3.0
        assert actuator.default_rotor_inertia() == model.dof_armature[model.jnt_dofadr[j]] > 0
        gains = actuator.get_controller_gains()
        assert (gains.p, gains.d) == (gait.kp[k], gait.kd[k]) == (80.0, 0.8)


class FinerGait:
    """A ServoGait played at shorter steps."""

    def __init__(self, gait, timestep):
        self._gait, self.timestep = gait, timestep

    def __getattr__(self, name):
        return getattr(self._gait, name)


def apart_in_the_air(design, timestep):
    """Root mean square of what is between the joint angles of the engines [rad]."""
    model, gait = design.model(), FinerGait(gait_of(design), timestep)
    model.key_qpos[:, 2] += 20.0
    model.opt.timestep = timestep
    drake, data, squares = Player(model, gait), design.data(model), []
    for k in range(round(0.5 / timestep)):
        qpos, _, _, forces = drake.step(k * timestep)
        mujoco.mj_step(model, data)
        squares.append(np.square(qpos[7:] - data.qpos[7:]))
        assert forces == {}
    assert qpos[2] == pytest.approx(data.qpos[2], abs=1e-5)  # both fall freely
    return np.sqrt(np.mean(squares))


def test_in_the_air_the_legs_move_as_in_mujoco(walk):
    """One law of the servos: what is between the engines vanishes with the step, to first order."""
    coarse, fine = apart_in_the_air(walk, 1e-3), apart_in_the_air(walk, 2.5e-4)
    assert coarse < 1e-3 and fine < 0.3 * coarse


def test_a_robot_that_stands_weighs_on_the_ground(walk):
    model, gait = walk.model(), gait_of(walk)
    player, weight = Player(model, gait), 9.81 * model.body_mass.sum()
    forces = [sum(player.step(k * 1e-3)[3].values()) for k in range(1000)]
    assert np.mean(forces, axis=0)[2] == pytest.approx(weight, rel=0.02)


def call(*words, cwd):
    program = Path(sys.executable).parent / 'legwright'
    return subprocess.run([program, *words], cwd=cwd, capture_output=True, text=True, check=False)


def test_the_co_designed_puppy_walks(walk):
    walking = lw.validate(walk, engine='drake', gains=[1.0], cycles=10)
    assert walking, walking
    (measured,) = walking.metrics.values()
    assert 0.96 <= measured['speed_ratio'] <= 1.0 and measured['tilt_max_rad'] < 0.03
    assert all(foot['stances'] == 8 and foot['missed_stances'] == 0 for foot in measured['feet'])
    assert walking.engine == 'drake' and walking.version.startswith('1.')


@pytest.mark.long
def test_the_command_tells_of_a_walk_and_of_a_fall(walk, tmp_path):
    """The given puppy falls in both engines; the exit codes are those of the verb."""
    walk.save(tmp_path / 'run')
    done = call('validate', '--engine', 'drake', '--cycles', '4', '--json', 'run', cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    record = json.loads((tmp_path / 'run/result/validation_drake.json').read_text())
    assert record == json.loads(done.stdout)
    assert record['engine'] == 'drake' and list(record['result']) == ['half', 'default', 'double']
    assert call('report', 'run', cwd=tmp_path).returncode == 0
    words = f'Drake {record["engine_version"]} passes at half, default and double gains'
    assert words in (tmp_path / 'run/report.html').read_text()
    for name in ('scene.xml', 'motion.csv'):
        shutil.copy(tmp_path / 'run/iterations/0000' / name, tmp_path / 'run/result' / name)
    done = call('validate', '--engine', 'drake', 'run', cwd=tmp_path)
    assert done.returncode == 1 and done.stderr == ''
    assert 'FAIL  walk sideways' in done.stdout and 'falls after' in done.stdout
    (tmp_path / 'run/run.json').write_text('{"schema": "legwright/run"}')
    done = call('validate', '--engine', 'drake', 'run', cwd=tmp_path)
    assert done.returncode == 4 and 'internal error' in done.stderr  # 1 would be a verdict


def test_floors_that_are_no_plane_are_refused(walk, tmp_path):
    block = '<geom name="block" type="box" size="1 1 0.1" contype="1" pos="3 0 0"/>'
    stepped = with_scene(
        walk, tmp_path / 'run', lambda scene: scene.replace('<worldbody>', f'<worldbody>{block}')
    )
    with pytest.raises(lw.InputError, match="geom 'block'.*steps and height fields"):
        lw.validate(stepped, engine='drake', gains=[1.0])
    done = call('validate', '--engine', 'drake', 'run', cwd=tmp_path)
    assert done.returncode == 2 and "geom 'block'" in done.stderr
    assert not (stepped.folder / 'result/validation_drake.json').exists()


def test_what_the_plant_has_not_is_refused_with_its_name(walk, examples, tmp_path):
    pistons = lw.codesign(
        lw.Robot(examples / 'piston_puppy/robot.xml'),
        lw.Task.load(examples / 'piston_puppy/forward.toml'),
        max_iterations=0,
        plan_only=True,
        reasons=False,
        certificate=False,
    )
    with pytest.raises(lw.InputError, match="actuator 'FL_piston'.*pulls along a tendon"):
        lw.validate(pistons, engine='drake', gains=[1.0])
    changes = {
        'a spring': 'stiffness="3"',
        'dry friction': 'frictionloss="0.1"',
    }
    for k, (words, attribute) in enumerate(changes.items()):
        changed = with_scene(
            walk,
            tmp_path / str(k),
            lambda scene, it=attribute: scene.replace(
                '<joint name="FL_knee"', f'<joint {it} name="FL_knee"'
            ),
        )
        with pytest.raises(lw.InputError, match=f"joint 'FL_knee' has {words}"):
            lw.validate(changed, engine='drake', gains=[1.0])


def test_shapes_touch_a_plane_where_the_geoms_do():
    model = mujoco.MjModel.from_xml_string(
        '<mujoco><worldbody><geom name="floor" type="plane" size="1 1 1" friction="0.5"/>'
        '<body pos="0 0 1"><freejoint/><geom type="box" size="0.1 0.2 0.3" friction="0.9"/>'
        '<geom type="capsule" size="0.05 0.2" priority="1" friction="0.3"/>'
        '<geom type="ellipsoid" size="0.1 0.2 0.3"/></body></worldbody></mujoco>'
    )
    corners = {tuple(np.round(at.translation(), 9)) for at, _ in shapes_of(model, 1)}
    assert len(corners) == 8 and (0.1, -0.2, 0.3) in corners
    ends = [tuple(at.translation()) for at, _ in shapes_of(model, 2)]
    assert ends == [(0, 0, -0.2), (0, 0, 0.2)]
    assert [friction_of(model, 0, geom) for geom in (1, 2)] == [0.9, 0.3]


STANDING = {  # shape: how high its body's origin is when it stands [m]
    'type="sphere" size="0.05"': 0.05,
    'type="box" size="0.1 0.05 0.02"': 0.02,
    'type="capsule" size="0.03 0.1" quat="1 0 1 0"': 0.03,
    'type="cylinder" size="0.05 0.1" quat="1 0 1 0"': 0.05,
    'type="ellipsoid" size="0.1 0.1 0.04"': 0.04,
    'type="mesh" mesh="brick"': 0.0,
}


@pytest.mark.parametrize('shape', STANDING, ids=lambda shape: shape.split('"')[1])
def test_each_shape_stands_on_the_plane(shape):
    corners = ' '.join(f'{x} {y} {z}' for x in (-0.1, 0.1) for y in (-0.1, 0.1) for z in (0, 0.06))
    corners += ' 0 0 0.03'
    model = mujoco.MjModel.from_xml_string(
        f'<mujoco><asset><mesh name="brick" vertex="{corners}"/></asset><worldbody>'
        '<geom type="plane" size="1 1 1" pos="0 0 0.3"/>'
        f'<body pos="0 0 {0.3 + STANDING[shape]}"><freejoint/><geom {shape}/></body>'
        '</worldbody></mujoco>'
    )
    builder = DiagramBuilder()
    plant, scene_graph = AddMultibodyPlantSceneGraph(builder, 1e-3)
    tree = add_tree(plant, plant.AddModelInstance('robot'), model)
    geoms = add_ground(plant, scene_graph, model, tree)
    plant.Finalize()
    simulator = Simulator(builder.Build())
    context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    states = StateMap(model, plant, tree)
    plant.SetPositions(context, states.to_drake(model.qpos0, np.zeros(model.nv))[0])
    simulator.AdvanceTo(0.5)
    qpos, qvel = states.to_mujoco(plant.GetPositions(context), plant.GetVelocities(context))
    assert set(geoms.values()) == {1}
    assert qpos[2] == pytest.approx(0.3 + STANDING[shape], abs=2e-3)
    assert np.abs(qvel).max() < 0.05
