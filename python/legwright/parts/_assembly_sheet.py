# SPDX-License-Identifier: Apache-2.0
"""The assembly sheet: a section for the trunk and for each limb, with steps in their order."""

from collections.abc import Mapping, Sequence

from legwright.parts._fastened import fastened_words, is_fastened
from legwright.parts._holes import Fixing, Hole
from legwright.parts._limb_views import limb_scene, number_of, trunk_scene
from legwright.parts._limbs import Limb, Piece, limbs_of, trunk_steps
from legwright.parts._reach import cut_by_slots, slot_words
from legwright.parts._robot import BuiltRobot, Module
from legwright.parts._solids import Part, Solid
from legwright.parts._tables import (
    TAPE,
    Row,
    is_pressed,
    is_taped,
    markdown,
    screw_of,
    tie_of,
)

SHEET = 'assembly.md'
_TRUNK = 'trunk'
_WORDS = """
Numbers are those of the rows of the bill of materials (`bom.md`), and of the pictures; printed
parts have theirs engraved where there is room. Screws are told with the attachment that they are
for, and with what they bridge until they are in the module: add the depth of its thread. "Not
known" is a pattern that no module file tells: holes are to be drilled there. **Not fastened** is
what is held at none of its attachments.
"""


class _Sheet:
    def __init__(self, rows: Sequence[Row]) -> None:
        self._screws = {
            (row.name, row.note): number
            for number, row in enumerate(rows, 1)
            if row.kind == 'screw'
        }
        self.numbers = {row.key: number for number, row in enumerate(rows, 1)}

    def _of_fixing(self, solid: Solid, fixing: Fixing) -> str:
        if is_pressed(solid, fixing):
            return f'{fixing.place.name}: none, it is pressed on its peg'
        holes = [hole for hole in solid.holes if hole.fixing is fixing]
        if not holes:
            number = self._screws.get(screw_of(fixing, None))
            row = '' if number is None else f' (no. {number})'
            return f'{fixing.place.name}: not known{row}'
        seats = sorted({f'{hole.seat:.1f}' for hole in holes}, key=float)
        of = ' to '.join(dict.fromkeys([seats[0], seats[-1]]))
        name = screw_of(fixing, holes[0])[0]
        rows = self._rows_of(fixing, holes)
        return f'{fixing.place.name}: {len(holes)} x {name}, bridging {of} mm ({rows})'

    def _rows_of(self, fixing: Fixing, holes: Sequence[Hole]) -> str:
        """The rows of the bill that have the screws of an attachment, with how many of each."""
        counts: dict[int, int] = {}
        for hole in holes:
            number = self._screws[screw_of(fixing, hole)]
            counts[number] = counts.get(number, 0) + 1
        if len(counts) == 1:
            return f'no. {min(counts)}'
        return ', '.join(f'{counts[number]} of no. {number}' for number in sorted(counts))

    def screws(self, solid: Solid, module: Module) -> str:
        """What fixes a solid to a module, by attachments."""
        found = [f for f in solid.fixings if f.module is module]
        if not found:
            cut = slot_words(cut_by_slots(solid, module))
            return f'nothing: {cut}' if cut else 'nothing: the part does not reach it'
        ways = '; '.join(self._of_fixing(solid, fixing) for fixing in found)
        return ways if is_fastened(solid, module) else f'**not fastened**, {ways}'

    def held(self, trunk: Solid, module: Module) -> str:
        """What fixes a module to the trunk."""
        found = [f for f in trunk.fixings if f.module is module and f.place.screw is not None]
        ways = [self._of_fixing(trunk, fixing) for fixing in found]
        for strap in trunk.straps:
            if strap.module is module:
                name = tie_of(strap)
                number = self.numbers[f'tie {name}']
                ways.append(f'{name} (no. {number}), over it and through the slots beside it')
        if is_taped(trunk, module):
            ways.append(f'{TAPE} (no. {self.numbers[f"tape {TAPE}"]}) under it: no tie has room')
        return '; '.join(ways)

    def table(self, lines: Sequence[Sequence[str]]) -> str:
        return markdown(['step', 'no.', 'what', 'goes', 'held by'], lines)


def _kind(module: Module) -> str:
    return f'{module.words.kind} {module.words.name}'


def _trunk_lines(sheet: _Sheet, steps: Sequence[Piece | Module]) -> list[list[str]]:
    base = next((step.solid for step in steps if isinstance(step, Piece)), None)
    lines = []
    for count, step in enumerate(steps, 1):
        number = str(number_of(step, sheet.numbers))
        if isinstance(step, Piece):
            lines.append([str(count), number, f'{step.part.name}.stl', 'open side up', ''])
            continue
        servo = step.words.kind == 'servo'
        goes = f'from above into {"its cradle" if servo else "the trunk"}, as {step.of}'
        if base is None:
            goes = f'on the trunk, as {step.of}'
        held = sheet.held(base, step) if base else ''
        lines.append([str(count), number, _kind(step), goes, held])
    return lines


def _limb_lines(sheet: _Sheet, limb: Limb) -> list[list[str]]:
    lines, carrier = [], None
    for count, step in enumerate(limb.steps, 1):
        number = str(number_of(step, sheet.numbers))
        if isinstance(step, Piece):
            servo = step.solid.link.servo
            goes = f'on the horn of {servo.of}' if servo else ''
            screws = sheet.screws(step.solid, servo) if servo else ''
            carrier = step.solid
            lines.append(
                [str(count), number, f'{step.solid.link.name}: {step.part.name}.stl', goes, screws]
            )
            continue
        if carrier is None:
            lines.append([str(count), number, _kind(step), f'is {step.of}, on the trunk', ''])
            continue
        goes = f'on {carrier.link.name}, as {step.of}'
        screws = sheet.screws(carrier, step)
        lines.append([str(count), number, _kind(step), goes, screws])
    return lines


def assembly_files(
    robot: BuiltRobot, parts: Sequence[Part], rows: Sequence[Row]
) -> tuple[dict[str, bytes], list[str]]:
    """assembly.md and the scenes of its pictures, by name; and the names of the pictures.

    A section is the trunk's or a limb's: an exploded picture, and steps in the order in which they
    are done.
    """
    sheet = _Sheet(rows)
    numbers: Mapping[str, int] = sheet.numbers
    steps = trunk_steps(robot, parts)
    scenes = {_TRUNK: trunk_scene(robot, steps, numbers)} if steps else {}
    sections = [(_TRUNK, _trunk_lines(sheet, steps))] if steps else []
    for limb in limbs_of(robot, parts):
        scenes[limb.name] = limb_scene(robot, limb, numbers)
        sections.append((limb.name, _limb_lines(sheet, limb)))
    text = f'# {robot.name}: assembly\n{_WORDS}'
    if loose := fastened_words(parts):
        text += f'\n{loose}'
    for name, lines in sections:
        picture = f'exploded_{name}.png'
        text += f'\n## {name}\n\n![{name}, moved apart]({picture})\n\n{sheet.table(lines)}'
    files = {f'exploded_{name}.xml': scene.encode() for name, scene in scenes.items()}
    files[SHEET] = text.encode()
    return files, [f'exploded_{name}.png' for name in scenes]
