# SPDX-License-Identifier: Apache-2.0
"""Strict reading of what `legwright build` declares of modules and connectors in a robot's file."""

from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray

from legwright._errors import InputError, together, unreadable
from legwright._files import MOST_OF_ROBOT, read_bytes

Array = NDArray[np.float64]
MODULE, CONNECTOR = 'legwright_module/', 'legwright_connector/'
_PRINT = 'legwright_print'
SCREW_SIZES = ('M1.6', 'M2', 'M2.5', 'M2.6', 'M3', 'M4', 'M5', 'M6')
_CURE = '`legwright build` writes it: build the robot anew, or put back what was changed'


@dataclass(frozen=True)
class Place:
    """An attachment of a module, from the origin of its body or geom [m]."""

    name: str
    on_horn: bool
    position: Array
    normal: Array
    screw: str | None
    """Size of its screws, "M2"; None where the pattern is not known."""
    holes: Array
    """N x 3: where they go in [m]."""


@dataclass(frozen=True)
class ModuleWords:
    """What the file says of a module."""

    of: str
    sort: str
    """`body` or `geom`: what `of` is the name of."""
    name: str
    kind: str
    mass: float
    """[kg]"""
    joint: str | None
    """That a servo turns."""
    price: float | None
    """Of one, in the currency of all of them; None where no file tells it."""
    cable: tuple[str, ...]
    """Names of the attachments at which cables leave."""
    places: tuple[Place, ...]


@dataclass(frozen=True)
class ConnectorWords:
    """What the file says of a connector: its mesh, shown by a body of the same name."""

    name: str
    density: float
    """[kg/m3]"""
    corners: Array
    """N x 3 in its body's frame [m]."""


@dataclass(frozen=True)
class RobotWords:
    """The declarations of a robot."""

    modules: tuple[ModuleWords, ...]
    connectors: tuple[ConnectorWords, ...]
    bed: tuple[float, float] | None
    """That [print] in its assembly gave [m]; None without [print]."""
    margin: float | None
    """That it leaves free at each side of the bed [m]; None where it does not tell."""


def _numbers(words: str) -> Array:
    """Raises ValueError where one is none, or not finite."""
    out = np.array([float(word) for word in words.split()], dtype=float)
    if not np.all(np.isfinite(out)):
        raise ValueError(words)
    return out


def _place(part: str) -> Place:
    head, colon, numbers = part.partition(':')
    words, found = head.split(), _numbers(numbers)
    screw = words[2] if len(words) == 3 else None
    if (
        not colon
        or len(words) not in (2, 3)
        or words[0] not in ('body', 'horn')
        or (screw is not None and screw not in SCREW_SIZES)
        or found.size % 3
        or (found.size != 6 if screw is None else found.size < 9)
    ):
        raise ValueError(part)
    rows = found.reshape(-1, 3)
    if abs(np.linalg.norm(rows[1]) - 1) > 1e-6:
        raise ValueError(part)
    return Place(words[1], words[0] == 'horn', rows[0], rows[1], screw, rows[2:])


def _taken(rest: list[str], word: str) -> str | None:
    """What follows that word, where it comes first; it is no longer in the rest."""
    return rest.pop(0).removeprefix(word) if rest and rest[0].startswith(word) else None


def _module(of: str, data: str) -> ModuleWords:
    parts = [part.strip() for part in data.split('|')]
    name, kind, mass, unit = parts[0].split()
    sort, _, holder = parts[1].partition(' ') if len(parts) > 1 else ('', '', '')
    if unit != 'kg' or sort not in ('body', 'geom') or holder != of:
        raise ValueError(data)
    if not _numbers(mass)[0] > 0:
        raise ValueError(data)
    rest = parts[2:]
    joint, price = _taken(rest, 'joint '), _taken(rest, 'price ')
    cable = tuple((_taken(rest, 'cable ') or '').split())
    cost = None if price is None else float(_numbers(price)[0])
    if cost is not None and cost < 0:
        raise ValueError(data)
    places = tuple(_place(part) for part in rest)
    if not set(cable) <= {place.name for place in places if not place.on_horn}:
        raise ValueError(data)
    weight = float(_numbers(mass)[0])
    return ModuleWords(of, sort, name, kind, weight, joint, cost, cable, places)


