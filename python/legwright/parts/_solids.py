# SPDX-License-Identifier: Apache-2.0
"""The solid of each link, and which of them are one part."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from manifold3d import Manifold

from legwright._errors import InputError
from legwright.parts._feet import Peg, peg_of, peg_solid
from legwright.parts._holes import Fixing, Hole, begins_at, drilled, fixings_of, holes_of
from legwright.parts._mesh_files import Mesh, as_printed, mesh_of
from legwright.parts._printing import Lying, best_lying, lying_on
from legwright.parts._robot import BuiltRobot, Link
from legwright.parts._shapes import MM, hull, joined, outline, placed, whole
from legwright.parts._slots import all_slots
from legwright.parts._straps import Strap
from legwright.parts._thin import without_thin
from legwright.parts._trunk import trunk_link, trunk_solid
from legwright.parts._words import Array

_FINE = 1e-3  # [mm]: finer details are left out
_SAME = 5e-3  # [mm]: vertices of solids that are one part


@dataclass(frozen=True)
class Solid:
    """What is printed of a link, in its frame [mm]."""

    link: Link
    declared: Manifold
    """The union of its hulls, as the file has them."""
    shape: Manifold
    """Less the modules' places and the holes."""
    pieces: int
    """1, where it hangs together."""
    fixings: tuple[Fixing, ...]
    holes: tuple[Hole, ...]
    seat_volume: float
    """What places of modules, slots for their cables and slots for ties take away [mm3]."""
    hole_volume: float
    """What holes take away [mm3]."""
    hull_volume: float
    """Sum of the hulls [mm3], by which the file's masses go: where they overlap, twice."""
    density: float
    """[kg/m3]; of several hulls by their volumes."""
    file_mass: float
    """Of the connectors, or of the trunk's module, as the robot's file says [kg]."""
    pegs: tuple[Peg, ...] = ()
    """On which ball feet are pressed."""
    peg_volume: float = 0.0
    """What they add [mm3]."""
    number_volume: float = 0.0
    """What its number takes away [mm3]."""
    straps: tuple[Strap, ...] = ()
    """Ties that hold what stands on the trunk."""

    @property
    def mass(self) -> float:
        """Of the shape, filled [kg]."""
        return self.density * self.shape.volume() / MM**3


@dataclass(frozen=True)
class Mark:
    """A number that is engraved, in the frame of the link [mm]."""

    number: int
    height: float
    """Of its digits."""
    wall: float
    """The least one, by which its strokes keep apart."""
    centre: Array
    normal: Array
    along: Array
    """In the direction of reading."""
    up: Array


@dataclass(frozen=True)
class Part:
    """A solid that is printed as often as links have it."""

    name: str
    solids: tuple[Solid, ...]
    number: int = 0
    """Of its row in the bill."""
    mark: Mark | None = None
    """None where no side has room for it."""
    down: Array | None = None
    """The direction that looks down; None: best_lying() finds it."""

    @property
    def solid(self) -> Solid:
        """One of them: the first of the file."""
        return self.solids[0]

    @cached_property
    def lying(self) -> Lying:
        """How it lies on the bed."""
        if self.down is not None:
            return lying_on(self.solid.shape, self.down)
        return best_lying(self.solid.shape)

    @cached_property
    def printed(self) -> Manifold:
        """As its files have it: as it lies on the bed, one corner of its box at the origin [mm]."""
        lying = placed(self.solid.shape, self.lying.turn, np.zeros(3))
        return as_printed(lying.translate(tuple(-np.array(lying.bounding_box()[:3]))))

    @cached_property
    def mesh(self) -> Mesh:
        """Its triangles there."""
        return mesh_of(self.printed)

    @property
    def links(self) -> list[str]:
        """The links that have it."""
        return [each.link.name for each in self.solids]

    @property
    def count(self) -> int:
        """How often it is printed."""
        return len(self.solids)


def _check_left(robot: BuiltRobot, link: Link, shape: Manifold) -> None:
    if shape.is_empty() or shape.volume() <= 0:
        raise InputError(
            f'{robot.file}: nothing of {link.name} is left beside its modules and holes: a smaller '
            '--fit, or a larger radius under [link] of the assembly'
        )


