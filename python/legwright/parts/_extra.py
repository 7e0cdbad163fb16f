# SPDX-License-Identifier: Apache-2.0
"""What printable parts need besides the package."""

import importlib

_MODULES = ('manifold3d', 'trimesh', 'mujoco')


def require_extra() -> None:
    """Imports them. Raises ImportError, with what to install, where one is missing."""
    for module in _MODULES:
        try:
            importlib.import_module(module)
        except ImportError as error:
            raise ImportError(
                f'printable parts need manifold3d, trimesh and mujoco ({error}): '
                'pip install "legwright[parts]", from a clone pip install ".[parts]"'
            ) from error
