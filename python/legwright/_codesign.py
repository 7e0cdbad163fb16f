# SPDX-License-Identifier: Apache-2.0
"""The co-design of a robot for its tasks."""

import os
import tempfile
import warnings
from collections.abc import Callable
from pathlib import Path

from legwright import _core
from legwright._design import Design
from legwright._errors import LegwrightWarning
from legwright._robot import Robot
from legwright._task import Tasks, text_of

Iteration = _core.Iteration


def codesign(
    robot: Robot,
    task: Tasks,
    *,
    on_iteration: Callable[[Iteration], bool | None] | None = None,
    folder: str | os.PathLike[str] | None = None,
    force: bool = False,
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
        on_iteration: called on the calling thread with each accepted iterate; where it returns
            False, the search ends and the best so far is what the run goes on with.
        folder: of the run, written as it goes (`legwright play --live` follows it); default: a
            temporary one that goes with the design.
        force: replace the run that the folder holds.
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
        reasons: what each change of the body buys, which costs about as much as the search.
        certificate: how well the result is an optimum.
        pictures: frame.png of each iteration; needs OpenGL.
        threads: default: all cores; results do not depend on it.

    Raises:
        InputError: for a robot and tasks that do not fit, by file and line.
        IoError: where the folder holds a run or cannot be written.
        MujocoError: where MuJoCo refuses a scene.
        KeyboardInterrupt: on Ctrl-C, once the run has stopped; what was found stands in `folder`.
    """
    options = _core.Options()
    if max_iterations is not None:
        options.max_iterations = max_iterations
    options.motion_only, options.plan_only = motion_only, plan_only
    options.one_start, options.starts, options.seed = one_start, starts, seed
    options.stop_at, options.few, options.few_keeps = stop_at, few, few_keeps
    options.front, options.physics_steps, options.threads = front, physics_steps, threads
    options.no_reasons, options.no_certificate = not reasons, not certificate
    options.no_pictures, options.force = not pictures, force
    text, file = text_of(task, robot)
    temporary = None
    if folder is None:
        temporary = tempfile.TemporaryDirectory(prefix='legwright-')
        folder = Path(temporary.name) / 'run'
    doubts = _core.codesign(robot._model, text, file, Path(folder), options, on_iteration)
    for doubt in doubts:
        warnings.warn(doubt, LegwrightWarning, stacklevel=2)
    return Design(folder, temporary)
