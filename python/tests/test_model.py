# SPDX-License-Identifier: Apache-2.0
"""The design in MuJoCo's own Python package."""

import importlib
import subprocess
import sys
import types
from pathlib import Path

import legwright as lw
import pytest

CYCLES = 10

mujoco = pytest.importorskip('mujoco')


def run(code, tmp_path):
    """Python in a process of its own, with this one's paths."""
    paths = f'import sys; sys.path[:] = {sys.path!r}\n'
    return subprocess.run(
        [sys.executable, '-c', paths + code],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )


def test_co_design_has_its_plugin_whichever_mujoco_is_installed(tmp_path):
    """It plays in the package's own MuJoCo; the build tree is no place to find the plugin in."""
    done = run(
        'import legwright\nprint(legwright.__file__)\n'
        'print(*{line.split()[-1] for line in open("/proc/self/maps") if "liblegwright" in line})',
        tmp_path,
    )
    assert done.returncode == 0, done.stderr
    package, plugins = done.stdout.splitlines()
    assert str(Path(package).parent / 'bin/mujoco_plugin/liblegwright.so') in plugins.split()


def test_the_model_walks_as_planned(walk):
    model = walk.model()
    data = walk.data(model)
    start = data.qpos[:3].copy()
    steps = round(CYCLES * walk.motion.period / model.opt.timestep)
    for _ in range(steps):
        mujoco.mj_step(model, data)
    moved, planned = data.qpos[:3] - start, CYCLES * walk.motion.travel
    along = moved[:2] @ planned[:2] / (planned[:2] @ planned[:2])
    assert 0.95 <= along <= 1.05
    assert data.qpos[2] == pytest.approx(start[2], abs=0.01)  # it stands


@pytest.mark.parametrize(
    'edit',
    [
        'model.actuator_gear[0, 0] = 2',
        'model.actuator_biasprm[0, 1] *= 1.1',
        'model.actuator_trnid[0] = model.actuator_trnid[1]',
        'model.jnt_type[model.actuator_trnid[0, 0]] = mujoco.mjtJoint.mjJNT_SLIDE',
    ],
)
def test_a_model_edited_after_compiling_does_not_end_the_host(walk, edit, tmp_path):
    scene = str(walk.folder / 'result/scene.xml')
    done = run(
        f'import legwright, mujoco\nmodel = mujoco.MjModel.from_xml_path({scene!r})\n'
        f'{edit}\ndata = [mujoco.MjData(model) for _ in range(3)][-1]\n'
        'mujoco.mj_step(model, data)\n'
        'print(abs(data.actuator_force).max())',
        tmp_path,
    )
    assert done.returncode == 0, done.stderr
    assert float(done.stdout.splitlines()[-1]) == 0.0
    assert done.stderr.count('changed after it was compiled') == 1


@pytest.mark.parametrize(
    'order', ['import mujoco, legwright', 'import legwright, mujoco', 'import legwright']
)
def test_any_order_of_imports_makes_the_plugin_known(walk, order, tmp_path):
    scene = str(walk.folder / 'result/scene.xml')
    done = run(
        f'{order}\nimport mujoco\nmodel = mujoco.MjModel.from_xml_path({scene!r})\n'
        'print(model.nplugin)\n'
        'maps = open("/proc/self/maps").read()\n'
        'print(len({line.split()[-1] for line in maps.splitlines() if "libmujoco.so" in line}))',
        tmp_path,
    )
    assert done.returncode == 0, done.stderr
    plugins, libraries = (int(line) for line in done.stdout.splitlines())
    assert plugins > 0
    releases = {mujoco.mj_versionString(), lw.mujoco_version}
    assert libraries == len(releases), 'two copies of one MuJoCo in a process'


def test_data_of_another_model_is_refused(walk):
    other = mujoco.MjModel.from_xml_string('<mujoco><worldbody/></mujoco>')
    with pytest.raises(ValueError, match="not this design's: it has no keyframe 'gait'"):
        walk.data(other)


def test_a_doubtful_version_is_told(walk, monkeypatch):
    found = mujoco.mj_versionString()
    monkeypatch.setattr(lw._plugin, '_DOUBTFUL', {found: 'errs'})
    with pytest.warns(lw.LegwrightWarning, match=f'MuJoCo {found} errs; pip install') as caught:
        walk.model()
    assert caught[0].filename == __file__
    monkeypatch.undo()
    assert set(lw._plugin._DOUBTFUL) == {'4.0.0'}


def test_another_version_is_told_with_what_to_install(walk, monkeypatch):
    other = types.SimpleNamespace(mj_versionString=lambda: '2.3.7')
    monkeypatch.setitem(sys.modules, 'mujoco', other)
    with pytest.raises(ImportError, match=r'MuJoCo 2\.3\.7 is installed.*legwright\[mujoco\]'):
        walk.model()


def test_no_mujoco_is_told_with_what_to_install(walk, monkeypatch):
    def refuse(name):
        raise ModuleNotFoundError(f'No module named {name!r}')

    monkeypatch.setattr(importlib, 'import_module', refuse)
    with pytest.raises(ImportError, match=rf'legwright\[mujoco\].*MuJoCo {lw.mujoco_version}'):
        walk.model()


def test_others_keep_their_warnings_and_errors(examples, tmp_path):
    """What MuJoCo tells other code of the process is as without Legwright."""
    shake = (
        'import mujoco\n'
        'model = mujoco.MjModel.from_xml_string("""<mujoco><worldbody><body><freejoint/>'
        '<geom size="1"/></body></worldbody></mujoco>""")\n'
        'data = mujoco.MjData(model)\n'
        'data.qvel[:] = 1e20\n'
        'mujoco.mj_step(model, data)\n'
        'try: mujoco.mj_stateSize(model, 1 << 30)\n'
        'except mujoco.FatalError as error: print(error)\n'
    )
    design = (
        'import legwright as lw\n'
        f'robot = lw.Robot({str(examples / "puppy/robot.xml")!r})\n'
        f'task = lw.Task.load({str(examples / "puppy/sideways.toml")!r})\n'
        'lw.codesign(robot, task, max_iterations=1, reasons=False)\n'
    )
    alone, after = run(shake, tmp_path), run(design + shake, tmp_path)
    assert 'unstable' in alone.stdout + alone.stderr
    assert (after.returncode, after.stdout, after.stderr) == (0, alone.stdout, alone.stderr)
