# SPDX-License-Identifier: Apache-2.0
"""Cable ties that hold down what stands on the trunk: where they go, and the slots for them."""

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from manifold3d import Manifold

from legwright.parts._robot import Module
from legwright.parts._shapes import joined, outline, placed
from legwright.parts._words import Array

WIDE, THICK = 5.0, 2.0
"""Of a slot [mm]."""
TAIL = 30.0
"""What a tie is longer than its loop, for its lock [mm]."""
TIE = 3.6
"""How wide it is [mm]."""
_FAR = 500.0  # [mm]: beyond all
_SIDEWAYS = 25.0  # [mm] from a module within which its tie goes down
_STEP = 0.5  # [mm] between tries
_SHARES = (0.0, 0.25, -0.25, 0.5, -0.5, 0.75, -0.75, 1.0, -1.0)  # of half of it: where along it
_LEVEL = 0.2  # an axis with less of it upright is level
_NOTHING = 1e-3  # [mm3]
_UP = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True)
class Strap:
    """A tie around a module and the trunk's floor, in the trunk's frame [mm]."""

    module: Module
    loop: float
    """Its length without a tail."""
    cut: Manifold
    """What the trunk leaves free for it."""
    tie: Manifold
    """Itself, for others to keep off."""

    @property
    def length(self) -> int:
        """What to buy at least, in steps of a centimetre [mm]."""
        return 10 * math.ceil((self.loop + TAIL) / 10)


@dataclass(frozen=True)
class _Lie:
    """Where a tie may lie: across a module along a level axis, at a place along the other."""

    frame: Array
    """Its columns: across, along, up."""
    along: float
    low: Array
    high: Array
    """The module's box in the frame."""

    def box(self, low: Sequence[float], high: Sequence[float]) -> Manifold:
        """From one corner (across, up) to the other, as wide as a slot."""
        size = (high[0] - low[0], WIDE, high[1] - low[1])
        middle = ((low[0] + high[0]) / 2, self.along, (low[1] + high[1]) / 2)
        return placed(Manifold.cube(size, True).translate(middle), self.frame, np.zeros(3))

    def column(self, side: float, outwards: float, grown: float = 0.0) -> Manifold:
        """A slot at a side, so far from the module, through all; larger by so much all around."""
        face = self.high[0] if side > 0 else -self.low[0]
        near = face + outwards - grown
        size = (THICK + 2 * grown, WIDE + 2 * grown, 2 * _FAR)
        middle = (side * (near + size[0] / 2), self.along, 0.0)
        return placed(Manifold.cube(size, True).translate(middle), self.frame, np.zeros(3))


def _lies(module: Module) -> Iterator[_Lie]:
    """Places for a tie, the shortest way across first, the middle first."""
    turn = module.shapes[0].turn
    level = [turn[:, k] for k in range(3) if abs(turn[2, k]) < _LEVEL]
    axes = [axis - axis[2] * _UP for axis in level] or [np.eye(3)[0], np.eye(3)[1]]
    points = np.asarray(outline(module).to_mesh64().vert_properties)[:, :3]
    found = []
    for axis in axes:
        across = axis / np.linalg.norm(axis)
        frame = np.column_stack([across, np.cross(_UP, across), _UP])
        seen = points @ frame
        found.append((frame, seen.min(axis=0), seen.max(axis=0)))
    found.sort(key=lambda each: float(each[2][0] - each[1][0]))
    for share, (frame, low, high) in itertools.product(_SHARES, found):
        half = (high[1] - low[1] - WIDE) / 2
        if half > 0:
            yield _Lie(frame, float((low[1] + high[1]) / 2 + share * half), low, high)


