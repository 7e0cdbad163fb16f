# SPDX-License-Identifier: Apache-2.0
"""A design as a notebook shows it, and what check() found."""

import base64
from collections.abc import Iterable
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from legwright._check import Findings
    from legwright._design import Design

_MOST_PICTURE = 200_000  # bytes of a picture that is put into the page
_STYLE = (
    'display:inline-block;max-width:52em;padding:.5em .9em;border:1px solid rgba(128,128,128,.45);'
    'border-radius:6px;font-size:13px;line-height:1.45;color:inherit;background:transparent'
)
_CELL = 'padding:1px 1.1em 1px 0;border:0;background:transparent;color:inherit;'
# In the middle between black and white: legible on either.
_COLOURS = {True: '#2a9d5c', False: '#d9534f', None: '#888888'}
_DOUBTFUL = '#b7791f'


def _cell(text: str, right: bool = False) -> str:
    return f'<td style="{_CELL}text-align:{"right" if right else "left"}">{text}</td>'


def _table(heads: list[str], rows: list[list[str]], left: int = 1) -> str:
    """@param left: so many columns are words, the others numbers."""
    head = ''.join(
        f'<th style="{_CELL}text-align:{"left" if i < left else "right"};font-weight:600;'
        f'opacity:.7">{escape(each)}</th>'
        for i, each in enumerate(heads)
    )
    body = ''.join(
        '<tr style="background:transparent">'
        + ''.join(_cell(each, i >= left) for i, each in enumerate(row))
        + '</tr>'
        for row in rows
    )
    return (
        '<table style="border-collapse:collapse;border:0;margin:.3em 0 0;font-size:inherit;'
        f'color:inherit"><thead><tr style="background:transparent">{head}</tr></thead>'
        f'<tbody>{body}</tbody></table>'
    )


def _chip(word: str, colour: str, line: str) -> str:
    chip = (
        f'<span style="background:{colour};color:#fff;border-radius:4px;padding:1px 7px;'
        f'font-weight:600">{escape(word)}</span>'
    )
    return f'<div>{chip} {escape(line)}</div>'


def _list(lines: Iterable[str]) -> str:
    listed = ''.join(f'<li>{escape(each)}</li>' for each in lines)
    return f'<ul style="margin:.3em 0 0">{listed}</ul>' if listed else ''


def _verdict(design: 'Design') -> str:
    verdict = design.verdict
    passed = None if verdict is None else verdict.passed
    word = {True: 'PASS', False: 'FAIL', None: 'not played'}[passed]
    line = design.status if verdict is None else verdict.line.removeprefix(word).strip()
    return _chip(word, _COLOURS[passed], line)


def _number(value: float | None) -> str:
    return '–' if value is None else f'{value:.4g}'


def _costs(design: 'Design') -> str:
    if not design.joint:
        rows = [['F', _number(design.motion_only_F), _number(design.F)]]
    else:
        rows = [['F of all tasks', _number(design.motion_only_F), _number(design.F)]]
        rows += [
            [f'F of {escape(name)}', _number(each.motion_only_F), _number(each.F)]
            for name, each in design.tasks.items()
        ]
    if design.J:
        rows.append(['J', '', _number(design.J)])
    return _table(['cost', 'given body', 'co-designed'], rows)


def _parameters(design: 'Design') -> str:
    declared: list[dict[str, Any]] = design.record['parameters']
    changed = [each for each in declared if each['final'] != each['initial']]
    if not changed:
        return '<div style="margin-top:.45em">The body is the given one.</div>'
    rows = [
        [
            escape(each['name']),
            f'{each["initial"]:.3f}',
            f'{each["final"]:.3f}',
            f'<span style="opacity:.7">{escape(each["unit"])}</span>',
        ]
        for each in changed
    ]
    title = f'{len(changed)} of {len(declared)} parameters changed'
    half = (len(rows) + 1) // 2 if len(rows) > 10 else len(rows)
    tables = ''.join(
        f'<div>{_table(["parameter", "from", "to", ""], part)}</div>'
        for part in (rows[:half], rows[half:])
        if part
    )
    return (
        f'<div style="margin-top:.6em;font-weight:600">{title}</div>'
        f'<div style="display:flex;flex-wrap:wrap;column-gap:1.5em">{tables}</div>'
    )


def _inline(file: Path, caption: str) -> str:
    if not file.is_file() or file.stat().st_size > _MOST_PICTURE:
        return ''
    data = base64.b64encode(file.read_bytes()).decode('ascii')
    return (
        '<figure style="margin:.5em .8em 0 0;display:inline-block">'
        f'<img alt="{escape(caption)}" style="width:15em;max-width:100%;border-radius:4px" '
        f'src="data:image/png;base64,{data}"><figcaption style="opacity:.7">{escape(caption)}'
        '</figcaption></figure>'
    )


def _pictures(design: 'Design') -> str:
    """The given body and the last iterate of the search, where they were drawn."""
    folders = [each.folder for each in design.tasks.values()][:1] if design.joint else [
        design.folder
    ]
    frames = sorted((folders[0] / 'iterations').glob('*/frame.png'))
    if not frames:
        return ''
    pictures = [_inline(frames[0], 'given body')]
    if len(frames) > 1:
        pictures.append(_inline(frames[-1], f'iteration {int(frames[-1].parent.name)}'))
    return '<div>' + ''.join(pictures) + '</div>'


def design_html(design: 'Design') -> str:
    """Verdict, cost and what changed of the body, as HTML for pages of either colour."""
    parts = [_verdict(design), _list(design.reasons), _pictures(design), _costs(design)]
    return f'<div style="{_STYLE}">{"".join(parts)}{_parameters(design)}</div>'


def _bounds(found: 'Findings') -> str:
    rows = []
    for name, parameter in found.robot.parameters.items():
        lower, upper = found.bounds[name]
        room = [f'{lower:.4g}', f'{upper:.4g}'] if lower < upper else ['frozen', '']
        unit = f'<span style="opacity:.7">{escape(parameter.unit)}</span>'
        rows.append([escape(name), f'{found.parameters[name]:.4g}', *room, unit])
    return _table(['parameter', 'value', 'from', 'to', ''], rows) if rows else ''


def findings_html(found: 'Findings') -> str:
    """Warnings, limbs and parameters, as HTML for pages of either colour."""
    doubtful = bool(found.warnings)
    word, colour = ('doubtful', _DOUBTFUL) if doubtful else ('ok', _COLOURS[True])
    limbs = [[escape(foot), escape(' → '.join(joints))] for foot, joints in found.limbs.items()]
    parts = [_chip(word, colour, found.summary), _list(found.warnings)]
    parts += [_table(['foot', 'joints'], limbs, left=2), _bounds(found)]
    return f'<div style="{_STYLE}">{"".join(parts)}</div>'
