# SPDX-License-Identifier: Apache-2.0
"""Metadata of the wheel that names the version of MuJoCo: read from CMake's table, where alone it
stands."""

import pathlib
import re

TABLE = pathlib.Path(__file__).resolve().parents[2] / 'cmake/MujocoWheel.cmake'


def dynamic_metadata(settings, project):
    """The extra `mujoco`: MuJoCo's own package in the version that the plugin is built for."""
    found = re.search(
        r'^set\(LEGWRIGHT_MUJOCO_VERSION ([0-9.]+)', TABLE.read_text(encoding='utf-8'), re.M
    )
    if not found:
        raise ValueError(f'{TABLE}: no line set(LEGWRIGHT_MUJOCO_VERSION ...)')
    version = found.group(1)
    package = 'mujoco' if version.startswith('3.') else 'mujoco-core'  # since 4 the bindings' own
    return {'optional-dependencies': {'mujoco': [f'{package}=={version}']}}
