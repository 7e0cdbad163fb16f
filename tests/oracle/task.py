# SPDX-License-Identifier: Apache-2.0
"""The tasks: gaits, what is wanted of the motion, and weights."""

import numpy as np
import tape
from robot import BODY_LENGTH, BODY_WIDTH, LEG_LENGTH, SIDES, Robot
from vectors import UNIT, times

WEIGHTS = dict(
    travel=1e3,
    turning=1e3,
    com_position=1e4,
    style_com=1.0,
    trunk_orientation=1.0,
    nominal_pose=1e-2,
    foot_position=1e4,
    style_foot=0.3,
    force_balance=1e3,
    torque_balance=1e3,
    smoothness=0.3,
    ground_height=1e4,
    stance_foot=1e4,
    friction_cone=1e-3,
    least_normal_force=1e-3,
    force_size=1e-3,
    force_smoothness=1e-3,
    swing_height=1e3,
    periodicity=1e4,
    design_tether=0.05,
)
EQUIPPED_WEIGHTS = dict(
    flat_foot=1e4,
    joint_limits=1e-3,
    torque_limits=1e-3,
    stroke_limits=1e-3,
    actuator_force=1e-3,
    limb_clearance=1e-3,
    mechanical_work=1.0,
    peak_torque=1e3,
    printed_volume=1.0,
    style_foot_height=2.0,
    style_joint=0.5,
)
FOOTPRINT = np.array(((0.12, 0.09), (0.12, -0.09), (-0.12, 0.09), (-0.12, -0.09)))  # [m]


class Task:
    """One gait and its aims. Knots count 0 ... T; knot T is knot 0 one cycle later."""

    barrier_edge = 0.02
    com_height, swing_height = 0.175, 0.025  # [m]
    friction, min_normal = 0.4, 0.1  # coefficient; share of the weight
    joint_margin, torque_margin = 0.0, 0.1  # [rad]; share of the limit
    clearance = 0.095 * LEG_LENGTH  # of limbs [m]
    turn_rate = 0.0  # [rad/s]
    up = np.array([0.0, 0.0, 1.0])  # against gravity
    com_heights = com_path = foot_targets = None  # lists over the cycle
    foot_heights = joint_angles = None  # by foot, by joint: (weight, [(phase, value), ...])
    constant_inertia = False  # in the torque balance
    follow_hips = False  # whether the footprint follows the hips of the design

    def __init__(self, name, seed, period, phase, duty, velocity, knots=24, planted_margin=1):
        self.name, self.seed = name, seed
        self.period, self.phase, self.duty = period, phase, duty  # [s], shares of the cycle
        self.velocity = velocity  # forward, left in the heading frame [m/s]
        self.knots, self.step = knots, period / knots
        self.planted_margin = planted_margin  # knots on the ground before and after stance
        cycle = (np.arange(knots)[:, None] / knots - np.array(phase)) % 1.0
        self.contact = cycle < duty - 1e-9  # (T, 4): in stance, and so with a force
        self.robot, self.weights, self.has_plan = Robot(), WEIGHTS, True

    def stands(self, knot, foot):
        return bool(self.contact[knot % self.knots, foot])

    def planted(self, knot, foot):
        """On the ground: in stance, or at most the margin away from it."""
        margin = self.planted_margin
        return any(self.stands(knot + o, foot) for o in range(-margin, margin + 1))

    def swing_phase(self, knot, foot):
        """Where in its swing a foot is that is not planted, above 0 and below 1."""
        first = last = knot
        while not self.planted(first - 1, foot):
            first -= 1
        while not self.planted(last + 1, foot):
            last += 1
        return (knot - first + 1) / (last - first + 2)

    def heading(self, knot):
        return self.turn_rate * knot * self.step

    def turn(self, knot):
        """From the heading frame at a knot to the world, (3, 3)."""
        c, s = np.cos(self.heading(knot)), np.sin(self.heading(knot))
        return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])

    def place(self, knot):
        """Where the wanted path is: an arc, or a straight line [m]."""
        time, half = knot * self.step, self.heading(knot) / 2
        chord = time * np.sinc(half / np.pi)  # of an arc of unit speed; it leads at half the turn
        c, s = chord * np.cos(half), chord * np.sin(half)
        forward, left = self.velocity
        return np.array([c * forward - s * left, s * forward + c * left, 0.0])

    def com_target(self, knot):
        height = (
            self.com_height
            if self.com_heights is None
            else over_cycle(self.com_heights, knot / self.knots)
        )
        sway = (
            np.zeros(2) if self.com_path is None else over_cycle(self.com_path, knot / self.knots)
        )
        return self.place(knot) + self.turn(knot) @ np.append(sway, height)

    def foot_target(self, knot, foot, design):
        """On the ground, (2). Without a list of its own, a foot may follow its hip: a body that is
        longer and wider than the given one takes its feet along."""
        own = (self.foot_targets or {}).get(foot)
        spot = tape.tensor(FOOTPRINT[foot] if own is None else over_cycle(own, knot / self.knots))
        if own is None and self.follow_hips:
            front, left = SIDES[foot]
            spot = spot + 0.5 * front * (design.length - BODY_LENGTH) * UNIT[0][:2]
            spot = spot + 0.5 * left * (design.width - BODY_WIDTH) * UNIT[1][:2]
        return times(self.turn(knot)[:2, :2], spot) + self.place(knot)[:2]


