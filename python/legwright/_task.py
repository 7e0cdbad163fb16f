# SPDX-License-Identifier: Apache-2.0
"""What the robot shall do: the text of a task file, from a file or from keywords."""

import numbers
import os
import tomllib
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from legwright import _core, _toml
from legwright._arguments import number_of, path_of
from legwright._errors import InputError, unreadable
from legwright._files import MOST_OF_TASK, read_text
from legwright._options import kind_of
from legwright._robot import Robot

_MADE = '<task>'  # what messages name in the place of a file
_OF_THE_BODY = ('design', 'outer', 'task')  # tables that hold for all tasks


def _table(key: str, table: Any) -> dict[str, Any]:
    if isinstance(table, Mapping):
        return dict(table)
    raise TypeError(
        f'{key} is {kind_of(table)}; expected a table with the keys that [{key}] has in a task '
        'file, as a dict'
    )


class Task:
    """One task: gait, speed and how to do it. SI units.

    Keywords become the text of a task file, which the program's own reader reads: the tables `gait`
    to `weights` have the keys of a task file, listed in docs/task_file.md and by
    `legwright check --keys`.

    Args:
        gait: name in the library (`legwright gaits` draws them), or a table like
            `{"name": "mine", "touchdown": [0, 0.5, 0.75, 0.25], "duty": 0.75}`.
        velocity: forward and left [m/s], as the robot faces.
        forward: where it faces in the frame of its trunk: "+x" (the default), "-x", "+y" or "-y".
        period: of one cycle [s]. Without one it is that of the first task which `legwright init`
            writes for the robot, with its duty, knots, swing height and servos.
        turn_rate: to the left [rad/s].
        aim_speed: the plan goes and turns so many times as fast, to make up for what MuJoCo loses.
        aim_turn_rate: the plan turns by so much more, likewise [rad/s].
        name: names folders where there are several tasks; default: the gait's.
        style: table of a task file: where body, feet and joints shall be [m, rad].
        limits: likewise: friction, margins, swing height.
        ground: its slope [rad].
        payload: a box on the trunk [kg, m].
        servos: stiffness and damping of soft ones [N m/rad, N m s/rad].
        weights: of the terms of F, by name.
        outer: the outer objective J.
        design: which parameters stay as they are, and narrower bounds of others [m, rad]:
            `{"freeze": ["body_width"], "bounds": {"thigh_length": [0.05, 0.08]}}`. It holds for all
            tasks: of a list of tasks none has it.
        dynamics: "full" or "constant_inertia".

    Raises:
        InputError: with everything that is wrong; `file` is "<task>", `line` that of `text()`.
        TypeError: for a keyword that is no such thing at all, as a table that is a number.
    """

    def __init__(
        self,
        gait: str | Mapping[str, Any],
        velocity: Sequence[float] | NDArray[Any],
        *,
        forward: str | None = None,
        period: float | None = None,
        turn_rate: float | None = None,
        aim_speed: float | None = None,
        aim_turn_rate: float | None = None,
        name: str | None = None,
        style: Mapping[str, Any] | None = None,
        limits: Mapping[str, Any] | None = None,
        ground: Mapping[str, Any] | None = None,
        payload: Mapping[str, Any] | None = None,
        servos: Mapping[str, Any] | None = None,
        weights: Mapping[str, float] | None = None,
        outer: Mapping[str, Any] | None = None,
        design: Mapping[str, Any] | None = None,
        dynamics: str | None = None,
    ) -> None:
        pattern: Any = {'name': gait} if isinstance(gait, str) else gait
        if not isinstance(pattern, Mapping):
            raise TypeError(
                f'gait is {kind_of(gait)}; expected its name in the library, as "trot", or a table'
            )
        if period is not None:
            pattern = {**pattern, 'period': period}
        travel: dict[str, Any] = {'velocity': velocity}
        if forward is not None:
            travel['forward'] = forward
        further = {'turn_rate': turn_rate, 'aim_speed': aim_speed, 'aim_turn_rate': aim_turn_rate}
        travel |= {key: value for key, value in further.items() if value is not None}
        self.name: str = name or str(pattern.get('name', 'task'))
        """Of the run, and of a folder where there are several tasks."""
        content: dict[str, Any] = {'robot': 'robot.xml', 'name': self.name}
        if dynamics is not None:
            content['dynamics'] = dynamics
        content['gait'] = pattern
        content['travel'] = travel
        tables = {'style': style, 'limits': limits, 'ground': ground, 'payload': payload}
        tables |= {'servos': servos, 'weights': weights, 'outer': outer, 'design': design}
        content |= {key: _table(key, table) for key, table in tables.items() if table is not None}
        self._content: dict[str, Any] | None = content
        self._loaded = ''
        self.file = Path(_MADE)
        """That messages name: the task file, or "<task>"."""
        checked = content if self._complete else self._with_defaults({'gait': {'period': 1.0}})
        _core.check_task(_toml.document(checked), self.file)

    @classmethod
    def load(cls, file: str | os.PathLike[str]) -> 'Task':
        """A task file, as it is; it may hold several tasks for one body.

        Its robot is not looked for: codesign() is given one.

        Raises:
            InputError: with everything that is wrong, by file and line; for an empty path, and a
                text in its place.
            IoError: where it is not there or cannot be read.
            TypeError: for what is no path.
        """
        if isinstance(file, str) and '\n' in file:
            message = 'is the text of a task; write it into a file and give its path'
            raise InputError(f'<text>: {message}', '<text>', 0, '', message)
        place = path_of('file', file, absolute=False)
        try:
            text = read_text(place, MOST_OF_TASK)
        except OSError as error:
            raise unreadable(place, error, 'give the path of a task file') from None
        except UnicodeDecodeError as error:
            raise InputError(f'{place}: is no UTF-8, as TOML is: {error}', str(place)) from None
        return cls._from_text(text, place)

    @classmethod
    def _from_text(cls, text: str, file: Path) -> 'Task':
        """The text of a task file; messages name `file`."""
        task = cls.__new__(cls)
        task.file, task._loaded, task._content = file, text, None
        _core.check_task(text, file)
        task.name = str(tomllib.loads(text).get('name', file.stem))
        return task

    @classmethod
    def _from_content(cls, content: Mapping[str, Any], file: Path) -> 'Task':
        """What a task file consists of, unchecked: one task may lack its period."""
        task = cls.__new__(cls)
        task.file, task._loaded, task._content = file, '', dict(content)
        task.name = str(content.get('name', file.stem))
        return task

    @property
    def _complete(self) -> bool:
        if self._content is None or 'task' in self._content:
            return True
        gait = self._content.get('gait')
        return not isinstance(gait, Mapping) or 'period' in gait

    @property
    def _own_pattern(self) -> bool:
        """Whether the gait is no one of the library, so that it has a touchdown of its own."""
        return self._content is not None and 'touchdown' in self._content['gait']

    def _with_defaults(self, defaults: Mapping[str, Any]) -> dict[str, Any]:
        """The content, with what it does not say taken from another task's tables."""
        assert self._content is not None
        content = dict(self._content)
        for table in ('gait', 'limits', 'servos'):
            if table in defaults:
                content[table] = {**defaults[table], **content.get(table, {})}
        if self._own_pattern and 'name' not in self._content['gait']:
            content['gait'].pop('name', None)  # that of the other task
        return content

    def text(self, robot: Robot | None = None) -> str:
        """The text of its task file. Without a period of its own it needs the robot.

        Raises:
            InputError: where the robot has no such gait.
            ValueError: where the robot is needed and not given.
            TypeError: where it is no Robot.
        """
        if self._content is None:
            return self._loaded
        if self._complete:
            return _toml.document(self._content)
        if robot is None:
            raise ValueError('a task without a period needs the robot: text(robot)')
        check_robot(robot)
        gait = None if self._own_pattern else self._content['gait'].get('name')
        try:
            starter = tomllib.loads(robot._model.starter_text(gait))
        except InputError as error:
            text = f'{self.file}: gait.name: {error.message}'
            raise InputError(text, str(self.file), 0, 'gait.name', error.message) from None
        return _toml.document(self._with_defaults(starter))

    def __repr__(self) -> str:
        return f'<Task {self.name}>'


