# SPDX-License-Identifier: Apache-2.0
"""The poses and loads of a run's gait, for what is checked over it."""

from pathlib import Path

import mujoco
import numpy as np

from legwright._errors import InputError
from legwright._motion import gait_table
from legwright.parts._robot import BuiltRobot
from legwright.parts._words import Array

_MOST_POSES = 100
PLAYED, PLANNED = 'playback_result.csv', 'motion.csv'


def results_of(run: Path) -> dict[str, Path]:
    """The result folders of a run: its own, called ''; of a run for several tasks theirs, by name.

    Raises InputError where there is none with a gait.
    """
    if (run / 'result' / PLANNED).is_file():
        return {'': run / 'result'}
    found = {file.parents[1].name: file.parent for file in run.glob(f'tasks/*/result/{PLANNED}')}
    if not found:
        raise InputError(
            f'{run}: has no gait (result/{PLANNED}); give a run whose search has ended, or the '
            'MJCF of a robot'
        )
    return dict(sorted(found.items()))


def _poses_of(robot: BuiltRobot, result: Path, task: str) -> tuple[bool, list[tuple[str, Array]]]:
    """Whether they were played, and at most 100 poses with their times."""
    played = (result / PLAYED).is_file()
    file = result / (PLAYED if played else PLANNED)
    cure = f'`legwright {"validate" if played else "optimize"}` makes it anew'
    columns, prefix = gait_table(file, cure), '' if played else 'q:'
    if 'time_s' not in columns:
        raise InputError(f'{file}: has no column time_s; {cure}', str(file))
    times = columns['time_s']
    qpos = np.tile(robot.model.qpos0, (len(times), 1))
    for joint in range(robot.model.njnt):
        name = robot.model.joint(joint).name
        column = columns.get(f'{prefix}{name}_rad')
        if column is not None:
            qpos[:, robot.model.jnt_qposadr[joint]] = column
        elif robot.model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_HINGE:
            raise InputError(f'{file}: has no column of the joint {name}; {cure}', str(file))
    step = -(-len(times) // _MOST_POSES)
    of = f'{task}, ' if task else ''
    return played, [(f'{of}t = {times[k]:.2f} s', qpos[k]) for k in range(0, len(times), step)]


def gait_poses(robot: BuiltRobot, run: Path) -> tuple[str, list[tuple[str, Array]]]:
    """What the poses are of, and at most 100 of each task: what MuJoCo played where `validate`
    did, else the plan. Of joints alone: the trunk stays where the file draws it."""
    found = [_poses_of(robot, result, task) for task, result in results_of(run).items()]
    gait = 'in the gait' if len(found) == 1 else 'in the gaits'
    how = 'as played' if all(played for played, _ in found) else 'as planned'
    return f'{gait} {how}', [pose for _, poses in found for pose in poses]
