# SPDX-License-Identifier: Apache-2.0
"""Extras of the wheel. The version of MuJoCo is read from CMake's table, where alone it stands."""

import pathlib
import re

DRAKE = 'drake>=1.51.1,<2'  # the oldest that was tried; docs/findings/second_engine.md
TABLE = pathlib.Path(__file__).resolve().parents[2] / 'cmake/MujocoVersions.cmake'


# What legwright.study needs, from the releases on that python/tests has seen.
STUDY = ['dask>=2026.8', 'distributed>=2026.8', 'pyarrow>=26']

# What legwright.parts needs beside MuJoCo.
PARTS = ['manifold3d>=3.5', 'trimesh>=5.2']


def dynamic_metadata(settings, project):
    """The extras: `mujoco`, MuJoCo's own package in the version that the plugin is built for;
    `drake`, the second engine, whose plant is built from MuJoCo's model; `study`; and `parts`."""
    table = TABLE.read_text(encoding='utf-8')

    def value(name):
        found = re.search(rf'^set\({re.escape(name)} ([^ )]+)', table, re.M)
        if not found:
            raise ValueError(f'{TABLE}: no line set({name} ...)')
        return found.group(1)

    version = value('LEGWRIGHT_MUJOCO_VERSION')
    package = value(f'legwright_mujoco_{version}_package')
    mujoco = f'{package}=={version}'
    extras = {'mujoco': [mujoco], 'drake': [mujoco, DRAKE], 'study': STUDY}
    extras['parts'] = [mujoco, *PARTS]
    return {'optional-dependencies': extras}
