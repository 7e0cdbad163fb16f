# SPDX-License-Identifier: Apache-2.0
"""The folder of a study: what is done stands in points/HASH, all else does not count."""

import fcntl
import hashlib
import json
import os
import secrets
import shutil
import socket
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from legwright import _core
from legwright._errors import IoError
from legwright._files import read_json
from legwright._robot import Robot
from legwright.study._points import Robots

RECORD = 'point.json'
"""In the folder of each point: its inputs, how it went, what it measured."""


class StudyFolder:
    """A folder of a study that is there.

    ```
    study.toml               the study file
    robots/HASH/             a robot of the study as it was: robot.xml and what it names
    points/HASH/             a point that is done: its run folder, and point.json
    unfinished/              what workers are at; nothing of it counts
    study.parquet, study.html
    ```
    """

    def __init__(self, root: Path) -> None:
        self.root = root
        self.points = root / 'points'
        self.robots = root / 'robots'
        self.unfinished = root / 'unfinished'
        self.study_file = root / 'study.toml'
        self._made: list[Path] = []  # by make()

    @classmethod
    def make(cls, root: Path) -> 'StudyFolder':
        """The folder, made where it is not there. Raises IoError where it holds something else."""
        folder = cls(root.absolute())
        if root.exists() and not root.is_dir():
            raise IoError(f'{root}: is a file; name a folder for the study')
        if root.is_dir() and any(root.iterdir()) and not folder.study_file.exists():
            raise IoError(
                f'{root}: holds something else than a study; name an empty or a new folder'
            )
        for each in (folder.root, folder.points, folder.robots, folder.unfinished):
            if not each.exists():
                folder._made.append(each)
                each.mkdir(parents=True)
        if not folder.study_file.exists():
            folder._made.append(folder.study_file)
            folder.study_file.touch()
        return folder

    def unmake(self) -> None:
        """Takes away what make() made, where the study came to nothing."""
        if self.study_file in self._made:
            (self.root / '.lock').unlink(missing_ok=True)
            self.study_file.unlink()
            for each in self._made:
                shutil.rmtree(each, ignore_errors=True)

    @contextmanager
    def locked(self) -> Iterator[None]:
        """Alone with the folder. Raises IoError where another study is at it."""
        with (self.root / '.lock').open('w') as file:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                raise IoError(
                    f'{self.root}: another `legwright study` is at work there; wait for its end'
                ) from None
            except OSError as error:
                raise IoError(
                    f'{self.root}: its file system locks no files ({error.strerror}); name a '
                    'folder elsewhere'
                ) from None
            yield

    def point(self, hash_: str) -> Path:
        """Where a point is once it is done."""
        return self.points / hash_

    def record(self, hash_: str) -> dict[str, Any] | None:
        """point.json of a point that is done; None of one that is not. Raises IoError where it is
        damaged."""
        file = self.point(hash_) / RECORD
        try:
            record = read_json(file)
        except FileNotFoundError:
            return None
        except ValueError:
            record = None
        if not _is_record(record):
            raise IoError(
                f'{file}: is damaged; remove the folder {file.parent}, and the same command makes '
                'the point again'
            )
        return record

    def sweep(self) -> set[str]:
        """Removes what workers left that were killed. One that still lives finds that its folder
        is another one, or none. @return the hashes of the points that they were at"""
        left = sorted(self.unfinished.iterdir())
        for each in left:
            self._remove(each)
        return {each.name.partition('-')[0] for each in left}

    def forget(self, hash_: str) -> None:
        """Makes a point one that is not done."""
        self._remove(self.point(hash_))

    def _remove(self, folder: Path) -> None:
        """All at once for whoever looks; what is not there, or vanishes meanwhile, is as well."""
        away = self.scratch('removed')
        with suppress(FileNotFoundError):
            folder.rename(away)
            shutil.rmtree(away, ignore_errors=True)

    def scratch(self, name: str) -> Path:
        """A name in unfinished/ that nobody else has."""
        host = socket.gethostname().split('.')[0]
        return self.unfinished / f'{name}-{host}-{os.getpid()}-{secrets.token_hex(4)}'

    def finish(self, made: Path, place: Path) -> None:
        """Puts a folder that is complete where it counts, at once; where one is there already, that
        one stays."""
        for directory in (made, made.parent):
            _sync(directory)
        try:
            made.rename(place)
        except OSError:
            if not place.is_dir():
                raise
            shutil.rmtree(made)
        _sync(place.parent)


def _is_record(record: Any) -> bool:
    """Whether it has what a study reads of a point."""
    return (
        isinstance(record, dict)
        and record.get('status') in ('done', 'refused')
        and 'reason' in record
        and isinstance(record.get('measures'), dict)
        and isinstance(record.get('seconds'), (int, float))
    )


def _sync(directory: Path) -> None:
    handle = os.open(directory, os.O_RDONLY | os.O_DIRECTORY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def write_text(file: Path, text: str) -> None:
    """Writes a file whole or not at all."""
    part = file.with_name(f'.{file.name}.{os.getpid()}.part')
    with part.open('w', encoding='utf-8', newline='\n') as stream:
        stream.write(text)
        stream.flush()
        os.fsync(stream.fileno())
    part.replace(file)


def write_record(folder: Path, record: Mapping[str, Any]) -> None:
    """Writes point.json."""
    text = json.dumps(record, indent=1, ensure_ascii=False, sort_keys=True)
    write_text(folder / RECORD, text + '\n')


class FolderRobots(Robots):
    """The robots of a study, copied into its folder."""

    def __init__(self, folder: StudyFolder) -> None:
        self._folder = folder
        self._robots: dict[Path, Robot] = {}
        self._hashes: dict[Path, dict[str, str]] = {}
        self._made: dict[str, Path] = {}

    def read(self, file: Path) -> Robot:
        if file not in self._robots:
            self._robots[file] = Robot(file)
        return self._robots[file]

    def place(self, name: str, xml: str) -> Path:
        sum_ = hashlib.sha256(xml.encode()).hexdigest()
        if sum_ not in self._made:
            folder = self._folder.scratch('built')
            folder.mkdir()
            self._made[sum_] = folder / f'{name}.xml'
            write_text(self._made[sum_], xml)
        return self._made[sum_]

    def hashes(self, file: Path) -> dict[str, str]:
        if file not in self._hashes:
            copy = self._folder.scratch('robot')
            copy.mkdir()
            _core.copy_robot(self.read(file)._model, copy)
            hashes = {
                each.relative_to(copy).as_posix(): hashlib.sha256(each.read_bytes()).hexdigest()
                for each in sorted(copy.rglob('*'))
                if each.is_file()
            }
            self._folder.finish(copy, self._folder.robots / robot_address(hashes))
            self._hashes[file] = hashes
        return self._hashes[file]


def robot_address(hashes: Mapping[str, str]) -> str:
    """The folder below robots/ of a robot with these files."""
    return hashlib.sha256(json.dumps(hashes, sort_keys=True).encode()).hexdigest()[:16]
