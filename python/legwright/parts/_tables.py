# SPDX-License-Identifier: Apache-2.0
"""Tables of what a robot is made of: for people, and for spreadsheets."""

import csv
import io
from collections.abc import Sequence
from dataclasses import dataclass

from legwright.parts._checks import Check
from legwright.parts._fastened import fastened_words
from legwright.parts._feet import feet_of, socket_size
from legwright.parts._holes import Fixing, Hole
from legwright.parts._robot import BuiltRobot, Module
from legwright.parts._shapes import MM
from legwright.parts._solids import Part, Solid
from legwright.parts._straps import TIE, Strap

TAPE = 'double-sided foam tape'
"""Under what no tie has room for."""


@dataclass(frozen=True)
class Row:
    """A row of the bill of materials."""

    kind: str
    name: str
    count: int
    mass: float | None
    """Of one [g]."""
    volume: float | None
    """Of one [cm3]."""
    note: str
    price: float | None = None
    """Of one, where its module file tells it."""

    @property
    def key(self) -> str:
        """Of its number in the exploded view."""
        return f'{self.kind} {self.name}'


def module_counts(robot: BuiltRobot) -> dict[tuple[str, str, float], int]:
    """How many there are, by kind, name and mass [kg]: a row of the bill each, the first."""
    counts: dict[tuple[str, str, float], int] = {}
    for module in robot.modules:
        key = (module.words.kind, module.words.name, module.words.mass)
        counts[key] = counts.get(key, 0) + 1
    return counts


def bill(robot: BuiltRobot, parts: Sequence[Part], press: float) -> list[Row]:
    """Modules, printed parts, screws, ties, tape; feet with sockets as the press asks [mm]."""
    counts = module_counts(robot)
    trunk = next((part.solid for part in parts if part.solid.link.servo is None), None)
    prices = {(m.words.kind, m.words.name): m.words.price for m in robot.modules}
    feet = _foot_notes(parts, press)
    rows = []
    for (kind, name, mass), count in counts.items():
        note = feet.get(name, '') if kind == 'foot' else ''
        if kind == 'trunk' and trunk is not None:
            mass, note = mass - trunk.mass, 'what else its mass stands for, beside the print'
        rows.append(Row(kind, name, count, MM * mass, None, note, prices[kind, name]))
    for part in parts:
        solid = part.solid
        rows.append(
            Row(
                'printed',
                part.name,
                part.count,
                MM * solid.mass,
                solid.shape.volume() / MM,
                'for ' + ', '.join(part.links),
            )
        )
    return rows + _screws(parts) + _ties(parts) + _tapes(parts)


def screw_of(fixing: Fixing, hole: Hole | None) -> tuple[str, str]:
    """Name and note of the bill's row for a screw; without a hole its pattern is not known."""
    what = f'{fixing.module.words.name}, {fixing.place.name}'
    if hole is None:
        return 'pattern not known', f'{what}: holes to be drilled'
    note = f'{what}: bridges {hole.seat:.1f} mm, and the depth of the thread there'
    return fixing.place.screw or '', note


def is_pressed(solid: Solid, fixing: Fixing) -> bool:
    """Whether a peg holds what is there, and no screw."""
    return any(peg.fixing is fixing for peg in solid.pegs)


def _foot_notes(parts: Sequence[Part], press: float) -> dict[str, str]:
    """Of each foot that stands on a peg, by the name of its module."""
    out = {}
    for name, peg in feet_of([peg for part in parts for peg in part.solid.pegs]).items():
        wide, deep = socket_size(peg, press)
        place = peg.fixing.place.name
        out[name] = f'socket of {wide:.2f} mm, {deep:.1f} mm deep, at its {place}'
    return out


def _screws(parts: Sequence[Part]) -> list[Row]:
    known: dict[tuple[str, str], int] = {}
    unknown: dict[tuple[str, str], int] = {}
    for part in parts:
        on_trunk = part.solid.link.servo is None  # where ties and tape do without screws
        for fixing in part.solid.fixings:
            held = on_trunk or is_pressed(part.solid, fixing)
            if fixing.place.screw is None and not held:
                key = screw_of(fixing, None)
                unknown[key] = unknown.get(key, 0) + part.count
        for hole in part.solid.holes:
            key = screw_of(hole.fixing, hole)
            known[key] = known.get(key, 0) + part.count
    return [
        Row('screw', name, count, None, None, note)
        for (name, note), count in [*known.items(), *unknown.items()]
    ]


