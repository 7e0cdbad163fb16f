# SPDX-License-Identifier: Apache-2.0
"""`legwright parts`: what is printed of a puppy, and what is refused."""

import io
import json
import os
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path
from xml.etree import ElementTree

import legwright as lw
import mujoco
import numpy as np
import pytest
import trimesh
from legwright import _command, parts
from legwright.parts import __main__ as command
from legwright.parts._feet import peg_solid
from legwright.parts._holes import drilled
from legwright.parts._shapes import hull, joined, outline

PROGRAM = Path(lw.__file__).parent / 'bin/legwright'


def build(assembly: Path, robot: Path) -> Path:
    subprocess.run(
        [PROGRAM, 'build', assembly, '-o', robot], check=True, capture_output=True, text=True
    )
    return robot


@pytest.fixture
def made(printed) -> parts.Parts:
    return printed('puppy')


def test_a_notebook_shows_parts_in_a_line(made):
    said = 'different parts, 9 to print, all checks pass, 4 places not fastened; in'
    assert repr(made) == f'<Parts of printed_puppy: {len(made.parts)} {said} {made.folder}>'


def test_left_and_right_are_parts_of_their_own_and_equal_ones_are_counted(made):
    assert [(part.name, part.count, part.links) for part in made.parts] == [
        ('FL_thigh', 2, ['FL_thigh', 'HL_thigh']),
        ('FL_shank', 2, ['FL_shank', 'HL_shank']),
        ('FR_thigh', 2, ['FR_thigh', 'HR_thigh']),
        ('FR_shank', 2, ['FR_shank', 'HR_shank']),
        ('trunk', 1, ['trunk']),
    ]
    assert made.passed, [check for check in made.checks if not check.passed]


def test_stl_and_3mf_are_closed_solids_of_one_volume_in_millimetres(made):
    archive = zipfile.ZipFile(io.BytesIO((made.folder / 'all.3mf').read_bytes()))
    assert archive.testzip() is None
    model = ElementTree.fromstring(archive.read('3D/3dmodel.model'))
    space = {'c': model.tag[1:].partition('}')[0]}
    assert model.get('unit') == 'millimeter'
    objects = model.findall('.//c:object', space)
    assert [each.get('name') for each in objects] == [part.name for part in made.parts]
    assert len(model.findall('.//c:item', space)) == sum(part.count for part in made.parts)
    for part, each in zip(made.parts, objects):
        stl = trimesh.load(made.folder / f'{part.name}.stl')
        vertices = [[float(v.get(a)) for a in 'xyz'] for v in each.findall('.//c:vertex', space)]
        triangles = each.findall('.//c:triangle', space)
        corners = [[int(t.get(a)) for a in ('v1', 'v2', 'v3')] for t in triangles]
        threemf = trimesh.Trimesh(vertices, corners, process=False)
        for mesh in (stl, threemf):
            assert mesh.is_watertight and mesh.is_winding_consistent
            assert mesh.volume == pytest.approx(part.solid.shape.volume(), rel=1e-6)
        assert np.all(np.ptp(stl.vertices, axis=0) > 5.0), 'millimetres'


def test_a_part_weighs_its_hulls_less_overlap_modules_and_holes(made):
    for part in made.parts[:-1]:
        solid = part.solid
        seats = joined([outline(module, 0.15) for module in solid.link.modules])
        left = joined([hull(each) for each in solid.link.hulls]) - seats
        assert solid.seat_volume == pytest.approx(solid.declared.volume() - left.volume(), abs=1)
        left = left - joined([drilled(hole) for hole in solid.holes])
        left = left + joined([peg_solid(peg) for peg in solid.pegs])
        assert solid.shape.volume() == pytest.approx(left.volume(), rel=1e-3)
        assert solid.seat_volume > 0 and solid.hole_volume > 0
        assert solid.file_mass == pytest.approx(1240e-9 * solid.hull_volume, rel=1e-9)
        assert solid.mass == pytest.approx(1240e-9 * solid.shape.volume(), rel=1e-12)
        assert 0.8 * solid.file_mass < solid.mass < solid.file_mass


