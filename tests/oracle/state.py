# SPDX-License-Identifier: Apache-2.0
"""Everything that the terms look at, for one s and m, and what several of them do with it."""

import equipment
import numpy as np
import tape
from motion import Motion
from robot import FOOT_RADIUS, GRAVITY, Placed
from vectors import UNIT, cross, dot, times

UP = UNIT[2]  # of the ground


class State:
    def __init__(self, task, layout, s, m):
        self.task, self.robot, self.stance, self.s = task, task.robot, layout.stance, s
        self.motion = Motion(layout, m)
        self.placed = Placed(task.robot, self.motion.pose, s)
        # One cycle moves everything by p -> turn p + travel.
        self.turn, self.travel = task.turn(task.knots), task.place(task.knots)
        self.turn_angle = task.heading(task.knots)
        self._torques = None

    def pairs(self, condition):
        """Indices (knot, foot) at knots 0 ... T - 1 for which the condition holds."""
        found = [(i, j) for i in range(self.task.knots) for j in range(4) if condition(i, j)]
        return tuple(np.array(found).T)

    def acceleration(self, places):
        """Second differences of places over time, at knots 0 ... T - 1."""
        moved_back = times(self.turn.T, places[-2:-1] - self.travel)
        return bend(places, moved_back) / self.task.step**2

    def contacts(self):
        """Where balls touch the ground below their centres, as the poses have them; knots < T."""
        return self.placed.feet[:-1] - FOOT_RADIUS * UP

    def joint_torques(self):
        """Of the motors by inverse dynamics, (T, 12): for each joint the moment about its axis that
        moves the masses below it and carries them, less that of the foot's force."""
        if self._torques is None:
            placed, force, contacts = self.placed, self.motion.force[:-1], self.contacts()
            pull = self.acceleration(placed.points) + GRAVITY * self.task.up
            angles = self.motion.pose[:, 6:]
            bends = bend(angles, angles[-2:-1]) / self.task.step**2
            torques = []
            for joint, moved in enumerate(placed.moved):
                anchor, leg = placed.anchors[:-1, joint], joint // 3
                arms = placed.points[:-1][:, moved] - anchor[:, None]
                moment = cross(arms, pull[:, moved] * placed.masses[moved][:, None]).sum(1)
                moment = moment - cross(contacts[:, leg] - anchor, force[:, leg])
                torques.append(
                    dot(placed.axes[:-1, joint], moment)
                    + armature(self.robot, joint) * bends[:, joint]
                    + self._resistance(joint)
                )
            self._torques = tape.stack(torques, 1)
        return self._torques


    def _resistance(self, joint):
        """Torque of a joint's damper and spring that its motor works against, at knots < T."""
        if not self.robot.equipped:
            return 0.0
        angles, k = self.motion.pose[:, 6 + joint], joint % 3
        before = tape.concatenate([angles[-2:-1], angles[:-2]])
        speed = (angles[1:] - before) / (2.0 * self.task.step)
        return equipment.DAMPING[k] * speed + equipment.STIFFNESS[k] * (
            angles[:-1] - equipment.SLACK_ANGLE[k]
        )


def armature(robot, joint):
    return equipment.ARMATURE[joint % 3] if robot.equipped else 0.0


def bend(values, before_first):
    """values₋ - 2 values + values₊ at knots 0 ... T - 1; before_first stands before knot 0: knot
    T - 1, moved back by one cycle."""
    before = tape.concatenate([before_first, values[:-2]])
    return before - 2.0 * values[:-1] + values[1:]
