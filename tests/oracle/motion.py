# SPDX-License-Identifier: Apache-2.0
"""Where everything is in m.

m = knots 0 ... T, each: pose (root position 3, rotation vector 3, 12 angles), COM 3, feet 4 × 3,
force 3 of each foot in stance, in order of feet.
"""

import numpy as np
import tape
from robot import FOOT_RADIUS, LEG_LENGTH, NOMINAL, Placed

POSE = 18


class Layout:
    """Indices in m. pose (T+1, 18), com (T+1, 3), foot (T+1, 4, 3), force (T+1, 4, 3);
    force is `size` where the foot swings: one entry behind the last one of m."""

    def __init__(self, task):
        count, at = task.knots + 1, 0
        self.robot = task.robot
        self.pose, self.com = np.zeros((count, POSE), int), np.zeros((count, 3), int)
        self.foot, self.force = np.zeros((count, 4, 3), int), np.full((count, 4, 3), -1)
        self.stance = np.array([[task.stands(i, j) for j in range(4)] for i in range(count)])
        for i in range(count):
            for block in (self.pose[i], self.com[i], self.foot[i]):
                block[...] = at + np.arange(block.size).reshape(block.shape)
                at += block.size
            for j in np.flatnonzero(self.stance[i]):
                self.force[i, j] = at + np.arange(3)
                at += 3
        self.size = at
        self.force[~self.stance] = at

    def units(self):
        """Size of what each entry of m counts: leg length, weight, radian."""
        out = np.ones(self.size)
        for places in (self.pose[:, :3], self.com, self.foot):
            out[places] = LEG_LENGTH
        out[self.force[self.stance]] = self.robot.weight
        return out

    def slots(self):
        """The first index of each part, knot by knot, as the stored documents tell it."""
        return [
            dict(
                q=int(self.pose[i, 0]),
                x=int(self.com[i, 0]),
                e=int(self.foot[i, 0, 0]),
                f=[int(self.force[i, j, 0]) if self.stance[i, j] else None for j in range(4)],
            )
            for i in range(len(self.pose))
        ]


class Motion:
    """The parts of m as tensors; forces of swinging feet are zero."""

    def __init__(self, layout, m):
        padded = tape.concatenate([m, np.zeros(1)])
        self.pose, self.com, self.foot = m[layout.pose], m[layout.com], m[layout.foot]
        self.force = padded[layout.force]


def standing(task, layout, s):
    """m of standing in the nominal pose, sliding along at the wanted speed, the weight shared by
    the feet in stance."""
    home = np.concatenate([np.zeros(6), NOMINAL])
    placed = Placed(task.robot, tape.tensor(home[None]), tape.tensor(s))
    com, feet = placed.com().value[0], placed.feet.value[0]
    lift = np.array([0.0, 0.0, FOOT_RADIUS - feet[:, 2].min()])
    m = np.zeros(layout.size)
    for i in range(task.knots + 1):
        shift = task.place(task.knots) * (i / task.knots) + lift
        m[layout.pose[i]] = home
        m[layout.pose[i, :3]] = shift
        m[layout.com[i]], m[layout.foot[i]] = com + shift, feet + shift
        stance = layout.force[i, layout.stance[i]]
        m[stance[:, 2]] = task.robot.weight / max(1, len(stance))
    return m
