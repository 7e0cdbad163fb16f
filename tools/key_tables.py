# SPDX-License-Identifier: Apache-2.0
"""The keys of a file, as `legwright check --keys --json` tells them, as tables of a page."""


def bounds_of(form):
    """The numbers that a key takes: "0 < x ≤ 5"; empty where all will do."""
    low, high = form['low'], form['high']
    left = '' if low is None else f'{low:g} {"<" if form["low_open"] else "≤"} '
    right = '' if high is None else f' {"<" if form["high_open"] else "≤"} {high:g}'
    return f'{left}x{right}' if left or right else ''


def key_row(key, scoped):
    """A key of a task file as a row."""

    def each(texts):
        return ' or '.join(dict.fromkeys(text for text in texts if text))

    forms = key['forms']
    cells = [
        f'`{key["key"].partition(".")[2] or key["key"]}`',
        each(form['type'] for form in forms),
        each(form['unit'] for form in forms),
        each(bounds_of(form) for form in forms),
        key['default'],
        f'{key["meaning"]} `{key["example"]}`',
    ]
    if scoped:
        cells.insert(1, key['in'])
    return f'| {" | ".join(cells)} |'


STANDS = {  # of a whole table of the file
    'file': 'Stands once in a file and holds for all its tasks.',
    'file or task': 'Holds for all tasks where it stands outside `[[task]]`, within it for one.',
    'task': 'Stands in each `[[task]]`, where there are several.',
}


def key_tables(document):
    """The keys of a file, a table for each table of the file; of a task file the terms, too."""
    tables, arrays = {}, set()
    for key in document['keys']:
        if key['forms'][0]['type'] == 'tables':
            arrays.add(key['key'])
        tables.setdefault(key['key'].split('.')[0] if '.' in key['key'] else '', []).append(key)
    out = []
    for name, keys in tables.items():
        stands = {key['in'] for key in keys}
        scoped = len(stands) > 1
        heads = ['key', *(['in'] if scoped else []), 'type', 'unit', 'bounds', 'default']
        heads.append('meaning, example')
        title = f'[[{name}]]' if name in arrays else f'[{name}]'
        out += [f'## `{title}`' if name else '## The file itself', '']
        out += [STANDS[stands.pop()], ''] if 'terms' in document and not scoped else []
        out += [f'| {" | ".join(heads)} |', '|---' * len(heads) + '|']
        out += [*(key_row(key, scoped) for key in keys), '']
        if name == 'weights':
            out += ['| TERM | default | asks for | equation | kind |', '|---|---|---|---|---|']
            out += [
                f'| `{term["name"]}` | {term["weight"]:g} | {term["label"]} | {term["equation"]} '
                f'| {term["role"]} |'
                for term in document['terms']
                if term['role'] != 'outer'
            ] + ['']
    return '\n'.join(out)
