# SPDX-License-Identifier: Apache-2.0
"""lw.validate() in MuJoCo, and the door by which other engines come in: who plays through it what
the plugin plays is measured as the plugin is."""

import json
import os
import signal
import subprocess
import sys
import threading
from pathlib import Path

import legwright as lw
import numpy as np
import pytest
from legwright import _core

mujoco = pytest.importorskip('mujoco')


def program(*words):
    done = subprocess.run(
        [Path(sys.executable).parent / 'legwright', *words],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode in (0, 1), done.stderr
    return done.stdout


@pytest.fixture(scope='module')
def in_mujoco(walk):
    return lw.validate(walk)


def test_mujoco_says_what_the_command_says(walk, in_mujoco, tmp_path):
    saved = walk.save(tmp_path / 'run')
    said = json.loads(program('validate', '--quick', '--json', saved))
    assert in_mujoco.metrics == said['metrics']['result']
    assert in_mujoco.line == said['verdict']['result']['line']
    assert in_mujoco.record['verdict'] == said['verdict']['result']
    assert in_mujoco and in_mujoco.engine == 'mujoco' and in_mujoco.version == lw.mujoco_version
    assert dict(in_mujoco.passes) == {'half': True, 'default': True, 'double': True}


def test_gains_cycles_and_limits_are_those_asked_for(walk, tmp_path):
    limits = tmp_path / 'limits.toml'
    limits.write_text('[tilt]\nhigh = 1e-6\n')
    strict = lw.validate(walk, gains=[3.0], cycles=5, limits=limits)
    assert not strict and dict(strict.passes) == {'3-fold': False}
    assert 'tilts by' in strict.reasons[0] and strict.metrics['3-fold']['cycles'] == 5
    limits.write_text('[survival]\nlow = 0.5\n')
    with pytest.raises(lw.InputError, match='`legwright validate RUN --limits .*` measure them'):
        lw.validate(walk, limits=limits)
    with pytest.raises(lw.IoError, match='No such file.*; give the path of a limits file'):
        lw.validate(walk, limits=tmp_path / 'none.toml')


def test_ctrl_c_ends_a_play_in_its_middle(walk):
    # Jobs in the background of a shell are started with the signal ignored.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    played = threading.Event()

    def interrupt():
        if not played.wait(1.0):
            os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=interrupt)
    thread.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            lw.validate(walk, cycles=100000)  # some hours
    finally:
        played.set()
        thread.join()
        signal.signal(signal.SIGINT, before)


def test_what_cannot_be_asked_is_told(walk):
    with pytest.raises(ValueError, match="'mujoco' or 'drake', found 'bullet'"):
        lw.validate(walk, engine='bullet')
    with pytest.raises(ValueError, match='at least one'):
        lw.validate(walk, gains=[])
    with pytest.raises(ValueError, match='above 0'):
        lw.validate(walk, gains=[-1.0])
    for cycles, words in (
        (3, 'is 3; expected 4 to'),
        (4.5, 'is a number; expected an integer'),
        ('a', 'is a text; expected an integer'),
        (None, 'is None; expected an integer'),
    ):
        with pytest.raises(ValueError, match=f'cycles: {words}'):
            lw.validate(walk, cycles=cycles)
    for gains in (['a'], 'ab', 3, None):
        with pytest.raises(lw.InputError, match='gains: are .*; expected a list of factors'):
            lw.validate(walk, gains=gains)
    with pytest.raises(TypeError, match='limits is an integer; expected a path'):
        lw.validate(walk, limits=3)


@pytest.mark.parametrize('what, words', [(None, 'None'), ('runs/mine', 'a text')])
def test_what_is_no_design_is_told(what, words):
    with pytest.raises(TypeError, match=f'design is {words}; expected a legwright.Design, as code'):
        lw.validate(what)
    with pytest.raises(TypeError, match=r'Design\.load\("runs/mine"\)'):
        lw.validate(what, engine='drake')


def test_a_robot_is_no_design(puppy):
    with pytest.raises(TypeError, match='design is a Robot; expected a legwright.Design'):
        lw.validate(puppy)


