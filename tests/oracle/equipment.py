# SPDX-License-Identifier: Apache-2.0
"""What the equipped puppy has beyond the plain one. SI units; three numbers: by joint of a leg."""

import numpy as np
import tape
from vectors import rotation_of

PAYLOAD = dict(mass=0.4, position=[0.02, -0.01, 0.05], size=[0.1, 0.06, 0.04])  # a box on the trunk
PRINT_DENSITY = 1000.0  # of all but hip motors and payload; the box and the rods' middles grow

JOINT_LOWER, JOINT_UPPER = (0.2, -1.3, 0.3), (0.9, -0.6, np.inf)
ARMATURE = (0.002, 0.003, 0.001)
DAMPING, FRICTION_LOSS = (0.03, 0.0, 0.02), (0.2, 0.1, 0.0)
STIFFNESS, SLACK_ANGLE = (0.5, 0.0, 0.4), (0.3, 0.2, -0.1)
TORQUE_LIMIT = (3.5, 3.0, np.inf)

# A piston drives each knee, joint 1, from the thigh to the shank. Its upper end is this and a sixth
# of the thigh down; the lower end is part of s, on right legs with the other sign of y.
PISTON_UPPER, PISTON_LOWER = np.array([0.02, 0.0, 0.0]), np.array([0.015, 0.0, -0.035])
PISTON_SHORTEST, PISTON_LONGEST, PISTON_FORCE = 0.045, 0.082, 120.0

# Capsules: two along the trunk's sides, at a share of its width and so far below the hips; one for
# the second and one for the last link of each leg.
TRUNK_SIDES, TRUNK_LOW, TRUNK_RADIUS = (0.3, -0.3), 0.035, 0.02
LIMB_RADII = (0.008, 0.006)

SOLE_ABOUT = np.array([1.0, -2.0, 0.5]) / np.linalg.norm([1.0, -2.0, 0.5])


def sole(foot):
    """The two directions of a foot's sole in the frame of its link: askew, each in its own way."""
    turn = rotation_of(tape.tensor((0.2 + 0.3 * foot) * SOLE_ABOUT[None])).value[0]
    return turn[:, 0], turn[:, 1]


def payload_points():
    """(mass, place): a box has Σ m x² = mass (edge/2)²/3 along each edge."""
    arm = np.array(PAYLOAD['size']) / 2 / np.sqrt(3)
    return [
        (PAYLOAD['mass'] / 8, np.array(PAYLOAD['position']) + arm * signs)
        for signs in np.array(np.meshgrid(*[(-1, 1)] * 3)).reshape(3, 8).T
    ]
