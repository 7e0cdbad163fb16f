# SPDX-License-Identifier: Apache-2.0
"""The puppy: a trunk and four legs of three hinges, as point masses, for any design s.

s = 12 link lengths, 36 components of joint axes (leg, joint, xyz), body width, body length; of the
equipped puppy also the three coordinates of its pistons' lower ends.
"""

import equipment
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
LATERAL = UNIT[1]


class Robot:
    """The plain puppy, or the equipped one (equipment.py), whose masses grow with its design."""

    def __init__(self, equipped=False):
        self.equipped = equipped
        self.mass = BODY_MASS + 4 * (3 * MOTOR_MASS + FOOT_MASS + LINK_DENSITY * LEG_LENGTH)
        if equipped:
            self.mass += equipment.PAYLOAD['mass']
        self.weight = self.mass * GRAVITY  # of the initial design

    def initial_design(self):
        plain = [LENGTHS * 4, np.tile(LATERAL, 12), [BODY_WIDTH, BODY_LENGTH]]
        return np.concatenate(plain + [equipment.PISTON_LOWER] if self.equipped else plain)

    def home(self):
        """The robot in its nominal pose at the initial design."""
        pose = np.concatenate([np.zeros(6), NOMINAL])[None]
        return Placed(self, tape.tensor(pose), tape.tensor(self.initial_design()))


class Design:
    """The parts of s; axes are normalised."""

    def __init__(self, robot, s):
        self.lengths = s[np.arange(12).reshape(4, 3)]
        axes = s[12 + np.arange(36).reshape(4, 3, 3)]
        self.axes = axes / tape.sqrt(dot(axes, axes))[..., None]
        self.width, self.length = s[48], s[49]
        self.piston_lower = s[50:53] if robot.equipped else None


class Placed:
    """The robot in n poses.

    masses      (points)            [kg]
    points      (n, points, 3)      places of the point masses [m]
    moved       12 lists            which points a joint moves
    anchors     (n, 12, 3)          the hinges [m]
    axes        (n, 12, 3)          their axes, unit vectors
    feet        (n, 4, 3)           centres of the feet's balls [m]
    shanks      4 of (n, 3, 3)      orientations of the links that carry the feet
    trunk       (n, 3, 3)           orientation of the trunk
    volume      printed volume [m³], 0 of the plain puppy
    """

    def __init__(self, robot, poses, s):
        """poses: (n, 18): root position, rotation vector of the root, 12 joint angles."""
        self.robot, self.design = robot, Design(robot, s)
        self.root, self.trunk = poses[:, 0:3], rotation_of(poses[:, 3:6])
        self._masses, self._points, self.volume = [], [], tape.tensor(0.0)
        self.moved, anchors, axes, feet, self.shanks = [], [], [], [], []
        self._place_trunk()
        for leg, (front, left) in enumerate(SIDES):
            hip = 0.5 * (front * self.design.length * UNIT[0] + left * self.design.width * UNIT[1])
            place, turn, first = self.on_trunk(hip), self.trunk, []
            for k in range(3):
                axis = self.design.axes[leg, k]
                anchors.append(place)
                axes.append(times(turn, axis))
                first.append(len(self._points))
                turn = turn @ rotation_about(axis, poses[:, 6 + 3 * leg + k])
                end = place + times(turn, -1.0 * self.design.lengths[leg, k] * UNIT[2])
                self._place_link(leg, k, place, end)
                place = end
            self._put(FOOT_MASS, place)
            self.moved += [list(range(start, len(self._points))) for start in first]
            feet.append(place)
            self.shanks.append(turn)
        self.masses, self.points = tape.stack(self._masses), tape.stack(self._points, 1)
        self.anchors, self.axes = tape.stack(anchors, 1), tape.stack(axes, 1)
        self.feet = tape.stack(feet, 1)

    def on_trunk(self, place):
        """A place in the trunk's frame, in the world. (n, 3)"""
        return self.root + times(self.trunk, place)

    def com(self):
        """φ_COM of each pose, (n, 3)."""
        return (self.points * (self.masses / self.masses.sum())[:, None]).sum(1)

    def _put(self, mass, place, growth=1.0, printed=True):
        """growth: how many times its initial mass and volume a part of the equipped puppy has."""
        if self.robot.equipped:
            mass = mass * growth
            if printed:
                self.volume = self.volume + mass / equipment.PRINT_DENSITY
        self._masses.append(tape.tensor(mass))
        self._points.append(place)

    def _place_trunk(self):
        """A box: a sixth of its mass in the middle of each face. A payload: eight points."""
        design = self.design
        growth = design.length / BODY_LENGTH * (design.width / BODY_WIDTH)
        for axis, size in zip(UNIT, (design.length, design.width, tape.tensor(BODY_HEIGHT))):
            for sign in (-0.5, 0.5):
                self._put(BODY_MASS / 6, self.on_trunk(sign * size * axis), growth)
        if self.robot.equipped:
            for mass, place in equipment.payload_points():
                self._put(mass, self.on_trunk(tape.tensor(place)), printed=False)

    def _place_link(self, leg, k, place, end):
        """A motor at the hinge and a thin rod, of which the middle is printed."""
        rod = LINK_DENSITY * LENGTHS[k]
        self._put(MOTOR_MASS, place, printed=k > 0)
        self._put(rod / 6, place)
        self._put(2 * rod / 3, (place + end) / 2, self.design.lengths[leg, k] / LENGTHS[k])
        self._put(rod / 6, end)
