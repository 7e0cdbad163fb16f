# SPDX-License-Identifier: Apache-2.0
"""The terms of F, each as a function of one State. Numbers in brackets are the paper's equations.

Residuals are dimensionless: lengths by the leg, forces by the weight, torques by their product.
"""
import numpy as np

import robot
import tape
from motion import Motion
from robot import FOOT_RADIUS, LEG_LENGTH, MASS, WEIGHT
from task import BARRIER_EDGE, WEIGHTS
from vectors import UNIT, cross, dot, times

UP = UNIT[2]
BEND_TIME = 4e-3  # [s²], makes accelerations of angles dimensionless


class State:
    """Everything that the terms look at, for one s and m."""

    def __init__(self, task, layout, s, m):
        self.task, self.stance, self.s = task, layout.stance, s
        self.motion = Motion(layout, m)
        self.placed = robot.Placed(self.motion.pose, s)
        share = np.arange(task.knots + 1)[:, None] / task.knots
        self.path = task.travel * share * [1, 1, 0] + task.com_height * UP  # wanted COM

    def pairs(self, condition):
        """Indices (knot, foot) at knots 0 ... T - 1 for which the condition holds."""
        found = [(i, j) for i in range(self.task.knots) for j in range(4) if condition(i, j)]
        return tuple(np.array(found).T)


def bend(values, travel):
    """values₋ - 2 values + values₊ at knots 0 ... T - 1; before knot 0 stands knot T - 1 moved
    back by one cycle's travel."""
    before = tape.concatenate([values[-2:-1] - travel, values[:-2]])
    return before - 2.0 * values[:-1] + values[1:]


def half_square(residual):
    return 0.5 * (residual * residual).sum()


def barrier(slack):
    """-log(slack) above the edge, below it the parabola with the same value and derivatives."""
    inside, edge = slack.value.real > BARRIER_EDGE, BARRIER_EDGE
    u = slack / edge - 2.0
    parabola = 0.5 * (u * u - 1.0) - np.log(edge)
    return tape.where(inside, -tape.log(tape.where(inside, slack, edge)), parabola).sum()


def travel(state):  # (9)
    com = state.motion.com
    return half_square((com[-1] - com[0] - state.task.travel) / LEG_LENGTH)


def turning(state):  # (9)
    return half_square(state.motion.pose[-1, 5] - state.motion.pose[0, 5])


def style_com(state):  # (10)
    return half_square((state.motion.com - state.path) / LEG_LENGTH)


def style_foot(state):  # (10)
    wanted = state.path[:, None, :2] + np.array(state.task.footprint)
    return half_square((state.motion.foot[:, :, :2] - wanted) / LEG_LENGTH)


def trunk_orientation(state):  # (10)
    return half_square(state.motion.pose[:, 3:6])


def nominal_pose(state):
    return half_square(state.motion.pose[:, 6:] - robot.NOMINAL)


def smoothness(state):  # (11)
    angles = state.motion.pose[:, 3:]
    return half_square(bend(angles, 0.0) * (BEND_TIME / state.task.step**2))


def com_position(state):  # (12)
    return half_square((state.placed.com() - state.motion.com) / LEG_LENGTH)


def foot_position(state):  # (12)
    return half_square((state.placed.feet - state.motion.foot) / LEG_LENGTH)


def force_balance(state):  # (13)
    acceleration = bend(state.motion.com, state.task.travel) / state.task.step**2
    force = state.motion.force[:-1].sum(1)
    return half_square((force - MASS * (acceleration + robot.GRAVITY * UP)) / WEIGHT)


def torque_balance(state):
    """(13) about the COM, with the rate of angular momentum of all masses. Forces act where the
    balls touch the ground."""
    motion, points = state.motion, state.placed.points
    com = motion.com[:-1, None]
    contact = motion.foot[:-1] - FOOT_RADIUS * UP
    torque = cross(contact - com, motion.force[:-1]).sum(1)
    rate = cross(points[:-1] - com, bend(points, state.task.travel)) / state.task.step**2
    rate = (rate * state.placed.masses[:, None]).sum(1)
    return half_square((torque - rate) / (WEIGHT * LEG_LENGTH))


def stance_foot(state):  # (14): the centre of a ball moves by r θ × ẑ while its link turns by θ
    task, total = state.task, 0.0
    for foot, shank in enumerate(state.placed.shanks):
        first = np.array([i for i in range(task.knots)
                          if task.planted(i, foot) and task.planted(i + 1, foot)])
        turn = shank[first + 1] @ shank[first].transpose()
        angle = 0.5 * tape.stack([turn[:, 2, 1] - turn[:, 1, 2], turn[:, 0, 2] - turn[:, 2, 0],
                                  turn[:, 1, 0] - turn[:, 0, 1]], 1)
        centre = state.motion.foot[:, foot]
        roll = FOOT_RADIUS * cross(angle, UP)
        total = total + half_square((centre[first + 1] - centre[first] - roll) / LEG_LENGTH)
    return total


def friction_cone(state):  # (15), rounded at its apex
    force = state.motion.force[:-1][state.stance[:-1]]
    x, y = force[:, 0], force[:, 1]
    tangential = tape.sqrt(x * x + y * y + (1e-3 * WEIGHT)**2)
    return barrier((state.task.friction * force[:, 2] - tangential) / WEIGHT)


def least_normal_force(state):
    force = state.motion.force[:-1][state.stance[:-1]]
    return barrier(force[:, 2] / WEIGHT - state.task.min_normal)


def periodicity(state):  # (17), with root height, feet and forces
    motion = state.motion
    pose = half_square(motion.pose[-1, 2:] - motion.pose[0, 2:])
    feet = half_square((motion.foot[-1] - motion.foot[0] - state.task.travel) / LEG_LENGTH)
    return pose + feet + half_square((motion.force[-1] - motion.force[0]) / WEIGHT)


def ground_height(state):
    height = state.motion.foot[state.pairs(state.task.planted)][:, 2] - FOOT_RADIUS
    return half_square(height / LEG_LENGTH)


def swing_height(state):
    task = state.task
    knots, feet = state.pairs(lambda i, j: not task.planted(i, j))
    phase = np.array([task.swing_phase(i, j) for i, j in zip(knots, feet)])
    height = state.motion.foot[knots, feet][:, 2] - FOOT_RADIUS
    return half_square((height - task.swing_height * np.sin(np.pi * phase)**1.5) / LEG_LENGTH)


def force_size(state):
    return half_square(state.motion.force[:-1] / WEIGHT)


def force_smoothness(state):
    both = state.stance[:-1] & state.stance[1:]
    force = state.motion.force
    return half_square((force[1:][both] - force[:-1][both]) / WEIGHT)


def design_tether(state):
    initial = robot.initial_design()
    scale = np.concatenate([initial[:12], np.ones(36), initial[48:]])
    return half_square((state.s - initial) / scale)


TERMS = (
    travel, turning, style_com, style_foot, trunk_orientation, nominal_pose, smoothness,
    com_position, foot_position, force_balance, torque_balance, stance_foot, friction_cone,
    periodicity, ground_height, swing_height, least_normal_force, force_size, force_smoothness,
    design_tether)


def weighted_terms(task, layout, s, m):
    """Each term times its weight, by name."""
    state = State(task, layout, s, m)
    return {term.__name__: WEIGHTS[term.__name__] * term(state) for term in TERMS}
