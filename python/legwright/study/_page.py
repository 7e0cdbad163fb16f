# SPDX-License-Identifier: Apache-2.0
"""The page that compares the designs of a study: one HTML file that needs nothing else."""

import base64
import hashlib
import json
import math
from collections.abc import Mapping
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from legwright import _core
from legwright._files import read_bytes
from legwright.study._measures import Measure
from legwright.study._table import FIRST, rows_of

if TYPE_CHECKING:
    from legwright.study._run import Study

_HERE = Path(__file__).parent
_PICTURES = 8_000_000  # bytes of pictures on a page, at most
_MOST_AXES = 8  # at first
_MEASURED = ('pass', 'validated', 'F', 'motion_only_F', 'J', 'mass', 'printed_volume', 'survival')

Rows = list[dict[str, Any]]


def _plain(value: Any) -> Any:
    """As JSON has it; what is infinite counts as none."""
    if isinstance(value, float) and not math.isfinite(value) or value == 'infinite':
        return None
    return json.dumps(value, ensure_ascii=False) if isinstance(value, (list, dict)) else value


def _words(value: Any) -> str:
    value = _plain(value)
    if value is None:
        return '–'
    if isinstance(value, bool):
        return 'yes' if value else 'no'
    return f'{value:.4g}' if isinstance(value, float) else str(value)


def _bytes_of(picture: Path) -> bytes:
    """Nothing where there is none, or one that fits on no page."""
    try:
        return read_bytes(picture, _PICTURES)
    except OSError:
        return b''


def _pictures(study: 'Study', rows: Rows) -> list[str | None]:
    """A data URI for each row that has a picture, as far as they fit."""
    left, out = _PICTURES, []
    for row in rows:
        record = study.records.get(row['hash'])
        name = record['measures'].get('picture') if record else None
        file = study.folder / 'points' / row['hash'] / name if name else None
        data = _bytes_of(file) if file else b''
        left -= len(data)
        fits = data and left >= 0
        out.append('data:image/webp;base64,' + base64.b64encode(data).decode() if fits else None)
    return out


def _varying(rows: Rows, columns: Mapping[str, Measure]) -> list[str]:
    """Columns in which designs differ and that can be drawn: what was set, then what was found."""
    done = [row for row in rows if row['status'] == 'done']
    out = []
    for name, measure in columns.items():
        if name in ('point', 'hash', 'status', 'reason', 'verdict', 'validated_verdict'):
            continue
        values = {_plain(row.get(name)) for row in done} - {None}
        words = measure.kind == 'string'
        if len(values) > 1 and not (words and len(values) > 24):
            out.append(name)
    return out


def _view(rows: Rows, columns: Mapping[str, Measure], set_by: list[str]) -> dict[str, Any]:
    """Which columns the page starts with."""
    varying = _varying(rows, columns)
    settings = [name for name in varying if name in set_by or name in ('robot', 'task')]
    measured = [name for name in _MEASURED if name in varying]
    axes = settings[: _MOST_AXES - min(3, len(measured))]
    axes = (axes + measured)[:_MOST_AXES] or ['F', 'mass']
    numbers = [name for name in settings if columns[name].kind in ('int64', 'float64')]
    places = {name: i for i, name in enumerate(columns)}
    return {
        'axes': [places[name] for name in axes],
        'varying': varying,
        'x': numbers[0] if numbers else 'mass',
        'x_better': 'most' if numbers else 'least',
        'y': 'F',
    }


def _table(rows: Rows, columns: Mapping[str, Measure], shown: list[str]) -> str:
    """All rows, readable without the script."""
    places = {name: i for i, name in enumerate(columns)}
    names = ['point', 'name', *[each for each in shown if each != 'name'], 'seconds']
    head = ''.join(
        f'<th{_class(columns[name])} title="{escape(columns[name].about)}"><button type="button" '
        f'data-column="{places[name]}">{escape(name)}</button></th>'
        for name in names
    )
    lines = []
    for i, row in enumerate(rows):
        cells = []
        for name in names:
            text = escape(_words(row.get(name)))
            if name == 'name':
                text = f'<button type="button">{text}</button>' if row['status'] == 'done' else text
                text += _outcome(row)
            cells.append(f'<td{_class(columns[name])}>{text}</td>')
        lines.append(f'<tr data-row="{i}">{"".join(cells)}</tr>')
    body = '\n'.join(lines)
    return f'<table id="table"><thead><tr>{head}</tr></thead><tbody>\n{body}\n</tbody></table>'


def _class(measure: Measure) -> str:
    return ' class="n"' if measure.kind in ('int64', 'float64') else ''


def _outcome(row: Mapping[str, Any]) -> str:
    """The verdict, or why there is no design."""
    if row['status'] != 'done':
        words = {'open': 'not run'}.get(row['status'], row['status'])
        return (
            f'<small class="no">{words}: {escape(row["reason"] or "the study was stopped")}</small>'
        )
    verdict = row.get('verdict')
    return f'<small>{escape(verdict)}</small>' if verdict else '<small>not played in MuJoCo</small>'


def _line(study: 'Study', rows: Rows) -> str:
    done = [row for row in rows if row['status'] == 'done']
    played = [row for row in done if row.get('pass') is not None]
    passed = sum(row['pass'] for row in played)
    words = [f'{len(rows)} points', f'{len(done)} with a design']
    words += [f'MuJoCo passes {passed} of {len(played)}'] if played else ['none played in MuJoCo']
    best = study.best_line
    words = [', '.join(words)] + ([best[0].upper() + best[1:]] if best else [])
    return f'{". ".join(words)}. Legwright {_core.__version__}, MuJoCo {_core.mujoco_version}.'


def page_of(study: 'Study') -> str:
    """The page of a study as it stands."""
    rows, columns = rows_of(study)
    set_by = list(columns)[len(FIRST) : _first_measured(columns)]
    view = _view(rows, columns, set_by)
    island = {
        'columns': [
            {'name': name, 'kind': each.kind, 'unit': each.unit, 'about': each.about}
            for name, each in columns.items()
        ],
        'rows': [[_plain(row.get(name)) for name in columns] for row in rows],
        'pictures': _pictures(study, rows),
        **view,
    }
    script = (_HERE / 'page.js').read_text(encoding='utf-8')
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    own = (_HERE / 'page.css').read_text(encoding='utf-8')
    names = list(columns)
    data = json.dumps(island, ensure_ascii=False, separators=(',', ':'), allow_nan=False)
    return (
        (_HERE / 'page.html')
        .read_text(encoding='utf-8')
        .format(
            script_hash=f'sha256-{digest}',
            title=escape(study.name),
            style=_core.report_style() + own,
            line=escape(_line(study, rows)),
            table=_table(rows, columns, [names[i] for i in view['axes']]),
            footer=f'Written by <code>legwright study</code> {escape(_core.__version__)}.',
            island=data.replace('<', '\\u003c'),
            script=script,
        )
    )


def _first_measured(columns: Mapping[str, Measure]) -> int:
    """Where the columns begin that were measured."""
    from legwright.study._measures import KNOWN

    return next(i for i, name in enumerate(columns) if name in KNOWN)
