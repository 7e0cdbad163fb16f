# SPDX-License-Identifier: Apache-2.0
"""The exploded view: a scene in which parts and modules stand apart, with numbers on them."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from legwright.parts._drawing import Drawing
from legwright.parts._labels import Thing, clearest_turn, labels_of
from legwright.parts._robot import BuiltRobot, Module
from legwright.parts._solids import Part, Solid
from legwright.parts._words import Array

_APART = 1.0  # times the way from the trunk's middle: how far things are moved out
_ALONG = 0.03  # [m], besides, of a part along the horn that it is screwed to


@dataclass(frozen=True)
class _Moved:
    """Something that is moved out, in the axes of the robot's world [m]."""

    of: Module | Solid
    shift: Array
    thing: Thing
    draw: Callable[[Drawing, Array], None]


def _moved_modules(
    robot: BuiltRobot, parts: Sequence[Part], numbers: Mapping[str, int]
) -> list[_Moved]:
    drawing = Drawing(robot)
    centre = drawing.world(robot.trunk, np.zeros(3))
    printed = {solid.link.body for part in parts for solid in part.solids}
    out: list[_Moved] = []
    told: set[str] = set()
    for module in robot.modules:
        if module.words.kind == 'trunk' and module.body in printed:
            continue
        corners = drawing.corners(module)
        shift = _APART * (corners.mean(axis=0) - centre)
        key = f'{module.words.kind} {module.words.name}'
        thing = Thing(corners + shift, None if key in told else numbers[key])
        told.add(key)
        out.append(_Moved(module, shift, thing, lambda to, by, what=module: to.module(what, by)))
    return out


def _moved_parts(robot: BuiltRobot, parts: Sequence[Part]) -> list[_Moved]:
    drawing = Drawing(robot)
    centre = drawing.world(robot.trunk, np.zeros(3))
    out: list[_Moved] = []
    for part in parts:
        for solid in part.solids:
            corners = drawing.corners_of_part(solid)
            horns = [f.normal for f in solid.fixings if f.place.on_horn]
            along = drawing.turn_of(solid.link.body) @ horns[0] if horns else np.zeros(3)
            middle = (corners.min(axis=0) + corners.max(axis=0)) / 2
            shift = _APART * (middle - centre) + _ALONG * along
            thing = Thing(corners + shift, part.number)
            out.append(
                _Moved(
                    solid,
                    shift,
                    thing,
                    lambda to, by, what=(part, solid): to.part(*what, by),
                )
            )
    return out


def exploded_scene(robot: BuiltRobot, parts: Sequence[Part], numbers: Mapping[str, int]) -> str:
    """MJCF of a robot in its home pose whose modules and parts are moved away from the trunk.

    Lines go from attachments to where parts have them; numbers are those of the bill's rows, by
    their keys: of parts on each, of modules on the first. It is turned so that things hide little
    of each other.
    """
    moved = _moved_modules(robot, parts, numbers) + _moved_parts(robot, parts)
    turn = clearest_turn([each.thing for each in moved])
    drawing = Drawing(robot, turn)
    shifts = {id(each.of): turn @ each.shift for each in moved}
    for each in moved:
        each.draw(drawing, shifts[id(each.of)])
        if not isinstance(each.of, Solid) or not each.of.link.servo:
            continue
        for fixing in each.of.fixings:
            place = drawing.world(each.of.link.body, fixing.position)
            drawing.line(place + shifts[id(fixing.module)], place + shifts[id(each.of)])
    things = [Thing(each.thing.corners @ turn.T, each.thing.number) for each in moved]
    for label in labels_of(things):
        drawing.label(label)
    return drawing.text()
