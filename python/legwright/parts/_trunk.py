# SPDX-License-Identifier: Apache-2.0
"""The trunk as a tray: floor and walls of its box, with cradles for the servos that stand on it."""

import itertools
import math
from dataclasses import dataclass

import mujoco
import numpy as np
from manifold3d import Manifold

from legwright.parts._robot import BuiltRobot, Link, Module, Shape, home_of, matrix
from legwright.parts._shapes import MM, grown, joined, outline
from legwright.parts._slots import all_slots
from legwright.parts._straps import Strap, straps_of
from legwright.parts._words import Array, Place

_WALL = 2.0  # times the least wall
_LOW = 15.0  # [mm] over the floor: servos that hang higher have a cradle on the walls alone
_INTO = 0.1  # [mm] that what stands on the floor goes into it
_RIB = 0.2  # of a length: where ribs are
_SOLID = 4.0  # times the wall: trunks that are lower are plates
_FAR = 500.0  # [mm]: beyond all
_HORN = 4.0  # [mm] before a horn that stay free, whatever turns there
_ROOM = 1.0  # [mm] around what turns
_USED = math.radians(45.0)  # to both sides of home, of joints that turn far
_STEP = math.radians(5.0)
_UP = np.array([0.0, 0.0, 1.0])


def trunk_link(robot: BuiltRobot) -> Link:
    """The trunk as what carries modules and turns on no horn."""
    own = tuple(m for m in robot.modules if m.body == robot.trunk and m.words.kind != 'trunk')
    return Link('trunk', robot.trunk, -1, None, (), own)


def _swept(module: Module, by: float, way: Array) -> Manifold:
    """A module's outline, larger by a clearance, and all that it passes on a straight way."""
    solids = []
    for shape in module.shapes:
        solid = grown(shape, by)
        solids.append(Manifold.batch_hull([solid, solid.translate(tuple(_FAR * way))]))
    return joined(solids)


def _box(robot: BuiltRobot) -> Module:
    return next(module for module in robot.modules if module.words.kind == 'trunk')


def _is_tray(shape: Shape, wall: float) -> bool:
    """Whether it is high enough to be hollow."""
    low, high = grown(shape, 0.0).bounding_box()[2::3]
    return shape.kind == 'box' and high - low > _SOLID * wall


def _shell(trunk: Module, wall: float) -> Manifold:
    """Open above; of low trunks all of it."""
    out = []
    for shape in trunk.shapes:
        whole = grown(shape, 0.0)
        if _is_tray(shape, wall):
            room = grown(shape, -wall)
            whole = whole - Manifold.batch_hull([room, room.translate(tuple(_FAR * _UP))])
        out.append(whole)
    return joined(out)


@dataclass(frozen=True)
class TrunkSolid:
    """The trunk as it is printed [mm]."""

    whole: Manifold
    """Before anything is cut out."""
    cut: Manifold
    straps: tuple[Strap, ...]
    """Whose slots are cut out, too."""


def trunk_solid(robot: BuiltRobot, least: float, fit: float) -> TrunkSolid:
    """The trunk's box as a tray, with walls of twice the least one.

    A servo gets a cradle: walls around it, but not above, from where it is put in, and not before
    its horn; what else is over the floor stands on ribs, however high, which rise from the box. Cut
    out are the modules, grown by the fit, with their way in from above, slots for their cables,
    what is just before the horns, what the links there pass through, and slots for ties.
    """
    wall = _WALL * least
    trunk, link = _box(robot), trunk_link(robot)
    top = MM * max(float(shape.position[2] + shape.size[2]) for shape in trunk.shapes)
    solids, cuts = [_shell(trunk, wall)], []
    for module in link.modules:
        solids += _stands(trunk, module, wall, fit)
        if module.words.kind == 'servo':
            solids.append(outline(module, fit + wall).trim_by_plane((0, 0, -1), -top))
            for place in module.places:
                if place.on_horn:
                    before = _swept(module, fit + wall + 1.0, place.normal) ^ _before(place)
                    cuts.append(before)
        cuts.append(_swept(module, fit, _UP))
    cuts += all_slots(link.modules, _FAR)
    passed = [_passed(robot, each) for each in robot.links if each.servo in link.modules]
    whole, cut = joined(solids), joined([*cuts, *passed])
    floor = max(_floor(shape, wall)[1] for shape in trunk.shapes)
    straps = straps_of(link.modules, whole - cut, floor, (fit + wall, least), passed)
    return TrunkSolid(whole, joined([cut, *(strap.cut for strap in straps)]), tuple(straps))


