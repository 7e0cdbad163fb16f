# SPDX-License-Identifier: Apache-2.0
"""What a robot and its tasks are, told before anything is solved."""

import json
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from legwright import _core
from legwright._html import findings_html
from legwright._robot import Robot
from legwright._task import Tasks, task_of, text_of

if TYPE_CHECKING:
    import mujoco


@dataclass(frozen=True, repr=False, eq=False)
class Findings:
    """What check() finds of a robot and its tasks, which codesign() takes as they are.

    What codesign() would refuse has been raised, what it would warn of stands in `warnings`.
    print() shows all that `legwright check` tells.
    """

    robot: Robot
    """As it was given, or read."""
    task: Tasks
    """Likewise."""
    warnings: tuple[str, ...]
    """What looks doubtful, but is allowed; of several tasks with their names. Else empty."""
    mass: float
    """Of the robot, without payload [kg]."""
    limbs: Mapping[str, tuple[str, ...]]
    """Joints of each leg from the trunk on, by the foot's name, in the order of robot.feet."""
    parameters: Mapping[str, float]
    """The given body: value of each design parameter by name [m, rad]."""
    bounds: Mapping[str, tuple[float, float]]
    """How far each may go, as robot and task have it; a frozen one has equal ones."""
    tasks: Mapping[str, Mapping[str, Any]]
    """By name of the task what it asks for: "gait", "travel", "weights", and its "warnings"."""
    record: Mapping[str, Any]
    """The document of `legwright check --json`."""
    text: str
    """The words of `legwright check`: limbs, parameters, footfalls, travel, servos."""

    @property
    def feet(self) -> tuple[str, ...]:
        """Names of the feet, in the order of the arrays of a motion."""
        return tuple(self.limbs)

    @property
    def free(self) -> tuple[str, ...]:
        """Parameters that codesign() may change; where there are none it finds the motion alone."""
        return tuple(name for name, (lower, upper) in self.bounds.items() if lower < upper)

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        doubts = ''.join(f'\n  {each}' for each in self.warnings)
        return f'<Findings {self.summary}{":" if doubts else ""}{doubts}>'

    @property
    def summary(self) -> str:
        """In a line: robot and tasks, what may change, how many warnings there are."""
        free, number = len(self.free), len(self.warnings)
        body = f'{free} of {len(self.parameters)} parameters may change'
        doubts = f'{number or "no"} warning{"s" * (number != 1)}'
        what = f'{self.robot.name}, {", ".join(self.tasks)}'
        return f'{what}: {len(self.feet)} feet, {body if free else "the body stays"}, {doubts}'

    def _repr_html_(self) -> str:
        """For notebooks: warnings, limbs, and the parameters that may change."""
        return findings_html(self)


def check(
    robot: 'Robot | str | os.PathLike[str] | mujoco.MjSpec',
    task: 'Tasks | str | os.PathLike[str] | Mapping[str, Any]',
) -> Findings:
    """Reads a robot and its tasks and tells what they are, as `legwright check`; nothing is solved.

    Args:
        robot: a Robot, with what is frozen and bounded of it, or what Robot() reads one from.
        task: as codesign() takes it; or a task file by its path, or a dict with its keys
            (`tomllib.load`). The robot that it names is not looked for.

    Raises:
        InputError: with everything that codesign() would refuse, by file and line.
        IoError: where a file is not there or cannot be read.
        TypeError: for a robot or task that is something else.
    """
    read = robot if isinstance(robot, Robot) else Robot(robot)
    tasks: Tasks = task_of(task)
    if isinstance(tasks, Iterator):  # which can be gone through once
        tasks = list(tasks)
    text, file = text_of(tasks, read)
    names, document, words = _core.check(read._model, text, file)
    record = json.loads(document)
    each = record['tasks'] if len(names) > 1 else {names[0]: record}
    first = each[names[0]]
    declared = first['parameters']
    return Findings(
        robot=read,
        task=tasks,
        warnings=tuple(
            f'{name}: {doubt}' if len(names) > 1 else doubt
            for name in names
            for doubt in each[name]['warnings']
        ),
        mass=first['robot']['mass_kg'],
        limbs={limb['foot']: tuple(limb['joints']) for limb in first['robot']['limbs']},
        parameters={row['name']: row['initial'] for row in declared},
        bounds={row['name']: (row['lower'], row['upper']) for row in declared},
        tasks=each,
        record=record,
        text=words,
    )
