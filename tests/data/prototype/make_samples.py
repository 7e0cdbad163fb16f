#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes puppy_walk.json and puppy_trot.json: values and gradients of F by the reference planner.

Usage: make_samples.py PROTOTYPE_DIR        (needs casadi, numpy and scipy)
PROTOTYPE_DIR holds the planner.py and codesign.py of the reference. Layout: ../README.md.
Numbers are written as the shortest text that reads back as the same float64. Fixed seeds; two runs
on one machine give the same bytes.
"""
import json
import pathlib
import sys

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
CORNERS = [(1, 1), (1, -1), (-1, 1), (-1, -1)]  # front left, front right, hind left, hind right
LATERAL = np.array([0.0, 1.0, 0.0])
TASKS = {
    'puppy_walk': dict(period=1.0, phase=[0, .5, .75, .25], duty=.75, travel=[0, .1, 0]),
    'puppy_trot': dict(period=.4, phase=[0, .5, .5, 0], duty=.5, travel=[0, .04, 0]),
}
COMMON = dict(knots=24, com_height=.175, footprint=[(.12, .09), (.12, -.09), (-.12, .09), (-.12, -.09)],
              swing_height=.025, friction=.4, min_normal=.1, planted_margin=1)


def make_robot(reference):
    legs = [dict(side=c, lengths=[.06, .08, .07], axes=[LATERAL] * 3) for c in CORNERS]
    return reference.Robot(legs, .24, .14, [.5, -1.0, .6] * 4)


def make_planner(reference, robot, task):
    contact = reference.contact_flags(COMMON['knots'], task['phase'], task['duty'])
    return reference.Planner(robot, COMMON['knots'], task['period'], contact, task['travel'], COMMON['com_height'],
                             COMMON['footprint'], COMMON['swing_height'], COMMON['friction'], COMMON['min_normal'],
                             COMMON['planted_margin'])


def random_design(robot, random, mirrored):
    """Lengths within ±20 %, axes within about 30 degrees of lateral, exact unit length, body within ±20 %."""
    s0 = robot.initial_design()
    lengths = s0[:12].reshape(4, 3) * random.uniform(.8, 1.2, (4, 3))
    axes = LATERAL + random.normal(0, .3, (4, 3, 3))
    axes /= np.linalg.norm(axes, axis=2, keepdims=True)
    if mirrored:  # a mirrored axis is a pseudo-vector
        lengths[1::2], axes[1::2] = lengths[0::2], axes[0::2] * [-1, 1, -1]
    return np.concatenate([lengths.ravel(), axes.ravel(), s0[-2:] * random.uniform(.8, 1.2, 2)])


def random_motion(planner, s, random):
    """The initial guess plus noise that drives barriers to both sides of their edge and leaves no residual at zero."""
    m, weight = planner.initial_guess(s), planner.robot.mass * 9.81
    for slot in planner.slots:
        q, x = slot['q'], slot['x']
        m[q:q + 3] += random.normal(0, .01, 3)
        m[q + 3:q + 6] += random.normal(0, .15, 3)
        m[q + 6:q + planner.nq] += random.normal(0, .2, planner.nq - 6)
        m[x:x + 15] += random.normal(0, .01, 15)
        for f in slot['f']:
            if f is not None:
                m[f:f + 3] += random.normal(0, [.05 * weight, .05 * weight, m[f + 2]])
    return m


def split_design(s):
    return dict(lengths=s[:12].reshape(4, 3).tolist(), axes=s[12:48].reshape(4, 3, 3).tolist(),
                body_width=float(s[48]), body_length=float(s[49]))


def check_barriers(planner, m):
    """Fails unless both barriers are met above and below their edge (slack 0.02)."""
    weight, edge = planner.robot.mass * 9.81, .02
    forces = np.array([m[f:f + 3] for slot in planner.slots[:-1] for f in slot['f'] if f is not None]) / weight
    cone = COMMON['friction'] * forces[:, 2] - np.sqrt(forces[:, 0]**2 + forces[:, 1]**2 + 1e-6)
    for slack in (cone, forces[:, 2] - COMMON['min_normal']):
        assert (slack > edge).sum() > 5 and (slack < edge).sum() > 5, 'barrier seen from one side only'


class Oracle:
    """Values and gradients of each term and of F."""

    def __init__(self, ca, planner):
        self.planner = planner
        m, s, v = ca.SX.sym('m', planner.size), ca.SX.sym('s', 50), ca.SX.sym('v', planner.size)
        terms = planner._terms(m, s)
        gradient = ca.gradient(sum(terms), m)
        self.by_term = ca.Function('by_term', [m, s], [ca.gradient(t, x) for t in terms for x in (m, s)])
        self.total = ca.Function('total', [m, s], [sum(terms), gradient, ca.gradient(sum(terms), s)])
        self.times = ca.Function('times', [m, s, v], [ca.jtimes(gradient, m, v), ca.jtimes(ca.gradient(sum(terms), s), m, v)])

    def sample(self, s, m, label, full=False, random=None):
        value, gradient, partial_s = (np.array(a).ravel() for a in self.total(m, s))
        out = dict(label=label, design=split_design(s), m=m.tolist(), terms=self.planner.terms(m, s), F=float(value[0]),
                   gradient_m=gradient.tolist(), gradient_s=partial_s.tolist())
        if full:
            parts = [np.array(a).ravel() for a in self.by_term(m, s)]
            names = self.planner.term_names
            out['term_gradients_m'] = {n: sparse(parts[2 * i]) for i, n in enumerate(names)}
            out['term_gradients_s'] = {n: sparse(parts[2 * i + 1]) for i, n in enumerate(names)}
            # A direction with few digits, scaled like m, keeps the file small.
            v = np.array([float(f'{a:.3g}') for a in random.normal(size=m.size) * self.planner.units])
            hmm, hsm = (np.array(a).ravel() for a in self.times(m, s, v))
            out['direction_m'], out['hessian_mm_direction'], out['hessian_sm_direction'] = v.tolist(), hmm.tolist(), hsm.tolist()
        return out


def sparse(vector):
    index = np.flatnonzero(vector)
    return dict(index=index.tolist(), value=vector[index].tolist())


def codesigned(reference, codesign, planner, oracle):
    """The reference's own optimum. Its axes are not unit vectors: it normalises them on use, but not in `design`."""
    s0 = planner.robot.initial_design()
    m0, value0, newton0, norm0 = planner.newton(planner.initial_guess(s0), s0)
    s, m, info = codesign.codesign(planner, m0)
    value = float(planner.value(m, s))
    axes = s[12:48].reshape(12, 3)
    norms = np.linalg.norm(axes, axis=1)
    unit = np.concatenate([s[:12], (axes / norms[:, None]).ravel(), s[48:]])
    return dict(
        motion_only=dict(F=value0, newton_iterations=newton0, scaled_gradient_norm=float(norm0),
                         terms=planner.terms(m0, s0)),
        F=value, design_iterations=int(info['design_iterations']), evaluations=int(info['evaluations']),
        newton_iterations=int(info['newton']),
        history=[dict(F=float(v), newton_iterations=int(n)) for v, n in info['history']],
        axis_norms=norms.tolist(), sample=oracle.sample(unit, m, 'co-designed optimum, axes made unit vectors'))


