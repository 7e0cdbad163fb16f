# SPDX-License-Identifier: Apache-2.0
"""The study file, read strictly: which robots and tasks, what varies, with which options."""

import os
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from legwright import _core
from legwright._arguments import path_of
from legwright._errors import InputError
from legwright._files import read_text
from legwright._options import kind_of
from legwright.study import _options
from legwright.study._measures import BEST
from legwright.study._problems import Key, Problems

MADE = Path('<study>')  # what messages name in the place of a file
KEYS = ('name', 'robot', 'assembly', 'library', 'task', 'pictures', 'best', 'base', 'build')
KEYS += ('codesign', 'validate', 'grid', 'points')
FILES = ('robot', 'assembly', 'task')
"""Keys that name files, alone or in the grid."""
_FIXED = ('name', 'pictures', 'best', 'library', 'base', 'grid', 'points')
_DOT_OF_FILE = 'has a dot within quotes; write the key without quotes: gait.period'
_DOT_OF_DICT = "has a dot; give a table in its table: {'gait': {'period': [0.8, 1.0]}}"
OPTIONS = {'codesign': _options.CODESIGN, 'validate': _options.VALIDATE}


@dataclass(frozen=True)
class Axis:
    """A key of the grid with its values."""

    key: Key
    values: tuple[Any, ...]


@dataclass(frozen=True)
class Listed:
    """An entry of [[points]]: what it sets, by key, and its place in the file."""

    place: Key
    settings: Mapping[Key, Any]
    name: str | None = None


@dataclass(frozen=True)
class StudyFile:
    """What a study file says."""

    file: Path
    """Paths in it are found from its folder; `<study>` where it was given as a mapping, and from
    the working directory."""
    text: str
    name: str
    robot: str | None
    assembly: str | None
    library: tuple[str, ...]
    """Folders of modules of one's own, for assemblies."""
    task: str | None
    pictures: bool
    best: str | None
    """The column whose least value, of the designs that pass, the study is after."""
    base: Mapping[Key, Any]
    """Keys of a task that hold for all points, by key."""
    build: Mapping[Key, Any]
    """Keys of the assembly that hold for all points, likewise."""
    codesign: Mapping[str, Any]
    validate: Mapping[str, Any] | None
    axes: tuple[Axis, ...]
    points: tuple[Listed, ...]
    problems: Problems = field(compare=False)
    """To which expansion adds."""

    @property
    def folder(self) -> Path:
        """From where paths are found."""
        return self.file.parent


def leaves(table: Mapping[str, Any], key: Key = ()) -> Iterator[tuple[Key, Any]]:
    """What a table and the tables in it hold, by key, in order."""
    for name, value in table.items():
        if isinstance(value, Mapping) and value:
            yield from leaves(value, (*key, name))
        else:
            yield (*key, name), value


def _check_setting(key: Key, value: Any, place: Key, problems: Problems) -> bool:
    """What can be told of a setting without its task: a path, an option, a key without dots.
    @return whether it is fine"""
    before = len(problems)
    if '.' in key[-1] or any('.' in name for name in key[:-1]):
        problems.add(place, _DOT_OF_DICT if problems.file == MADE else _DOT_OF_FILE)
    elif key[0] in FILES and len(key) == 1:
        if not isinstance(value, str):
            problems.add(place, f'is {kind_of(value)}; expected the path of a file')
    elif key[0] in OPTIONS:
        _options.check(OPTIONS[key[0]], '.'.join(key[1:]), value, place, problems)
    elif key[0] in _FIXED or key == ('build',):
        problems.add(
            place,
            'cannot vary: expected a key of a task file, robot, assembly, build.…, task, '
            'codesign.… or validate.…',
        )
    return len(problems) == before


def _read_axes(grid: Any, problems: Problems) -> tuple[Axis, ...]:
    axes = []
    for key, values in leaves(grid):
        place = ('grid', *key)
        if not isinstance(values, list):
            problems.add(place, f'is {kind_of(values)}; expected a list of values, like [0.8, 1.0]')
            continue
        if not values:
            problems.add(place, 'is an empty list; give one value at least')
        good = []
        for i, value in enumerate(values):
            if value in values[:i]:
                problems.add((*place, str(i)), f'has {value!r} twice')
            elif _check_setting(key, value, (*place, str(i)), problems):
                good.append(value)
        if good:
            axes.append(Axis(key, tuple(good)))
    return tuple(axes)


def _read_points(listed: Any, grid: Any, problems: Problems) -> tuple[Listed, ...]:
    points = []
    varied = [key for key, _ in leaves(grid)]
    for i, table in enumerate(listed):
        place: Key = ('points', str(i))
        settings = dict(leaves(table))
        name = settings.pop(('name',), None)
        if name is not None and not isinstance(name, str):
            problems.add((*place, 'name'), f'is {kind_of(name)}; expected a text')
        good = {}
        for key, value in settings.items():
            if _check_setting(key, value, (*place, *key), problems):
                good[key] = value
            for other in varied:
                if other[: len(key)] == key[: len(other)]:
                    problems.add(
                        (*place, *key),
                        f'stands in [grid], too (line '
                        f'{problems.line(("grid", *other))}); say it in one '
                        'place',
                    )
        points.append(Listed(place, good, name if isinstance(name, str) else None))
    return tuple(points)


