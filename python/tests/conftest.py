# SPDX-License-Identifier: Apache-2.0
"""What tests share: the examples, and one co-designed puppy."""

from __future__ import annotations

import functools
import os
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import legwright as lw
import pytest

if TYPE_CHECKING:
    from legwright import parts

EXAMPLES = Path(__file__).resolve().parents[2] / 'examples'


def pytest_configure(config) -> None:
    config.addinivalue_line('markers', 'long: for `tools/test --long` alone')


def pytest_collection_modifyitems(items) -> None:
    """Passes over what is for a long run, unless LEGWRIGHT_LONG_TESTS is set."""
    if 'LEGWRIGHT_LONG_TESTS' in os.environ:
        return
    for item in items:
        if item.get_closest_marker('long'):
            item.add_marker(pytest.mark.skip(reason='tools/test --long runs it'))


@pytest.fixture(scope='session')
def examples() -> Path:
    return EXAMPLES


@pytest.fixture(scope='session')
def built(tmp_path_factory) -> Callable[[str], Path]:
    """Builds the robot of a `printed_NAME.toml` of the examples, once: not to be changed."""
    folder = tmp_path_factory.mktemp('built')
    program = Path(lw.__file__).parent / 'bin/legwright'

    @functools.cache
    def robot(name: str) -> Path:
        file = folder / f'{name}.xml'
        assembly = EXAMPLES / f'assemblies/printed_{name}.toml'
        subprocess.run([program, 'build', assembly, '-o', file], check=True, capture_output=True)
        return file

    return robot


@pytest.fixture(scope='session')
def printed(built, tmp_path_factory) -> Callable[[str], parts.Parts]:
    """Makes the parts of such a robot, once: not to be changed."""
    folder = tmp_path_factory.mktemp('printed')

    @functools.cache
    def made(name: str) -> parts.Parts:
        from legwright import parts  # needs more than other tests do

        return parts.make(built(name), folder / name)

    return made


@pytest.fixture(scope='session')
def dog(built) -> Path:
    """The puppy that is meant to be printed, as `build` writes it."""
    return built('puppy')


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
