# SPDX-License-Identifier: Apache-2.0
"""The print sheet: how each part lies on the bed, and what that costs."""

import math
from collections.abc import Sequence

from legwright.parts._checks import Check
from legwright.parts._options import PartOptions
from legwright.parts._shapes import MM
from legwright.parts._solids import Part
from legwright.parts._tables import markdown

_CURE = 'a larger printer (--bed), or a smaller upper bound of that length'
_CURE_OF_MARGIN = '; a printer that needs no skirt has a smaller margin (--margin)'
_RULES = """
Sizes are of the box of a part as its STL lies, which is how it is to be printed. Of the flat sides
of its hull on which it stands firm that side is down which leaves the least area looking down by
more than 45°. Firm is what touches at least a twentieth of its box and half the square of its
height; where none does, that side is down which touches most by the square of its height: such a
part is better printed with a brim. Sides on which the part would be higher than half its length
come last, as layers across a part are where it breaks.
Wall is the least thickness that the checks found. Support is 15 % of the room between such areas
and the bed. Time is volume and support by 4 mm³/s and 3 s for each layer of 0.2 mm: a rule to
compare parts by, no slicer's figure. Mass is of part and support, filled, at the density that the
robot was designed with. What fits leaves that margin at each side of the bed, where skirt, brim and
clips are.
"""


def _sizes(values: Sequence[float]) -> str:
    return ' x '.join(f'{value:.1f}' for value in values)


def _bed_words(options: PartOptions) -> str:
    """Of the bed and its margin [mm]."""
    return f'{_sizes(options.bed_for(None))} mm, {options.margin_for(None):.3g} mm left free'


def _fits(part: Part, options: PartOptions) -> str:
    """Whether it fits, and what is left beside it where the margin alone is too little."""
    bed = options.bed_for(None)
    if part.lying.fits(bed, options.margin_for(None)):
        return 'yes'
    if not part.lying.fits(bed):
        return 'NO'
    return f'NO, {abs(part.lying.room(bed)):.1f} mm left at a side'


def _direction(part: Part) -> str:
    return ' '.join(f'{value + 0.0:.2f}' for value in part.lying.down)


def _minutes(seconds: float) -> str:
    return f'{seconds / 60:.0f}'


def _grams(part: Part) -> float:
    """Of one, with its support."""
    return part.solid.density * (part.solid.shape.volume() + part.lying.support) / MM**2


def _total_words(parts: Sequence[Part]) -> str:
    pieces = sum(part.count for part in parts)
    hours = sum(part.count * part.lying.seconds for part in parts) / 3600
    grams = sum(part.count * _grams(part) for part in parts)
    support = sum(part.count * part.lying.support for part in parts) / MM
    return (
        f'{pieces} pieces, {hours:.1f} h and {grams:.0f} g together, {support:.1f} cm3 of it '
        'support.\n'
    )


def prints_markdown(
    name: str, parts: Sequence[Part], checks: Sequence[Check], options: PartOptions
) -> str:
    """A table of all parts, with the rules by which it was made; walls are those of the checks."""
    walls = {check.part: check.figure for check in checks if check.name == 'wall'}
    rows = []
    for part in parts:
        lying = part.lying
        rows.append(
            [
                str(part.number),
                part.name,
                str(part.count),
                _sizes(lying.size),
                _direction(part),
                f'{lying.contact:.0f}',
                f'{lying.overhang:.0f}',
                f'{walls[part.name] or math.nan:.1f}',
                f'{lying.support:.0f}',
                f'{_grams(part):.1f}',
                _minutes(lying.seconds),
                _fits(part, options),
            ]
        )
    head = [
        'no.',
        'part',
        'count',
        'size, mm',
        'down, in its link',
        'on the bed, mm2',
        'overhang, mm2',
        'wall, mm',
        'support, mm3',
        'g each',
        'min each',
        f'fits {_bed_words(options)}',
    ]
    return (
        f'# {name}: print sheet\n\n{markdown(head, rows)}\n'
        f'{_total_words(parts)}{_RULES}'
    )


def check_bed(parts: Sequence[Part], options: PartOptions) -> list[Check]:
    """Each part on the bed as it lies, within the margin."""
    bed = options.bed_for(None)
    out = []
    for part in parts:
        good = part.lying.fits(bed, options.margin_for(None))
        largest = float(max(part.lying.size))
        where, cure = _sizes(part.lying.size) + ' mm', _CURE
        if part.lying.fits(bed):
            where += f', {abs(part.lying.room(bed)):.1f} mm left at a side'
            cure += _CURE_OF_MARGIN
        out.append(
            Check(
                part.name,
                'size on the bed',
                good,
                largest,
                'mm',
                f'in {_bed_words(options)} at each side',
                where,
                '' if good else cure,
            )
        )
    return out