def test_the_bill_has_each_module_and_part_with_count_and_mass(made):
    text = (made.folder / 'bom.csv').read_text(encoding='utf-8')
    assert 'servo,XL430-W250,8,57.2,457.6,' in text
    assert 'foot,ball_foot_12,4,8.69,34.76,' in text
    assert re.search(r'^5,printed,FL_thigh,2,\d+\.\d+,', text, re.M)
    assert '| 3 | servo | XL430-W250 | 8 |' in (made.folder / 'bom.md').read_text(encoding='utf-8')


def test_the_same_robot_gives_the_same_bytes_and_takes_the_old_ones_place(made, dog, tmp_path):
    place = tmp_path / 'again'
    shutil.copytree(made.folder, place)
    for file in {*place.iterdir()} - {place / 'checks.json'}:  # which tells that it is ours
        file.write_bytes(b'of before')
    parts.make(dog, place)
    for file in made.folder.iterdir():
        assert (place / file.name).read_bytes() == file.read_bytes(), file.name
    files = {name for name in made.document['files'] if not name.endswith('.png')}
    assert {file.name for file in place.iterdir()} == files, 'the program draws pictures'
    (place / 'mine.txt').write_text('keep')
    with pytest.raises(lw.IoError, match='holds something else than parts'):
        parts.make(dog, place)
    assert (place / 'mine.txt').exists()


