# SPDX-License-Identifier: Apache-2.0
import re
import subprocess
from pathlib import Path

import legwright as lw
import pytest

PROGRAM = Path(lw.__file__).parent / 'bin/legwright'


@pytest.fixture
def bare(examples, tmp_path):
    """The quadruped without a word about what may change."""
    text = (examples / 'quadruped/robot.xml').read_text(encoding='utf-8')
    file = tmp_path / 'robot.xml'
    file.write_text(re.sub(r'<custom>.*?</custom>', '', text, flags=re.DOTALL), encoding='utf-8')
    assert len(lw.Robot(file).parameters) == 0
    return file


def test_proposals_are_those_of_init(bare, tmp_path):
    before = bare.read_bytes()
    proposals = lw.propose(bare)
    assert bare.read_bytes() == before
    assert list(proposals.legs) == ['FL', 'FR', 'HL', 'HR']
    assert {len(joints) for joints in proposals.legs.values()} == {2}
    assert proposals.declared == [] and proposals.not_standing == ''
    thigh = proposals['front_thigh_length']
    assert thigh.unit == 'm' and thigh.bounds[0] < thigh.value < thigh.bounds[1]
    assert thigh.sentence.startswith('Length of') and thigh.binding.startswith('stretch ')
    written = proposals.write(tmp_path / 'declared.xml')
    theirs = tmp_path / 'by_init.xml'
    done = subprocess.run([PROGRAM, 'init', bare, '-o', theirs], capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
    assert written.read_bytes() == theirs.read_bytes()
    robot = lw.Robot(written)
    assert set(robot.parameters) == set(proposals)
    assert robot.parameters['front_thigh_length'].bounds == pytest.approx(thigh.bounds)
    assert repr(lw.Robot(bare).parameters) == '<no parameters: the body stays as it is>'
    again = lw.propose(written)
    assert set(again.declared) == set(proposals) and len(again) == 0
    assert repr(again) == f'<no proposals; {len(proposals)} parameters are declared>'


def test_write_puts_them_into_the_robots_own_file(bare):
    assert lw.propose(bare).write() == bare
    assert len(lw.Robot(bare).parameters) == len(lw.propose(bare).declared) > 0


def test_a_file_that_was_changed_meanwhile_is_left_alone(bare):
    proposals = lw.propose(bare)
    bare.write_text(bare.read_text(encoding='utf-8') + '<!-- mine -->', encoding='utf-8')
    with pytest.raises(lw.IoError, match='changed since it was studied'):
        proposals.write()
    assert bare.read_text(encoding='utf-8').endswith('<!-- mine -->')
    again = lw.propose(bare)
    again.write()
    again.write()  # what is there already may be written again
    assert '<!-- mine -->' in bare.read_text(encoding='utf-8')


def test_a_file_that_is_there_is_left_alone(bare, tmp_path):
    other = tmp_path / 'other.xml'
    other.write_text('mine', encoding='utf-8')
    with pytest.raises(lw.IoError, match='exists already'):
        lw.propose(bare).write(other)
    assert other.read_text(encoding='utf-8') == 'mine'


def test_what_is_left_out_has_its_reason(bare):
    text = bare.read_text(encoding='utf-8')
    text = re.sub(r'(<joint name="F._hip")', r'\1 ref="0.1"', text)
    bare.write_text(text, encoding='utf-8')
    left_out = lw.propose(bare).left_out
    assert 'ref' in left_out['front_hip_axis_yaw']


def test_a_task_in_its_place_is_told_as_such(examples):
    with pytest.raises(lw.InputError, match=r'found a task file .* expected the robot'):
        lw.propose(examples / 'puppy/sideways.toml')


HOPPER = """<robot name="hopper">
  <link name="trunk"><inertial><mass value="2"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.025"/></inertial></link>
  <link name="thigh"><inertial><mass value="0.3"/>
    <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.0001"/></inertial></link>
  <joint name="hip" type="revolute"><origin xyz="0 0 -0.02"/><parent link="trunk"/>
    <child link="thigh"/><axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="6" velocity="9"/>
    </joint>
  <link name="shank"><inertial><mass value="0.2"/>
    <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.0001"/></inertial>
    <collision><origin xyz="0 0 -0.13"/><geometry><sphere radius="0.02"/></geometry></collision>
  </link>
  <joint name="knee" type="revolute"><origin xyz="0 0 -0.12"/><parent link="thigh"/>
    <child link="shank"/><axis xyz="0 1 0"/><limit lower="-2" upper="2" effort="4" velocity="9"/>
    </joint>
</robot>"""


def test_a_urdf_becomes_mjcf_elsewhere(tmp_path):
    urdf = tmp_path / 'hopper.urdf'
    urdf.write_text(HOPPER, encoding='utf-8')
    proposals = lw.propose(urdf)
    assert any('2 joints get position servos' in each for each in proposals.mended)
    with pytest.raises(lw.InputError, match=r'is a URDF.* -o ROBOT.xml'):
        proposals.write()
    written = proposals.write(tmp_path / 'hopper.xml')
    assert urdf.read_text(encoding='utf-8') == HOPPER
    assert set(lw.Robot(written).parameters) == set(proposals)
    with pytest.raises(lw.InputError, match='is a URDF, expected MJCF'):
        lw.Robot(urdf)


def test_what_is_changed_besides_is_told(bare, tmp_path):
    assert lw.propose(bare).mended == []
    text = bare.read_text(encoding='utf-8')
    axes = ('1 0 0', '0 1 0', '0 0 1')
    six = ''.join(f'<joint type="slide" axis="{axis}"/><joint axis="{axis}"/>' for axis in axes)
    text, count = re.subn(r'<freejoint[^>]*/>', six, text)
    assert count == 1
    text = re.sub(r'<keyframe>.*?</keyframe>', '', text, flags=re.DOTALL)
    bare.write_text(text, encoding='utf-8')
    (said,) = lw.propose(bare).mended
    assert said.startswith('a free joint in the place of the six')


def test_a_robot_faces_where_it_is_told_to(bare, tmp_path):
    theirs = tmp_path / 'by_init.xml'
    words = (PROGRAM, 'init', bare, '-o', theirs, '--forward', '-x')
    done = subprocess.run(words, capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
    turned = lw.propose(bare, forward='-x')
    assert turned.write(tmp_path / 'turned.xml').read_bytes() == theirs.read_bytes()
    assert list(turned.legs) != list(lw.propose(bare).legs)
    with pytest.raises(lw.InputError, match=r"forward: is 'north'; expected one of \+x, -x"):
        lw.propose(bare, forward='north')
