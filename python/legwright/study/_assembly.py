# SPDX-License-Identifier: Apache-2.0
"""Robots of a study that are built of modules: an assembly, with keys of it that vary."""

import copy
import re
import tomllib
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from legwright import _core, _toml
from legwright._assembly import MODULES
from legwright._errors import InputError, IoError
from legwright._options import kind_of
from legwright.study._file import StudyFile
from legwright.study._problems import Key, dotted

_COMPLAINT = re.compile(r':(?:(\d+):)? (?:([^\s:]+): )?(.*)')
Places = Mapping[Key, Key]
"""Where each setting stands in the study file."""


@dataclass(frozen=True)
class Built:
    """What became of an assembly."""

    text: str
    """The assembly, with what the point sets."""
    xml: str
    """MJCF of the robot; empty where there is none."""
    refusal: str
    """Why these modules make no robot that stands on legs; else empty."""


def set_key(content: dict[str, Any], key: Key, value: Any) -> str | None:
    """Sets a key in tables of tables. @return what is wrong"""
    table = content
    for name in key[:-1]:
        table = table.setdefault(name, {})
        if not isinstance(table, dict):
            return f'sets a key of {name}, which is {kind_of(table)}'
    table[key[-1]] = copy.deepcopy(value)
    return None


class Assemblies:
    """Builds each robot once."""

    def __init__(self, study: StudyFile) -> None:
        self._folder, self._problems = study.folder, study.problems
        self._modules = [MODULES, *(study.folder / each for each in study.library)]
        self._of_all = {('build', *key): value for key, value in study.build.items()}
        self._built: dict[tuple[Path, str], Built | None] = {}

    def build(
        self,
        named: str,
        settings: Mapping[Key, Any],
        places: Places,
        read: Callable[[Path, Key], str | None],
    ) -> Built | None:
        """The robot of an assembly with what `build.…` keys set; None, with problems, where
        something is wrong with it.

        Args:
            named: the assembly's file, from the folder of the study.
            read: gives the text of a file, or reports at the place that names it: None.
        """
        file = self._folder / named
        before = len(self._problems)
        text = read(file, places.get(('assembly',), ('assembly',)))
        if text is None:
            return None
        own = {
            key[1:]: value
            for key, value in {**self._of_all, **settings}.items()
            if key[0] == 'build'
        }
        places = {**{key: key for key in self._of_all}, **places}
        if own:
            text = self._changed(text, file, own, places)
        if len(self._problems) > before:
            return None
        if (file, text) not in self._built:
            self._built[file, text] = self._build(text, file, own, places)
        return self._built[file, text]

    def _changed(
        self, text: str, file: Path, own: Mapping[Key, Any], places: Places
    ) -> str:
        try:
            _core.key_lines(text, file)  # which tells what is no TOML better
        except InputError as error:
            self._problems.add_of(file, error.line, error.where, error.message)
            return ''
        content = {'name': file.stem, **tomllib.loads(text)}
        for key, value in own.items():
            if fault := set_key(content, key, value):
                self._problems.add(places['build', *key], fault)
        try:
            return _toml.document(content)
        except TypeError as error:
            self._problems.add_of(file, 0, '', str(error))
            return ''

    def _build(
        self, text: str, file: Path, own: Mapping[Key, Any], places: Places
    ) -> Built | None:
        try:
            built = _core.build_robot(text, file, self._modules, file)
        except InputError as error:
            for each in error.reasons or (error,):
                self._tell(each, file, own, places)
            return None
        except IoError as error:
            self._problems.add(('library',), str(error))
            return None
        refusal = '' if built.refusal is None else str(built.refusal)
        return Built(text, built.xml, refusal.removeprefix(f'{file}: '))

    def _tell(
        self, error: InputError, file: Path, own: Mapping[Key, Any], places: Places
    ) -> None:
        """What is wrong, of the key that the study sets, else of the assembly or a module file."""
        if error.file and Path(error.file) != file:
            self._problems.add_of(Path(error.file), error.line, error.where, error.message)
            return
        for line in str(error).splitlines():
            found = _COMPLAINT.fullmatch(line.removeprefix(str(file)))
            number, where, message = found.groups() if found else (None, None, line)
            key = next((k for k in own if _is_of(where or '', dotted(k))), None)
            if key is not None:
                self._problems.add(places['build', *key], message)
            else:  # with keys of the study, lines are those of the text that was made
                number = 0 if own else int(number or 0)
                self._problems.add_of(file, number, where or '', message)


def _is_of(where: str, key: str) -> bool:
    return where == key or where.startswith((key + '.', key + '['))
