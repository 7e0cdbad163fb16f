#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests that a robot is read alike, however it is written. LEGWRIGHT names the program."""

import importlib.machinery
import importlib.util
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
LEGWRIGHT = os.environ.get('LEGWRIGHT', str(HERE.parents[1] / 'build/bin/legwright'))
RENAMED = ('coded', 'nameless')  # where parameters have other names


def script(name):
    """A script of this folder, as a module."""
    loader = importlib.machinery.SourceFileLoader(name, str(HERE / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


class Restate(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name).resolve()
        self.restate = script('restate')

    def legwright(self, folder, *words):
        done = subprocess.run(
            [LEGWRIGHT, *words], cwd=folder, check=False, capture_output=True, text=True
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def found(self, robot, way):
        """What init proposes, and F of the plan of its first task with the given body."""
        folder = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        text = ElementTree.tostring(self.restate.restated(robot, way), encoding='unicode')
        (folder / 'given.xml').write_text(text)
        told = self.legwright(
            *(folder, 'init', 'given.xml', '-o', 'robot.xml', '--task', 'task.toml', '--json')
        )
        told = json.loads(told)
        self.legwright(
            *(folder, 'optimize', 'task.toml', '-o', 'run', '--motion-only', '--plan-only'),
            *('--no-pictures', '--no-certificate', '--no-reasons'),
        )
        run = json.loads((folder / 'run/run.json').read_text())
        proposed = [
            (
                '' if way in RENAMED else each['name'],
                each['unit'],
                *(round(each[key], 7) for key in ('value', 'lower', 'upper')),
            )
            for each in told['proposals']
        ]
        return {
            'mass': round(told['mass_kg'], 6),
            'legs': [len(limb['joints']) for limb in told['limbs']],
            'pairs': [limb['partner'] for limb in told['limbs']],
            'proposed': sorted(proposed),
            'F': run['final_F'],
        }

    def alike(self, robot, leave_out=()):
        robot = ElementTree.parse(robot).getroot()
        wanted = self.found(robot, 'same')
        self.assertGreater(len(wanted['proposed']), 10)
        nameless = sorted(('', *each[1:]) for each in wanted['proposed'])
        for way in self.restate.WAYS:
            if way in leave_out or way == 'same':
                continue
            with self.subTest(way):
                found = self.found(robot, way)
                self.assertAlmostEqual(found['F'] / wanted['F'], 1.0, delta=1e-4)
                proposed = nameless if way in RENAMED else wanted['proposed']
                self.assertEqual(found | {'F': 0}, wanted | {'proposed': proposed, 'F': 0})

    def test_a_dog_is_read_alike(self):
        self.alike(HERE / 'servo_dog/robot.xml')

    def test_a_hexapod_without_keyframe_is_read_alike(self):
        drawn = script('draw').Drawn(6)
        (self.folder / 'drawn.xml').write_text(drawn.mjcf())
        self.alike(self.folder / 'drawn.xml')

    @unittest.skipUnless(os.environ.get('LEGWRIGHT_LONG_TESTS'), 'one of the long tests')
    def test_robots_of_every_construction_are_read_alike(self):
        for name in ('courser', 'goat', 'lurcher', 'mule', 'ox', 'porter', 'strider'):
            with self.subTest(name):
                # Of two legs alone nobody knows how far a trunk is askew to them.
                askew = ('frame_yaw_10',) if name == 'porter' else ()
                degrees = ('degrees',) if name == 'ox' else ()
                self.alike(HERE / name / 'robot.xml', askew + degrees)

    def test_what_does_not_fit_is_told(self):
        command = [sys.executable, '-B', str(HERE / 'restate'), str(HERE / 'ox/robot.xml')]
        done = subprocess.run(
            [*command, '-o', str(self.folder), '--way', 'degrees', '--way', 'same'],
            check=False,
            capture_output=True,
            text=True,
        )
        self.assertEqual(done.returncode, 2)
        self.assertIn('degrees: its angles are in degrees', done.stderr)
        self.assertTrue((self.folder / 'same.xml').is_file())


if __name__ == '__main__':
    unittest.main()
