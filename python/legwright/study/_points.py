# SPDX-License-Identifier: Apache-2.0
"""The points of a study: grid and list multiplied out, each with its robot, task and options."""

import copy
import hashlib
import itertools
import json
import os
import re
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from legwright import _core
from legwright._errors import InputError
from legwright._files import read_text
from legwright._robot import Robot
from legwright._task import Task
from legwright.study import _options
from legwright.study._assembly import Assemblies, Built, Places, set_key
from legwright.study._file import FILES, MADE, Listed, StudyFile
from legwright.study._problems import Key, dotted

MOST = 100_000  # points of a study
_POINT = Path('<point>')
_COMPLAINT = re.compile(r'<point>:(?:\d+:)? (?:([^\s:]+): )?(.*)')


@dataclass(frozen=True)
class Point:
    """One co-design."""

    index: int
    name: str
    """As [[points]] names it, and what it sets."""
    settings: Mapping[str, Any]
    """What it sets, by dotted key."""
    robot_file: str
    """From the folder of the study file."""
    task_file: str
    """The base's, likewise; `<study>` where there is none."""
    robot: Mapping[str, str]
    """SHA-256 of each of the robot's files, by path; the main one is robot.xml. Where there is no
    robot, that of its assembly."""
    task: str
    """Text of its task file."""
    codesign: Mapping[str, Any]
    validate: Mapping[str, Any] | None
    refusal: str = ''
    """Why its modules make no robot; it is refused for that."""

    @property
    def inputs(self) -> dict[str, Any]:
        """All that its design depends on. Options are complete, so that a default that is given
        counts as one that is not."""
        inputs = {
            'legwright': _core.__version__,
            'mujoco': _core.mujoco_version,
            'robot': dict(self.robot),
            'task': self.task,
            'codesign': dict(self.codesign),
            'validate': None if self.validate is None else dict(self.validate),
        }
        return inputs | ({'refusal': self.refusal} if self.refusal else {})

    @property
    def hash(self) -> str:
        """The address of its run: 16 hexadecimal digits of the SHA-256 of its inputs."""
        text = json.dumps(self.inputs, sort_keys=True, ensure_ascii=False)
        return hashlib.sha256(text.encode()).hexdigest()[:16]


def _apply(content: dict[str, Any], key: Key, value: Any) -> str | None:
    """Sets a key of a task; of a file with several tasks, `tasks.NAME.…` one of them. @return what
    is wrong"""
    table = content
    if key[0] == 'tasks':
        listed = content.get('task', [])
        named = {each.get('name'): each for each in listed if isinstance(each, dict)}
        if len(key) < 3 or key[1] not in named:
            there = ', '.join(map(str, named)) or 'none: it has no [[task]]'
            return f'expected tasks.NAME.KEY, NAME of a task of the file, which has {there}'
        table, key = named[key[1]], key[2:]
    return set_key(table, key, value)


@dataclass(frozen=True)
class _Source:
    """Where a robot comes from."""

    file: Path
    """Its MJCF, or the assembly that it is built of."""
    place: Key
    """In the study file."""
    built: Built | None = None


