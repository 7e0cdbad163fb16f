# SPDX-License-Identifier: Apache-2.0
"""The terms of F that every robot has, each as a function of one State. Numbers in brackets are
the paper's equations.

Residuals are dimensionless: lengths by the leg, forces by the weight, torques by their product.
"""

import limits
import numpy as np
import tape
from penalties import barrier, half_square
from robot import FOOT_RADIUS, GRAVITY, LEG_LENGTH, NOMINAL, Placed
from state import UP, State, bend
from task import between_phases
from vectors import cross, times

BEND_TIME = 4e-3  # [s²], makes accelerations of angles dimensionless
APEX = 1e-3  # at which friction cones are rounded, share of the weight
YAW = np.eye(15)[2]  # among the root's rotation vector and the joint angles


def travel(state):  # (9)
    com = state.motion.com
    return half_square((com[-1] - times(state.turn, com[0]) - state.travel) / LEG_LENGTH)


def turning(state):  # (9)
    return half_square(state.motion.pose[-1, 5] - state.motion.pose[0, 5] - state.turn_angle)


def style_com(state):  # (10)
    wanted = np.array([state.task.com_target(i) for i in range(state.task.knots + 1)])
    return half_square((state.motion.com - wanted) / LEG_LENGTH)


def style_foot(state):  # (10)
    wanted = tape.stack(
        [
            tape.stack([state.task.foot_target(i, j, state.placed.design) for j in range(4)])
            for i in range(state.task.knots + 1)
        ]
    )
    return half_square((state.motion.foot[:, :, :2] - wanted) / LEG_LENGTH)


def style_foot_height(state):  # (10), at knots that are not planted
    task, total = state.task, 0.0
    for foot, (weight, pairs) in task.foot_heights.items():
        knots = np.array([i for i in range(task.knots) if not task.planted(i, foot)])
        wanted = np.array([between_phases(pairs, i / task.knots) for i in knots])
        height = state.motion.foot[knots, foot][:, 2] - FOOT_RADIUS
        total = total + weight * half_square((height - wanted) / LEG_LENGTH)
    return total


def style_joint(state):  # (10)
    total, count = 0.0, state.task.knots
    for joint, (weight, pairs) in state.task.joint_angles.items():
        wanted = np.array([between_phases(pairs, i / count) for i in range(count + 1)])
        total = total + weight * half_square(state.motion.pose[:, 6 + joint] - wanted)
    return total


def trunk_orientation(state):  # (10)
    heading = np.array([[0.0, 0.0, state.task.heading(i)] for i in range(state.task.knots + 1)])
    return half_square(state.motion.pose[:, 3:6] - heading)


def nominal_pose(state):
    return half_square(state.motion.pose[:, 6:] - NOMINAL)


def smoothness(state):  # (11)
    angles = state.motion.pose[:, 3:]
    bends = bend(angles, angles[-2:-1] - state.turn_angle * YAW)
    return half_square(bends * (BEND_TIME / state.task.step**2))


def com_position(state):  # (12)
    return half_square((state.placed.com() - state.motion.com) / LEG_LENGTH)


def foot_position(state):  # (12)
    return half_square((state.placed.feet - state.motion.foot) / LEG_LENGTH)


def force_balance(state):  # (13)
    pull = state.acceleration(state.motion.com) + GRAVITY * state.task.up
    force = state.motion.force[:-1].sum(1) - state.placed.masses.sum() * pull
    return half_square(force / state.robot.weight)


def torque_balance(state):
    """(13) about the COM, with the rate of angular momentum of all masses. Forces act where the
    balls touch the ground."""
    motion, points = state.motion, state.placed.points
    com = motion.com[:-1, None]
    contact = motion.foot[:-1] - FOOT_RADIUS * UP
    torque = cross(contact - com, motion.force[:-1]).sum(1)
    if state.task.constant_inertia:
        rate = constant_inertia_rate(state)
        return half_square((torque - rate) / (state.robot.weight * LEG_LENGTH))
    rate = cross(points[:-1] - com, state.acceleration(points))
    rate = (rate * state.placed.masses[:, None]).sum(1)
    return half_square((torque - rate) / (state.robot.weight * LEG_LENGTH))