def gaits(robot: Robot | int) -> dict[str, str]:
    """Gaits of the library for a robot or a number of feet: what each is, by its name.

    `legwright gaits` draws them. Empty where there are none, as for one and three feet.

    Raises TypeError for what is neither.
    """
    feet = len(robot.feet) if isinstance(robot, Robot) else robot
    if isinstance(feet, bool) or not isinstance(feet, numbers.Integral):
        raise TypeError(f'robot is {kind_of(robot)}; expected a Robot or a number of feet')
    return dict(_core.gait_library(int(feet))) if 0 < feet < 1000 else {}


Tasks = Task | Iterable[Task | tuple[Task, float]]
"""What codesign() takes: one task, or several for one body, each with a weight or 1/number."""


def _listed(tasks: Any) -> list[tuple[Task, float | None]]:
    """Tasks with their weights. Raises TypeError for what is neither."""
    several = isinstance(tasks, Iterable) and not isinstance(tasks, (str, bytes, Mapping))
    listed = []
    for each in tasks if several else [tasks]:
        pair = each if isinstance(each, tuple) else (each, None)
        if len(pair) != 2 or not isinstance(pair[0], Task):
            raise TypeError(
                f'task is {kind_of(each)}; expected a Task, as Task("trot", (0.4, 0.0)) or '
                'Task.load("trot.toml"), or a list of tasks or of pairs (task, weight)'
            )
        listed.append(pair)
    return listed


