# SPDX-License-Identifier: Apache-2.0
"""Where nothing holds a part to a module: no screw whose pattern is known, and no peg."""

from collections.abc import Sequence
from dataclasses import dataclass

from legwright.parts._checks import Check
from legwright.parts._holes import Fixing
from legwright.parts._robot import Module
from legwright.parts._solids import Part, Solid

_SHOWN = 6  # names of places; more are counted


@dataclass(frozen=True)
class Loose:
    """Modules of one kind at which parts end without being fastened."""

    module: str
    """Name of the module, by which its file is found."""
    side: str
    """`horn` or `body`."""
    attachments: tuple[str, ...]
    """That parts cover there."""
    of: tuple[str, ...]
    """The modules of the robot, one a place."""


def is_held(solid: Solid, fixing: Fixing) -> bool:
    """Whether screws or a peg hold the solid there."""
    screwed = any(hole.fixing is fixing for hole in solid.holes)
    return screwed or any(peg.fixing is fixing for peg in solid.pegs)


def is_fastened(solid: Solid, module: Module) -> bool:
    """Whether the solid of a link is held to a module at one of its attachments at least."""
    return any(each.module is module and is_held(solid, each) for each in solid.fixings)


def _joined(solid: Solid) -> list[Module]:
    """The modules that a link's solid covers: its servo's horn, and what stands on it."""
    return list({id(each.module): each.module for each in solid.fixings}.values())


def _links(parts: Sequence[Part]) -> list[Solid]:
    """Ties and tape hold what is on the trunk: links alone."""
    return [each for part in parts for each in part.solids if each.link.servo is not None]


def places(parts: Sequence[Part]) -> int:
    """At how many places links end at modules."""
    return sum(len(_joined(solid)) for solid in _links(parts))


def loose_places(parts: Sequence[Part]) -> list[Loose]:
    """Of which modules no pattern is known where links end at them, by module and side."""
    found: dict[tuple[str, str], tuple[dict[str, None], list[str]]] = {}
    for solid in _links(parts):
        for module in _joined(solid):
            if is_fastened(solid, module):
                continue
            names = [each.place.name for each in solid.fixings if each.module is module]
            side = 'horn' if module is solid.link.servo else 'body'
            attachments, of = found.setdefault((module.words.name, side), ({}, []))
            attachments.update(dict.fromkeys(names))
            of.append(module.of)
    return [Loose(*key, tuple(names), tuple(of)) for key, (names, of) in found.items()]


def place_words(loose: Loose) -> str:
    """How many, of which module, and where."""
    count = len(loose.of)
    shown = ', '.join(loose.of[:_SHOWN])
    more = f' and {count - _SHOWN} more' if count > _SHOWN else ''
    return (
        f'{loose.module} at its {loose.side} ({", ".join(loose.attachments)}): {count} '
        f'{"place" if count == 1 else "places"}, {shown}{more}'
    )


def cure_of(loose: Loose) -> str:
    """What fastens it."""
    names = ' or '.join(loose.attachments)
    return (
        f'no screw pattern in the module file of {loose.module}: add screws = "M2", or what it '
        f'has, with circle and count, or holes, under its [[attachment]] {names} and build the '
        'robot anew, or drill or glue there'
    )


def check_fastened(parts: Sequence[Part]) -> list[Check]:
    """A note for each kind of module that nothing holds; else that all are held.

    No failure: one may drill, or glue.
    """
    all_of_them, loose = places(parts), loose_places(parts)
    if not loose:
        words = f'all {all_of_them} places where links end at modules, by screws or pegs'
        return [Check('', 'fastened', True, None, '', '', words)]
    unit, limit = f'of {all_of_them} places', 'by screws of a known pattern, or a peg'
    return [
        Check(
            '', 'not fastened', True, len(each.of), unit, limit, place_words(each), cure_of(each),
            is_note=True,
        )
        for each in loose
    ]  # fmt: skip


def fastened_words(parts: Sequence[Part]) -> str:
    """A paragraph in Markdown for the sheets; empty where all is fastened."""
    loose = loose_places(parts)
    if not loose:
        return ''
    count = sum(len(each.of) for each in loose)
    lines = ''.join(f'- {place_words(each)}; {cure_of(each)}.\n' for each in loose)
    head = f'**Not fastened: {count} of {places(parts)} places where links end at modules.**'
    return f'{head}\n\n{lines}'
