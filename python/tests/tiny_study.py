# SPDX-License-Identifier: Apache-2.0
"""A study whose points take a fraction of a second each."""

from pathlib import Path
from typing import Any

PUPPY = Path(__file__).resolve().parents[2] / 'examples/puppy/robot.xml'


def tiny(robot: Path = PUPPY, **more: Any) -> dict[str, Any]:
    """The puppy's motion at 12 knots, unplayed, at two swing heights; `more` replaces keys."""
    return {
        'robot': str(robot),
        'pictures': False,
        'base': {
            'gait': {'name': 'trot', 'knots': 12, 'period': 0.4},
            'travel': {'velocity': [0.1, 0.0]},
        },
        'codesign': {'motion_only': True, 'plan_only': True, 'certificate': False},
        'grid': {'limits': {'swing_height': [0.02, 0.03]}},
    } | more


def heights(count: int) -> dict[str, Any]:
    """A grid of so many swing heights."""
    return {'limits': {'swing_height': [round(0.02 + 0.001 * i, 4) for i in range(count)]}}
