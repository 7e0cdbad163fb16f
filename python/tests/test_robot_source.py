# SPDX-License-Identifier: Apache-2.0
"""Robots from a mujoco.MjSpec and by a name of robot_descriptions.

The package itself fetches repositories; a stand-in of its shape is on the path here.
"""

import gc
import importlib
import struct
import subprocess
import sys
import zlib

import legwright as lw
import pytest

mujoco = pytest.importorskip('mujoco')

DOT = 'v 0 0 0\nv {0} 0 0\nv 0 {0} 0\nv 0 0 {0}\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n'
QUICK = {'reasons': False, 'certificate': False, 'plan_only': True, 'max_iterations': 2}


def png(width, height):
    def chunk(kind, data):
        crc = struct.pack('>I', zlib.crc32(kind + data))
        return struct.pack('>I', len(data)) + kind + data + crc

    rows = b''.join(b'\0' + b'\x80\x40\x20' * width for _ in range(height))
    head = struct.pack('>IIBBBBB', width, height, 8, 2, 0, 0, 0)
    end = chunk(b'IDAT', zlib.compress(rows)) + chunk(b'IEND', b'')
    return b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', head) + end


def with_files(examples):
    """The puppy with two meshes of one file name in two folders, and a texture."""
    text = (examples / 'puppy/robot.xml').read_text(encoding='utf-8')
    assets = (
        '<mesh name="dot" file="sub/dot.obj"/><mesh name="spot" file="dot.obj"/>'
        '<texture name="skin" type="2d" file="skin.png"/><material name="fur" texture="skin"/>'
    )
    geoms = '<geom type="mesh" mesh="dot" material="fur"/><geom type="mesh" mesh="spot"/>'
    eyes = '<body name="eyes" pos="0.095 0 0">'
    assert eyes in text
    text = text.replace('<asset>', '<asset>' + assets, 1).replace(eyes, eyes + geoms)
    return text.replace('<compiler ', '<compiler meshdir="meshes" texturedir="../pictures" ', 1)


@pytest.fixture
def files():
    return {
        'meshes/sub/dot.obj': DOT.format(0.01).encode(),
        'meshes/dot.obj': DOT.format(0.02).encode(),
        '../pictures/skin.png': png(4, 2),
    }


@pytest.mark.parametrize('name', ['puppy', 'hexapod', 'piston_puppy', 'printed_quadruped', 'biped'])
def test_a_spec_is_the_robot_of_its_file(examples, name):
    file = examples / name / 'robot.xml'
    theirs, ours = lw.Robot(file), lw.Robot(mujoco.MjSpec.from_file(str(file)))
    assert ours.name == theirs.name and ours.feet == theirs.feet
    for mine, given in zip(ours.parameters.values(), theirs.parameters.values(), strict=True):
        assert mine.name == given.name and mine.sentence == given.sentence
        assert mine.value == pytest.approx(given.value, rel=1e-9)
        assert mine.bounds == pytest.approx(given.bounds, rel=1e-9)
    assert ours.s == pytest.approx(theirs.s, rel=1e-9)


def test_proposals_are_read_from_the_spec_of_their_file(examples, tmp_path):
    from_file = examples.parent / 'tests/robots/servo_dog/robot.xml'
    declared = lw.propose(from_file).write(tmp_path / 'declared.xml')
    spec = mujoco.MjSpec.from_file(str(declared))
    text = next(each for each in spec.texts if each.name.startswith('legwright/'))
    text.data += " MuJoCo's CDATA."
    assert '<![CDATA[' in spec.to_xml()
    ours, theirs = lw.Robot(spec), lw.Robot(declared)
    assert list(ours.parameters) == list(theirs.parameters)
    sentences = [each.sentence for each in ours.parameters.values()]
    assert sum(each.endswith("MuJoCo's CDATA.") for each in sentences) == 1


def test_a_spec_walks_as_its_file_does(examples, walk, sideways):
    spec = mujoco.MjSpec.from_file(str(examples / 'puppy/robot.xml'))
    before = spec.to_xml()
    design = lw.codesign(lw.Robot(spec), sideways, **{**QUICK, 'max_iterations': 60})
    optimum = lw.codesign(lw.Robot(examples / 'puppy/robot.xml'), sideways, **QUICK)
    assert design.motion_only_F == pytest.approx(optimum.motion_only_F, rel=1e-6)
    assert 0.02 * design.motion_only_F > design.F
    assert spec.to_xml() == before


def test_files_come_from_the_specs_assets(examples, files, sideways):
    spec = mujoco.MjSpec.from_string(with_files(examples))
    spec.assets = files
    robot = lw.Robot(spec)
    folder = robot.file.parent
    assert sorted(each.read_bytes() for each in (folder / 'assets').iterdir()) == sorted(
        files.values()
    )
    model = mujoco.MjModel.from_xml_path(str(robot.file))
    assert model.nmesh == 2 and model.ntex >= 1
    assert model.mesh_pos[0].tolist() != model.mesh_pos[1].tolist()
    spec.assets = {}
    lw.codesign(robot, sideways, motion_only=True, **QUICK)
    del robot
    gc.collect()
    assert not folder.exists()