def tie_of(strap: Strap) -> str:
    """Name of the bill's row for a cable tie."""
    return f'cable tie {TIE:g} x {strap.length}'


def _ties(parts: Sequence[Part]) -> list[Row]:
    around: dict[str, list[str]] = {}
    for part in parts:
        for strap in part.solid.straps:
            around.setdefault(tie_of(strap), []).append(strap.module.of)
    return [
        Row('tie', name, len(held), None, None, f'or longer, around {", ".join(held)}')
        for name, held in sorted(around.items())
    ]


def is_taped(trunk: Solid, module: Module) -> bool:
    """Whether neither screws that are known nor a tie hold a module on the trunk."""
    screwed = any(hole.fixing.module is module for hole in trunk.holes)
    return not screwed and all(strap.module is not module for strap in trunk.straps)


def _tapes(parts: Sequence[Part]) -> list[Row]:
    held = [
        module.of
        for part in parts
        if not part.solid.link.servo
        for module in part.solid.link.modules
        if is_taped(part.solid, module)
    ]
    note = f'under {", ".join(held)}: no tie has room'
    return [Row('tape', TAPE, len(held), None, None, note)] if held else []


def price_cells(row: Row) -> list[str]:
    """Of one, and of all of them; empty where it is not known."""
    return ['', ''] if row.price is None else [f'{row.price:.2f}', f'{row.count * row.price:.2f}']


_UNPRICED = ('printed', 'screw', 'tie', 'tape', 'trunk')


def _price_words(rows: Sequence[Row]) -> str:
    """The sum, and of how many modules no file tells a price."""
    modules = [row for row in rows if row.kind not in _UNPRICED or row.price]
    known = [row for row in modules if row.price is not None]
    unknown = sum(row.count for row in modules if row.price is None)
    all_of_them = sum(row.count for row in modules)
    if not known:
        return 'No module file gives a price: `price = 23.9` in a file of your own library does.'
    total = sum(row.count * (row.price or 0.0) for row in known)
    rest = f'not known of {unknown} of {all_of_them} modules' if unknown else 'of all modules'
    without = 'printed parts, screws, ties and tape are not in them'
    return f'Prices come to {total:.2f}, {rest}; {without}.'


def bill_csv(rows: Sequence[Row]) -> str:
    """A row each, with empty cells for what is not known."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator='\n')
    head = 'no kind name count mass_g total_mass_g volume_cm3 price total_price note'
    writer.writerow(head.split())
    for number, row in enumerate(rows, 1):
        mass = '' if row.mass is None else f'{row.mass:.4g}'
        total = '' if row.mass is None else f'{row.count * row.mass:.4g}'
        volume = '' if row.volume is None else f'{row.volume:.4g}'
        price, cost = price_cells(row)
        cells = [mass, total, volume, price, cost, row.note]
        writer.writerow([number, row.kind, row.name, row.count, *cells])
    return out.getvalue()


def markdown(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table in Markdown."""
    lines = ['| ' + ' | '.join(head) + ' |', '|' + '---|' * len(head)]
    for row in rows:
        lines.append('| ' + ' | '.join(cell.replace('|', '/') for cell in row) + ' |')
    return '\n'.join(lines) + '\n'


def _mass_rows(parts: Sequence[Part]) -> list[list[str]]:
    rows = []
    for part in parts:
        solid = part.solid
        file, own = MM * solid.file_mass, MM * solid.mass
        overlap = solid.hull_volume - solid.declared.volume()
        density = MM * file / solid.shape.volume() * MM
        rows.append(
            [
                part.name,
                f'{file:.3f}',
                f'{own:.3f}',
                f'{100 * (own - file) / file:+.1f} %',
                f'{overlap:.0f}',
                f'{solid.seat_volume:.0f}',
                f'{solid.hole_volume:.0f}',
                f'{solid.peg_volume:.0f}',
                f'{solid.number_volume:.0f}' if part.mark else 'no room',
                f'{density:.0f}',
            ]
        )
    return rows


_HEAD = [
    'no.',
    'kind',
    'name',
    'count',
    'g each',
    'g',
    'cm3 each',
    'price each',
    'price',
    'note',
]


def _fastened_words(parts: Sequence[Part]) -> str:
    loose = fastened_words(parts)
    return f'{loose}\n' if loose else ''