def settings(reference, planner, robot, task):
    return dict(
        **task, **COMMON, contact=planner.contact.tolist(), weights=dict(reference.WEIGHTS), gravity=reference.GRAVITY,
        sides=[list(c) for c in CORNERS], nominal=robot.nominal.tolist(), mass=robot.mass, leg_length=robot.leg_length,
        body_mass=robot.body_mass, body_height=robot.body_height, motor_mass=robot.motor_mass,
        link_density=robot.link_density, foot_mass=robot.foot_mass, foot_radius=robot.foot_radius,
        initial_design=split_design(robot.initial_design()), motion_size=planner.size, barrier_edge=.02,
        slots=planner.slots)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.dont_write_bytecode = True
    sys.path.insert(0, sys.argv[1])
    import casadi
    import codesign
    import planner as reference
    robot, prepared = make_robot(reference), []
    for number, (name, task) in enumerate(TASKS.items()):
        random = np.random.default_rng(20180000 + number)
        planner = make_planner(reference, robot, task)
        oracle = Oracle(casadi, planner)
        samples = []
        for k, label in enumerate(('legs all different', 'left and right mirrored', 'legs all different')):
            s = random_design(robot, random, mirrored='mirrored' in label)
            m = random_motion(planner, s, random)
            check_barriers(planner, m)
            samples.append(oracle.sample(s, m, label, full=k == 0, random=random))
            assert all(abs(v) > 1e-9 for v in samples[-1]['terms'].values()), 'a term vanishes'
        prepared.append((name, task, planner, oracle, samples))
    for name, task, planner, oracle, samples in prepared:
        document = dict(schema='legwright/prototype-samples', version=1, name=name,
                        settings=settings(reference, planner, robot, task), samples=samples,
                        optimum=codesigned(reference, codesign, planner, oracle))
        path = HERE / f'{name}.json'
        path.write_text(json.dumps(document, allow_nan=False, separators=(',', ':')) + '\n')
        print(path.name, path.stat().st_size, 'bytes, optimum F', document['optimum']['F'],
              document['optimum']['newton_iterations'], 'Newton iterations')


if __name__ == '__main__':
    main()
