# SPDX-License-Identifier: Apache-2.0
"""The table of a study: a row for each point, typed columns that say what they are."""

import json
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from legwright.study import _measures
from legwright.study._measures import Measure

if TYPE_CHECKING:
    from legwright.study._points import Point
    from legwright.study._run import Study

FIRST: Mapping[str, Measure] = {
    'point': Measure('int64', '', 'number of the point, from 0'),
    'name': Measure('string', '', 'of the point, as the study names it or what it sets'),
    'hash': Measure('string', '', 'of its inputs; its run folder is points/HASH'),
    'status': Measure('string', '', 'done, refused (inputs), failed (worker, files) or open'),
    'reason': Measure('string', '', 'why it has no design'),
    'robot': Measure('string', '', 'its file or that of its assembly, from that of the study'),
    'task': Measure('string', '', 'file of the base task, likewise'),
}
"""Columns that each study has first; then come what the points set, and what they measured."""


def _plain_settings(point: 'Point') -> dict[str, Any]:
    """What a point sets, lists of numbers as a column for each entry."""
    out: dict[str, Any] = {}
    for key, value in point.settings.items():
        if key in ('robot', 'assembly', 'task'):
            continue
        if isinstance(value, list) and value and all(_is_number(each) for each in value):
            out |= {f'{key}[{i}]': each for i, each in enumerate(value)}
        else:
            out[key] = value
    return out


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _kind(values: Iterable[Any]) -> str:
    """The narrowest type that holds all."""
    there = [value for value in values if value is not None]
    if there and all(isinstance(value, bool) for value in there):
        return 'bool'
    if there and all(_is_number(value) for value in there):
        return 'int64' if all(isinstance(value, int) for value in there) else 'float64'
    return 'string'


def _typed(value: Any, kind: str) -> Any:
    if value is None:
        return None
    if kind == 'float64':
        return _measures.as_float(value)
    if kind == 'string' and not isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    return value


def rows_of(study: 'Study') -> tuple[list[dict[str, Any]], dict[str, Measure]]:
    """A mapping of columns for each point, and what the columns are, in their order."""
    rows, settings = [], [_plain_settings(point) for point in study.points]
    columns: dict[str, Measure] = dict(FIRST)
    for name in dict.fromkeys(key for each in settings for key in each):
        kind = _kind(each.get(name) for each in settings)
        columns[name] = Measure(kind, '', 'set by the study: key of task or assembly, or option')
    measured: dict[str, Measure] = dict(_measures.KNOWN)
    for point, own in zip(study.points, settings):
        record = study.records.get(point.hash)
        found = dict(record['measures']) if record else {}
        units = found.pop('units', {})
        found.pop('picture', None)
        for name in found:
            if name not in measured:
                measured[name] = _measure_of(name, units)
        failed = study.failures.get(point.hash)
        row = {
            'point': point.index,
            'name': point.name,
            'hash': point.hash,
            'status': record['status'] if record else 'failed' if failed else 'open',
            'reason': record['reason'] if record else failed,
            'robot': point.robot_file,
            'task': point.task_file,
            'seconds': record['seconds'] if record else None,
        }
        rows.append({**own, **found, **row})
    present = {name for row in rows for name, value in row.items() if value is not None}
    order = {name: measured[name] for name in sorted(measured, key=_rank)}
    return rows, columns | {
        name: measure for name, measure in order.items() if name in present or name in _ALWAYS
    }


_ALWAYS = ('feasible', 'pass', 'F', 'motion_only_F', 'mass', 'seconds')
_PREFIXES = {'s.': 1, 'limit.': 2, 'term.': 3}


def _rank(name: str) -> tuple[int, int]:
    """Named measures in their order, then the body, limits and terms as they came."""
    known = list(_measures.KNOWN)
    prefix = next((rank for start, rank in _PREFIXES.items() if name.startswith(start)), 0)
    return (prefix, known.index(name) if name in known else 0)


def _measure_of(name: str, units: Mapping[str, str]) -> Measure:
    if name.startswith('s.'):
        return Measure('float64', units.get(name, ''), 'design parameter of the result')
    if name.startswith('term.'):
        return Measure('float64', '', 'what the term adds to F')
    return Measure('float64', '', 'the worst value of what the verdict limits')


def table_of(study: 'Study') -> Any:
    """The pyarrow.Table; each field's metadata has `about` and `unit`."""
    import pyarrow

    rows, columns = rows_of(study)
    fields = [
        pyarrow.field(
            name,
            pyarrow.type_for_alias(measure.kind),
            metadata={'about': measure.about, 'unit': measure.unit},
        )
        for name, measure in columns.items()
    ]
    data = {
        name: [_typed(row.get(name), measure.kind) for row in rows]
        for name, measure in columns.items()
    }
    schema = pyarrow.schema(fields, metadata={'schema': 'legwright/study', 'version': '1'})
    return pyarrow.table(data, schema=schema)