def _connector(name: str, data: str, meshes: dict[str, str]) -> ConnectorWords:
    density, unit = data.partition('|')[0].split()
    corners = _numbers(meshes[name])
    if unit != 'kg/m3' or not _numbers(density)[0] > 0 or corners.size % 3 or corners.size < 12:
        raise ValueError(data)
    return ConnectorWords(name, float(density), corners.reshape(-1, 3))


def _bed(data: str) -> tuple[tuple[float, float], float | None]:
    """Its sides, and the margin: files of older programs have none."""
    first, _, rest = data.partition(' margin ')
    word, *sides, unit = first.split()
    found = _numbers(' '.join(sides))
    if word != 'bed' or unit != 'm' or found.size != 2 or not np.all(found > 0):
        raise ValueError(data)
    if not rest:
        return (float(found[0]), float(found[1])), None
    value, unit = rest.split()
    margin = float(_numbers(value)[0])
    if unit != 'm' or margin < 0:
        raise ValueError(data)
    return (float(found[0]), float(found[1])), margin


def _refuse_linear(file: Path, modules: list[ModuleWords]) -> None:
    """Raises InputError for a robot with linear actuators, naming what of it is not printed."""
    joints = [module.joint for module in modules if module.kind == 'linear']
    if not joints:
        return
    names = ', '.join(str(joint) for joint in joints)
    message = (
        f'has linear actuators at {names}: the links above and below these joints are capsules '
        'with arms to the pivots, for which no printable parts are made, nor are hinges; so no '
        'part of this robot is. Draw those links yourself, or let servos turn these joints'
    )
    raise InputError(f'{file}: {message}', str(file), 0, '', message)


def read_words(file: Path) -> RobotWords:
    """The declarations of a robot's file.

    Raises IoError where it cannot be read, InputError where it has linear actuators, no connector,
    or one of its declarations is not as `legwright build` writes it: all that are wrong at once.
    """
    try:
        root = ElementTree.fromstring(read_bytes(file, MOST_OF_ROBOT))
    except OSError as error:
        raise unreadable(file, error, 'give a run folder or the MJCF of a robot') from None
    except ElementTree.ParseError as error:
        raise InputError(f'{file}: is no XML ({error}); give the MJCF of a robot') from None
    meshes = {
        mesh.get('name', ''): mesh.get('vertex', '') for mesh in root.iterfind('./asset/mesh')
    }
    modules: list[ModuleWords] = []
    connectors: list[ConnectorWords] = []
    wrong: list[InputError] = []
    bed: tuple[float, float] | None = None
    margin: float | None = None
    for text in root.iterfind('./custom/text'):
        name, data = text.get('name', ''), text.get('data', '')
        try:
            if name == _PRINT:
                bed, margin = _bed(data)
            elif name.startswith(MODULE):
                modules.append(_module(name.removeprefix(MODULE), data))
            elif name.startswith(CONNECTOR):
                connectors.append(_connector(name.removeprefix(CONNECTOR), data, meshes))
        except (ValueError, KeyError):
            where = f'text {name}'
            message = f"attribute data: '{data[:60]}…' is not what parts need; {_CURE}"
            wrong.append(InputError(f'{file}: {where}: {message}', str(file), 0, where, message))
    if wrong:
        raise together(wrong)
    _refuse_linear(file, modules)
    if not connectors:
        message = (
            'has no connector, so there is nothing to print: `legwright build assembly.toml -o '
            'robot.xml` makes robots that have some ([link] shape = "hull", the default)'
        )
        raise InputError(f'{file}: {message}', str(file), 0, '', message)
    if not modules:
        message = (
            'does not say of which modules it is made: it was built by an older Legwright; build '
            'it anew from its assembly, and optimize that'
        )
        raise InputError(f'{file}: {message}', str(file), 0, '', message)
    return RobotWords(tuple(modules), tuple(connectors), bed, margin)
