#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""An independent oracle for F. Usage: python3 tests/oracle/oracle.py make|check [FOLDER]

make   writes the documents of all tasks to FOLDER (tests/oracle/data unless told)
check  makes their numbers anew and compares them with the stored ones: the points as they are
       drawn, and everything else at the stored points.
Exits 1 if they differ, 2 if a file is missing.
"""

import pathlib
import sys

import document
import sampling
from motion import Layout
from task import TASKS

MOST_LINES = 10


def check(task, folder):
    """Lines that tell what differs."""
    stored = document.read(document.path_of(task, folder))
    lines = document.differences(document.make(task, stored), stored)
    drawn = [document.split_point(point) for point in sampling.draw(task, Layout(task))]
    expected = [{key: sample.get(key) for key in drawn[0]} for sample in stored['samples']]
    return lines + document.differences(drawn, expected, 'drawn')


def main(arguments):
    if not 1 <= len(arguments) <= 2 or arguments[0] not in ('make', 'check'):
        print(__doc__, file=sys.stderr)
        return 2
    folder = pathlib.Path(arguments[1]) if len(arguments) == 2 else document.DATA
    failed = False
    for task in TASKS:
        path = document.path_of(task, folder)
        if arguments[0] == 'make':
            document.write(path, document.make(task))
            print(f'{path}: {path.stat().st_size} bytes')
            continue
        if not path.is_file():
            print(f'{path}: missing; write it by: tests/oracle/oracle.py make', file=sys.stderr)
            return 2
        lines = check(task, folder)
        print(f'{path}: {len(lines)} differences' if lines else f'{path}: as stored')
        for line in lines[:MOST_LINES]:
            print(f'  {line}')
        failed = failed or bool(lines)
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
