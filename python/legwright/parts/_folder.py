# SPDX-License-Identifier: Apache-2.0
"""The folder of parts: written whole beside its place, then put there."""

import os
import secrets
import shutil
from collections.abc import Mapping
from pathlib import Path

from legwright._errors import IoError
from legwright._files import read_json

CHECKS = 'checks.json'
SCHEMA = 'legwright/parts'


def _is_ours(folder: Path) -> bool:
    """Whether all that a folder holds is what such a folder was written with."""
    try:
        document = read_json(folder / CHECKS)
        known = set(document['files'])
        ours = document['schema'] == SCHEMA
    except (OSError, ValueError, KeyError, TypeError):
        return False
    return ours and {entry.name for entry in folder.iterdir()} <= known


def check_place(folder: Path) -> None:
    """Raises IoError where a folder holds something else than parts."""
    if folder.exists() and not folder.is_dir():
        raise IoError(f'{folder}: is a file; name a folder for the parts')
    if folder.is_dir() and any(folder.iterdir()) and not _is_ours(folder):
        raise IoError(
            f'{folder}: holds something else than parts; name an empty or a new folder with -o'
        )


def write_folder(folder: Path, files: Mapping[str, bytes]) -> None:
    """Puts the files there, in the place of all that earlier calls wrote. Raises IoError."""
    check_place(folder)
    folder = folder.resolve()
    beside = folder.with_name(f'.{folder.name}.{secrets.token_hex(4)}')
    aside = beside.with_name(f'{beside.name}.old')
    try:
        beside.mkdir(parents=True)
        for name, data in files.items():
            (beside / name).parent.mkdir(parents=True, exist_ok=True)
            (beside / name).write_bytes(data)
        if folder.exists():
            os.replace(folder, aside)
        os.replace(beside, folder)
    except OSError as error:
        if aside.exists() and not folder.exists():
            os.replace(aside, folder)
        shutil.rmtree(beside, ignore_errors=True)
        why = error.strerror or error
        raise IoError(f'{folder}: {why}; name another folder with -o') from None
    shutil.rmtree(aside, ignore_errors=True)
