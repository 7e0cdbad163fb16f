# SPDX-License-Identifier: Apache-2.0
"""Run folders: one without a design yet, one copied to where somebody wants it."""

import hashlib
import os
import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from legwright import _core
from legwright._errors import InputError, IoError
from legwright._files import json_of, read_bytes


def read_run(folder: Path) -> tuple[dict[str, Any], str]:
    """What run.json says of a run that has come to its end, and the digest of its bytes.

    Raises IoError where there is no run, InputError where it has no end.
    """
    _core.open_run(folder)
    data = read_bytes(folder / 'run.json')
    record: dict[str, Any] = json_of(data, folder / 'run.json')
    if 'final_F' not in record:
        raise no_end(folder, record)
    return record, hashlib.sha256(data).hexdigest()


def check_unchanged(folder: Path, digest: str) -> None:
    """Raises IoError where the folder of a run is gone, InputError where it has another one."""
    _core.open_run(folder)
    if hashlib.sha256(read_bytes(folder / 'run.json')).hexdigest() == digest:
        return
    message = (
        'has another run, or another pick of it, than when this design was read; '
        f'Design.load({str(folder)!r}) reads what is there now'
    )
    raise InputError(f'{folder}: {message}', str(folder), 0, '', message)


def no_end(folder: Path, record: Mapping[str, Any]) -> InputError:
    """Why a run has no design, with the way on."""
    if failure := record.get('failure'):
        message = f'its run failed ({failure}); begin it anew with force=True'
    else:
        message = (
            'its search has not ended: it is still going on, or was killed; then '
            f'codesign(…, folder={str(folder)!r}, resume=True) goes on with it, with the same '
            'arguments otherwise'
        )
    return InputError(f'{folder}: {message}', str(folder), 0, '', message)


def save_run(folder: Path, target: Path, force: bool) -> Path:
    """Copies a run; files that are links to one another stay so. Raises as Design.save()."""
    here, there = folder.resolve(), target.resolve()
    if here == there:
        return target
    if here.is_relative_to(there) or there.is_relative_to(here):
        raise IoError(f'{target}: the design itself lies in {folder}; name another folder')
    made = _core.create_run(target, force)
    copies: dict[tuple[int, int], str] = {}

    def copy(source: str, to: str) -> str:
        about = os.stat(source)  # meshes that designs share stay one file
        key = (about.st_dev, about.st_ino)
        if about.st_nlink > 1 and key in copies:
            os.link(copies[key], to)
            return to
        copies[key] = to
        return shutil.copy2(source, to)

    lock = shutil.ignore_patterns('.lock')
    try:
        shutil.copytree(
            folder, made.path, copy_function=copy, ignore=lock, dirs_exist_ok=True
        )
        if not made.stand():
            raise IoError(f'{target}: the design has no result; the run that is there stays')
    finally:
        del made  # nobody else could write there until now
    return target
