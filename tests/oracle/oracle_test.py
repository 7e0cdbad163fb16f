#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The oracle's own parts: derivatives against complex steps, comparisons that see what is wrong."""
import contextlib
import copy
import io
import pathlib
import tempfile
import unittest

import numpy as np

import derivatives
import document
import tape
import vectors
from oracle import check, main
from motion import Layout
from task import TASKS, WEIGHTS
from terms import weighted_terms

TASK = TASKS[0]
STORED = document.read(document.path_of(TASK))


def run(*arguments):
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
        return main(list(arguments))


def point(index):
    sample = STORED['samples'][index]
    return document.join_design(sample['design']), np.array(sample['m'])


class Derivatives(unittest.TestCase):
    def test_gradients_of_all_terms_are_those_of_complex_steps(self):
        layout, random = Layout(TASK), np.random.default_rng(1)
        for index in (0, len(STORED['samples']) - 1):
            s, m = point(index)
            ds, dm = random.normal(size=s.size), random.normal(size=m.size)
            tiny = 1j * derivatives.TINY
            stepped = weighted_terms(TASK, layout, tape.tensor(s + tiny * ds),
                                     tape.tensor(m + tiny * dm))
            for name, (of_m, of_s) in derivatives.by_term(TASK, layout, s, m).items():
                slope = stepped[name].value.imag / derivatives.TINY
                size = np.abs(of_m) @ np.abs(dm) + np.abs(of_s) @ np.abs(ds)
                self.assertGreater(size, 0, name)
                self.assertLess(abs(of_m @ dm + of_s @ ds - slope), 1e-11 * size, name)

    def test_hessian_is_the_difference_of_gradients(self):
        layout, (s, m) = Layout(TASK), point(0)
        v = np.array(STORED['samples'][0]['direction_m'])
        ahead, behind = (derivatives.at_point(TASK, layout, s, m + sign * 1e-6 * v)
                         for sign in (1, -1))
        of_m, of_s = derivatives.hessian_times(TASK, layout, s, m, v)
        for product, name in ((of_m, 'gradient_m'), (of_s, 'gradient_s')):
            difference = (getattr(ahead, name) - getattr(behind, name)) / 2e-6
            self.assertLess(np.linalg.norm(product - difference), 1e-7 * np.linalg.norm(product))

    def test_rotations_are_rotations_and_smooth_at_zero(self):
        for length in (0.0, 1e-9, 0.0099, 0.0101, 1.0, 3.0):
            o = length * np.array([[2.0, -1.0, 2.0]]) / 3
            r = vectors.rotation_of(tape.tensor(o)).value[0]
            np.testing.assert_allclose(r @ r.T, np.eye(3), atol=1e-15)
            np.testing.assert_allclose(r @ o[0], o[0], atol=1e-15)
            np.testing.assert_allclose(np.trace(r), 1 + 2 * np.cos(length), atol=1e-15)


def scale(parent, key):
    parent[key] *= 1 + 1e-8


class Comparison(unittest.TestCase):
    def assert_noticed(self, part, change):
        changed = copy.deepcopy(part)
        self.assertEqual(document.differences(changed, part), [])
        change(changed)
        self.assertNotEqual(document.differences(part, changed), [])

    def test_notices_a_change_of_each_number_of_a_sample(self):
        for sample in (STORED['samples'][0], STORED['samples'][-1]):
            for name in WEIGHTS:
                self.assert_noticed(sample['terms'], lambda d: scale(d, name))
                for by in ('term_gradients_m', 'term_gradients_s'):
                    values = sample[by][name]['value']
                    if values:
                        self.assert_noticed(values, lambda d: scale(d, np.argmax(np.abs(d))))
            for key in ('gradient_m', 'gradient_s', 'hessian_mm_direction', 'hessian_sm_direction',
                        'm'):
                self.assert_noticed(sample[key], lambda d: scale(d, np.argmax(np.abs(d))))

    def test_notices_a_change_of_the_document(self):
        for change in (lambda d: scale(d['settings']['weights'], 'travel'),
                       lambda d: d['samples'][1].pop('F'), lambda d: d['samples'].pop(),
                       lambda d: d.update(name='puppy_run'),
                       lambda d: d['samples'][0].update(F=float('nan'))):
            self.assert_noticed(STORED, change)

    def test_command_fails_on_a_changed_number_or_point(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            self.assertEqual(run('check', name), 2)
            self.assertEqual(run('make', name), 0)
            self.assertEqual(run('check', name), 0)
            for change in (lambda d: d['samples'][0]['gradient_s'].__setitem__(3, 0.0),
                           lambda d: d['samples'][1]['m'].__setitem__(0, 0.5)):
                changed = copy.deepcopy(STORED)
                change(changed)
                document.write(document.path_of(TASK, folder), changed)
                self.assertEqual(run('check', name), 1)
            # A point that is moved together with all that follows from it was not drawn.
            moved = copy.deepcopy(STORED)
            moved['samples'][1]['m'][0] += 1e-3
            moved = document.make(TASK, moved)
            self.assertEqual(document.differences(document.make(TASK, moved), moved), [])
            document.write(document.path_of(TASK, folder), moved)
            lines = check(TASK, folder)
            self.assertEqual(len(lines), 1, lines)
            self.assertTrue(lines[0].startswith('drawn m[0]'), lines)

    def test_command_wants_a_verb(self):
        self.assertEqual(run(), 2)
        self.assertEqual(run('verify'), 2)


if __name__ == '__main__':
    unittest.main()
