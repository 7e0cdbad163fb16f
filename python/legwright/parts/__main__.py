# SPDX-License-Identifier: Apache-2.0
"""`python -m legwright.parts`: what `legwright parts` runs."""

import argparse
import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from legwright._command import NOT_ALL, OK, told
from legwright._errors import InputError
from legwright.parts._extra import require_extra
from legwright.parts._options import PartOptions

if TYPE_CHECKING:
    from legwright.parts._make import Parts


def _parsed(words: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog='legwright parts', description=__doc__)
    parser.add_argument('robot', type=Path, metavar='RUN|ROBOT', help='run folder, or MJCF')
    parser.add_argument('-o', '--output', type=Path, default=Path('parts'), help='folder')
    for name in ('fit', 'wall', 'gap', 'strength', 'safety', 'press'):
        parser.add_argument(f'--{name}', type=float, default=getattr(PartOptions, name))
    parser.add_argument('--bed', help="in mm, 220x220x250; default: the robot's")
    parser.add_argument('--margin', type=float, help="of the bed, in mm; default: the robot's")
    parser.add_argument('--step', action='store_true', help='each part as STEP, too')
    parser.add_argument('--quiet', action='store_true', help='say nothing but errors')
    parser.add_argument('--json', action='store_true', help='print checks.json')
    return parser.parse_args(words)


def _options(words: argparse.Namespace) -> PartOptions:
    try:
        bed = words.bed and tuple(float(side) for side in words.bed.split('x'))
    except ValueError:
        raise InputError(f'--bed is {words.bed}; expected three sizes in mm: 220x220x250') from None
    return PartOptions(
        words.fit,
        words.wall,
        words.gap,
        bed,
        words.strength,
        words.safety,
        words.press,
        words.step,
        words.margin,
    )


def _summary(made: 'Parts') -> str:
    from legwright.parts._tables import check_lines

    count = sum(part.count for part in made.parts)
    failed = sum(not check.passed for check in made.checks)
    printed = f'{len(made.parts)} different parts, {count} to print'
    loose = f'; {made.not_fastened} places not fastened' if made.not_fastened else ''
    verdict = 'PASS' if made.passed else f'FAIL: {failed} of {len(made.checks)} checks'
    return '\n'.join(
        [
            *check_lines(made.checks),
            f'{verdict}  {made.robot.name}: {printed}{loose}',
            f'written  {made.folder}',
        ]
    )


def _run(parsed: argparse.Namespace) -> int:
    require_extra()
    from legwright.parts._make import make

    made = make(parsed.robot, parsed.output, _options(parsed))
    if parsed.json:
        print(json.dumps(made.document, indent=1, ensure_ascii=False))
    elif not parsed.quiet:
        print(_summary(made))
    return OK if made.passed else NOT_ALL


def main(words: list[str] | None = None) -> int:
    """The command; returns its exit code."""
    parsed = _parsed(words)
    return told(lambda: _run(parsed))


if __name__ == '__main__':
    sys.exit(main())
