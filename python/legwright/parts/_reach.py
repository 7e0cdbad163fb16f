# SPDX-License-Identifier: Apache-2.0
"""Whether a part reaches what it is fixed to, and what mends it where it does not."""

import math
from collections.abc import Sequence

import numpy as np

from legwright.parts._checks import Check
from legwright.parts._holes import REACH, gap_before, is_covered
from legwright.parts._robot import Module
from legwright.parts._shapes import MM, joined, outline
from legwright.parts._slots import cable_places, slot_before
from legwright.parts._solids import Solid

_STANDS = 50.0
"""Area of what a module stands on, at least [mm2]."""
_UNDER = 0.5  # [mm]: what begins within that is what it stands on


def _cure(solid: Solid, module: Module, is_horn: bool) -> str:
    """By what the module is, and what carries it."""
    name, kind = module.words.name, module.words.kind
    if not any(place.on_horn == is_horn for place in module.places):
        side, on = ('horn', ', on = "horn"') if is_horn else ('body', '')
        return (
            f'{name} has no attachment on its {side}: its module file needs an [[attachment]] '
            f'there (name, position, normal{on}); then build the robot anew'
        )
    on_trunk = solid.link.servo is None
    if kind == 'servo' and on_trunk:
        return (
            'no attachment of it is covered: put the hip (hip or step of its [[limb]] in the '
            "assembly) nearer to the trunk's box, or give that another size under [trunk]"
        )
    if kind == 'servo':
        return (
            'no attachment of it is covered: move that joint further away (offset in the '
            'assembly), or turn its servo by roll, so that its connector need not be pulled back'
        )
    if on_trunk:
        return (
            'no attachment of it is covered, and it does not stand on the tray: material must '
            f'begin within {REACH:g} mm before one, or right under it at both sides of its middle; '
            'move it over the tray, to its floor or side (position of its [[part]] in the '
            'assembly), or give the trunk another size under [trunk]'
        )
    return (
        'no attachment of it is covered: move it further away (foot_offset of its [[limb]] in the '
        'assembly), so that its connector need not be pulled back'
    )


def cut_by_slots(solid: Solid, module: Module) -> list[tuple[str, Module, str]]:
    """Attachments of a module on a solid that it would cover, were there no slot for a cable.

    Of each its name, whose cable it is, and the attachment at which that leaves.
    """
    own = solid.link.modules
    slots = [(each, place) for each in own for place in cable_places(each)]
    if not slots:
        return []
    whole = solid.declared - joined([outline(each) for each in own])
    out = []
    for each, place in slots:
        filled = solid.shape + (whole ^ slot_before(place))
        out += [
            (held.name, each, place.name)
            for held in module.places
            if not held.on_horn and is_covered(filled, MM * held.position, held.normal)
        ]
    return out


def slot_words(cut: Sequence[tuple[str, Module, str]]) -> str:
    """What cuts it away, for people."""
    found = [
        f'what would hold it at its {held} is cut away by the slot for the cable of {of.of} at '
        f'its {side}'
        for held, of, side in cut
    ]
    return '; '.join(found)


def _slot_cure(cut: Sequence[tuple[str, Module, str]]) -> str:
    """What mends that: the cable leaves where nothing is held, or something is held elsewhere."""
    names = ' or '.join(dict.fromkeys(of.words.name for _, of, _ in cut))
    sides = ' and '.join(dict.fromkeys(side for _, _, side in cut))
    return (
        f'the slot for a cable cuts away what would hold it: let the cable leave elsewhere than at '
        f'{sides} (cable in the module file of {names}), or turn that servo by roll, so that '
        'another of its sides is held; then build the robot anew'
    )


def _nearest(solid: Solid, module: Module) -> str:
    """Where material begins before the attachments of what stands on the solid."""
    places = [place for place in module.places if not place.on_horn]
    gaps = [(gap_before(solid.shape, place), place.name) for place in places]
    gap, name = min(gaps, default=(math.inf, ''))
    return f'nearest {gap:.1f} mm before {name}' if math.isfinite(gap) else ''


def stands_on(solid: Solid, module: Module) -> float:
    """The area on which a module stands on the trunk [mm2].

    0 where it would fall over: where its middle is not over the box of what is under it.
    """
    if not module.shapes:
        return 0.0
    body = outline(module)
    x0, y0, low, x1, y1, _ = body.bounding_box()
    top = solid.shape.trim_by_plane((0, 0, -1), -low).trim_by_plane((0, 0, 1), low - _UNDER)
    under = top ^ body.translate((0, 0, -_UNDER))
    if under.is_empty():
        return 0.0
    box, middle = np.array(under.bounding_box()), np.array([(x0 + x1) / 2, (y0 + y1) / 2])
    is_over = (box[:2] < middle).all() and (middle < box[3:5]).all()
    return float(under.volume()) / _UNDER if is_over else 0.0


def _standing(solid: Solid, module: Module) -> str:
    """In words, of what rides on the trunk beside its attachments; empty where it does not."""
    if solid.link.servo is not None or module.words.kind == 'servo':
        return ''
    area = stands_on(solid, module)
    return f'stands on {area:.0f} mm2' if area >= _STANDS else ''


def reaches(solid: Solid, part: str) -> list[Check]:
    """Whether it reaches the horn that turns it, and each module on its link."""
    wanted = [(each, False) for each in solid.link.modules]
    if solid.link.servo:
        wanted.append((solid.link.servo, True))
    out = []
    for module, is_horn in wanted:
        found = [
            fixing.place.name
            for fixing in solid.fixings
            if fixing.module.of == module.of and fixing.place.on_horn == is_horn
        ]
        standing = '' if found or is_horn else _standing(solid, module)
        good = bool(found or standing)
        where = standing or ', '.join(found)
        cure = '' if good else _cure(solid, module, is_horn)
        if not good and not is_horn:
            where = _nearest(solid, module)
            if cut := cut_by_slots(solid, module):
                where, cure = slot_words(cut), _slot_cure(cut)
        out.append(
            Check(
                part,
                f'reaches the horn of {module.of}' if is_horn else f'reaches {module.of}',
                good,
                float(len(found) or bool(standing)),
                'attachments',
                'at least 1',
                where,
                cure,
            )
        )
    return out
