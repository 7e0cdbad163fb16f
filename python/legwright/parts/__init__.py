# SPDX-License-Identifier: Apache-2.0
"""Printable parts of a robot that was built from modules: STL, 3MF, tables, checks.

    from legwright import parts

    made = parts.make('runs/puppy', 'parts')
    print(made.passed, [part.name for part in made.parts])

It needs the extra `parts`: pip install "legwright[parts]". docs/parts.md tells what is made.
"""

import importlib
from typing import TYPE_CHECKING, Any

from legwright.parts._extra import require_extra

if TYPE_CHECKING:
    from legwright.parts._checks import Check
    from legwright.parts._make import Parts, make
    from legwright.parts._options import PartOptions
    from legwright.parts._solids import Part

__all__ = ['Check', 'Part', 'PartOptions', 'Parts', 'make']

_MODULES = {
    'Check': '_checks',
    'Part': '_solids',
    'PartOptions': '_options',
    'Parts': '_make',
    'make': '_make',
}


def __getattr__(name: str) -> Any:
    """What is public, loaded when asked for. Raises ImportError where the extra is missing."""
    if name not in _MODULES:
        raise AttributeError(f'module {__name__} has no attribute {name}')
    require_extra()
    return getattr(importlib.import_module(f'{__name__}.{_MODULES[name]}'), name)
