# SPDX-License-Identifier: Apache-2.0
"""The plugin legwright.gait, made known to MuJoCo."""

import ctypes
import importlib
import importlib.metadata
import os
import warnings
from pathlib import Path
from typing import Any

from legwright import _core
from legwright._errors import LegwrightWarning

_BIN = Path(__file__).parent / 'bin'
_OTHERS = _BIN / 'legwright_plugins'  # a folder for each release
_DOUBTFUL = {
    '4.0.0': 'factorises wrongly where the constraint Jacobian is sparse (its issue 3767)',
}


def _library(version: str) -> Path:
    """The plugin for a release of MuJoCo; it may not be there."""
    own = version == _core.mujoco_version
    return (_BIN / 'mujoco_plugin' if own else _OTHERS / version) / 'liblegwright.so'


def _installed_mujoco() -> str:
    """The release that `import mujoco` brings; the own one where it brings none."""
    for package in ('mujoco-core', 'mujoco'):  # what holds the library since MuJoCo 4, and before
        try:
            return importlib.metadata.version(package)
        except importlib.metadata.PackageNotFoundError:
            pass
    return _core.mujoco_version


def register() -> None:
    """Makes legwright.gait and legwright.sensor known to the MuJoCo that this process has loaded.

    `import legwright` does it; from MuJoCo 4 on `import mujoco` does, too. The library registers
    itself as it is loaded, once. Co-design plays in the MuJoCo that the package holds, whichever
    other is installed: that one gets its own.
    """
    ctypes.CDLL(str(_library(_core.mujoco_version)), os.RTLD_NOW | os.RTLD_LOCAL)
    installed = _installed_mujoco()
    if installed != _core.mujoco_version and _library(installed).exists():
        try:
            importlib.import_module('mujoco')  # the plugin finds its library where it is loaded
        except ImportError:
            return
        ctypes.CDLL(str(_library(installed)), os.RTLD_NOW | os.RTLD_LOCAL)


def served_mujoco() -> Any:
    """The module mujoco, in a release that there is a plugin for.

    Raises ImportError, with what to install, where it is missing or another one.
    """
    served = [_core.mujoco_version, *sorted(each.name for each in _OTHERS.glob('*'))]
    cure = f'pip install "legwright[mujoco]", which is MuJoCo {_core.mujoco_version}'
    try:
        mujoco = importlib.import_module('mujoco')
    except ImportError as error:
        raise ImportError(f"a model needs MuJoCo's Python package ({error}): {cure}") from error
    found = mujoco.mj_versionString()
    if found not in served:
        raise ImportError(
            f'MuJoCo {found} is installed, and a plugin holds for one release of it, here for '
            f'{", ".join(served)}: {cure}, or build legwright for {found}'
        )
    if found in _DOUBTFUL:
        doubt = f'MuJoCo {found} {_DOUBTFUL[found]}; {cure}'
        warnings.warn(doubt, LegwrightWarning, stacklevel=3)
    ctypes.CDLL(str(_library(found)), os.RTLD_NOW | os.RTLD_LOCAL)  # metadata may name another
    return mujoco
