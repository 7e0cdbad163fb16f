# SPDX-License-Identifier: Apache-2.0
"""Slots for cables: before the sides of modules at which they leave."""

from collections.abc import Sequence

import numpy as np
from manifold3d import Manifold

from legwright.parts._robot import Module
from legwright.parts._shapes import MM, frame_along, placed
from legwright.parts._words import Place

WIDE, FAR = 10.0, 30.0
"""Across, both ways, and how far from the module's side [mm]: plugs of servos go through."""
_BEHIND = 1.0  # [mm] into the module, so that no skin is left


def _frame(normal: np.ndarray) -> np.ndarray:
    """A frame whose z is the normal, with a side that is level where there is one."""
    across = np.cross(np.array([0.0, 0.0, 1.0]), normal)
    if np.linalg.norm(across) < 1e-6:
        return frame_along(normal)
    x = across / np.linalg.norm(across)
    return np.column_stack([x, np.cross(normal, x), normal])


def slot_before(place: Place, up: float = 0.0) -> Manifold:
    """What must stay free before a side at which a cable leaves, in the frame of what carries it.

    A square channel from the middle of the side outwards [mm]. Where a module is put in from above,
    it is swept upwards by so much [mm].
    """
    channel = Manifold.cube((WIDE, WIDE, FAR + _BEHIND), True)
    channel = channel.translate((0, 0, (FAR - _BEHIND) / 2))
    solid = placed(channel, _frame(place.normal), MM * place.position)
    return Manifold.batch_hull([solid, solid.translate((0, 0, up))]) if up > 0 else solid


def cable_places(module: Module) -> list[Place]:
    """The sides at which its cables leave."""
    return [each for each in module.places if not each.on_horn and each.name in module.words.cable]


def slots_of(module: Module, up: float = 0.0) -> list[Manifold]:
    """What must stay free before the sides of its cables (slot_before())."""
    return [slot_before(place, up) for place in cable_places(module)]


def all_slots(modules: Sequence[Module], up: float = 0.0) -> list[Manifold]:
    """Of all of them."""
    return [slot for module in modules for slot in slots_of(module, up)]
