# SPDX-License-Identifier: Apache-2.0
"""The pistons of the equipped puppy, by the places of their ends in the thigh's frame."""

import equipment
import numpy as np
import tape
from robot import SIDES
from vectors import UNIT, cross, dot, rotation_about, times

LEGS = range(4)


class Piston:
    """length (n) and arm = ∂length/∂angle (n) [m] at the angles (n) of the knee."""

    def __init__(self, design, leg, angle):
        thigh = design.lengths[leg, 0] * -UNIT[2]  # from its hinge to the knee
        axis = design.axes[leg, 1]
        lower = design.piston_lower * np.array([1.0, SIDES[leg][1], 1.0])
        turned = times(rotation_about(axis, angle), lower)
        along = thigh + turned - (equipment.PISTON_UPPER + thigh / 6)
        self.length = tape.sqrt(dot(along, along))
        self.arm = dot(along, cross(axis, turned)) / self.length
