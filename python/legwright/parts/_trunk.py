# SPDX-License-Identifier: Apache-2.0
"""The trunk as a tray: floor and walls of its box, with cradles for the servos that stand on it."""

import numpy as np
from manifold3d import Manifold

from legwright.parts._robot import BuiltRobot, Link, Module
from legwright.parts._shapes import MM, grown, joined, outline
from legwright.parts._words import Array

_SOLID = 4.0  # times the wall: trunks that are lower are plates
_FAR = 500.0  # [mm]: beyond all
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


def _shell(trunk: Module, wall: float) -> Manifold:
    """Open above; of low trunks all of it."""
    out = []
    for shape in trunk.shapes:
        whole = grown(shape, 0.0)
        height = whole.bounding_box()[5] - whole.bounding_box()[2]
        if shape.kind == 'box' and height > _SOLID * wall:
            room = grown(shape, -wall)
            whole = whole - Manifold.batch_hull([room, room.translate(tuple(_FAR * _UP))])
        out.append(whole)
    return joined(out)


def trunk_solid(robot: BuiltRobot, wall: float, fit: float) -> tuple[Manifold, Manifold]:
    """What is printed before anything is cut out, and what is cut out [mm].

    The trunk's box as a tray. A servo gets a cradle: walls around it, but not above, from where it
    is put in, and not before its horn. Cut out are the modules, grown by the fit, with their way
    in from above, and what is before the horns.
    """
    trunk, link = _box(robot), trunk_link(robot)
    top = MM * max(float(shape.position[2] + shape.size[2]) for shape in trunk.shapes)
    solids, cuts = [_shell(trunk, wall)], []
    for module in link.modules:
        if module.words.kind == 'servo':
            solids.append(outline(module, fit + wall).trim_by_plane((0, 0, -1), -top))
            for place in module.places:
                if place.on_horn:
                    cuts.append(_swept(module, fit + wall + 1.0, place.normal) ^ _before(place))
        cuts.append(_swept(module, fit, _UP))
    return joined(solids), joined(cuts)


def _before(place) -> Manifold:
    """The half of space on which a horn looks, from just below its plane."""
    half = Manifold.cube((2 * _FAR, 2 * _FAR, 2 * _FAR), True)
    normal = place.normal
    start = MM * float(normal @ place.position) - 0.2
    return half.trim_by_plane(tuple(normal), start)