def test_files_come_from_beside_the_specs_own(examples, files, tmp_path):
    home = tmp_path / 'home'
    for name, data in files.items():
        (home / name).parent.mkdir(parents=True, exist_ok=True)
        (home / name).write_bytes(data)
    (home / 'robot.xml').write_text(with_files(examples), encoding='utf-8')
    robot = lw.Robot(mujoco.MjSpec.from_file(str(home / 'robot.xml')))
    assert len(list((robot.file.parent / 'assets').iterdir())) == 3
    (home / 'meshes/dot.obj').unlink()
    with pytest.raises(lw.InputError) as caught:
        lw.Robot(mujoco.MjSpec.from_file(str(home / 'robot.xml')))
    for part in ('<MjSpec puppy>: file ', "'dot.obj'", "spec.assets['meshes/dot.obj']"):
        assert part in str(caught.value)


def test_errors_name_the_spec(examples):
    spec = mujoco.MjSpec.from_file(str(examples / 'puppy/robot.xml'))
    spec.option.gravity = [0.0, 0.0, -1.6]
    with pytest.raises(lw.InputError) as caught:
        lw.Robot(spec)
    assert caught.value.file == '<MjSpec puppy>'
    assert str(caught.value).startswith('<MjSpec puppy>')
    assert 'gravity' in str(caught.value) and 'legwright-' not in str(caught.value)
    nothing = mujoco.MjSpec.from_string('<mujoco><worldbody/></mujoco>')
    with pytest.raises(lw.InputError, match='^<MjSpec MuJoCo Model>'):
        lw.Robot(nothing)
    with pytest.raises(TypeError, match='a file or a mujoco.MjSpec, not int'):
        lw.Robot(3)


def test_a_spec_that_does_not_compile_is_refused_with_mujocos_reason():
    spec = mujoco.MjSpec.from_string('<mujoco model="thin"><worldbody/></mujoco>')
    spec.worldbody.add_body(name='light').add_freejoint()
    with pytest.raises(
        lw.InputError, match="^<MjSpec thin>: MuJoCo does not compile it: .*'light'"
    ):
        lw.Robot(spec)


@pytest.fixture
def descriptions(examples, tmp_path, monkeypatch):
    """A package robot_descriptions with modules as the real ones are."""
    package = tmp_path / 'robot_descriptions'
    package.mkdir()
    (package / '__init__.py').write_text('')
    (package / 'pup_mj_description.py').write_text(
        'from os import path as _path\n'
        f'REPOSITORY_PATH: str = {str(examples)!r}\n'
        'PACKAGE_PATH: str = _path.join(REPOSITORY_PATH, "puppy")\n'
        'MJCF_PATH: str = _path.join(PACKAGE_PATH, "robot.xml")\n'
    )
    (package / 'pup_description.py').write_text('URDF_PATH: str = "pup.urdf"\n')
    (package / 'cat_description.py').write_text('URDF_PATH: str = "cat.urdf"\n')
    (package / 'far_mj_description.py').write_text(
        'raise OSError("no route to host")\nMJCF_PATH: str = "far.xml"\n'
    )
    monkeypatch.syspath_prepend(tmp_path)
    importlib.invalidate_caches()
    yield
    for name in [each for each in sys.modules if each.split('.')[0] == 'robot_descriptions']:
        del sys.modules[name]


def test_a_name_of_robot_descriptions(examples, descriptions, monkeypatch, tmp_path):
    robot = lw.Robot('pup_mj_description')
    assert robot.name == 'puppy' and robot.file == examples / 'puppy/robot.xml'
    with pytest.raises(lw.InputError, match=r"has no MJCF; 'pup_mj_description' has one"):
        lw.Robot('pup_description')
    with pytest.raises(lw.InputError, match='makes one of a URDF'):
        lw.Robot('cat_description')
    with pytest.raises(lw.InputError, match="is 'pup_mj_description' meant"):
        lw.Robot('pupp_mj_description')
    with pytest.raises(lw.IoError, match='could not fetch it: no route to host'):
        lw.Robot('far_mj_description')
    # A file of that name goes before.
    monkeypatch.chdir(tmp_path)
    (tmp_path / 'pup_mj_description').write_text('<mujoco/>')
    with pytest.raises(lw.InputError, match='^pup_mj_description'):
        lw.Robot('pup_mj_description')


def test_without_the_package_it_is_told_how_to_install_it():
    code = 'import legwright as lw\ntry:\n    lw.Robot("go2_mj_description")\n'
    code += 'except lw.InputError as error:\n    print(error)\n'
    if importlib.util.find_spec('robot_descriptions'):
        pytest.skip('robot_descriptions is installed here')
    done = subprocess.run([sys.executable, '-c', code], capture_output=True, text=True, check=True)
    assert "'go2_mj_description' is no file; " in done.stdout
    assert 'pip install robot_descriptions' in done.stdout
