# SPDX-License-Identifier: Apache-2.0
"""A robot's limbs: what each is put together of, in order."""

import re
from collections.abc import Sequence
from dataclasses import dataclass

from legwright.parts._robot import BuiltRobot, Module
from legwright.parts._solids import Part, Solid

_FILE_NAME = re.compile(r'[A-Za-z0-9_-]+')


@dataclass(frozen=True)
class Piece:
    """A printed solid, and the part that it is."""

    part: Part
    solid: Solid


@dataclass(frozen=True)
class Limb:
    """From the servo that stands on the trunk to the foot."""

    name: str
    """By which a file may be called."""
    steps: tuple[Piece | Module, ...]
    """In the order of assembly: the servo on the trunk, then each link and what it carries."""


def trunk_steps(robot: BuiltRobot, parts: Sequence[Part]) -> list[Piece | Module]:
    """The printed trunk, if there is one, then what stands on it."""
    out: list[Piece | Module] = []
    own = [m for m in robot.modules if m.body == robot.trunk and m.words.kind != 'trunk']
    for part in parts:
        out += [Piece(part, solid) for solid in part.solids if solid.link.body == robot.trunk]
    return out + own


def _root(robot: BuiltRobot, body: int) -> int:
    """The body next to the trunk that a body hangs on."""
    parent = int(robot.model.body_parentid[body])
    while parent not in (0, robot.trunk):
        body, parent = parent, int(robot.model.body_parentid[parent])
    return body


def limbs_of(robot: BuiltRobot, parts: Sequence[Part]) -> list[Limb]:
    """The limbs that have printed links, in the order of the file.

    Each is called after its foot, else after its first link.
    """
    pieces = {s.link.body: Piece(p, s) for p in parts for s in p.solids if s.link.servo}
    out: list[Limb] = []
    for root in dict.fromkeys(_root(robot, body) for body in sorted(pieces)):
        bodies = [body for body in sorted(pieces) if _root(robot, body) == root]
        first = pieces[bodies[0]].solid.link
        steps: list[Piece | Module] = []
        for body in bodies:
            piece = pieces[body]
            servo = piece.solid.link.servo
            if servo is not None and all(servo is not step for step in steps):
                steps.append(servo)
            steps += [piece, *piece.solid.link.modules]
        feet = [s.of for s in steps if isinstance(s, Module) and s.words.kind == 'foot']
        name = feet[0] if feet and _FILE_NAME.fullmatch(feet[0]) else first.name
        if name in [limb.name for limb in out]:
            name = f'{name}_{len(out) + 1}'
        out.append(Limb(name, tuple(steps)))
    return out
