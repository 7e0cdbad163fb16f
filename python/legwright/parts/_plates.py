# SPDX-License-Identifier: Apache-2.0
"""Where parts lie on plates of the printer's bed: in rows, the deepest first."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from legwright.parts._mesh_files import Item, Place, threemf_bytes
from legwright.parts._solids import Part

SPACE = 5.0  # [mm] between parts
STRIDE = 1.2  # times the bed's width: from plate to plate in all.3mf
_ROUNDING = 1e-6  # [mm]


@dataclass
class _Row:
    """Parts beside each other on a plate [mm]."""

    plate: int
    y: float
    deep: float
    used: float = 0.0


@dataclass(frozen=True)
class _Copy:
    """A copy of a part on a plate, by the lower corner of its box [mm]."""

    part: int
    plate: int
    x: float
    y: float
    size: tuple[float, float]
    """Of its box there."""
    turned: bool
    """By a quarter."""


class _Packing:
    """Rows on plates that are filled one after the other; each part in the first that has room."""

    def __init__(self, wide: float, deep: float) -> None:
        self._wide, self._deep = wide + _ROUNDING, deep + _ROUNDING
        self._rows: list[_Row] = []
        self._ends: list[float] = []  # of the rows on each plate

    def put(self, wide: float, deep: float) -> tuple[int, float, float]:
        """Plate, x and y of the next one."""
        row = next((r for r in self._rows if self._has_room(r, wide, deep)), None)
        if row is None:
            row = self._new_row(wide, deep)
        x = row.used
        row.used += wide + SPACE
        if wide > self._wide or deep > self._deep:
            row.used = self._ends[row.plate] = math.inf  # nothing beside it
        return row.plate, x, row.y

    def _has_room(self, row: _Row, wide: float, deep: float) -> bool:
        return row.used + wide <= self._wide and deep <= row.deep

    def _new_row(self, wide: float, deep: float) -> _Row:
        ends = self._ends
        is_small = deep <= self._deep and wide <= self._wide
        free = [k for k, end in enumerate(ends) if is_small and end + deep <= self._deep]
        plate = free[0] if free else len(ends)
        if plate == len(ends):
            ends.append(0.0)
        row = _Row(plate, ends[plate], deep)
        ends[plate] += deep + SPACE
        self._rows.append(row)
        return row


def _packed(parts: Sequence[Part], bed: Sequence[float]) -> list[_Copy]:
    """All copies; what is larger than the room on the bed has a plate of its own."""
    copies = []
    for number, part in enumerate(parts):
        x, y = (float(side) for side in part.mesh.vertices.max(axis=0)[:2])
        turned = (x > bed[0] or y > bed[1]) and y <= bed[0] and x <= bed[1]
        copies += [(number, (y, x) if turned else (x, y), turned)] * part.count
    copies.sort(key=lambda each: (-each[1][1], -each[1][0], each[0]))
    packing = _Packing(bed[0], bed[1])
    return [
        _Copy(number, *packing.put(*size), size=size, turned=turned)
        for number, size, turned in copies
    ]


def _centred(copies: Sequence[_Copy], bed: Sequence[float], stride: float) -> list[_Copy]:
    """Each plate's in the middle of its bed; plates beside each other by that [mm]."""
    out = []
    for plate in sorted({copy.plate for copy in copies}):
        own = [copy for copy in copies if copy.plate == plate]
        x = (bed[0] - max(copy.x + copy.size[0] for copy in own)) / 2 + plate * stride
        y = (bed[1] - max(copy.y + copy.size[1] for copy in own)) / 2
        out += [_Copy(c.part, plate, c.x + x, c.y + y, c.size, c.turned) for c in own]
    return out


def _items(parts: Sequence[Part], copies: Sequence[_Copy]) -> list[Item]:
    """Parts that have copies, each with its places."""
    items = []
    for number, part in enumerate(parts):
        places = [
            Place(copy.x + (copy.size[0] if copy.turned else 0.0), copy.y, 0.0, copy.turned)
            for copy in copies
            if copy.part == number
        ]
        if places:
            items.append(Item(part.name, part.mesh, places))
    return items


def plate_files(
    title: str, parts: Sequence[Part], bed: Sequence[float], margin: float = 0.0
) -> dict[str, bytes]:
    """all.3mf with all plates side by side; of more than one each in a file of its own, too.

    Parts have the lower corner of their box at the origin. @param bed of the printer [mm]
    @param margin that is free at each side of it [mm]
    """
    copies = _packed(parts, [side - 2 * margin for side in bed[:2]])
    widest = max((copy.size[0] for copy in copies), default=0.0)
    placed = _centred(copies, bed, max(STRIDE * bed[0], widest + SPACE))
    files = {'all.3mf': threemf_bytes(title, _items(parts, placed))}
    plates = sorted({copy.plate for copy in copies})
    if len(plates) == 1:
        return files
    placed = _centred(copies, bed, 0.0)
    for plate in plates:
        own = [copy for copy in placed if copy.plate == plate]
        name = f'plate_{plate + 1}.3mf'
        files[name] = threemf_bytes(f'{title}, plate {plate + 1}', _items(parts, own))
    return files
