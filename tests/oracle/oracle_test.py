#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The oracle's own parts: derivatives against complex steps, comparisons that see what is wrong."""

import contextlib
import copy
import io
import pathlib
import tempfile
import unittest

import derivatives
import document
import equipment
import numpy as np
import penalties
import segments
import tape
import vectors
from motion import Layout
from oracle import check, main
from robot import GRAVITY, NOMINAL, Placed
from state import State
from task import TASKS
from terms import weighted_terms

STORED = {task: document.read(document.path_of(task)) for task in TASKS}
WALK = TASKS[0]


def run(*arguments):
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
        return main(list(arguments))


def full_samples():
    """(task, sample) of all that have second derivatives."""
    return [
        (task, sample)
        for task in TASKS
        for sample in STORED[task]['samples']
        if 'direction_m' in sample
    ]


def point(sample):
    return document.join_design(sample['design']), np.array(sample['m'])


class Derivatives(unittest.TestCase):
    def test_gradients_of_all_terms_are_those_of_complex_steps(self):
        random, tiny = np.random.default_rng(1), 1j * derivatives.TINY
        for task, sample in full_samples():
            layout, (s, m) = Layout(task), point(sample)
            ds, dm = random.normal(size=s.size), random.normal(size=m.size)
            stepped = weighted_terms(
                task, layout, tape.tensor(s + tiny * ds), tape.tensor(m + tiny * dm)
            )
            for name, (of_m, of_s) in derivatives.by_term(task, layout, s, m).items():
                slope = stepped[name].value.imag / derivatives.TINY
                size = np.abs(of_m) @ np.abs(dm) + np.abs(of_s) @ np.abs(ds)
                self.assertGreater(size, 0, name)
                self.assertLess(abs(of_m @ dm + of_s @ ds - slope), 1e-11 * size, name)

    def test_hessian_is_the_difference_of_gradients(self):
        for task in TASKS:
            sample = STORED[task]['samples'][0]
            layout, (s, m), v = Layout(task), point(sample), np.array(sample['direction_m'])
            ahead, behind = (
                derivatives.at_point(task, layout, s, m + sign * 1e-6 * v) for sign in (1, -1)
            )
            of_m, of_s = derivatives.hessian_times(task, layout, s, m, v)
            for product, name in ((of_m, 'gradient_m'), (of_s, 'gradient_s')):
                difference = (getattr(ahead, name) - getattr(behind, name)) / 2e-6
                self.assertLess(
                    np.linalg.norm(product - difference), 1e-7 * np.linalg.norm(product)
                )

    def test_pieces_join_with_two_derivatives(self):
        step = 1e-9
        for function, joins in (
            (segments.ramp, (-0.05, 0.05)),
            (segments.clamp, (0.05, 0.95)),
            (segments.finite_reciprocal, (0.03,)),
            (lambda x: segments.rounded_root(x, 0.2), (0.04,)),
            (lambda x: penalties.barrier(x, 0.02), (0.02,)),
            (lambda x: penalties.near_barrier(x, 0.02), (0.02, 1.0)),
        ):
            for join in joins:
                below, above = (
                    self.two_derivatives(function, join + side * step) for side in (-1, 1)
                )
                np.testing.assert_allclose(below, above, rtol=1e-6, atol=1e-6)

    @staticmethod
    def two_derivatives(function, at):
        x = tape.tensor(np.array([at + 1j * derivatives.TINY]))
        y = function(x)
        (slope,) = tape.gradients(y.sum(), [x])
        return y.value.sum().real, slope[0].real, slope[0].imag / derivatives.TINY

    def test_rotations_are_rotations_and_smooth_at_zero(self):
        for length in (0.0, 1e-9, 0.0099, 0.0101, 1.0, 3.0):
            o = length * np.array([[2.0, -1.0, 2.0]]) / 3
            r = vectors.rotation_of(tape.tensor(o)).value[0]
            np.testing.assert_allclose(r @ r.T, np.eye(3), atol=1e-15)
            np.testing.assert_allclose(r @ o[0], o[0], atol=1e-15)
            np.testing.assert_allclose(np.trace(r), 1 + 2 * np.cos(length), atol=1e-15)


