# SPDX-License-Identifier: Apache-2.0
"""The points at which F is sampled: random ones, and a plan."""

import dataclasses
import json
import pathlib

import motion
import numpy as np
import robot

LABELS = ('legs all different', 'left and right mirrored', 'legs all different')
PLAN = 'a plan'
PLANS = pathlib.Path(__file__).resolve().parent / 'plans'


@dataclasses.dataclass
class Point:
    label: str
    s: np.ndarray
    m: np.ndarray
    direction: np.ndarray = None  # in m; None: no second derivatives, no gradients by term


def random_design(task, random, mirrored):
    """Lengths and body within 20 % of the initial ones, axes about 30 degrees off lateral."""
    initial = task.robot.initial_design()
    lengths = initial[:12].reshape(4, 3) * random.uniform(0.8, 1.2, (4, 3))
    axes = robot.LATERAL + random.normal(0, 0.3, (4, 3, 3))
    axes /= np.linalg.norm(axes, axis=2, keepdims=True)
    if mirrored:  # a mirrored axis is a pseudo-vector
        lengths[1::2], axes[1::2] = lengths[0::2], axes[0::2] * [-1, 1, -1]
    body = initial[48:50] * random.uniform(0.8, 1.2, 2)
    pistons = initial[50:] + random.uniform(-0.01, 0.01, initial.size - 50)
    return np.concatenate([lengths.ravel(), axes.ravel(), body, pistons])


def random_motion(task, layout, s, random):
    """Standing, with noise that leaves no residual at zero and takes both barriers to both sides of
    their edge."""
    m = motion.standing(task, layout, s)
    for i in range(task.knots + 1):
        pose = layout.pose[i]
        m[pose[:3]] += random.normal(0, 0.01, 3)
        m[pose[3:6]] += random.normal(0, 0.15, 3)
        m[pose[6:]] += random.normal(0, 0.2, 12)
        m[np.concatenate([layout.com[i], layout.foot[i].ravel()])] += random.normal(0, 0.01, 15)
        for force in layout.force[i, layout.stance[i]]:
            sideways = 0.05 * task.robot.weight
            m[force] += random.normal(0, [sideways, sideways, m[force[2]]])
    return m


def check_barriers(task, layout, m):
    """Fails unless both barriers are met above and below their edge."""
    force = m[layout.force[:-1][layout.stance[:-1]]] / task.robot.weight
    tangential = np.sqrt(force[:, 0] ** 2 + force[:, 1] ** 2 + 1e-6)
    for slack in (task.friction * force[:, 2] - tangential, force[:, 2] - task.min_normal):
        above = int((slack > task.barrier_edge).sum())
        if not 5 < above < len(slack) - 5:
            raise ValueError('the points meet a barrier from one side only')


def random_direction(layout, random):
    """Scaled like m, with few digits, which keeps the documents small."""
    return np.array([float(f'{x:.3g}') for x in random.normal(size=layout.size) * layout.units()])


def read_plan(task):
    """A point near which F is least: residuals are small there, as they never are at random."""
    plan = json.loads((PLANS / f'{task.name}.json').read_text(encoding='utf-8'))
    return np.array(plan['s']), np.array(plan['m'])


def draw(task, layout):
    random, points = np.random.default_rng(task.seed), []
    for k, label in enumerate(LABELS):
        s = random_design(task, random, 'mirrored' in label)
        m = random_motion(task, layout, s, random)
        check_barriers(task, layout, m)
        points.append(Point(label, s, m, random_direction(layout, random) if k == 0 else None))
    if task.has_plan:
        points.append(Point(PLAN, *read_plan(task), random_direction(layout, random)))
    return points
