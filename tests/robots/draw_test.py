#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests of tests/robots/draw, and of what `legwright` makes of robots drawn by chance. LEGWRIGHT
names the program."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
LEGWRIGHT = os.environ.get('LEGWRIGHT', str(HERE.parents[1] / 'build/bin/legwright'))


def draw(folder: pathlib.Path, count: int) -> list[str]:
    """Draws the first robots; a line each."""
    command = [sys.executable, '-B', str(HERE / 'draw'), '--count', str(count), '-o', str(folder)]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()


class Draw(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name).resolve()

    def legwright(self, *words: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [LEGWRIGHT, *words], cwd=self.folder, check=False, capture_output=True, text=True
        )

    def test_a_seed_gives_the_same_file_each_time(self) -> None:
        first, again = self.folder / 'first', self.folder / 'again'
        self.assertEqual(draw(first, 3), draw(again, 3))
        texts = [(first / f'drawn_{seed}.xml').read_bytes() for seed in range(3)]
        self.assertEqual(texts, [(again / f'drawn_{seed}.xml').read_bytes() for seed in range(3)])
        self.assertEqual(len(set(texts)), 3)

    def test_init_finds_all_legs_and_a_first_task(self) -> None:
        lines = draw(self.folder, 24)
        self.assertTrue(any('star' in line for line in lines))
        for seed, line in enumerate(lines):
            with self.subTest(line):
                done = self.legwright(
                    *('init', f'drawn_{seed}.xml', '--write', '--task', f'drawn_{seed}.toml')
                )
                self.assertEqual(done.returncode, 0, done.stderr)
                # The legs of a star are drawn 0.1 rad off the axes of its trunk.
                turned = 'turned by -5.7' if 'star' in line else ''
                self.assertEqual('turned' in done.stdout, bool(turned), done.stdout)
                self.assertIn(turned, done.stdout)
                legs = re.search(r'(\d) legs of (\d) joints', line)
                moving = int(legs[1]) * int(legs[2])
                self.assertIn(f'{legs[1]} legs, {moving} joints that move', done.stdout)

    def test_a_light_one_walks_as_planned(self) -> None:
        """A quadruped of 0.2 kg, whose servos damp its links at 13 000 per second."""
        draw(self.folder, 2)
        self.legwright('init', 'drawn_1.xml', '--write', '--task', 'task.toml')
        checked = self.legwright('check', 'task.toml').stdout
        self.assertIn('scenes take steps of 0.25 ms', checked)
        planned = self.legwright('optimize', 'task.toml', '-o', 'run', '--plan-only')
        self.assertEqual(planned.returncode, 0, planned.stderr)
        judged = self.legwright('validate', 'run', '--quick')
        self.assertEqual(judged.returncode, 0, judged.stdout)


if __name__ == '__main__':
    unittest.main()
