# SPDX-License-Identifier: Apache-2.0
"""The tasks: gaits, what is wanted of the motion, and weights."""
import numpy as np

BARRIER_EDGE = 0.02
WEIGHTS = dict(
    travel=1e3, turning=1e3, com_position=1e4, style_com=1.0, trunk_orientation=1.0,
    nominal_pose=1e-2, foot_position=1e4, style_foot=0.3, force_balance=1e3, torque_balance=1e3,
    smoothness=0.3, ground_height=1e4, stance_foot=1e4, friction_cone=1e-3,
    least_normal_force=1e-3, force_size=1e-3, force_smoothness=1e-3, swing_height=1e3,
    periodicity=1e4, design_tether=0.05)


class Task:
    """One gait and its aims. Knots count 0 ... T; knot T is knot 0 one cycle later."""

    knots = 24
    com_height, swing_height = 0.175, 0.025  # [m]
    footprint = ((0.12, 0.09), (0.12, -0.09), (-0.12, 0.09), (-0.12, -0.09))  # [m]
    friction, min_normal = 0.4, 0.1          # coefficient; share of the weight
    planted_margin = 1                       # knots on the ground before and after stance

    def __init__(self, name, seed, period, phase, duty, travel):
        self.name, self.seed = name, seed
        self.period, self.phase, self.duty = period, phase, duty  # [s], shares of the cycle
        self.travel = np.array(travel)  # of one cycle [m]
        self.step = period / self.knots
        cycle = (np.arange(self.knots)[:, None] / self.knots - np.array(phase)) % 1.0
        self.contact = cycle < duty - 1e-9  # (T, 4): in stance, and so with a force

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


TASKS = (
    Task('puppy_walk', 20180000, 1.0, (0, 0.5, 0.75, 0.25), 0.75, (0, 0.1, 0)),
    Task('puppy_trot', 20180001, 0.4, (0, 0.5, 0.5, 0), 0.5, (0, 0.04, 0)))
