# SPDX-License-Identifier: Apache-2.0
"""The terms that only the equipped puppy has: limits of joints, motors and pistons, flat feet,
limbs that keep apart, and what motors and bodies cost."""

import clearance
import equipment
import numpy as np
import tape
from penalties import barrier, half_square, near_barrier
from pistons import LEGS, Piston
from robot import LEG_LENGTH, NOMINAL
from vectors import times

TORQUE_RANGE = 0.3  # share of what is allowed over which barriers of torque and force act
WORK_ROUNDING = 1e-4  # of |work| at zero, share of weight times length


def joint_limits(state):
    total = 0.0
    for joint in range(12):
        lower, upper = equipment.JOINT_LOWER[joint % 3], equipment.JOINT_UPPER[joint % 3]
        angle, margin = state.motion.pose[:-1, 6 + joint], state.task.joint_margin
        half = (upper - lower) / 2 - margin if np.isfinite(upper - lower) else 1.0
        edge = state.task.barrier_edge
        if np.isfinite(lower):
            total = total + barrier((angle - lower - margin) / half, edge)
        if np.isfinite(upper):
            total = total + barrier((upper - margin - angle) / half, edge)
    return total


def _torque_shares(state):
    """Torques of the motors that have a limit, as shares of it, (T, motors)."""
    limit = np.array((np.array(equipment.TORQUE_LIMIT) - equipment.FRICTION_LOSS).tolist() * 4)
    limited = np.flatnonzero(np.isfinite(limit))
    return state.joint_torques()[:, limited] / limit[limited]


def torque_limits(state):
    share = _torque_shares(state) / (1 - state.task.torque_margin)
    edge = state.task.barrier_edge
    return sum(near_barrier((1.0 + sign * share) / TORQUE_RANGE, edge) for sign in (-1.0, 1.0))


def peak_torque(state):
    """16th powers of the torques of all motors. Feet here are planted for longer than one knot, so
    that servos add nothing."""
    power = state.joint_torques() / (state.robot.weight * LEG_LENGTH)
    for _ in range(4):
        power = power * power
    return power.sum()


def mechanical_work(state):
    """Positive parts of τ Δq of all motors over the cycle, with a rounded root."""
    angles, unit = state.motion.pose[:, 6:], state.robot.weight * LEG_LENGTH
    before = tape.concatenate([angles[-2:-1], angles[:-2]])
    work = state.joint_torques() * (angles[1:] - before) / 2.0 / unit
    return (0.5 * (work + tape.sqrt(work * work + WORK_ROUNDING**2) - WORK_ROUNDING)).sum()


def printed_volume(state):
    return state.placed.volume / LEG_LENGTH**3


def stroke_limits(state):
    half = (equipment.PISTON_LONGEST - equipment.PISTON_SHORTEST) / 2
    total, edge = 0.0, state.task.barrier_edge
    for leg in LEGS:
        length = Piston(state.placed.design, leg, state.motion.pose[:-1, 7 + 3 * leg]).length
        total = total + barrier((length - equipment.PISTON_SHORTEST) / half, edge)
        total = total + barrier((equipment.PISTON_LONGEST - length) / half, edge)
    return total


def actuator_force(state):
    """|τ| stays below the allowed force times the moment arm, which keeps its sign at home."""
    allowed = (1 - state.task.torque_margin) * equipment.PISTON_FORCE
    home_design = state.robot.home().design
    total, edge = 0.0, state.task.barrier_edge
    for leg in LEGS:
        knee = 1 + 3 * leg
        home = Piston(home_design, leg, tape.tensor(NOMINAL[knee : knee + 1])).arm.value[0]
        arm = Piston(state.placed.design, leg, state.motion.pose[:-1, 6 + knee]).arm
        reach = state.joint_torques()[:, knee] / allowed
        for sign in (-1.0, 1.0):
            slack = np.sign(home) * arm + sign * reach
            total = total + near_barrier(slack / (TORQUE_RANGE * abs(home)), edge)
    return total


def flat_foot(state):
    """Soles are level at all knots and do not turn while they are planted."""
    task, total = state.task, 0.0
    for foot, shank in enumerate(state.placed.shanks):
        ahead, beside = (times(shank, direction) for direction in equipment.sole(foot))
        total = total + half_square(ahead[:, 2]) + half_square(beside[:, 2])
        first = np.array(
            [i for i in range(task.knots) if task.planted(i, foot) and task.planted(i + 1, foot)]
        )
        total = total + half_square((ahead[first + 1] - ahead[first])[:, :2])
    return total


def limb_clearance(state):  # (16), the right way round
    pairs = clearance.pairs(state.robot, state.task.clearance)
    least, reach = (
        np.array([[getattr(pair, name)] for pair in pairs]) for name in ('clearance', 'range')
    )
    gap = clearance.distances(pairs, state.placed)[:, :-1] - least
    return near_barrier(gap / reach, state.task.barrier_edge)


TERMS = (
    joint_limits,
    torque_limits,
    peak_torque,
    mechanical_work,
    printed_volume,
    stroke_limits,
    actuator_force,
    flat_foot,
    limb_clearance,
)
