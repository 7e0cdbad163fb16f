# SPDX-License-Identifier: Apache-2.0
"""Whether parts bear what a gait asks of them: each as a beam from the horn to what it carries."""

from collections.abc import Sequence

import numpy as np

from legwright.parts._checks import Check, at_least
from legwright.parts._loads import GaitLoads, Loads
from legwright.parts._options import PartOptions
from legwright.parts._robot import BuiltRobot
from legwright.parts._sections import Section, disc, sections_of
from legwright.parts._shapes import MM
from legwright.parts._solids import Part, Solid

_SHARES = np.linspace(0.15, 0.85, 29)  # of the way: where loads enter a beam says nothing
_FACTOR = 'times the stress'
_REMEDY = 'a larger radius or wall under [link] of the assembly, or --strength of another material'


def _beam(solid: Solid) -> list[Section]:
    """Sections between the horn and the middle of what is fixed at the other end."""
    horns = [f.position for f in solid.fixings if f.place.on_horn]
    others = [f.position for f in solid.fixings if not f.place.on_horn]
    if not horns or not others:
        return []
    start, end = MM * np.mean(horns, axis=0), MM * np.mean(others, axis=0)
    return sections_of(solid.shape, start, end, _SHARES)


def _most(section: Section, loads: Loads) -> tuple[float, int]:
    """The largest stress of loads at a section [MPa], and of which row."""
    moments = MM * loads.moments - np.cross(section.centre, loads.forces)
    found = section.stress(loads.forces, moments)
    k = int(np.argmax(found))
    return float(found[k]), k


def _worst(sections: list[Section], loads: Sequence[Loads]) -> tuple[float, str]:
    """The largest stress of all loads and sections [MPa], and where and when."""
    worst, where = 0.0, ''
    for each in loads:
        for section in sections:
            found, k = _most(section, each)
            if found > worst:
                worst = found
                where = f'{100 * section.share:.0f} % of the way, {each.when(k)}'
    return worst, where


def _stalled(robot: BuiltRobot, solid: Solid, sections: list[Section]) -> float:
    """The largest stress where the servo gives all that its file lets it, against the far end."""
    model, joint = robot.model, solid.link.joint
    limits = [
        float(np.abs(model.actuator_forcerange[a]).max())
        for a in range(model.nu)
        if model.actuator_trnid[a, 0] == joint
    ]
    moment = MM * max(limits, default=0.0) * model.jnt_axis[joint]
    return max((s.stress(np.zeros(3), (1 - s.share) * moment) for s in sections), default=0.0)


def _bears_servo(robot: BuiltRobot, part: Part, sections: list[Section], strength: float) -> Check:
    """Fails where the servo has no limit: nothing was looked at."""
    name, stress = 'bears its servo', _stalled(robot, part.solid, sections)
    if stress <= 0:
        joint = robot.model.joint(part.solid.link.joint).name
        where = f'no actuator of {joint} has a forcerange'
        cure = 'the file is not as `legwright build` writes it: build the robot anew'
        return Check(part.name, name, False, None, '', 'at least 1', where, cure)
    where = f'{stress:.1f} of {strength:g} MPa, all of the torque limit, against the far end'
    return at_least(part.name, name, strength / stress, 1.0, _FACTOR, where, _REMEDY)


def _bears_gait(
    part: Part, sections: list[Section], loads: GaitLoads, options: PartOptions
) -> Check:
    """Under another name where the plan's forces say nothing of a part."""
    own = [load for each in part.solids for load in loads.links.get(each.link.body, ())]
    if not own:
        where = 'no foot of the plan is beyond it: what it carries is not looked at'
        return Check(part.name, 'no foot beyond, not checked', True, None, '', '', where)
    name = f'bears {loads.gait}'
    stress, where = _worst(sections, own)
    if stress <= 0:
        limit, where = f'at least {options.safety:g}', 'the plan has no force on a foot beyond it'
        return Check(part.name, name, False, None, '', limit, where, 'optimize the robot anew')
    words = f'{stress:.1f} of {options.strength:g} MPa, {where}'
    factor = options.strength / stress
    return at_least(part.name, name, factor, options.safety, _FACTOR, words, _REMEDY)


def pegs_bear(part: Part, loads: GaitLoads, options: PartOptions) -> list[Check]:
    """Each peg where it leaves the part, under the ground's force on its foot."""
    out = []
    for number in range(len(part.solid.pegs)):
        stress, when = 0.0, 'the gait has no force on its foot'
        for solid in part.solids:
            own = solid.pegs[number]
            root = disc(own.start - own.begins * own.axis, own.axis, own.radius)
            for load in loads.feet.get(own.fixing.module.of, ()):
                found, k = _most(root, load)
                if found > stress:
                    stress, when = found, load.when(k)
        words = f'{stress:.1f} of {options.strength:g} MPa, {when}'
        factor = options.strength / stress if stress > 0 else 0.0
        cure = 'a larger foot, one whose module file has screws, or --strength of another material'
        name, least = f'peg bears {loads.gait}', options.safety
        out.append(at_least(part.name, name, factor, least, _FACTOR, words, cure))
    return out


def _not_judged(part: Part, name: str) -> Check:
    """Of a link that does not reach both its horn and what it carries, which fails by itself."""
    where = 'it does not reach both its horn and what it carries: see "reaches"'
    return Check(part.name, f'{name}, not judged', True, None, '', '', where)


def check_beams(
    robot: BuiltRobot, parts: list[Part], loads: GaitLoads | None, options: PartOptions
) -> list[Check]:
    """Safety factors of all parts: under those of a gait, if there is one, and their servo's
    torque."""
    out = []
    for part in parts:
        sections = _beam(part.solid)
        if not sections:
            if part.solid.link.servo:
                names = [*([f'bears {loads.gait}'] if loads else []), 'bears its servo']
                out += [_not_judged(part, name) for name in names]
            continue
        if loads:
            out.append(_bears_gait(part, sections, loads, options))
            out += pegs_bear(part, loads, options)
        out.append(_bears_servo(robot, part, sections, options.strength))
    return out
