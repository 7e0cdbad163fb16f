# SPDX-License-Identifier: Apache-2.0
"""Robots built of modules: servos, feet and trunks, as an assembly file says."""

import os
from collections.abc import Sequence
from pathlib import Path

from legwright import _core
from legwright._arguments import path_of
from legwright._errors import InputError, IoError, unreadable
from legwright._files import read_text
from legwright._robot import Robot

MODULES = Path(__file__).parent / 'share/legwright/modules'
"""The library that came with the package."""


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

    Raises:
        InputError: for what is wrong with the assembly, by line and key, or where its robot does
            not stand on legs.
        IoError: where `output` is there already, or something cannot be read or written.
    """
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
    xml, refusal = _core.build_robot(text, file, folders)
    if refusal:
        message = f'its robot is refused and not written; of {refusal}'
        raise InputError(f'{file}: {message}', str(file), 0, '', message)
    made = place.with_name(f'.{place.name}.{os.getpid()}.part')
    try:
        made.write_text(xml, encoding='utf-8', newline='\n')
        os.link(made, place)  # refuses what is there
    except FileExistsError:
        raise IoError(f'{place}: is there already; name another file') from None
    except OSError as error:
        raise IoError(f'{place}: cannot be written: {error.strerror}') from None
    finally:
        made.unlink(missing_ok=True)
    return Robot(place)