def task_of(given: Any) -> Any:
    """A task file by its path, or what one consists of as a dict, as a Task; all else as it is.

    Raises as Task.load(), and TypeError for a `task` that is no list of tables.
    """
    if isinstance(given, (str, os.PathLike)):
        return Task.load(given)
    if not isinstance(given, Mapping):
        return given
    tables = given.get('task', ())
    if not isinstance(tables, (list, tuple)) or not all(isinstance(e, Mapping) for e in tables):
        raise TypeError(f'task is {kind_of(tables)}; expected a list of tables, as [[task]] makes')
    gait = given.get('gait')
    name = gait.get('name', 'task') if isinstance(gait, Mapping) else 'task'
    return Task._from_content({'robot': 'robot.xml', 'name': name, **given}, Path(_MADE))


def check_robot(robot: object) -> None:
    if not isinstance(robot, Robot):
        raise TypeError(
            f'robot is {kind_of(robot)}; expected a legwright.Robot, as Robot("robot.xml")'
        )


def text_of(tasks: Tasks, robot: Robot, *, bounded: bool = True) -> tuple[str, Path]:
    """The text of the task file for a run, and the file that messages name. It has what is frozen
    and bounded of the robot, where `bounded`.

    Raises TypeError where the robot is no Robot or the tasks are none.
    """
    check_robot(robot)
    if isinstance(tasks, Task):
        text, file = tasks.text(robot), tasks.file
    else:
        listed = _listed(tasks)
        if not listed:
            raise InputError('an empty list of tasks; give one at least')
        text, file = _joint_text(listed, robot), Path(_MADE)
    if bounded and (design := robot._design_table()):
        if 'design' in tomllib.loads(text):
            message = (
                '[design] stands in the task file, and bounds were set on the robot, too; '
                'say in one place what may change'
            )
            raise InputError(f'{file}: {message}', str(file), 0, 'design', message)
        text = text.rstrip('\n') + '\n' + _toml.document({'design': design})
    return text, file


def _joint_text(listed: Sequence[tuple[Task, float | None]], robot: Robot) -> str:
    tables = []
    for task, weight in listed:
        content = tomllib.loads(task.text(robot))
        for key in _OF_THE_BODY:
            if key in content:
                message = f'[{key}] holds for all tasks of a file and cannot stand in one of a list'
                raise InputError(f'{task.file}: {message}', str(task.file), 0, key, message)
        for key in ('robot', 'name'):
            content.pop(key, None)
        head: dict[str, Any] = {'name': task.name}
        if weight is not None:
            head['weight'] = number_of(f'weight of task {task.name}', weight)
        tables.append({**head, **content})
    name = '-'.join(table['name'] for table in tables)
    return _toml.document({'robot': 'robot.xml', 'name': name, 'task': tables})