def test_a_part_that_does_not_reach_a_module_fails_with_the_remedy(examples, tmp_path):
    robot = build(examples / 'assemblies/hexapod.toml', tmp_path / 'hexapod.xml')
    done = subprocess.run(
        [sys.executable, '-m', 'legwright.parts', robot, '-o', tmp_path / 'out'],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == _command.NOT_ALL, done.stderr
    assert 'FL_femur_link: reaches FL_tibia_servo: 0 attachments' in done.stdout
    assert 'turn its servo by roll' in done.stdout
    document = json.loads((tmp_path / 'out/checks.json').read_text())
    assert document['passed'] is False


@pytest.mark.parametrize(
    'name, count',
    [
        ('quadruped', 13),
        pytest.param('hexapod', 19, marks=pytest.mark.long),
    ],
)
def test_robots_that_are_meant_to_be_printed_pass_at_home(name, count, printed):
    made = printed(name)
    assert made.passed, [check for check in made.checks if not check.passed]
    assert sum(part.count for part in made.parts) == count
    trunk = made.parts[-1].solid
    for module in trunk.link.modules:
        assert (outline(module) ^ trunk.shape).volume() < 1e-6, f'{module.of} stands in the tray'


def test_pads_are_by_default_as_wide_as_the_screws_need(examples, tmp_path):
    """Of the radius that a part asks for whose pads are too small."""
    text = (examples / 'assemblies/printed_puppy.toml').read_text(encoding='utf-8')
    lines = [line for line in text.splitlines() if not line.startswith(('radius =', 'wall ='))]
    assembly = tmp_path / 'plain.toml'
    assembly.write_text('\n'.join(lines) + '\n', encoding='utf-8')
    made = parts.make(build(assembly, tmp_path / 'plain.xml'), tmp_path / 'out')
    assert made.passed, [check for check in made.checks if not check.passed]
    (edge,) = (each for each in made.checks if each.name == 'edge of holes, FL_hip_servo horn')
    assert 1.2 <= edge.figure < 1.3, 'of --wall, and no wider than rounding makes them'


def test_an_axis_that_the_design_turned_away_from_its_servo_fails(dog, tmp_path):
    text = dog.read_text(encoding='utf-8')
    turned = text.replace(
        '<joint name="FL_hip" axis="0 1 0"', '<joint name="FL_hip" axis="0.0175 0.9998 0"'
    )
    assert turned != text
    robot = tmp_path / 'turned.xml'
    robot.write_text(turned, encoding='utf-8')
    made = parts.make(robot, tmp_path / 'out')
    (failed,) = [check for check in made.checks if not check.passed]
    assert failed.name == 'axis of FL_hip on the horn' and failed.figure == pytest.approx(
        np.degrees(np.arctan2(0.0175, 0.9998))
    )
    assert 'freeze = ["*_axis_*"]' in failed.remedy


def test_without_its_libraries_it_says_what_to_install(dog, tmp_path):
    (tmp_path / 'manifold3d').mkdir()
    (tmp_path / 'manifold3d/__init__.py').write_text("raise ImportError('not here')")
    path = os.pathsep.join([str(tmp_path), *sys.path])
    done = subprocess.run(
        [sys.executable, '-m', 'legwright.parts', dog, '-o', tmp_path / 'out'],
        env={**os.environ, 'PYTHONPATH': path},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == _command.IO_ERROR and 'pip install "legwright[parts]"' in done.stderr
    assert 'not here' in done.stderr and not (tmp_path / 'out').exists()


def test_what_is_no_robot_of_modules_is_bad_input(examples, dog, tmp_path, capsys):
    plain = examples / 'puppy/robot.xml'
    assert command.main([str(plain), '-o', str(tmp_path / 'a')]) == _command.BAD_INPUT
    assert 'has no connector' in capsys.readouterr().err
    text = dog.read_text(encoding='utf-8')
    old = tmp_path / 'old.xml'
    old.write_text(re.sub(r'<text name="legwright_module.*', '', text), encoding='utf-8')
    assert command.main([str(old), '-o', str(tmp_path / 'a')]) == _command.BAD_INPUT
    assert 'older Legwright' in capsys.readouterr().err
    rods = tmp_path / 'rods.xml'
    sliding = re.sub(r'(_knee_servo" data="\S+) servo ', r'\1 linear ', text)
    rods.write_text(sliding, encoding='utf-8')
    assert command.main([str(rods), '-o', str(tmp_path / 'a')]) == _command.BAD_INPUT
    told = capsys.readouterr().err
    assert 'has linear actuators at FL_knee, FR_knee, HL_knee, HR_knee: the links' in told
    odd = tmp_path / 'odd.xml'
    odd.write_text(text.replace('0.0572 kg | body FL_hip', '0.0572 g | body FL_hip'))
    assert command.main([str(odd), '-o', str(tmp_path / 'a')]) == _command.BAD_INPUT
    assert 'text legwright_module/FL_hip_servo' in capsys.readouterr().err
    assert command.main([str(dog), '--bed', '200', '-o', str(tmp_path / 'a')]) == _command.BAD_INPUT
    assert command.main([str(dog), '--fit', '-1', '-o', str(tmp_path / 'a')]) == _command.BAD_INPUT
    assert command.main([str(tmp_path / 'gone.xml')]) == _command.IO_ERROR
    (tmp_path / 'empty').mkdir()
    assert command.main([str(tmp_path / 'empty')]) == _command.BAD_INPUT
    assert not (tmp_path / 'a').exists()


def test_names_of_links_lead_nowhere_but_into_the_folder(dog, tmp_path, capsys, monkeypatch):
    text = dog.read_text(encoding='utf-8')
    evil = tmp_path / 'evil.xml'
    for name in ('../FL_thigh', f'{tmp_path}/FL_thigh', 'all'):
        evil.write_text(text.replace('FL_thigh', name), encoding='utf-8')
        assert command.main([str(evil), '-o', str(tmp_path / 'out/parts')]) == _command.BAD_INPUT
        assert 'rename it' in capsys.readouterr().err
    assert not list(tmp_path.glob('**/*.stl'))
    evil.write_text(text.replace('<mujoco model="', '<mujoco model="a &quot;b&quot; '))
    (tmp_path / 'here').mkdir()
    monkeypatch.chdir(tmp_path / 'here')
    assert command.main([str(evil), '-o', '.', '--quiet']) in (_command.OK, 1)
    assert (tmp_path / 'here/checks.json').exists()
    scene = mujoco.MjModel.from_xml_path(str(tmp_path / 'here/exploded.xml'))
    assert scene.ngeom > 8
    assert not list(tmp_path.glob('.here*'))
