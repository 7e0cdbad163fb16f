# SPDX-License-Identifier: Apache-2.0
"""Links to round joints, held at their mantle, are printed; so is what carries a payload."""

import subprocess

from legwright import parts
from test_parts import PROGRAM

QUADRUPED = """
servo = "AK60-6"
[trunk]
size = [0.36, 0.2, 0.08]
[print]
bed = [0.5, 0.4]
[[part]]
module = "realsense_d435"
position = [0.1, 0.0, 0.06]
[[limb]]
names = ["F", "H"]
hip = [0.14, 0.11, 0.0]
step = [-0.28, 0.0, 0.0]
copies = 2
mirror = "y"
joint = [
  { name = "hip", link = "thigh", axis = [0, 1, 0], range = [-0.8, 1.4] },
  { name = "knee", link = "shank", axis = [0, 1, 0], range = [-2.0, 0.2], offset = [0, 0, -0.2] },
]
foot = "ball_foot_20"
foot_offset = [0.0, 0.0, -0.2]
"""


def test_a_quadruped_of_brushless_joints_has_parts(tmp_path):
    assembly, robot = tmp_path / 'assembly.toml', tmp_path / 'robot.xml'
    assembly.write_text(QUADRUPED, encoding='utf-8')
    told = subprocess.run(
        [PROGRAM, 'build', assembly, '-o', robot], check=True, capture_output=True, text=True
    )
    assert 'no attachment of the next module' not in told.stdout
    made = parts.make(robot, tmp_path / 'out')
    assert made.passed, [check for check in made.checks if not check.passed]
    thigh = next(part for part in made.parts if part.name == 'FL_thigh')
    held = [f.place.name for f in thigh.solid.fixings if f.module.of == 'FL_knee_servo']
    assert held and held[0] in ('left', 'right', 'top', 'bottom')
    names = {check.name for check in made.checks if check.part == 'trunk'}
    assert 'reaches part_1_realsense_d435' in names
    assert made.not_fastened == 12, 'no pattern of these joints is known'
