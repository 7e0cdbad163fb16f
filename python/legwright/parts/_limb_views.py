# SPDX-License-Identifier: Apache-2.0
"""Exploded views of a limb, drawn in a row from the trunk to the foot, and of the trunk."""

import math
from collections.abc import Mapping, Sequence

import numpy as np

from legwright.parts._drawing import Drawing, spread
from legwright.parts._labels import AWAY, RIGHT, UP, Thing, clearest_turn, labels_of
from legwright.parts._limbs import Limb, Piece
from legwright.parts._robot import BuiltRobot, Module
from legwright.parts._words import Array

_GAP = 0.02  # [m] between two things of a row
_OUT = 0.008  # [m] from a hole to its screw
_ASIDE, _ABOVE = math.radians(18.0), math.radians(35.0)  # of a row, and of the horns in it
_LIFTED = 0.02  # [m] above the trunk


def number_of(step: Piece | Module, numbers: Mapping[str, int]) -> int:
    """Of its row in the bill."""
    if isinstance(step, Piece):
        return step.part.number
    return numbers[f'{step.words.kind} {step.words.name}']


def _corners(drawing: Drawing, step: Piece | Module) -> Array:
    if isinstance(step, Piece):
        return drawing.corners_of_part(step.solid)
    return drawing.corners(step)


def _row_turn(robot: BuiltRobot, limb: Limb) -> Array:
    """The turn that lays a limb from left to right, and shows the heads on its first horn."""
    drawing = Drawing(robot)
    middles = [_corners(drawing, step).mean(axis=0) for step in limb.steps]
    chain = middles[-1] - middles[0]
    first = next(step for step in limb.steps if isinstance(step, Piece))
    horns = [f.normal for f in first.solid.fixings if f.place.on_horn]
    horn = drawing.turn_of(first.solid.link.body) @ (horns[0] if horns else np.eye(3)[1])
    to = math.cos(_ASIDE) * RIGHT - math.sin(_ASIDE) * AWAY
    seen = math.sin(_ABOVE) * UP - math.cos(_ABOVE) * AWAY
    return _frame(to, seen) @ _frame(chain, horn).T


def _frame(along: Array, other: Array) -> Array:
    """A right-handed frame whose x is along the first, and whose y looks towards the second."""
    x = along / max(1e-9, float(np.linalg.norm(along)))
    y = other - (other @ x) * x
    if np.linalg.norm(y) < 1e-3:
        y = np.cross(x, np.eye(3)[np.argmin(np.abs(x))])
    y = y / np.linalg.norm(y)
    return np.column_stack([x, y, np.cross(x, y)])


def _draw(
    drawing: Drawing,
    steps: Sequence[Piece | Module],
    shifts: Sequence[Array],
    numbers: Mapping[str, int],
) -> str:
    """The scene: things, screws and ties, lines from modules to parts, numbers."""
    moved = {id(step): shift for step, shift in zip(steps, shifts)}
    things = []
    for step, shift in zip(steps, shifts):
        things.append(Thing(_corners(drawing, step) + shift, number_of(step, numbers)))
        if isinstance(step, Module):
            drawing.module(step, shift)
            continue
        drawing.part(step.part, step.solid, shift)
        body = step.solid.link.body
        for hole in step.solid.holes:
            drawing.screw(body, hole, shift, _OUT)
        for strap in step.solid.straps:
            drawing.tie(body, strap, moved[id(strap.module)])
        for fixing in step.solid.fixings:
            if id(fixing.module) in moved and step.solid.link.servo:
                place = drawing.world(body, fixing.position)
                drawing.line(place + moved[id(fixing.module)], place + shift)
    for label in labels_of(things):
        drawing.label(label)
    return drawing.text()


def limb_scene(robot: BuiltRobot, limb: Limb, numbers: Mapping[str, int]) -> str:
    """MJCF of a limb in its home pose, laid from left to right, its things moved apart along it.

    The numbers are those of the bill's rows.
    """
    drawing = Drawing(robot, _row_turn(robot, limb))
    along = math.cos(_ASIDE) * RIGHT - math.sin(_ASIDE) * AWAY
    rows = [(_corners(drawing, step), np.zeros(3)) for step in limb.steps]
    return _draw(drawing, limb.steps, spread(rows, _GAP, along), numbers)


def trunk_scene(
    robot: BuiltRobot, steps: Sequence[Piece | Module], numbers: Mapping[str, int]
) -> str:
    """MJCF of the trunk, and of what stands in it, lifted out as it is put in: from above."""
    flat = Drawing(robot)
    corners = [_corners(flat, step) for step in steps]
    bases = [c for step, c in zip(steps, corners) if isinstance(step, Piece)]
    top = max((float(c[:, 2].max()) for c in bases), default=0.0)
    shifts = []
    for step, points in zip(steps, corners):
        by = 0.0 if isinstance(step, Piece) else top + _LIFTED - float(points[:, 2].min())
        shifts.append(np.array([0.0, 0.0, by]))
    turn = clearest_turn([Thing(c + s, None) for c, s in zip(corners, shifts)])
    return _draw(Drawing(robot, turn), steps, [turn @ shift for shift in shifts], numbers)
