# SPDX-License-Identifier: Apache-2.0
"""Plays the result of a run in Drake and judges it: `legwright validate --engine drake RUN`, which
is where the program's own options, messages and exit codes come from.

Writes validation_drake.json into result/, of several tasks into that of each.
"""

import argparse
import json
import sys
import traceback
from pathlib import Path

from legwright._design import Design
from legwright._errors import InputError, IoError
from legwright._validate import GAINS, Validation, in_drake

OK, FAILS, BAD_INPUT, NO_FILE, INTERNAL, INTERRUPTED = 0, 1, 2, 3, 4, 130  # exit_code.hpp


def _progress(seconds: float):
    """Tells how far a roll-out is, on a terminal."""
    if not sys.stderr.isatty():
        return None

    def watch(gains: float, time: float) -> None:
        if round(time * 1e3) % 200 == 0:
            share = min(time / seconds, 1.0)
            print(f'\r\x1b[K{gains} × gains: {share:4.0%}', end='', file=sys.stderr, flush=True)
        if time >= seconds:
            print('\r\x1b[K', end='', file=sys.stderr, flush=True)

    return watch


def _complain(error: Exception) -> None:
    """On stderr; names from files move no cursor."""
    words = (c if c.isprintable() or c == '\n' else '?' for c in str(error))
    print(f'legwright: {"".join(words)}', file=sys.stderr)


def _validate(design: Design, options: argparse.Namespace) -> Validation:
    return in_drake(
        design,
        gains=GAINS,
        cycles=options.cycles,
        limits=options.limits,
        write=True,
        watch=_progress(options.cycles * design.motion.period),
    )


def _run(options: argparse.Namespace) -> int:
    design = Design.load(options.run)
    found = {name: _validate(task, options) for name, task in design.tasks.items()}
    if options.json:
        records = {name: one.record for name, one in found.items()}
        document = records if design.joint else next(iter(records.values()))
        print(json.dumps(document, indent=2, ensure_ascii=False))
    else:
        for name, one in found.items():
            task = f'{name}, ' if design.joint else ''
            print(f'{task}Drake {one.version}: {one.line}')
    return OK if all(found.values()) else FAILS


def main() -> int:
    parser = argparse.ArgumentParser('legwright validate --engine drake', description=__doc__)
    parser.add_argument('run', type=Path, metavar='RUN', help='that legwright optimize wrote')
    parser.add_argument('--cycles', type=int, default=20, help='of the gait to play')
    parser.add_argument('--limits', default='', metavar='FILE', help='TOML file of what passes')
    parser.add_argument('--json', action='store_true', help='the record on stdout')
    try:
        return _run(parser.parse_args())
    except (IoError, OSError, ImportError) as error:
        _complain(error)
        return NO_FILE
    except (InputError, ValueError) as error:
        _complain(error)
        return BAD_INPUT
    except KeyboardInterrupt:
        return INTERRUPTED
    except Exception:
        print('legwright: internal error:', file=sys.stderr)
        traceback.print_exc()
        return INTERNAL


if __name__ == '__main__':
    sys.exit(main())
