# SPDX-License-Identifier: Apache-2.0
"""What a study keeps of a design: one number or word a column of the table."""

import hashlib
import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from legwright._design import Design
from legwright._files import MOST_OF_RUN, read_bytes, read_json


@dataclass(frozen=True)
class Measure:
    """A column."""

    kind: str
    """Of Arrow: "float64", "int64", "bool", "string"."""
    unit: str
    about: str


KNOWN: Mapping[str, Measure] = {
    'feasible': Measure('bool', '', 'whether the plan keeps its constraints and MuJoCo passes it'),
    'pass': Measure('bool', '', "MuJoCo's verdict; empty where it was not asked"),
    'verdict': Measure('string', '', 'the verdict in words'),
    'merit': Measure('float64', '', 'how far the gait is from passing: 0 passes, infinite fell'),
    'F': Measure('float64', '', 'the cost of body and motion'),
    'J': Measure('float64', '', 'the outer objective; 0 without one'),
    'motion_only_F': Measure('float64', '', 'F of the given body with its best motion'),
    'search': Measure('string', '', 'how the search ended'),
    'design_iterations': Measure('int64', '', 'of the search'),
    'newton_iterations': Measure('int64', '', 'of all motions of the search'),
    'joints': Measure('int64', '', 'that a servo turns'),
    'initial_mass': Measure('float64', 'kg', 'of the given body, without payload'),
    'mass': Measure('float64', 'kg', 'of the body, without payload'),
    'initial_printed_volume': Measure('float64', 'm^3', 'of the given body'),
    'printed_volume': Measure('float64', 'm^3', 'of the printed parts of the body'),
    'validated': Measure('bool', '', 'what `legwright validate` says'),
    'validated_verdict': Measure('string', '', 'the same in words'),
    'survival': Measure('float64', '1', 'share of the disturbed walks that get through'),
    'seconds': Measure('float64', 's', 'wall time of the point on its worker'),
}
"""By name; beside these stand `s.NAME`, `term.NAME` and `limit.NAME`."""


BEST = ('F', 'J', 'mass', 'printed_volume', 'joints')
"""Measures of which a study may be after the least."""


def of_design(design: Design) -> dict[str, Any]:
    """Measures of a design, by column; `units` has those of `s.NAME`."""
    record, verdict = design.record, design.verdict
    out: dict[str, Any] = {
        'feasible': design.feasible,
        'pass': None if verdict is None else verdict.passed,
        'verdict': None if verdict is None else verdict.line,
        'merit': None if verdict is None else _number(verdict.merit),
        'F': _number(design.F),
        'J': _number(design.J),
        'motion_only_F': _number(design.motion_only_F),
        'search': design.status,
        'design_iterations': record.get('design_iterations'),
        'newton_iterations': record.get('newton_iterations'),
        'joints': len(next(iter(design.tasks.values())).motion.joint_names),
    }
    for prefix, which in (('initial_', 'initial'), ('', 'final')):
        body = (record.get('body') or {}).get(which) or {}
        out[f'{prefix}mass'] = body.get('mass_kg')
        out[f'{prefix}printed_volume'] = body.get('printed_volume_m3')
    out |= {f's.{name}': value for name, value in design.parameters.items()}
    out |= {f'term.{name}': _number(value) for name, value in design.terms.items()}
    out['units'] = {f's.{each["name"]}': each['unit'] for each in record['parameters']}
    return out


def _number(value: float) -> float | str:
    """JSON has no infinity."""
    return value if math.isfinite(value) else 'infinite'


def as_float(measured: float | str) -> float:
    """The number again that _number() told."""
    return math.inf if measured == 'infinite' else float(measured)


def _stands(folder: Path, of: Mapping[str, str]) -> bool:
    """Whether a judgement is of what stands in a run: `of` has SHA-256 sums of files below, and of
    other things by names without a slash."""

    def same(name: str, known: str) -> bool:
        file = (folder / name).resolve()
        inside = file.is_relative_to(folder.resolve()) and file.is_file()
        return inside and hashlib.sha256(read_bytes(file, MOST_OF_RUN)).hexdigest() == known

    return 'result/scene.xml' in of and all(same(*each) for each in of.items() if '/' in each[0])


def of_validation(design: Design) -> dict[str, Any]:
    """Measures of a design that `legwright validate` has judged; of several tasks the worst."""
    out: dict[str, Any] = {'validated': True, 'validated_verdict': ''}
    lines = []
    for name, each in design.tasks.items():
        verdict = read_json(each.folder / 'result/verdict.json')
        of = verdict.get('of')
        if of is not None and not _stands(each.folder, of):
            return {'validated': None, 'validated_verdict': 'not of this result: judge again'}
        out['validated'] = out['validated'] and verdict['pass']
        line = verdict['result']['line'] + (' (without sums)' if of is None else '')
        lines.append((f'{name}: ' if design.joint else '') + line)
        if not design.joint:
            out |= {f'limit.{row["name"]}': row['value'] for row in verdict['result']['limits']}
        robustness = each.folder / 'result/robustness.json'
        if robustness.exists():
            drawn = read_json(robustness)['monte_carlo']
            if drawn['samples'] > 0:
                out['survival'] = min(drawn['share'], out.get('survival', 1.0))
    out['validated_verdict'] = '; '.join(lines)
    return out