class Mechanics(unittest.TestCase):
    def test_distance_is_that_of_many_points_of_the_segments(self):
        random, shares = np.random.default_rng(2), np.linspace(0, 1, 201)[:, None]
        for _ in range(200):
            p1, q1, p2, q2 = random.normal(size=(4, 3))
            found = segments.segment_distance(*[tape.tensor(x) for x in (p1, q1, p2, q2)], 1e-9)
            first, second = p1 + shares * (q1 - p1), p2 + shares * (q2 - p2)
            nearest = np.linalg.norm(first[:, None] - second, axis=2).min()
            length = max(np.linalg.norm(q1 - p1), np.linalg.norm(q2 - p2))
            self.assertGreater(found.value**2, nearest**2 - (length / 200) ** 2)
            self.assertLess(found.value**2, nearest**2 + 0.001 * length**2)

    def test_torques_at_rest_are_slopes_of_potential_energy(self):
        task = TASKS[-1]
        layout, s = Layout(task), tape.tensor(task.robot.initial_design())
        pose = np.concatenate([[0.1, 0.2, 0.3, 0.2, -0.1, 0.3], NOMINAL + 0.1])
        m = np.zeros(layout.size)
        m[layout.pose] = pose
        torques = State(task, layout, s, tape.tensor(m)).joint_torques().value
        q = tape.tensor(pose[None])
        placed = Placed(task.robot, q, s)
        height = (placed.points * task.up).sum(-1)
        bent = q[:, 6:] - np.array(equipment.SLACK_ANGLE * 4)
        springs = (bent * bent * (np.array(equipment.STIFFNESS * 4) / 2)).sum()
        (slope,) = tape.gradients((height * placed.masses * GRAVITY).sum() + springs, [q])
        np.testing.assert_allclose(torques[4], slope[0, 6:], atol=1e-14)


def scale(parent, key):
    parent[key] *= 1 + 1e-10


class Comparison(unittest.TestCase):
    def assert_noticed(self, part, change):
        changed = copy.deepcopy(part)
        self.assertEqual(document.differences(changed, part), [])
        change(changed)
        self.assertNotEqual(document.differences(part, changed), [])

    def test_notices_a_change_of_each_number_of_a_sample(self):
        for task in TASKS:
            sample = STORED[task]['samples'][0]
            for name in sample['terms']:
                self.assert_noticed(sample['terms'], lambda d, name=name: scale(d, name))
                for by in ('term_gradients_m', 'term_gradients_s'):
                    if sample[by][name]['value']:
                        self.assert_noticed(
                            sample[by][name],
                            lambda d: scale(d['value'], np.argmax(np.abs(d['value']))),
                        )
            for key in (
                'gradient_m',
                'gradient_s',
                'hessian_mm_direction',
                'hessian_sm_direction',
                'm',
            ):
                self.assert_noticed(sample[key], lambda d: scale(d, np.argmax(np.abs(d))))

    def test_plans_are_compared_more_loosely(self):
        plan = STORED[WALK]['samples'][-1]
        changed = copy.deepcopy(plan)
        changed['F'] *= 1 + 1e-9
        self.assertEqual(document.differences(changed, plan), [])
        changed['F'] *= 1 + 1e-7
        self.assertEqual(len(document.differences(changed, plan)), 1)

    def test_notices_a_change_of_the_document(self):
        for change in (
            lambda d: scale(d['settings']['weights'], 'travel'),
            lambda d: d['samples'][1].pop('F'),
            lambda d: d['samples'].pop(),
            lambda d: d.update(name='puppy_run'),
            lambda d: d['samples'][0].update(F=float('nan')),
        ):
            self.assert_noticed(STORED[WALK], change)

    def test_command_fails_on_a_changed_number_or_point(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            self.assertEqual(run('check', name), 2)
            self.assertEqual(run('make', name), 0)
            self.assertEqual(run('check', name), 0)
            for change in (
                lambda d: d['samples'][0]['gradient_s'].__setitem__(3, 0.0),
                lambda d: d['samples'][1]['m'].__setitem__(0, 0.5),
            ):
                changed = copy.deepcopy(STORED[WALK])
                change(changed)
                document.write(document.path_of(WALK, folder), changed)
                self.assertEqual(run('check', name), 1)
            # A point that is moved together with all that follows from it was not drawn.
            moved = copy.deepcopy(STORED[WALK])
            moved['samples'][1]['m'][0] += 1e-3
            moved = document.make(WALK, moved)
            self.assertEqual(document.differences(document.make(WALK, moved), moved), [])
            document.write(document.path_of(WALK, folder), moved)
            lines = check(WALK, folder)
            self.assertEqual(len(lines), 1, lines)
            self.assertTrue(lines[0].startswith('drawn[1].m[0]'), lines)

    def test_command_wants_a_verb(self):
        self.assertEqual(run(), 2)
        self.assertEqual(run('verify'), 2)


if __name__ == '__main__':
    unittest.main()
