# SPDX-License-Identifier: Apache-2.0
"""Which limbs and capsules are to keep apart, and how far. Lengths in m."""

import dataclasses
import functools

import equipment
import numpy as np
import tape
from robot import LEG_LENGTH
from segments import segment_distance
from vectors import UNIT

LIMB_RANGE = 0.1  # beyond the clearance over which limbs cost, share of the leg
ROUNDING = 0.25  # distance below which its root is rounded, share of the clearance
TRUNK_MARGIN, TRUNK_RANGE = 0.015, 0.05  # of capsules, shares of the leg
LEAST_RANGE = 0.1  # share of the range that is left to capsules that are near at home
TOUCHING = 1e-6


@dataclasses.dataclass
class Pair:
    """first, second: functions of Placed that give the ends of a segment, (n, 3) each."""

    first: object
    second: object
    clearance: float
    range: float


def distances(found, placed):
    """Of each pair in each pose, (pairs, n)."""
    ends = zip(*[(*pair.first(placed), *pair.second(placed)) for pair in found])
    rounding = np.array([[ROUNDING * pair.clearance] for pair in found])
    return segment_distance(*[tape.stack(list(end)) for end in ends], rounding)


@functools.cache
def pairs(robot, clearance):
    return _limb_pairs(robot, clearance) + _capsule_pairs(robot)


def _link(leg, k):
    """The segment from a hinge to the next one, or to the foot."""

    def ends(placed):
        joint = 3 * leg + k
        end = placed.anchors[:, joint + 1] if k < 2 else placed.feet[:, leg]
        return placed.anchors[:, joint], end

    return ends


def _limb_pairs(robot, clearance):
    """All links of different legs; of the same leg those that share no end and are farther apart at
    home than the barrier reaches."""
    found, home, reach = [], robot.home(), LIMB_RANGE * LEG_LENGTH
    links = [(leg, k) for leg in range(4) for k in range(3)]
    for a, (leg, k) in enumerate(links):
        for other, below in links[a + 1 :]:
            pair = Pair(_link(leg, k), _link(other, below), clearance, reach)
            if leg != other or not (
                below == k + 1 or distances([pair], home).value[0, 0] < clearance + reach
            ):
                found.append(pair)
    return found


def _trunk_capsule(side):
    def ends(placed):
        design, low = placed.design, equipment.TRUNK_LOW * UNIT[2]
        return [
            placed.on_trunk(front * design.length * UNIT[0] + side * design.width * UNIT[1] - low)
            for front in (0.5, -0.5)
        ]

    return ends


def _capsule_pairs(robot):
    """Trunk and limbs. Those that are near at home have a margin and a range as much smaller, so
    that home costs nothing; those that touch there are left out."""
    found, home = [], robot.home()
    margin, reach = TRUNK_MARGIN * LEG_LENGTH, TRUNK_RANGE * LEG_LENGTH
    for side in equipment.TRUNK_SIDES:
        for leg in range(4):
            for k, radius in zip((1, 2), equipment.LIMB_RADII):
                first, second = _trunk_capsule(side), _link(leg, k)
                ends = [*first(home), *second(home)]
                radii = equipment.TRUNK_RADIUS + radius
                gap = segment_distance(*ends, TOUCHING).value[0] - radii
                if gap < TOUCHING:
                    continue
                room = min(gap, margin + reach)
                own = max(room / (margin + reach), LEAST_RANGE) * reach
                wall = max(radii + room - own, LEAST_RANGE * own)
                found.append(Pair(first, second, wall, own))
    return found
