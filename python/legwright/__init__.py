# SPDX-License-Identifier: Apache-2.0
"""Co-design of body and gait of legged robots, in MuJoCo.

    import legwright as lw

    robot = lw.Robot('puppy.xml')
    design = lw.codesign(robot, lw.Task(gait='trot', velocity=(0.4, 0.0)))
    print(design.F, design.verdict)
    design.save('runs/mine')

Importing it makes the plugin legwright.gait known to MuJoCo.
"""

from legwright._assembly import build
from legwright._check import Findings, check
from legwright._codesign import Iteration, codesign
from legwright._core import __version__, mujoco_version
from legwright._design import Design
from legwright._errors import InputError, IoError, LegwrightError, LegwrightWarning, MujocoError
from legwright._judgement import Judgement
from legwright._motion import Motion
from legwright._objective import Objective, PlannedMotion
from legwright._plugin import register as _register
from legwright._propose import Proposal, Proposals, propose
from legwright._robot import Parameter, Robot
from legwright._session import Session
from legwright._session_state import SessionEvent, SessionState
from legwright._task import Task, gaits
from legwright._validate import Validation, validate
from legwright._verdict import FrontPoint, Verdict
from legwright._why import Change

__all__ = [
    'Change',
    'Design',
    'Findings',
    'FrontPoint',
    'InputError',
    'IoError',
    'Iteration',
    'Judgement',
    'LegwrightError',
    'LegwrightWarning',
    'Motion',
    'MujocoError',
    'Objective',
    'Parameter',
    'PlannedMotion',
    'Proposal',
    'Proposals',
    'Robot',
    'Session',
    'SessionEvent',
    'SessionState',
    'Task',
    'Validation',
    'Verdict',
    '__version__',
    'build',
    'check',
    'codesign',
    'gaits',
    'mujoco_version',
    'propose',
    'validate',
]

_register()
