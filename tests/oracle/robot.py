# SPDX-License-Identifier: Apache-2.0
"""The puppy: a trunk and four legs of three hinges, as point masses, for any design s.

s = 12 link lengths, 36 components of joint axes (leg, joint, xyz), body width, body length.
"""
import numpy as np

import tape
from vectors import UNIT, dot, rotation_about, rotation_of, times

GRAVITY = 9.81
SIDES = ((1, 1), (1, -1), (-1, 1), (-1, -1))  # front left, front right, hind left, hind right
LENGTHS = (0.06, 0.08, 0.07)
NOMINAL = np.array([0.5, -1.0, 0.6] * 4)
BODY_LENGTH, BODY_WIDTH, BODY_HEIGHT = 0.24, 0.14, 0.05
BODY_MASS, MOTOR_MASS, FOOT_MASS = 1.0, 0.08, 0.02
LINK_DENSITY, FOOT_RADIUS = 0.4, 0.012  # [kg/m] of the initial length, [m]

LEG_LENGTH = sum(LENGTHS)
MASS = BODY_MASS + 4 * (3 * MOTOR_MASS + FOOT_MASS + LINK_DENSITY * LEG_LENGTH)
WEIGHT = MASS * GRAVITY
LATERAL = UNIT[1]


class Design:
    """The parts of s."""

    def __init__(self, s):
        self.lengths = s[np.arange(12).reshape(4, 3)]
        self.axes = s[12 + np.arange(36).reshape(4, 3, 3)]
        self.width, self.length = s[48], s[49]


def initial_design():
    return np.concatenate([LENGTHS * 4, np.tile(LATERAL, 12), [BODY_WIDTH, BODY_LENGTH]])


class Placed:
    """The robot in n poses.

    points      (n, masses, 3)   places of the point masses [m]; `masses` tells their mass [kg]
    feet        (n, 4, 3)        centres of the feet's balls [m]
    shanks      4 of (n, 3, 3)   orientations of the links that carry the feet
    """

    def __init__(self, poses, s):
        """poses: (n, 18): root position, rotation vector of the root, 12 joint angles."""
        design = Design(s)
        self.masses, points, feet, self.shanks = [], [], [], []

        def put(mass, place):
            self.masses.append(mass)
            points.append(place)

        root, trunk = poses[:, 0:3], rotation_of(poses[:, 3:6])
        for axis, size in zip(UNIT, (design.length, design.width, tape.tensor(BODY_HEIGHT))):
            for sign in (-0.5, 0.5):  # a box: a sixth of its mass in the middle of each face
                put(BODY_MASS / 6, root + times(trunk, sign * size * axis))
        for leg, (front, left) in enumerate(SIDES):
            hip = 0.5 * (front * design.length * UNIT[0] + left * design.width * UNIT[1])
            place, turn = root + times(trunk, hip), trunk
            for k in range(3):
                axis = design.axes[leg, k]
                axis = axis / tape.sqrt(dot(axis, axis))
                turn = turn @ rotation_about(axis, poses[:, 6 + 3 * leg + k])
                end = place + times(turn, -1.0 * design.lengths[leg, k] * UNIT[2])
                rod = LINK_DENSITY * LENGTHS[k]
                put(MOTOR_MASS, place)
                put(rod / 6, place)
                put(2 * rod / 3, (place + end) / 2)
                put(rod / 6, end)
                place = end
            put(FOOT_MASS, place)
            feet.append(place)
            self.shanks.append(turn)
        self.masses = np.array(self.masses)
        self.points, self.feet = tape.stack(points, 1), tape.stack(feet, 1)

    def com(self):
        """φ_COM of each pose, (n, 3)."""
        return (self.points * (self.masses / self.masses.sum())[:, None]).sum(1)