def _table(content: Mapping[str, Any], name: str, problems: Problems) -> Mapping[str, Any]:
    value = content.get(name, {})
    if isinstance(value, Mapping):
        return value
    problems.add((name,), f'is {kind_of(value)}; expected a table: [{name}]')
    return {}


def _text(content: Mapping[str, Any], name: str, problems: Problems) -> str | None:
    value = content.get(name)
    if value is None or isinstance(value, str):
        return value
    hint = f'; several stand in [grid]: {name} = [...]' if isinstance(value, list) else ''
    problems.add((name,), f'is {kind_of(value)}; expected a text{hint}')
    return None


def _folders(content: Mapping[str, Any], problems: Problems) -> tuple[str, ...]:
    value = content.get('library', [])
    if isinstance(value, list) and all(isinstance(each, str) for each in value):
        return tuple(value)
    problems.add(('library',), 'expected a list of folders, like ["my_modules"]')
    return ()


def _best(content: Mapping[str, Any], problems: Problems) -> str | None:
    value = _text(content, 'best', problems)
    if value is not None and value not in BEST:
        problems.add(('best',), f'is {value!r}; expected one of {", ".join(BEST)}')
    return value


def _options_of(content: Mapping[str, Any], name: str, problems: Problems) -> dict[str, Any]:
    return {
        key: value
        for key, value in _table(content, name, problems).items()
        if _options.check(OPTIONS[name], key, value, (name, key), problems)
    }


def _parse(
    content: Mapping[str, Any], file: Path, text: str, lines: Mapping[Key, int]
) -> StudyFile:
    problems = Problems(file, lines)
    for name in content:
        if name not in KEYS:
            problems.add_unknown((name,), KEYS)
    pictures = content.get('pictures', True)
    if not isinstance(pictures, bool):
        problems.add(('pictures',), f'is {kind_of(pictures)}; expected true or false')
    listed = content.get('points', [])
    if not isinstance(listed, list) or not all(isinstance(each, Mapping) for each in listed):
        problems.add(('points',), 'expected tables: [[points]] before each')
        listed = []
    grid = _table(content, 'grid', problems)
    axes = _read_axes(grid, problems)
    points = _read_points(listed, grid, problems)
    if not len(problems) and not axes and not points:
        problems.add(
            (),
            'neither [grid] nor [[points]] is there; add for instance: '
            'grid.gait.period = [0.8, 1.0]',
        )
    has_task = 'task' in content or 'base' in content or _varies('task', axes, points)
    if not has_task:
        problems.add(
            (),
            'names no task; add for instance: task = "trot.toml", or keys of a task below [base]',
        )
    settings = [axis.key for axis in axes] + [key for each in points for key in each.settings]
    validates = 'validate' in content or any(key[0] == 'validate' for key in settings)
    study = StudyFile(
        file=file,
        text=text,
        name=_text(content, 'name', problems) or (file.stem if file != MADE else 'study'),
        robot=_text(content, 'robot', problems),
        assembly=_text(content, 'assembly', problems),
        library=_folders(content, problems),
        task=_text(content, 'task', problems),
        pictures=bool(pictures),
        best=_best(content, problems),
        base=dict(leaves(_table(content, 'base', problems))),
        build=dict(leaves(_table(content, 'build', problems))),
        codesign=_options_of(content, 'codesign', problems),
        validate=_options_of(content, 'validate', problems) if validates else None,
        axes=axes,
        points=points,
        problems=problems,
    )
    if len(problems) and not (has_task and _has_points(study, content)):
        problems.raise_if_any()
    return study


def _has_points(study: StudyFile, content: Mapping[str, Any]) -> bool:
    """Whether what is wrong leaves points to look at, whose problems are then told with it."""
    given = all(getattr(study, name) is not None or name not in content for name in FILES)
    return (
        given and isinstance(content.get('base', {}), Mapping) and bool(study.axes or study.points)
    )


def _varies(name: str, axes: tuple[Axis, ...], points: tuple[Listed, ...]) -> bool:
    """Whether each point sets the key by itself."""
    in_grid = any(axis.key == (name,) for axis in axes)
    return in_grid or bool(points) and all((name,) in each.settings for each in points)


def _plain(value: Any) -> Any:
    """As TOML would have it: tuples and NumPy's arrays and numbers are what they hold, paths
    texts."""
    if isinstance(value, Mapping):
        return {str(name): _plain(each) for name, each in value.items()}
    if hasattr(value, 'tolist'):
        value = value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    return [_plain(each) for each in value] if isinstance(value, (list, tuple)) else value


def read_study(study: str | os.PathLike[str] | Mapping[str, Any]) -> StudyFile:
    """A study file, or a mapping with its keys.

    Raises:
        TypeError: for what is neither.
        InputError: where it cannot be read, or nothing can be told of its points. What is wrong
            besides is in `problems`, which points_of() raises with what is wrong of points.
    """
    if isinstance(study, Mapping):
        return _parse(_plain(study), MADE, '', {})
    file = path_of('study', study, absolute=False)
    try:
        text = read_text(file)
    except OSError as error:
        cure = 'give the path of a study file, for instance study.toml'
        raise InputError(f'{file}: {error.strerror}; {cure}', str(file)) from None
    except UnicodeDecodeError as error:
        raise InputError(f'{file}: is no UTF-8, as TOML is: {error}', str(file)) from None
    lines = {tuple(key): line for key, line in _core.key_lines(text, file)}
    return _parse(tomllib.loads(text), file, text, lines)
