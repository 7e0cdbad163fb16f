# SPDX-License-Identifier: Apache-2.0
"""What is there beside the modules once the package is installed."""

import importlib.metadata
import importlib.util
import json
import os
import subprocess
import sys
from pathlib import Path

import legwright as lw
import pytest

try:
    DISTRIBUTION = importlib.metadata.distribution('legwright')
except importlib.metadata.PackageNotFoundError:
    pytest.skip('legwright is not installed here, only on the path', allow_module_level=True)


def run(*words):
    bare = {key: value for key, value in os.environ.items() if key != 'LD_LIBRARY_PATH'}
    return subprocess.run(words, capture_output=True, text=True, check=False, env=bare)


def test_the_command_is_the_program_with_its_own_plugin():
    command = Path(sys.executable).parent / 'legwright'
    assert run(command, '--version').stdout.strip().endswith(lw.__version__)
    doctor = run(command, 'doctor')
    plugin = Path(lw.__file__).parent / 'bin/mujoco_plugin/liblegwright.so'
    assert f'{plugin}, loadable' in doctor.stdout
    assert run(command, 'optimize').returncode == 2  # exit codes are the program's


def test_without_a_viewer_it_is_told_what_to_install_not_what_to_build(walk, tmp_path):
    command = Path(sys.executable).parent / 'legwright'
    told = json.loads(run(command, 'doctor', '--json').stdout)['items']
    (viewer,) = (each for each in told if each['name'] == 'viewer')
    play = run(command, 'play', walk.folder, '--viewer', 'legwright')
    assert play.returncode == 3
    for said in (viewer['fix'], play.stderr):
        assert '[rendering]==' in said and '--viewer python' in said and 'cmake' not in said


def test_doctor_tells_which_extras_are_there():
    command = Path(sys.executable).parent / 'legwright'
    told = json.loads(run(command, 'doctor', '--json').stdout)['items']
    items = {each['name']: each for each in told}
    needed = {
        'study': ('distributed', 'pyarrow'),
        'drake': ('pydrake',),
        'parts': ('manifold3d', 'trimesh', 'mujoco'),
    }
    for extra, libraries in needed.items():
        there = all(importlib.util.find_spec(each) for each in libraries)
        assert items[extra]['found'] is there and not items[extra]['required']
        if there:
            assert f'has legwright with {libraries[0]}' in items[extra]['detail']
        else:
            assert f'"legwright[{extra}]" beside an installed wheel' in items[extra]['fix']


def test_mujoco_finds_the_plugin_by_its_entry_point():
    (entry,) = (
        each
        for each in importlib.metadata.entry_points(group='mujoco.plugins')
        if each.name == 'legwright'
    )
    code = (
        'import importlib.metadata, mujoco\n'
        'model = "<mujoco><extension><plugin plugin=\'legwright.gait\'/></extension></mujoco>"\n'
        'try: mujoco.MjModel.from_xml_string(model); known = True\n'
        'except ValueError: known = False\n'
        'print(known or mujoco.__version__)\n'
        'for each in importlib.metadata.entry_points(group="mujoco.plugins"): each.load()()\n'
        'mujoco.MjModel.from_xml_string(model)\n'
    )
    done = run(sys.executable, '-c', code)
    assert done.returncode == 0, done.stderr
    before = done.stdout.strip()  # MuJoCo 3 knows no entry points
    assert before == 'True' or int(before.split('.')[0]) < 4
    assert entry.value == 'legwright._plugin:register'


def test_version_types_licence_and_the_served_mujoco_are_told():
    assert DISTRIBUTION.version == lw.__version__
    files = {str(file) for file in DISTRIBUTION.files or ()}
    assert {'legwright/py.typed', 'legwright/_core.pyi'} <= files
    assert any(file.endswith('licenses/LICENSE') for file in files)
    extras = {'mujoco': [], 'drake': [], 'study': [], 'parts': []}
    for each in DISTRIBUTION.requires or ():
        for name, packages in extras.items():
            if f'extra == "{name}"' in each.replace("'", '"'):
                packages.append(each.split(';')[0].replace(' ', ''))
    (mujoco,) = extras['mujoco']
    assert f'=={lw.mujoco_version}' in mujoco
    # The second engine builds its plant from MuJoCo's model.
    assert mujoco in extras['drake'] and sum(e.startswith('drake') for e in extras['drake']) == 1
    assert [each.split('>')[0] for each in extras['study']] == ['dask', 'distributed', 'pyarrow']
    assert [each.split('>')[0] for each in extras['parts']] == [mujoco, 'manifold3d', 'trimesh']
    assert {f'legwright/study/page.{kind}' for kind in ('html', 'css', 'js')} <= files


def test_no_library_is_looked_for_outside_but_those_of_the_system():
    """Where auditwheel has been: what every Linux has, and MuJoCo, whose name must stay."""
    package = Path(lw.__file__).parent
    if not (package.parent / 'legwright.libs').exists():
        pytest.skip('a wheel without its libraries')
    for file in (next(package.glob('_core.*.so')), package / 'bin/legwright'):
        needed = run('ldd', file).stdout
        assert 'not found' not in needed
        ours, system = f'=> {package.parent}', ('linux-vdso', '/lib', 'libc.so', 'libm.so')
        system += ('libstdc++', 'libgcc_s', 'libdl', 'libpthread', 'librt', 'libz.')
        outside = [line.split()[0] for line in needed.splitlines() if ours not in line]
        assert [name for name in outside if not name.startswith(system)] == []
