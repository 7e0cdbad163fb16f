# SPDX-License-Identifier: Apache-2.0
"""Writes what a task file consists of as TOML. The project's strict reader judges the text."""

import json
import re
from collections.abc import Mapping
from typing import Any

from legwright._errors import InputError

_BARE = re.compile(r'[A-Za-z0-9_-]+')


def _key(name: Any, table: str = '') -> str:
    """@param table: that messages name, with its dot."""
    of = f'{table[:-1]}: ' if table else ''
    if not isinstance(name, str):
        raise TypeError(f'{of}{name!r} is no name of a key; expected a text')
    if not _is_utf8(name):
        message = f'{name!r} is no text in UTF-8; expected the name of a key'
        raise InputError(of + message, '', 0, table[:-1], message)
    return name if _BARE.fullmatch(name) else _text(name)


def _is_utf8(text: str) -> bool:
    try:
        text.encode('utf-8')
    except UnicodeEncodeError:
        return False
    return True


def _text(value: str) -> str:
    # JSON's escapes of a string are TOML's, but for DEL, which TOML wants escaped.
    return json.dumps(value, ensure_ascii=False).replace('\x7f', '\\u007f')


def value(item: Any) -> str:
    """A value within a line. Raises TypeError for what TOML has no word for."""
    if hasattr(item, 'tolist'):  # numpy's arrays and scalars
        item = item.tolist()
    if isinstance(item, bool):
        return 'true' if item else 'false'
    if isinstance(item, (int, float)):
        return repr(item)
    if isinstance(item, str):
        return _text(item)
    if isinstance(item, Mapping):
        return '{ ' + ', '.join(f'{_key(k)} = {value(v)}' for k, v in item.items()) + ' }'
    if isinstance(item, (list, tuple)):
        return '[' + ', '.join(value(each) for each in item) + ']'
    raise TypeError(f'expected numbers, texts, lists and tables, not {type(item).__name__}')


def _value_of(key: str, item: Any) -> str:
    try:
        text = value(item)
    except TypeError as error:
        raise TypeError(f'{key}: {error}') from None
    if not _is_utf8(text):
        message = f'is {item!r}, which is no text in UTF-8; expected a text'
        raise InputError(f'{key}: {message}', '', 0, key, message)
    return text


def document(content: Mapping[str, Any], path: str = '', header: str | None = None) -> str:
    """The text of a table, its own tables below it. A list under the key `task` becomes [[task]].

    Args:
        path: of the table, with its dot: `task.`; empty for the whole file.
        header: line before its keys, where it has one.
    """
    lines = [f'\n{header}'] if header else []
    tables = []
    for name, item in content.items():
        full = path + _key(name, path)
        if name == 'task' and not path:
            tables += [document(each, 'task.', '[[task]]') for each in item]
        elif isinstance(item, Mapping):
            tables.append(document(item, full + '.', f'[{full}]'))
        else:
            lines.append(f'{_key(name)} = {_value_of(full, item)}')
    return '\n'.join(lines) + '\n' + ''.join(tables)