@dataclass(frozen=True)
class _Trunk:
    """What a tie goes around, and what it must keep off [mm]."""

    tray: Manifold
    floor: float
    """The most that a slot goes through."""
    wall: float
    """The least one, that stays around a slot."""
    keep_off: Manifold

    def near(self, lie: _Lie, least: float) -> '_Trunk':
        """What of it a tie that lies there can meet: less to cut by."""
        far = least + _SIDEWAYS + 2 * (THICK + self.wall)
        size = (lie.high[0] - lie.low[0] + 2 * far, WIDE + 2 * self.wall + 1, 2 * _FAR)
        middle = ((lie.low[0] + lie.high[0]) / 2, lie.along, 0.0)
        strip = placed(Manifold.cube(size, True).translate(middle), lie.frame, np.zeros(3))
        return replace(self, tray=self.tray ^ strip, keep_off=self.keep_off ^ strip)

    def side(self, lie: _Lie, side: float, least: float) -> float | None:
        """How far from the module a tie goes down; None: nowhere."""
        for outwards in np.arange(least, least + _SIDEWAYS, _STEP):
            around = lie.column(side, outwards, self.wall)
            area = (THICK + 2 * self.wall) * (WIDE + 2 * self.wall)
            if (around ^ self.tray).volume() > 1.05 * area * self.floor:
                continue  # there is a wall
            leg = lie.column(side, outwards)
            leg = leg.trim_by_plane((0, 0, -1), -float(lie.high[2]))
            under = leg ^ self.tray
            low = under.bounding_box()[2] if under.volume() > _NOTHING else float(lie.low[2])
            if (leg.trim_by_plane((0, 0, 1), low) ^ self.keep_off).volume() < _NOTHING:
                return float(outwards)
        return None

    def strap(self, module: Module, lie: _Lie, least: float) -> Strap | None:
        """The tie that lies there; None where it cannot."""
        top = float(lie.high[2])
        lid = lie.box((float(lie.low[0]), top), (float(lie.high[0]), top + THICK))
        if (lid ^ self.keep_off).volume() > _NOTHING:
            return None
        sides = [self.side(lie, side, least) for side in (-1.0, 1.0)]
        if sides[0] is None or sides[1] is None:
            return None
        left = float(lie.low[0]) - sides[0] - THICK
        right = float(lie.high[0]) + sides[1] + THICK
        below = lie.box((left + THICK, -_FAR), (right - THICK, float(lie.low[2]))) ^ self.tray
        if below.volume() < _NOTHING:
            return None  # nothing to be held to
        low = float((lie.box((left, -_FAR), (right, top)) ^ self.tray).bounding_box()[2])
        over = lie.box((left, top), (right, top + THICK))
        under = lie.box((left, low - THICK), (right, low))
        legs = [lie.column(side, out) for side, out in zip((-1.0, 1.0), sides)]
        span = lie.box((left, low), (right, top))
        tie = joined([over, under, *(leg ^ span for leg in legs)])
        if (tie ^ self.keep_off).volume() > _NOTHING:
            return None
        cut = joined([*legs, lie.box((left, top), (right, _FAR))])
        loop = 2 * (right - left) + 2 * (top - low + 2 * THICK)
        return Strap(module, loop, cut, tie)


def straps_of(
    modules: Sequence[Module],
    tray: Manifold,
    floor: float,
    walls: tuple[float, float],
    passed: Sequence[Manifold],
) -> list[Strap]:
    """A tie for each module for which there is room.

    It goes over the module, down on both sides through slots in the floor, or beside it, and
    through under the trunk: where no wall, no other module and nothing that moves is in its way.

    Args:
        modules: what stands on the trunk.
        tray: the trunk as it is printed but for these slots.
        floor: how thick its floor is [mm].
        walls: of cradles with the room in them, which ties go around; the least wall [mm].
        passed: what moves there.
    """
    out: list[Strap] = []
    for module in modules:
        others = [outline(other, 0.5) for other in modules if other is not module]
        keep_off = joined([*others, *passed, *(strap.tie for strap in out)])
        trunk = _Trunk(tray, floor, walls[1], keep_off)
        least = walls[0] if module.words.kind == 'servo' else 0.5
        found = (trunk.near(lie, least).strap(module, lie, least) for lie in _lies(module))
        strap = next((each for each in found if each is not None), None)
        if strap is not None:
            out.append(strap)
    return out