def _floor(shape: Shape, wall: float) -> tuple[float, float]:
    """Its upper side, and how thick it is [mm]."""
    whole = grown(shape, 0.0).bounding_box()
    if _is_tray(shape, wall):
        return whole[2] + wall, wall
    return whole[5], whole[5] - whole[2]


def _stands(trunk: Module, module: Module, wall: float, fit: float) -> list[Manifold]:
    """What fills the room between a module, or the low cradle of a servo, and the floor."""
    is_servo = module.words.kind == 'servo'
    body = outline(module, fit + wall if is_servo else fit)
    low = body.bounding_box()[2]
    gap = low - max(_floor(shape, wall)[0] for shape in trunk.shapes)
    if gap <= 0 or (is_servo and gap >= _LOW):
        return []
    solid = Manifold.batch_hull([body, body.translate((0, 0, -gap - _INTO))])
    solid = solid.trim_by_plane((0, 0, -1), -low - (wall if is_servo else 0.0))
    boxes = [grown(shape, 0.0) for shape in trunk.shapes]
    if is_servo:
        return [solid ^ joined(boxes)]
    up = tuple(_FAR * _UP)
    over = joined([Manifold.batch_hull([box, box.translate(up)]) for box in boxes])
    return [(solid ^ rib) ^ over for rib in _ribs(module, wall)]


def _ribs(module: Module, wall: float) -> list[Manifold]:
    """Slabs across the longer level side of a module, through all, at both ends."""
    x0, y0, _, x1, y1, _ = outline(module).bounding_box()
    long = 0 if x1 - x0 > y1 - y0 else 1
    low, high = ((x0, x1), (y0, y1))[long]
    size = [2 * _FAR, 2 * _FAR, 2 * _FAR]
    size[long] = wall
    out = []
    for share in (_RIB, 1 - _RIB):
        middle = [0.0, 0.0, 0.0]
        middle[long] = low + share * (high - low)
        out.append(Manifold.cube(size, True).translate(middle))
    return out


def _passed(robot: BuiltRobot, link: Link) -> Manifold:
    """What the hulls of a link pass through over the range of its joint, with some room [mm].

    Of joints that turn by more than half a turn 45 degrees to both sides of home.
    """
    model, joint = robot.model, link.joint
    low, high = model.jnt_range[joint] if model.jnt_limited[joint] else (-math.pi, math.pi)
    if high - low > math.pi:  # a range that says nothing
        home = float(home_of(robot)[model.jnt_qposadr[joint]])
        low, high = max(low, home - _USED), min(high, home + _USED)
    steps = max(2, math.ceil((high - low) / _STEP))
    corners = _ROOM * np.array(list(itertools.product((-1, 1), repeat=3)))
    place = MM * (model.body_pos[link.body] + model.jnt_pos[joint])
    solids = []
    for hull in link.hulls:
        points = MM * (hull.points - model.jnt_pos[joint])
        turned = []
        for angle in np.linspace(low, high, steps + 1):
            quat = np.zeros(4)
            mujoco.mju_axisAngle2Quat(quat, model.jnt_axis[joint], angle)
            turned.append(place + points @ matrix(quat).T)
        for one, other in itertools.pairwise(turned):
            both = np.vstack([one, other])
            solids.append(Manifold.hull_points((both[:, None] + corners).reshape(-1, 3)))
    return joined(solids)


def _before(place: Place) -> Manifold:
    """A slab on which a horn looks, from just below its plane."""
    half = Manifold.cube((2 * _FAR, 2 * _FAR, 2 * _FAR), True)
    start = MM * float(place.normal @ place.position) - 0.2
    slab = half.trim_by_plane(tuple(place.normal), start)
    return slab.trim_by_plane(tuple(-place.normal), -start - _HORN)
