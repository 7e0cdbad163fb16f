# SPDX-License-Identifier: Apache-2.0
"""Metadata of the wheel that names the version of MuJoCo: read from CMake's table, where alone it
stands."""

import pathlib
import re

TABLE = pathlib.Path(__file__).resolve().parents[2] / 'cmake/MujocoVersions.cmake'


def dynamic_metadata(settings, project):
    """The extra `mujoco`: MuJoCo's own package in the version that the plugin is built for."""
    table = TABLE.read_text(encoding='utf-8')

    def value(name):
        found = re.search(rf'^set\({re.escape(name)} ([^ )]+)', table, re.M)
        if not found:
            raise ValueError(f'{TABLE}: no line set({name} ...)')
        return found.group(1)

    version = value('LEGWRIGHT_MUJOCO_VERSION')
    package = value(f'legwright_mujoco_{version}_package')
    return {'optional-dependencies': {'mujoco': [f'{package}=={version}']}}