def _cut(
    robot: BuiltRobot,
    link: Link,
    declared: Manifold,
    taken: Manifold,
    wall: float,
    told: dict[str, float],
) -> Solid:
    """What is left of a solid without its modules' places and without holes for screws."""
    shape, _ = whole(declared - taken)
    shape = without_thin(shape, wall, _FINE)
    _check_left(robot, link, shape)
    seated = shape.volume()
    fixings = fixings_of(robot, link, shape)
    holes = [hole for fixing in fixings for hole in holes_of(fixing, shape, wall)]
    if holes:
        shape = shape - joined([drilled(hole) for hole in holes])
        shape = without_thin(shape, wall, _FINE)
    shape, pieces = whole(shape)
    shape = shape.simplify(_FINE)
    _check_left(robot, link, shape)
    without = shape.volume()
    pegs = [peg for fixing in fixings if (peg := peg_of(fixing, begins_at(shape, fixing)))]
    if pegs:
        shape = (shape + joined([peg_solid(peg) for peg in pegs])).simplify(_FINE)
    return Solid(
        link=link,
        declared=declared,
        shape=shape,
        pieces=pieces,
        fixings=tuple(fixings),
        holes=tuple(holes),
        seat_volume=declared.volume() - seated,
        hole_volume=seated - without,
        pegs=tuple(pegs),
        peg_volume=shape.volume() - without,
        **told,
    )


def solid_of(robot: BuiltRobot, link: Link, fit: float, wall: float) -> Solid:
    """The union of a link's hulls, less its modules grown by the fit, less holes for screws."""
    hulls = [hull(each) for each in link.hulls]
    for each, solid in zip(link.hulls, hulls):
        if solid.is_empty() or solid.volume() <= 0:
            raise InputError(
                f'{robot.file}: connector {each.words.name} is flat: no solid to print; build the '
                'robot anew'
            )
    volume = sum(each.volume() for each in hulls)
    masses = sum(h.volume() * e.words.density for h, e in zip(hulls, link.hulls))
    told = {
        'hull_volume': volume,
        'density': masses / volume,
        'file_mass': sum(each.mass for each in link.hulls),
    }
    taken = joined([*(outline(module, fit) for module in link.modules), *all_slots(link.modules)])
    return _cut(robot, link, joined(hulls), taken, wall, told)


def trunk_of(robot: BuiltRobot, fit: float, wall: float, density: float) -> Solid:
    """The trunk as a tray (trunk_solid()) with walls of twice the least one, of that density."""
    trunk = trunk_solid(robot, wall, fit)
    mass = next(m.words.mass for m in robot.modules if m.words.kind == 'trunk')
    told = {'hull_volume': trunk.whole.volume(), 'density': density, 'file_mass': mass}
    solid = _cut(robot, trunk_link(robot), trunk.whole, trunk.cut, wall, told)
    return replace(solid, straps=trunk.straps)


def vertices_of(shape: Manifold) -> Array:
    """N x 3 [mm]."""
    return np.asarray(shape.to_mesh64().vert_properties)[:, :3]


def _are_same(a: Manifold, b: Manifold) -> bool:
    """Whether two solids have the same corners, each in the frame of its link."""
    volume = a.volume()
    if a.num_vert() != b.num_vert() or abs(volume - b.volume()) > 1e-4 * volume:
        return False
    one, other = vertices_of(a), vertices_of(b)
    far = np.linalg.norm(one[:, None] - other[None], axis=2)
    return bool(far.min(axis=1).max() < _SAME and far.min(axis=0).max() < _SAME)


def parts_of(robot: BuiltRobot, fit: float, wall: float) -> list[Part]:
    """The parts of a robot, in the order of its file, the trunk last.

    Equal solids are one part, called after the first. A mirror image is a part of its own, but
    where it is the same solid. Fit and least wall in mm.
    """
    groups: list[list[Solid]] = []
    for link in robot.links:
        solid = solid_of(robot, link, fit, wall)
        group = next((g for g in groups if _are_same(g[0].shape, solid.shape)), None)
        if group is None:
            groups.append([solid])
        else:
            group.append(solid)
    parts = [Part(group[0].link.name, tuple(group)) for group in groups]
    return [*parts, Part('trunk', (trunk_of(robot, fit, wall, groups[0][0].density),))]
