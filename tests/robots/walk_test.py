#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests of tests/robots/walk with folders of robots as people keep them. LEGWRIGHT names the
program; what it searches for is cut short."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
LEGWRIGHT = os.environ.get('LEGWRIGHT', str(HERE.parents[1] / 'build/bin/legwright'))
SHORT = """#!/bin/sh
[ "$1" = optimize ] && set -- "$@" --plan-only --max-iterations 0
exec "$PROGRAM" "$@"
"""


class Walk(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name).resolve()
        self.robots, self.runs = self.folder / 'robots', self.folder / 'runs'
        self.robots.mkdir()
        self.program = self.folder / 'legwright'
        self.program.write_text(SHORT, encoding='utf-8')
        self.program.chmod(0o755)

    def put(self, place, text):
        file = self.robots / place
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding='utf-8')
        return file

    def put_robot(self, place, robot='servo_dog'):
        return self.put(place, (HERE / robot / 'robot.xml').read_text(encoding='utf-8'))

    def walk(self, *arguments, code=0):
        """The rows of the table, and what was told besides."""
        done = subprocess.run(
            [str(HERE / 'walk'), '--verdicts', '-o', str(self.runs), *map(str, arguments)],
            env=os.environ | {'LEGWRIGHT': str(self.program), 'PROGRAM': LEGWRIGHT},
            capture_output=True,
            text=True,
            check=False,
        )
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout.splitlines()[2:], done.stderr

    def names(self, rows):
        return [row.split('|')[1].strip() for row in rows]

    def test_robots_of_one_file_name_have_results_of_their_own(self):
        self.put_robot('a/robot.xml')
        self.put_robot('b/robot.xml', 'goat')
        for given in ([self.robots], [self.robots / 'a/robot.xml', self.robots / 'b/robot.xml']):
            suffix = '.xml' if len(given) > 1 else ''
            rows, _ = self.walk('--jobs', '2', *given)
            self.assertEqual(self.names(rows), [f'a/robot{suffix}', f'b/robot{suffix}'])
            self.assertIn('1.5 kg | 4 × 2', rows[0])
            self.assertIn('5.1 kg | 4 × 4', rows[1])
            for name in self.names(rows):
                self.assertEqual((self.runs / name / 'run.codes').read_text(), '0 0\n')

    def test_a_robot_whose_files_lie_above_its_folder_walks(self):
        shutil.copytree(HERE / 'pilgrim', self.robots / 'pilgrim')
        rows, _ = self.walk(self.robots / 'pilgrim/mjcf/robot.xml', code=1)  # its body as it was
        self.assertEqual(self.names(rows), ['robot'])
        self.assertIn('10.7 kg | 4 × 3', rows[0])
        self.assertTrue((self.runs / 'robot/parts/motors.xml').is_file())

    def test_parts_of_robots_are_passed_over(self):
        robot = self.put_robot('dog/robot.xml')
        self.put('scene.xml', '<mujoco><include file="dog/robot.xml"/></mujoco>')
        self.put('package.xml', '<package/>')
        self.put('arm.xml', '<mujocoinclude/>')
        self.put('broken.xml', '<mujoco>')
        rows, told = self.walk(self.robots, code=1)
        self.assertEqual(self.names(rows), ['broken', 'scene'])
        self.assertIn('refused: broken.xml:', rows[0])
        self.assertIn('1.5 kg', rows[1])
        self.assertIn(f'passes over {robot}: another file includes it', told)
        self.assertIn('package.xml: its root element is <package>, which is neither', told)
        self.assertIn('arm.xml: its root element is <mujocoinclude>', told)

    def test_names_that_meet_get_suffixes(self):
        for place in ('a.xml', 'a/b.xml', 'c.xml'):
            self.put(place, '<mujoco/>')
        self.put('c.urdf', '<robot name="c"/>')
        rows, _ = self.walk(self.robots, self.robots / 'c.xml', code=1)
        self.assertEqual(self.names(rows), ['a/b', 'a.xml', 'c.urdf', 'c.xml'])

    def test_results_are_no_robots(self):
        self.runs = self.robots / 'runs'
        file = self.put('runs/robot.xml', '<mujoco/>')
        for given in (file, self.robots):
            rows, told = self.walk(given, code=2)
            self.assertEqual(rows, [])
            self.assertIn(str(self.runs), told)
        self.assertTrue(file.is_file())

    def test_a_refusal_names_the_file_from_its_folder(self):
        rows, _ = self.walk('tailor')
        self.assertIn('| tailor | | | refused: robot.xml:7: option:', rows[0])


if __name__ == '__main__':
    unittest.main()
