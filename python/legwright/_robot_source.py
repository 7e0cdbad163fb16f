# SPDX-License-Identifier: Apache-2.0
"""Robots that are no file yet: a mujoco.MjSpec, or a name of the package robot_descriptions."""

import difflib
import importlib
import importlib.util
import os
import pkgutil
import re
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path, PurePosixPath
from typing import Any

from legwright._errors import InputError, IoError, check_readable
from legwright._files import MOST_OF_ASSET, read_bytes

_PACKAGE = 'robot_descriptions'
_NAME = re.compile(r'[A-Za-z]\w*')
_FILE_NAME = re.compile(r'[^A-Za-z0-9._-]')


def is_spec(robot: Any) -> bool:
    """Whether it is a mujoco.MjSpec; without mujoco nothing is."""
    mujoco = sys.modules.get('mujoco')
    return mujoco is not None and isinstance(robot, mujoco.MjSpec)


def spec_name(spec: Any) -> str:
    """What messages call it, in the place of a file."""
    return f'<MjSpec {spec.modelname or "without a name"}>'


def write_spec(spec: Any) -> tuple['tempfile.TemporaryDirectory[str]', Path]:
    """Writes a spec and its assets into a folder of its own. The spec stays as it is.

    Returns:
        the folder, which goes with the object, and the MJCF in it.

    Raises:
        InputError: where MuJoCo does not compile it, or an asset is nowhere.
    """
    temporary = tempfile.TemporaryDirectory(prefix='legwright-')
    folder = Path(temporary.name)
    written = spec.copy()
    (folder / 'assets').mkdir()
    for number, (element, key, index) in enumerate(_named_files(written)):
        named = _file_of(element, index)
        of_kind = written.meshdir if key == 'meshdir' else written.texturedir
        name = f'{number}_{_FILE_NAME.sub("_", PurePosixPath(named).name)}'
        (folder / 'assets' / name).write_bytes(_asset(spec, of_kind, named))
        _set_file(element, index, name)
    written.meshdir = written.texturedir = 'assets'
    written.modelfiledir = str(folder) + os.sep
    written.strippath = False
    try:
        text = written.to_xml()
    except ValueError as error:
        message = f'MuJoCo does not compile it: {"; ".join(str(error).splitlines())}'
        raise InputError(f'{spec_name(spec)}: {message}', spec_name(spec), 0, '', message) from None
    file = folder / f'{_FILE_NAME.sub("_", spec.modelname) or "robot"}.xml'
    file.write_text(text, encoding='utf-8')
    return temporary, file


def _named_files(spec: Any) -> Iterator[tuple[Any, str, int]]:
    """Elements that name a file, the folder that it is in, and which of a cube's; -1: the only."""
    for mesh in spec.meshes:
        if mesh.file:
            yield mesh, 'meshdir', -1
    for field in spec.hfields:
        if field.file:
            yield field, 'meshdir', -1
    for texture in spec.textures:
        if texture.file:
            yield texture, 'texturedir', -1
        for index, file in enumerate(texture.cubefiles):
            if file:
                yield texture, 'texturedir', index


def _file_of(element: Any, index: int) -> str:
    return str(element.file if index < 0 else element.cubefiles[index])


def _set_file(element: Any, index: int, name: str) -> None:
    if index < 0:
        element.file = name
    else:
        element.cubefiles[index] = name


def _asset(spec: Any, directory: str, named: str) -> bytes:
    """The bytes of a file that a spec names, from its assets or from beside its own file."""
    if spec.strippath:
        named = PurePosixPath(named).name
    inside = os.path.normpath(os.path.join(directory, named))
    for key in (inside, os.path.join(directory, named), named):
        if key in spec.assets:
            data = spec.assets[key]
            return data.encode('utf-8') if isinstance(data, str) else bytes(data)
    path = Path(spec.modelfiledir or '.') / inside
    try:
        return read_bytes(path, MOST_OF_ASSET)
    except OSError as error:
        message = (
            f'file {named!r} is neither in spec.assets nor on disk ({path}: {error.strerror}); '
            f'put its bytes into spec.assets[{inside!r}]'
        )
        raise InputError(
            f'{spec_name(spec)}: {message}', spec_name(spec), 0, 'asset', message
        ) from None


def of_spec(error: InputError, spec: Any, file: Path) -> InputError:
    """The same error, told of the spec in the place of the file that was written of it."""
    name = spec_name(spec)
    text = str(error).replace(str(file), name)
    message = error.message.replace(str(file), name)
    reasons = tuple(of_spec(reason, spec, file) for reason in error.reasons)
    return InputError(text, name, error.line, error.where, message, reasons)


def file_of(robot: 'str | os.PathLike[str]', *, names: bool = True) -> Path:
    """The MJCF of a path or, with `names`, of a name of robot_descriptions; it can be read.

    Raises:
        InputError: for the text of an MJCF, and as described().
        IoError: where there is no such file, or it cannot be read.
    """
    if isinstance(robot, str) and robot.lstrip().startswith('<'):
        message = (
            'is the text of a robot; write it into a file and give its path, or give '
            'mujoco.MjSpec.from_string(text) to Robot()'
        )
        raise InputError(f'<text>: {message}', '<text>', 0, '', message)
    found = described(robot) if names and isinstance(robot, str) else None
    file = found or Path(robot)
    check_readable(file, "give the path of a robot's MJCF" + (' or a mujoco.MjSpec' * names))
    return file


def described(robot: str) -> Path | None:
    """The MJCF of a name of robot_descriptions; None for what looks like a path, or is one.

    Importing a description may fetch its repository, as that package does.

    Raises:
        InputError: for a name that the package has not, or without an MJCF; without the package.
        IoError: where the package cannot fetch its files.
    """
    if not _NAME.fullmatch(robot) or not robot.endswith('_description') or Path(robot).exists():
        return None
    found = importlib.util.find_spec(_PACKAGE)
    if found is None or not found.submodule_search_locations:
        raise _refusal(robot, f'is no file; a name of {_PACKAGE} needs it: pip install {_PACKAGE}')
    names = [each.name for each in pkgutil.iter_modules(found.submodule_search_locations)]
    if robot not in names:
        near = difflib.get_close_matches(robot, names, 1)
        meant = f'; is {near[0]!r} meant?' if near else f'; python -m {_PACKAGE} list tells all'
        raise _refusal(robot, f'is neither a file nor a name of {_PACKAGE}{meant}')
    described = importlib.util.find_spec(f'{_PACKAGE}.{robot}')
    assert described is not None and described.origin is not None
    if 'MJCF_PATH' not in Path(described.origin).read_text(encoding='utf-8'):  # nothing to fetch
        other = re.sub('_description$', '_mj_description', robot)
        meant = f'; {other!r} has one' if other in names else '; legwright init makes one of a URDF'
        raise _refusal(robot, f'has no MJCF{meant}')
    try:
        module = importlib.import_module(f'{_PACKAGE}.{robot}')
    except Exception as error:
        raise IoError(
            f'{robot}: {_PACKAGE} could not fetch it: {" ".join(str(error).split())}'
        ) from error
    return Path(module.MJCF_PATH)


def _refusal(robot: str, message: str) -> InputError:
    return InputError(f'{robot!r} {message}', robot, 0, '', message)
