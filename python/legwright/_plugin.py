# SPDX-License-Identifier: Apache-2.0
"""The plugin legwright.gait, made known to MuJoCo."""

import ctypes
import importlib
import os
from pathlib import Path
from typing import Any

from legwright import _core

_LIBRARY = Path(__file__).parent / 'bin/mujoco_plugin/liblegwright.so'


def register() -> None:
    """Makes legwright.gait and legwright.sensor known to the MuJoCo that this process has loaded.

    `import legwright` does it; from MuJoCo 4 on `import mujoco` does, too. The library registers
    itself as it is loaded, once.
    """
    ctypes.CDLL(str(_LIBRARY), os.RTLD_NOW | os.RTLD_LOCAL)


def served_mujoco() -> Any:
    """The module mujoco, in the version that the plugin is built for.

    Raises ImportError, with what to install, where it is missing or another one.
    """
    wanted = _core.mujoco_version
    cure = f'pip install "legwright[mujoco]", which is MuJoCo {wanted}'
    try:
        mujoco = importlib.import_module('mujoco')
    except ImportError as error:
        raise ImportError(f"a model needs MuJoCo's Python package ({error}): {cure}") from error
    found = mujoco.mj_versionString()
    if found != wanted:
        raise ImportError(
            f'MuJoCo {found} is installed, and a plugin holds for one version of it, here '
            f'{wanted}: {cure}, or build legwright for {found}'
        )
    return mujoco
