# SPDX-License-Identifier: Apache-2.0
"""Printable parts of a robot that was built from modules: STL, 3MF, tables, checks.

    from legwright import parts

    made = parts.make('runs/puppy', 'parts')
    print(made.passed, [part.name for part in made.parts])

It needs the extra `parts`: pip install "legwright[parts]". docs/parts.md tells what is made.
"""

from legwright.parts._extra import require_extra

require_extra()

from legwright.parts._checks import Check  # noqa: E402
from legwright.parts._make import Parts, make  # noqa: E402
from legwright.parts._options import PartOptions  # noqa: E402
from legwright.parts._solids import Part  # noqa: E402

__all__ = ['Check', 'Part', 'PartOptions', 'Parts', 'make']