def bill_markdown(robot: BuiltRobot, parts: Sequence[Part], rows: Sequence[Row]) -> str:
    """The bill, and how far the printed masses are from those that the design was made with."""
    cells = [
        [
            str(number),
            row.kind,
            row.name,
            str(row.count),
            '' if row.mass is None else f'{row.mass:.2f}',
            '' if row.mass is None else f'{row.count * row.mass:.2f}',
            '' if row.volume is None else f'{row.volume:.2f}',
            *price_cells(row),
            row.note,
        ]
        for number, row in enumerate(rows, 1)
    ]
    total = sum(row.count * row.mass for row in rows if row.mass is not None)
    of_file = MM * float(robot.model.body_mass.sum())
    return (
        f'# {robot.name}: bill of materials\n\n'
        + markdown(_HEAD, cells)
        + f'\n{total:.1f} g, without screws, ties and cables; '
        f"the robot's file has {of_file:.1f} g.\n"
        f'{_price_words(rows)}\n\n'
        f'{_fastened_words(parts)}'
        '## Masses of the printed parts\n\n'
        + markdown(
            [
                'part',
                'g in the file',
                'g as printed',
                'difference',
                'overlap, mm3',
                'modules, mm3',
                'holes, mm3',
                'pegs, mm3',
                'number, mm3',
                'kg/m3 for the mass of the file',
            ],
            _mass_rows(parts),
        )
        + '\nThe file weighs each hull by itself: where two overlap, twice. Modules, holes '
        'and the number take material away; "no room": no flat side has room for the number. '
        'Pegs of feet add some. A fill of less than all of the volume is lighter still.\n'
    )


_TOGETHER = {
    'reaches': 'reaches its modules',
    'axis': 'axes on their horns',
    'middle': 'axes through their horns',
    'range': 'ranges of joints',
    'edge': 'edges of holes',
    'screws': 'screws reached',
}


_UNJUDGED = ', not judged'


def check_lines(checks: Sequence[Check]) -> list[str]:
    """What fails, with remedies; what passes in a line for each kind, with its worst part."""
    lines, seen = [], dict[str, list[Check]]()
    for check in checks:
        first = check.name.split()[0]
        name = check.name.removesuffix(_UNJUDGED)
        seen.setdefault(_TOGETHER.get(first, name), []).append(check)
    for title, group in seen.items():
        failed = [check for check in group if not check.passed]
        verdict = 'FAIL' if failed else 'NOTE' if any(each.is_note for each in group) else 'PASS'
        lines.append(f'{verdict}  {title:26} {_judged(group)}')
        told = failed or [check for check in group if check.is_note]
        for check in told:
            if check.is_note:
                lines.append(f'      {check.where}')
                continue
            where = f' ({check.where})' if check.where else ''
            of = f'{check.part}: ' if check.part else ''
            lines.append(f'      {of}{check.name}: {_figure(check)}, {check.limit}{where}')
        for remedy in dict.fromkeys(check.remedy for check in told):
            lines.append(f'      {remedy}')
    return lines


def _figure(check: Check) -> str:
    if check.figure is None:
        return 'no'
    return f'{check.figure:.3g} {check.unit}'.rstrip()


def _judged(group: Sequence[Check]) -> str:
    """The worst of those that were judged, and how many were not; of notes their sum."""
    if all(check.is_note for check in group):
        total = sum(check.figure or 0.0 for check in group)
        return f'{total:g} {group[0].unit}, {group[0].limit}'
    judged = [check for check in group if not check.name.endswith(_UNJUDGED)]
    left = len(group) - len(judged)
    if not left:
        return _worst(group)
    words = f'{left} of {len(group)} not judged: they do not reach their modules'
    return f'{_worst(judged)}; {words}' if judged else words


def _worst(group: Sequence[Check]) -> str:
    told = [check for check in group if check.figure is not None]
    if len(group) == 1 and group[0].passed and not told and group[0].where:
        return group[0].where
    if not told or not all(check.passed for check in group):
        return f'{sum(check.passed for check in group)} of {len(group)}'
    least = told[0].limit.startswith('at least')
    worst = (min if least else max)(told, key=lambda check: check.figure or 0.0)
    worse = 'worst ' if len({check.figure for check in told}) > 1 else ''
    return f'{len(group)} of {len(group)}, {worse}{_figure(worst)}, {worst.limit}'