class StockMujoco:
    """The exported scene without plugin, its servos commanded as those of other engines are."""

    def __init__(self, model, gait):
        self.model, self.gait = model, gait
        self.data = mujoco.MjData(model)
        mujoco.mj_resetDataKeyframe(model, self.data, model.key('gait').id)
        self.dofs = model.jnt_dofadr[gait.joints]

    def step(self, time):
        model, data, gait = self.model, self.data, self.gait
        target, velocity, torque = gait.command(time)
        data.ctrl[gait.actuators] = gait.kp * target + gait.kd * velocity + torque
        mujoco.mj_step(model, data)
        forces, wrench = {}, np.zeros(6)
        for k, contact in enumerate(data.contact):
            if model.geom_bodyid[contact.geom[0]] != 0:
                continue
            mujoco.mj_contactForce(model, data, k, wrench)
            geom = int(contact.geom[1])
            force = contact.frame.reshape(3, 3).T @ wrench[:3]
            forces[geom] = forces.get(geom, np.zeros(3)) + force
        torques = data.qfrc_actuator[self.dofs]
        return data.qpos.copy(), data.qvel.copy(), torques.copy(), forces


def test_another_player_of_the_same_commands_is_measured_alike(walk, in_mujoco, tmp_path):
    """Control and measures at once: every figure of the plugin's roll-outs, to a rounding that
    contacts let grow."""
    program('export', walk.save(tmp_path / 'run'), '-o', tmp_path / 'out', '--no-picture')
    model = mujoco.MjModel.from_xml_path(str(tmp_path / 'out/walk.xml'))
    players = []

    def start(gait):
        players.append(StockMujoco(model, gait))
        return players[-1].step

    text = _core.validate_in_engine(walk.folder, 'stock', '1', start, 20, [1.0], '', False)
    found, known = (each['default'] for each in (json.loads(text)['result'], in_mujoco.metrics))
    assert set(found) == set(known)
    for key in (
        'speed_ratio',
        'tilt_max_rad',
        'torque_rms_Nm',
        'power_mean_W',
        'tracking_rms_rad',
        'penetration_max_m',
        'lateral_drift_mps',
        'heading_drift_rad',
        'path_deviation',
    ):
        assert found[key] == pytest.approx(known[key], rel=1e-6, abs=1e-9), key
    for mine, its in zip(found['feet'], known['feet'], strict=True):
        assert mine['contacts_s'] == its['contacts_s'] and mine['stances'] == its['stances'] > 0
        assert mine['slip_mean_m'] == pytest.approx(its['slip_mean_m'], rel=1e-6)
    plugin = walk.model()
    data = walk.data(plugin)
    origin = data.qpos[:2].copy()
    for _ in range(round(20 * walk.motion.period / plugin.opt.timestep) + 1):
        mujoco.mj_step(plugin, data)
    way, by_plugin = players[0].data.qpos[:2] - origin, data.qpos[:2] - origin
    assert np.linalg.norm(way - by_plugin) <= 0.005 * np.linalg.norm(by_plugin)


def test_what_a_player_raises_ends_the_roll_out(walk):
    def start(gait):
        raise RuntimeError('no such engine')

    with pytest.raises(RuntimeError, match='no such engine'):
        _core.validate_in_engine(walk.folder, 'stock', '1', start, 4, [1.0], '', False)
    one = np.zeros(1)
    for answer, error, words in (
        ((one, one, one, {}), ValueError, 'numbers in qpos'),
        ((one, one), TypeError, 'expected qpos, qvel, torques'),
    ):
        with pytest.raises(error, match=words):
            _core.validate_in_engine(
                walk.folder, 'stock', '1', lambda _, it=answer: lambda time: it, 4, [1.0], '', False
            )


def test_without_drake_its_extra_is_named(walk, monkeypatch):
    for name in [each for each in sys.modules if each.startswith('legwright.drake')]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, 'pydrake', None)
    for name in [each for each in sys.modules if each.startswith('pydrake.')]:
        monkeypatch.delitem(sys.modules, name)
    with pytest.raises(ImportError, match=r'pip install "legwright\[drake\]"'):
        lw.validate(walk, engine='drake')
