# SPDX-License-Identifier: Apache-2.0
"""What printable parts need besides the package."""

from legwright import _command

_MODULES = ('manifold3d', 'trimesh', 'mujoco')


def require_extra() -> None:
    """Imports them. Raises ImportError, with what to install, where one is missing."""
    words = 'printable parts need manifold3d, trimesh and mujoco'
    _command.require_extra('parts', _MODULES, words)
