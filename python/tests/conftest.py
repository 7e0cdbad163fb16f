# SPDX-License-Identifier: Apache-2.0
"""What tests share: the examples, and one co-designed puppy."""

from pathlib import Path

import legwright as lw
import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / 'examples'


@pytest.fixture(scope='session')
def examples() -> Path:
    return EXAMPLES


@pytest.fixture
def puppy() -> lw.Robot:
    """Read anew for each test, which may freeze its parameters."""
    return lw.Robot(EXAMPLES / 'puppy/robot.xml')


@pytest.fixture(scope='session')
def sideways() -> lw.Task:
    return lw.Task.load(EXAMPLES / 'puppy/sideways.toml')


@pytest.fixture(scope='session')
def walk(sideways: lw.Task) -> lw.Design:
    """The puppy that walks sideways, with all that a run writes but pictures."""
    return lw.codesign(lw.Robot(EXAMPLES / 'puppy/robot.xml'), sideways)
