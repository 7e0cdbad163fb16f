# SPDX-License-Identifier: Apache-2.0
"""What the run as printed is told of its parts' strength, for its report."""

import json
from collections.abc import Sequence

from legwright.parts._checks import Check
from legwright.parts._options import PartOptions

FILE = 'result/strength.json'
_SCHEMA = 'legwright/strength'
_SERVO = 'bears its servo'
_LOADS = ('bears ', 'peg bears ', 'no foot beyond')


def strength_bytes(checks: Sequence[Check], options: PartOptions) -> bytes:
    """The safety factors of all parts, with where and when they are stressed most."""
    rows = [
        {
            'part': check.part,
            'load': check.name,
            'factor': check.as_json()['figure'],
            'least_factor': 1.0 if check.name.startswith(_SERVO) else options.safety,
            'where': check.where,
            'pass': check.as_json()['passed'],
        }
        for check in checks
        if check.name.startswith(_LOADS)
    ]
    record = {'schema': _SCHEMA, 'version': 1, 'strength_MPa': options.strength, 'parts': rows}
    return (json.dumps(record, indent=1, ensure_ascii=False) + '\n').encode()
