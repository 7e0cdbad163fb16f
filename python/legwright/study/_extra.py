# SPDX-License-Identifier: Apache-2.0
"""What a study needs besides the package."""

from legwright import _command

_MODULES = ('distributed', 'pyarrow', 'pyarrow.parquet')


def require_extra() -> None:
    """Imports Dask and Arrow. Raises ImportError, with what to install, where one is missing."""
    _command.require_extra('study', _MODULES, 'a study needs Dask and Arrow')
