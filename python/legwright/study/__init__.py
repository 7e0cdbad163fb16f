# SPDX-License-Identifier: Apache-2.0
"""Studies: co-designs over a grid or a list of robots, tasks and options, on Dask.

    from legwright import study

    found = study.run('examples/studies/puppy_speeds.toml', 'runs/speeds', workers=2)
    print(found.table.select(['travel.velocity[0]', 'F', 'pass']))
    found.design(0).model()

It needs the extra `study`: pip install "legwright[study]". docs/studies.md explains the file.
"""

from legwright.study._points import Point
from legwright.study._run import Done, Study, run

__all__ = ['Done', 'Point', 'Study', 'run']
