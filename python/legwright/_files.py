# SPDX-License-Identifier: Apache-2.0
"""Reads files that somebody else may have written: regular ones of limited size alone.

What is refused raises OSError, as what is not there does.
"""

import errno
import json
import os
import stat
from pathlib import Path
from typing import Any

MOST = 64 << 20
"""Bytes of a text, at most; all these limits are those of the program."""
MOST_OF_TASK = 1 << 20
MOST_OF_ROBOT = 16 << 20  # its MJCF
MOST_OF_ASSET = 256 << 20  # a mesh or a picture
MOST_OF_RUN = 1 << 30  # any file of a run, assets and all
_CHUNK = 1 << 20


def open_regular(file: str | os.PathLike[str]) -> int:
    """A descriptor to read a regular file by. A pipe is not waited for."""
    opened = os.open(file, os.O_RDONLY | os.O_NONBLOCK | os.O_NOCTTY)
    mode = os.fstat(opened).st_mode
    if stat.S_ISREG(mode):
        return opened
    os.close(opened)
    if stat.S_ISDIR(mode):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), os.fspath(file))
    fault = 'is a pipe, a socket or a device; expected a regular file'
    raise OSError(errno.EINVAL, fault, os.fspath(file))


def read_bytes(file: str | os.PathLike[str], most: int = MOST) -> bytes:
    """What a regular file holds."""
    data = bytearray()
    with open(open_regular(file), 'rb', buffering=0) as stream:
        while chunk := stream.read(_CHUNK):
            data += chunk
            if len(data) > most:
                raise OSError(errno.EFBIG, f'larger than {most >> 20} MiB', os.fspath(file))
    return bytes(data)


def read_text(file: str | os.PathLike[str], most: int = MOST) -> str:
    """Its text. Raises UnicodeDecodeError, a ValueError, where it is no UTF-8."""
    return read_bytes(file, most).decode('utf-8')


def read_json(file: Path) -> Any:
    """Its document. Raises ValueError where it is none, or one that nests too deep to be read."""
    return json_of(read_bytes(file), file)


def json_of(data: bytes, file: Path) -> Any:
    """The document that a file holds. Raises as read_json()."""
    try:
        return json.loads(data)
    except ValueError as error:
        raise ValueError(f'{file}: is damaged, it is no JSON ({error})') from None
    except RecursionError:
        raise ValueError(f'{file}: its JSON nests too deep to be read') from None