class _Expansion:
    """Makes points; reads each robot and each base task once."""

    def __init__(self, study: StudyFile, robots: 'Robots') -> None:
        self.study, self.robots, self.problems = study, robots, study.problems
        self._bases: dict[Path, dict[str, Any]] = {}
        self._assemblies = Assemblies(study)

    def _base(self, named: str | None, place: Key) -> tuple[Path, dict[str, Any]]:
        """The content of a base task, a copy; empty where there is none."""
        if named is None:
            return MADE, {'name': 'task'}  # not the study's name, which is no input
        file = self.study.folder / named
        if file not in self._bases:
            self._bases[file] = {}
            try:
                if (text := self._text(file, place)) is not None:
                    _core.key_lines(text, file)  # which tells what is no TOML better
                    self._bases[file] = {'name': file.stem, **tomllib.loads(text)}
            except InputError as error:
                self.problems.add_of(file, error.line, error.where, error.message)
        return file, copy.deepcopy(self._bases[file])

    def _text(self, file: Path, place: Key) -> str | None:
        try:
            return read_text(file)
        except (OSError, UnicodeDecodeError) as error:
            why = error.strerror if isinstance(error, OSError) else 'it is no UTF-8'
            self.problems.add(place, f'{file} cannot be read: {why}')
            return None

    def _robot_of(self, file: Path, place: Key) -> Robot | None:
        if not file.is_file():
            self.problems.add(place, f'names the robot {file}, which is not there')
            return None
        try:
            return self.robots.read(file)
        except InputError as error:
            for each in error.reasons or (error,):
                self.problems.add_of(Path(each.file or file), each.line, each.where, each.message)
        except OSError as error:
            self.problems.add(place, f'{file} cannot be read: {error}')
        return None

    def _source(
        self,
        settings: Mapping[Key, Any],
        task_file: Path,
        content: Mapping[str, Any],
        places: Places,
    ) -> _Source | None:
        """Where the robot comes from: its file, an assembly, or the robot of the base task."""
        robot = settings.get(('robot',), self.study.robot)
        assembly = settings.get(('assembly',), self.study.assembly)
        sets = [places[key] for key in settings if key[0] == 'build']
        sets += [('build', *key) for key in self.study.build]
        if assembly is None and sets:
            fault = 'sets a key of an assembly, and none is named; add: assembly = "FILE.toml"'
            self.problems.add(sets[0], fault)
        elif assembly is not None and robot is not None:
            place = places.get(('assembly',), ('assembly',))
            self.problems.add(place, 'stands beside a robot; name one of the two')
        elif assembly is not None:
            made = self._assemblies.build(assembly, settings, places, self._text)
            place = places.get(('assembly',), ('assembly',))
            return made and _Source(self.study.folder / assembly, place, made)
        elif robot is not None:
            place = places.get(('robot',), ('robot',))
            return _Source(self.study.folder / robot, place)
        elif isinstance(content.get('robot'), str):
            place = places.get(('task',), ('task',))
            return _Source(task_file.parent / content['robot'], place)
        elif not len(self.problems):
            self.problems.add((), 'names no robot; add for instance: robot = "robot.xml"')
        return None

    def _settle(
        self, content: dict[str, Any], settings: Mapping[Key, Any], places: Places
    ) -> dict[str, dict[str, Any]]:
        """Puts the settings into the content of the task. @return those that are options"""
        options = {
            'codesign': dict(self.study.codesign),
            'validate': dict(self.study.validate or {}),
        }
        for key, value in settings.items():
            if key[0] == 'build' or len(key) == 1 and key[0] in FILES:
                continue
            if key[0] in options:
                options[key[0]][key[1]] = value
            elif fault := _apply(content, key, value):
                self.problems.add(places[key], fault)
        if limits := options['validate'].get('limits'):
            place = places.get(('validate', 'limits'), ('validate', 'limits'))
            options['validate']['limits'] = self._text(self.study.folder / limits, place)
        return options

    def point(self, index: int, listed: Listed, settings: Mapping[Key, Any]) -> Point | None:
        """The point with these settings; None, with problems, where there is something wrong."""
        before = len(self.problems)
        places = {key: ('base', *key) for key in self.study.base}
        places |= {
            key: (*listed.place, *key) if key in listed.settings else ('grid', *key)
            for key in settings
        }
        task_file, content = self._base(
            settings.get(('task',), self.study.task), places.get(('task',), ('task',))
        )
        source = self._source(settings, task_file, content, places)
        if source is None:
            return None
        content['robot'] = 'robot.xml'
        options = self._settle(content, {**self.study.base, **settings}, places)
        if len(self.problems) > before:
            return None
        robot, text, hashes, refusal = None, '', {}, ''
        if source.built is not None and source.built.refusal:
            refusal = source.built.refusal
            sum_ = hashlib.sha256(source.built.text.encode()).hexdigest()
            hashes = {'assembly.toml': sum_}
        else:
            file = source.file
            if source.built is not None:
                file = self.robots.place(source.file.stem, source.built.xml)
            robot = self._robot_of(file, source.place)
            if robot is None:
                return None
            text = self._task_text(content, task_file, robot, places)
            hashes = self.robots.hashes(file)
        if len(self.problems) > before:
            return None
        validates = self.study.validate is not None
        return Point(
            index=index,
            name=_name_of(index, listed, settings),
            settings={dotted(key): value for key, value in settings.items()},
            robot_file=os.path.relpath(source.file, self.study.folder),
            task_file=str(MADE)
            if task_file == MADE
            else os.path.relpath(task_file, self.study.folder),
            robot=hashes,
            task=text,
            codesign=_options.with_defaults(_options.CODESIGN, options['codesign']),
            validate=_options.with_defaults(_options.VALIDATE, options['validate'])
            if validates
            else None,
            refusal=refusal,
        )

    def _task_text(
        self, content: Mapping[str, Any], file: Path, robot: Robot, places: Places
    ) -> str:
        """The text of the task file, checked; what is wrong is told where it was set."""
        try:
            text = Task._from_content(content, _POINT).text(robot)
            _core.check_task(text, _POINT)
            return text
        except InputError as error:
            for line in str(error).splitlines():
                found = _COMPLAINT.fullmatch(line)
                where, message = found.groups() if found else ('', line)
                key = self._setting_of(where or '', places)
                if key is not None:
                    self.problems.add(places[key], message)
                elif file == MADE:
                    self.problems.add(('base',), f'{where}: {message}' if where else message)
                else:
                    self.problems.add_of(file, 0, where or '', message)
        except TypeError as error:
            self.problems.add((), str(error))
        return ''

    @staticmethod
    def _setting_of(where: str, places: Places) -> Key | None:
        """The setting that a complaint of the task reader is about."""
        for key in places:
            name = dotted(key[2:] if key[0] == 'tasks' else key)
            if where == name or where.startswith((name + '.', name + '[')):
                return key
            if key[0] == 'tasks' and where.endswith('.' + name):
                return key
        # Of a table that lacks something: the first that is set in it.
        return next((key for key in places if where and dotted(key).startswith(where + '.')), None)