def constant_inertia_rate(state):
    """(13) as in the paper: I ö with o the root's rotation vector and I about the COM in the home
    pose, turned by the wanted heading."""
    home = Placed(state.robot, tape.tensor(np.concatenate([np.zeros(6), NOMINAL])[None]), state.s)
    arm = (home.points - home.com()[:, None])[0]
    turned = state.motion.pose[:, 3:6]
    back = turned[-2:-1] - np.array([0.0, 0.0, state.turn_angle])
    accelerations = bend(turned, back) / state.task.step**2
    rates = []
    for knot in range(state.task.knots):
        heading = state.task.turn(knot)
        spin = times(heading.T, accelerations[knot])
        # I ω = Σ m a × (ω × a)
        momentum = (cross(arm, cross(spin, arm)) * home.masses[:, None]).sum(0)
        rates.append(times(heading, momentum))
    return tape.stack(rates, 0)


def stance_foot(state):  # (14): the centre of a ball moves by r θ × ẑ while its link turns by θ
    task, total = state.task, 0.0
    for foot, shank in enumerate(state.placed.shanks):
        first = np.array(
            [i for i in range(task.knots) if task.planted(i, foot) and task.planted(i + 1, foot)]
        )
        turn = shank[first + 1] @ shank[first].transpose()
        angle = 0.5 * tape.stack(
            [
                turn[:, 2, 1] - turn[:, 1, 2],
                turn[:, 0, 2] - turn[:, 2, 0],
                turn[:, 1, 0] - turn[:, 0, 1],
            ],
            1,
        )
        centre = state.motion.foot[:, foot]
        roll = FOOT_RADIUS * cross(angle, UP)
        total = total + half_square((centre[first + 1] - centre[first] - roll) / LEG_LENGTH)
    return total


def friction_cone(state):  # (15), rounded at its apex
    force = state.motion.force[:-1][state.stance[:-1]] / state.robot.weight
    x, y = force[:, 0], force[:, 1]
    tangential = tape.sqrt(x * x + y * y + APEX**2)
    return barrier(state.task.friction * force[:, 2] - tangential, state.task.barrier_edge)


def least_normal_force(state):
    force = state.motion.force[:-1][state.stance[:-1]] / state.robot.weight
    return barrier(force[:, 2] - state.task.min_normal, state.task.barrier_edge)


def periodicity(state):  # (17), with root height, feet and forces
    motion, turn = state.motion, state.turn
    height = half_square(motion.pose[-1, 2] - motion.pose[0, 2])
    angles = motion.pose[-1, 3:] - motion.pose[0, 3:] - state.turn_angle * YAW
    feet = motion.foot[-1] - times(turn, motion.foot[0]) - state.travel
    force = motion.force[-1] - times(turn, motion.force[0])
    return (
        height
        + half_square(angles)
        + half_square(feet / LEG_LENGTH)
        + half_square(force / state.robot.weight)
    )


def ground_height(state):
    height = state.motion.foot[state.pairs(state.task.planted)][:, 2] - FOOT_RADIUS
    return half_square(height / LEG_LENGTH)


def swing_height(state):
    task = state.task
    own = task.foot_heights or {}  # these feet have style_foot_height
    knots, feet = state.pairs(lambda i, j: not task.planted(i, j) and j not in own)
    phase = np.array([task.swing_phase(i, j) for i, j in zip(knots, feet)])
    height = state.motion.foot[knots, feet][:, 2] - FOOT_RADIUS
    return half_square((height - task.swing_height * np.sin(np.pi * phase) ** 1.5) / LEG_LENGTH)


def force_size(state):
    return half_square(state.motion.force[:-1] / state.robot.weight)


def force_smoothness(state):
    both = state.stance[:-1] & state.stance[1:]
    force = state.motion.force
    return half_square((force[1:][both] - force[:-1][both]) / state.robot.weight)


def design_tether(state):
    """Lengths relative to their initial values, axis components as they are, and the pistons' lower
    ends over the leg, once for each of the four pistons."""
    initial = state.robot.initial_design()
    scale = np.concatenate(
        [initial[:12], np.ones(36), initial[48:50], np.full(initial.size - 50, LEG_LENGTH / 2)]
    )
    return half_square((state.s - initial) / scale)


TERMS = {
    term.__name__: term
    for term in (
        travel,
        turning,
        style_com,
        style_foot,
        style_foot_height,
        style_joint,
        trunk_orientation,
        nominal_pose,
        smoothness,
        com_position,
        foot_position,
        force_balance,
        torque_balance,
        stance_foot,
        friction_cone,
        periodicity,
        ground_height,
        swing_height,
        least_normal_force,
        force_size,
        force_smoothness,
        design_tether,
    )
    + limits.TERMS
}


def weighted_terms(task, layout, s, m):
    """Each term of the task times its weight, by name."""
    state = State(task, layout, s, m)
    return {name: weight * TERMS[name](state) for name, weight in task.weights.items()}
