# SPDX-License-Identifier: Apache-2.0
"""Whether screws hold in a part, and can be reached."""

import math
from collections.abc import Iterable

from legwright.parts._checks import Check, at_least
from legwright.parts._holes import Hole, driver_way, reach_at_face
from legwright.parts._shapes import outline
from legwright.parts._solids import Part, Solid

_TOUCHES = 1e-3  # [mm3] that a driver's way may share with what is beside it


def _groups(solid: Solid) -> dict[tuple[str, str], list[Hole]]:
    """Holes by module and attachment."""
    groups: dict[tuple[str, str], list[Hole]] = {}
    for hole in solid.holes:
        groups.setdefault((hole.fixing.module.of, hole.fixing.place.name), []).append(hole)
    return groups


def _edges(part: Part, of: str, holes: list[Hole], wall: float) -> Check:
    """Least material around the holes of an attachment."""
    worst, where = min(hole.edge for hole in holes), ''
    far = max(math.dist(hole.start, 1e3 * hole.fixing.position) for hole in holes)
    needed = far + holes[0].screw.clearance / 2 + wall
    begins = max(hole.begins for hole in holes)
    if reach_at_face(part.solid.shape, holes[0].fixing, begins) >= needed:
        remedy = (
            'a larger wall under [link] of the assembly: the pad is wide enough where it begins, '
            'and the part leaves it aslant'
        )
    else:
        # Pads are octagons; their flat sides are nearer than their radius.
        radius = math.ceil(needed / math.cos(math.pi / 8) * 10) / 1e4
        remedy = (
            f'pads that hold these screws: radius = {radius:g} or more under [link] of the assembly'
        )
    apart = min(hole.apart for hole in holes)
    if apart < worst:
        worst, where = apart, 'between two of them'
        remedy = 'fewer or smaller screws in the module file, or --wall for a finer nozzle'
    return at_least(part.name, f'edge of holes, {of}', worst, wall, 'mm', where, remedy)


def _blocked(solid: Solid, hole: Hole) -> str:
    """What stands in the way of a straight driver; empty: nothing."""
    way = driver_way(hole)
    if (way ^ solid.shape).volume() > _TOUCHES:
        return 'the part itself'
    servo = [solid.link.servo] if solid.link.servo is hole.fixing.module else []
    for module in (*solid.link.modules, *servo):
        if module is not hole.fixing.module and (way ^ outline(module)).volume() > _TOUCHES:
            return module.of
    return ''


def _reach(part: Part, of: str, holes: Iterable[Hole]) -> Check:
    solid = part.solid
    blocked = {what for hole in holes if (what := _blocked(solid, hole))}
    remedy = 'turn the module by roll, or move it along its link'
    return Check(
        part.name,
        f'screws reached, {of}',
        not blocked,
        None,
        '',
        'by a straight driver of 80 mm',
        f'in the way: {", ".join(sorted(blocked))}' if blocked else '',
        remedy if blocked else '',
    )


def check_screws(parts: list[Part], wall: float) -> list[Check]:
    """Edges and reach of all screws whose pattern is known, once for each attachment."""
    out = []
    for part in parts:
        for (module, place), holes in _groups(part.solid).items():
            of = f'{module} {place}'
            out += [_edges(part, of, holes, wall), _reach(part, of, holes)]
    return out