def _name_of(index: int, listed: Listed, settings: Mapping[Key, Any]) -> str:
    """What tells a point from the others: the name in its list, what it sets else."""
    words = [listed.name] if listed.name else []
    for key, value in settings.items():
        if listed.name is None or key not in listed.settings:
            words.append(f'{dotted(key)} = {_words(value)}')
    return ', '.join(words) or f'point {index}'


def _words(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False) if not isinstance(value, str) else value


class Robots:
    """The robots of a study, each read once and copied to where workers find it."""

    def read(self, file: Path) -> Robot:
        """Raises InputError, IoError."""
        raise NotImplementedError

    def place(self, name: str, xml: str) -> Path:
        """A file of a robot that was made, for read()."""
        raise NotImplementedError

    def hashes(self, file: Path) -> dict[str, str]:
        """SHA-256 of each of the files of a robot that has been read, by path."""
        raise NotImplementedError


def _combinations(study: StudyFile) -> Iterator[tuple[Listed, dict[Key, Any]]]:
    for listed in study.points or (Listed((), {}),):
        for values in itertools.product(*(axis.values for axis in study.axes)):
            grid = {axis.key: value for axis, value in zip(study.axes, values)}
            yield listed, {**listed.settings, **grid}


def points_of(study: StudyFile, robots: Robots) -> list[Point]:
    """All points: each of [[points]] with each combination of [grid], the last key of the grid
    changing fastest.

    Raises:
        InputError: with everything that is wrong with robots, tasks and settings.
    """
    count = len(study.points or (1,))
    for axis in study.axes:
        count *= len(axis.values)
    if count > MOST:
        study.problems.add(('grid',), f'makes {count} points; a study has {MOST} at most')
        study.problems.raise_if_any()
    expansion = _Expansion(study, robots)
    points = []
    for index, (listed, settings) in enumerate(_combinations(study)):
        point = expansion.point(index, listed, settings)
        if point is not None:
            points.append(point)
        if len(study.problems) > 20:
            break
    study.problems.raise_if_any()
    return points
