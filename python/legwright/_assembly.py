# SPDX-License-Identifier: Apache-2.0
"""Robots built of modules: servos, feet and trunks, as an assembly file says."""

import os
import warnings
from collections.abc import Iterable, Sequence
from pathlib import Path

from legwright import _core
from legwright._arguments import path_of
from legwright._errors import InputError, IoError, LegwrightWarning, unreadable
from legwright._files import read_text
from legwright._options import kind_of
from legwright._robot import Robot

MODULES = Path(__file__).parent / 'share/legwright/modules'
"""The library that came with the package."""


def _of_robot(refusal: InputError, assembly: Path) -> InputError:
    """What is wrong with the robot, told of the assembly that it comes from."""
    message = f'its robot is refused and not written; of {refusal}'
    return InputError(f'{assembly}: {message}', str(assembly), 0, '', message)


def build(
    assembly: str | os.PathLike[str],
    output: str | os.PathLike[str],
    *,
    library: Sequence[str | os.PathLike[str]] = (),
) -> Robot:
    """Builds a robot of modules and writes its MJCF, as `legwright build`.

    Args:
        assembly: an assembly file (docs/assembly_file.md).
        output: the new file of the robot.
        library: folders of modules of one's own; of one name the later one counts.

    What is hardly meant, as a figure in another unit or modules inside each other, is a
    LegwrightWarning, before anything is written.

    Raises:
        InputError: for what is wrong with the assembly, by line and key, or where its robot does
            not stand on legs, or has modules whose middle is in another one.
        IoError: where `output` is there already, or something cannot be read or written.
    """
    if isinstance(assembly, str) and '\n' in assembly:
        message = 'is the text of an assembly; write it into a file and give its path'
        raise InputError(f'<text>: {message}', '<text>', 0, '', message)
    if isinstance(library, (str, os.PathLike)) or not isinstance(library, Iterable):
        raise TypeError(f'library is {kind_of(library)}; expected a list of folders, as ["mine"]')
    file = path_of('assembly', assembly, absolute=False)
    place = path_of('output', output, absolute=False)
    folders = [MODULES, *(path_of('library', each, absolute=False) for each in library)]
    try:
        text = read_text(file)
    except OSError as error:
        raise unreadable(file, error, 'give the path of an assembly file') from None
    except UnicodeDecodeError as error:
        message = f'is no UTF-8, as TOML is: {error}'
        raise InputError(f'{file}: {message}', str(file), 0, '', message) from None
    built = _core.build_robot(text, file, folders, place)
    for doubt in built.doubts:
        warnings.warn(LegwrightWarning(doubt), stacklevel=2)
    if built.refusal is not None:
        raise built.refusal if built.tells_lines else _of_robot(built.refusal, file)
    made = place.with_name(f'.{place.name}.{os.getpid()}.part')
    try:
        made.write_text(built.xml, encoding='utf-8', newline='\n')
        os.link(made, place)  # refuses what is there
    except FileExistsError:
        raise IoError(f'{place}: is there already; name another file') from None
    except OSError as error:
        raise IoError(f'{place}: cannot be written: {error.strerror}') from None
    finally:
        made.unlink(missing_ok=True)
    return Robot(place)
