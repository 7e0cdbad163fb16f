# SPDX-License-Identifier: Apache-2.0
"""The poses and loads of a run's gait, for what is checked over it."""

import csv
from pathlib import Path

import numpy as np

from legwright._errors import InputError
from legwright.parts._robot import BuiltRobot
from legwright.parts._words import Array

_MOST_POSES = 100
PLAYED, PLANNED = 'playback_result.csv', 'motion.csv'


def _columns(file: Path) -> dict[str, Array]:
    with open(file, encoding='utf-8', newline='') as stream:
        rows = list(csv.reader(stream))
    table = np.array([[float(cell) for cell in row] for row in rows[1:]])
    return {name: table[:, k] for k, name in enumerate(rows[0])}


def gait_poses(robot: BuiltRobot, result: Path) -> tuple[str, list[tuple[str, Array]]]:
    """What the poses are of, and at most 100 of them with their times: what MuJoCo played where
    `validate` did, else the plan. Of joints alone: the trunk stays where the file draws it."""
    played = (result / PLAYED).is_file()
    file = result / (PLAYED if played else PLANNED)
    columns, prefix = _columns(file), '' if played else 'q:'
    times = columns['time_s']
    qpos = np.tile(robot.model.qpos0, (len(times), 1))
    for joint in range(robot.model.njnt):
        name = robot.model.joint(joint).name
        column = columns.get(f'{prefix}{name}_rad')
        if column is not None:
            qpos[:, robot.model.jnt_qposadr[joint]] = column
        elif robot.model.jnt_type[joint] == 3:
            raise InputError(f'{file}: has no column of the joint {name}; optimize anew')
    step = -(-len(times) // _MOST_POSES)
    poses = [(f't = {times[k]:.2f} s', qpos[k]) for k in range(0, len(times), step)]
    return ('in the gait as played' if played else 'in the gait as planned'), poses
