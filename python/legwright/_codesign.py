# SPDX-License-Identifier: Apache-2.0
"""The co-design of a robot for its tasks."""

import os
import tempfile
import warnings
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from legwright import _core
from legwright._arguments import path_of
from legwright._design import Design
from legwright._errors import InputError, LegwrightWarning
from legwright._objective import Objective, ObjectiveFunction, asked
from legwright._options import CODESIGN, checked, kind_of
from legwright._robot import Robot
from legwright._task import Tasks, text_of

Iteration = _core.Iteration
_NEGATED = ('reasons', 'certificate', 'pictures')
_NO_OPTIONS = ('check_gradient', 'resume')  # of the program


def _options_of(words: Mapping[str, Any]) -> _core.Options:
    """Keywords, checked, as the program's options."""
    options = _core.Options()
    for name, value in words.items():
        if name in _NEGATED:
            setattr(options, f'no_{name}', not value)
        elif name not in _NO_OPTIONS and value is not None:
            setattr(options, name, value)
    return options


def _going_on(on_iteration: Callable[[Iteration], Any]) -> Callable[[Iteration], bool]:
    """Whether the search goes on: unless the answer is False, Python's or numpy's."""

    def ask(iteration: Iteration) -> bool:
        answer = on_iteration(iteration)
        return bool(answer) or not isinstance(answer, (bool, np.bool_))

    return ask


def _warn(doubt: str) -> None:
    warnings.warn(doubt, LegwrightWarning, stacklevel=3)  # where codesign() is called


def codesign(
    robot: Robot,
    task: Tasks,
    *,
    objective: Objective | ObjectiveFunction | None = None,
    check_gradient: bool = True,
    on_iteration: Callable[[Iteration], bool | None] | None = None,
    folder: str | os.PathLike[str] | None = None,
    force: bool = False,
    resume: bool = False,
    max_iterations: int | None = None,
    motion_only: bool = False,
    plan_only: bool = False,
    one_start: bool = False,
    starts: int = 0,
    seed: int = 1,
    stop_at: float | None = None,
    few: bool = False,
    few_keeps: float = 95.0,
    front: int = 0,
    physics_steps: int = 0,
    reasons: bool = True,
    certificate: bool = True,
    pictures: bool = False,
    threads: int = 0,
) -> Design:
    """Changes body and gait together until the robot can do its tasks, as `legwright optimize`.

    Of the designs that the search comes by, the one with the least F that MuJoCo passes (of nearly
    equal ones a stable one) is handed back; where it passes none, the nearest, with `feasible`
    False and `reasons`. Same input, same bits as the program. The interpreter's lock is free
    meanwhile.

    Args:
        robot: what may change is what its parameters say.
        task: one task, or several for one body: tasks, or pairs of a task and its weight.
        objective: an outer objective J of one's own, minimised over the body besides F: a function
            `J(s, motion)` that returns J, dJ_ds and dJ_dm, or an Objective, which says more of it.
            Called on the calling thread, one call at a time. In the place of a task's `outer`.
        check_gradient: compare its gradients with central differences before the search.
        on_iteration: called on the calling thread with each accepted iterate; where it returns
            False, the search ends and the best so far is what the run goes on with.
        folder: of the run, written as it goes (`legwright play --live` follows it); default: a
            temporary one that goes with the design.
        force: replace the run that the folder holds.
        resume: go on with the search of the folder's run, which was killed or interrupted, to the
            same bytes: robot, task and options must be those that it was begun with. Not with an
            objective of one's own.
        max_iterations: design iterations at most; default 60.
        motion_only: keep the given body, optimize its motion.
        plan_only: hand back the optimum of F, whatever MuJoCo says of it.
        one_start: several tasks: start from the given body only.
        starts: further starts from perturbed bodies, by `seed`.
        stop_at: end the search once F is as low as this.
        few: the body with the fewest changes that keeps `few_keeps` percent of the fall of F.
        front: two tasks: so many points of their trade-off besides the ends and the weights asked
            for, as `design.front`.
        physics_steps: then so many steps on the gait from roll-outs in MuJoCo.
        reasons: what each change of the body buys, which takes up to half of the time.
        certificate: how well the result is an optimum.
        pictures: frame.png of each iteration; needs OpenGL.
        threads: default: all cores; results do not depend on it.

    Raises:
        InputError: for a robot and tasks that do not fit, by file and line; for options outside
            their range, by keyword; for an objective that is not finite, has the wrong shape or a
            wrong gradient. What it raises is raised.
        TypeError: for a robot, task, folder or on_iteration that is something else.
        IoError: where the folder holds a run or cannot be written.
        MujocoError: where MuJoCo refuses a scene.
        KeyboardInterrupt: on Ctrl-C, once the run has stopped; what was found stands in `folder`.
    """
    given = locals()  # before there are others than the keywords
    words = checked(CODESIGN, {name: given[name] for name in CODESIGN})
    resume = words['resume']
    if on_iteration is not None and not callable(on_iteration):
        raise TypeError(
            f'on_iteration is {kind_of(on_iteration)}; expected a function of an Iteration'
        )
    if resume and (folder is None or objective is not None):
        fault = (
            'goes on with the search in a folder, without an objective of your own; give the '
            'folder of the run that was interrupted'
        )
        raise InputError(f'resume: {fault}', '', 0, 'resume', fault)
    text, file = text_of(task, robot)
    temporary = None
    if folder is None:
        temporary = tempfile.TemporaryDirectory(prefix='legwright-')
        folder = Path(temporary.name) / 'run'
    run = path_of('folder', folder)
    tells = None if on_iteration is None else _going_on(on_iteration)
    asks = None if objective is None else asked(objective, words['check_gradient'])
    _core.codesign(robot._model, text, file, run, _options_of(words), tells, asks, resume, _warn)
    return Design(run, temporary)