def between_phases(pairs, phase):
    """The value at a phase of (phase, value) pairs, straight in between and round the cycle."""
    phases, values = np.array(pairs).T
    return np.interp(phase, phases, values, period=1.0)


def over_cycle(values, phase):
    """A list of values, evenly spaced over the cycle, straight in between, at a phase."""
    ring = np.concatenate([values, values[:1]])
    at = np.linspace(0, 1, len(ring))
    if ring.ndim == 1:
        return np.interp(phase % 1.0, at, ring)
    return np.array([np.interp(phase % 1.0, at, column) for column in ring.T])


def equipped_turn():
    """The equipped puppy on a slope and in a curve: everything that the other tasks leave out."""
    task = Task(
        'equipped_turn',
        20180002,
        0.8,
        (0, 0.5, 0.75, 0.25),
        0.65,
        (0.06, 0.08),
        knots=16,
        planted_margin=2,
    )
    task.robot, task.weights, task.has_plan = Robot(True), {**WEIGHTS, **EQUIPPED_WEIGHTS}, False
    task.turn_rate = 0.6
    task.up = np.array([0.1, -0.05, 1.0]) / np.linalg.norm([0.1, -0.05, 1.0])
    task.joint_margin, task.torque_margin, task.clearance = 0.05, 0.2, 0.13
    task.com_heights = np.array([0.17, 0.18, 0.175])
    task.com_path = np.array([[0.01, 0.0], [-0.01, 0.01]])
    task.follow_hips = True
    task.foot_targets = {1: np.array([[0.1, -0.09], [0.12, -0.1], [0.14, -0.08]])}
    task.foot_heights = {2: (1.5, [[0.1, 0.01], [0.55, 0.05], [0.8, 0.03]])}
    task.joint_angles = {
        1: (0.7, [[0.0, -0.9], [0.5, -1.1]]),
        11: (2.0, [[0.25, 0.5], [0.3, 0.7], [0.9, 0.6]]),
    }
    return task


def constant_turn():
    """The torque balance as the paper has it, of the equipped puppy in a curve."""
    task = equipped_turn()
    task.name, task.seed, task.constant_inertia = 'constant_turn', 20180003, True
    task.weights = dict(torque_balance=1e3, stance_foot=1e4)
    return task


TASKS = (
    Task('puppy_walk', 20180000, 1.0, (0, 0.5, 0.75, 0.25), 0.75, (0.0, 0.1)),
    Task('puppy_trot', 20180001, 0.4, (0, 0.5, 0.5, 0), 0.5, (0.0, 0.1)),
    equipped_turn(),
    constant_turn(),
)
