# SPDX-License-Identifier: Apache-2.0
"""What a study needs besides the package."""

import importlib

_MODULES = ('distributed', 'pyarrow', 'pyarrow.parquet')


def require_extra() -> None:
    """Imports Dask and Arrow. Raises ImportError, with what to install, where one is missing."""
    for module in _MODULES:
        try:
            importlib.import_module(module)
        except ImportError as error:
            raise ImportError(
                f'a study needs Dask and Arrow ({error}): pip install "legwright[study]", from a '
                'clone pip install ".[study]"'
            ) from error
