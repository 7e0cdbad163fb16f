#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Lays out the pages of the site: every page of the repository in its place, so that links between
pages lead where they do in the repository, and what else pages link to.

Usage: tools/site_pages.py FOLDER
Pictures are copied. Other files, and all robots and tasks of the examples, become pages with their
text, FILE.md; folders become lists of their files, notebooks pages with the outputs that are stored
in them. docs/gallery.md is left to examples/gallery.
"""

import base64
import html
import json
import os
import pathlib
import posixpath
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
LEFT_OUT = ('tests/tools/',)  # data of tests
PICTURES = ('.png', '.svg', '.webp')
LANGUAGES = {
    '.toml': 'toml',
    '.xml': 'xml',
    '.json': 'json',
    '.py': 'python',
    '.cpp': 'cpp',
    '.hpp': 'cpp',
    '.cff': 'yaml',
    '.cmake': 'cmake',
}
EXAMPLE = re.compile(r'examples/(?!broken)\w+/[\w.]+\.(toml|xml)')  # each has a page
LINK = re.compile(r'(\]\(|^\[[^]]+\]: )([^()\s]+)', re.MULTILINE)
FENCE = re.compile(r'^```.*?^```$', re.DOTALL | re.MULTILINE)
MARKER = re.compile(r'^<!-- /?tools/readme.*-->$', re.MULTILINE)


def repository_files():
    listed = subprocess.run(
        ['git', 'ls-files', '-co', '--exclude-standard'],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        text=True,
        check=True,
    ).stdout.splitlines()
    return [name for name in sorted(set(listed)) if (ROOT / name).is_file()]


def spaced(text):
    """A blank line before tables, lists and blocks of code that follow a paragraph: GitHub does
    without, Python-Markdown does not."""
    out = []
    fenced = False
    for line in text.split('\n'):
        last = out[-1] if out else ''
        starts = (
            (line.startswith('|') and not last.startswith('|'))
            or (line.startswith('```') and not fenced)
            or (re.match(r'(-|\d+\.) ', line) and not re.match(r'(-|\d+\.) |\s', last))
        )
        if starts and not (fenced or not last.strip()):
            out.append('')
        if line.startswith('```'):
            fenced = not fenced
        out.append(line)
    return '\n'.join(out)


def bars(text):
    """Bars in code within tables: GitHub takes them escaped, Python-Markdown not at all."""

    def cell(code):
        return f'<code>{html.escape(code[1]).replace(chr(92) + "|", "&#124;")}</code>'

    return re.sub(
        r'^\|.*$',
        lambda row: re.sub(r'`([^`\n]*\\\|[^`\n]*)`', cell, row[0]),
        text,
        flags=re.MULTILINE,
    )


def outside_code(text, change):
    """The text, changed where it is no block of code."""
    parts, at = [], 0
    for fence in FENCE.finditer(text):
        parts += [change(text[at : fence.start()]), fence[0]]
        at = fence.end()
    return ''.join([*parts, change(text[at:])])


class Site:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.files = repository_files()
        self.linked = {name for name in self.files if EXAMPLE.fullmatch(name)}

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding='utf-8')

    def page(self, name):
        text = MARKER.sub('', (ROOT / name).read_text(encoding='utf-8'))

        def link(match):
            target, hash_, anchor = match[2].partition('#')
            if re.match(r'[a-z]+:', target) or not target:
                return match[0]
            file = posixpath.normpath(posixpath.join(posixpath.dirname(name), target))
            if file.endswith('.ipynb'):
                target = target.removesuffix('.ipynb') + '.md'
            elif not file.endswith('.md'):
                self.linked.add(file)
                if not file.endswith(PICTURES):
                    target += '.md'
            return f'{match[1]}{target}{hash_}{anchor}'

        self.write(name, spaced(outside_code(text, lambda part: bars(LINK.sub(link, part)))))

    def folder_page(self, name, files):
        listed = ''.join(f'- `{each}`\n' for each in files)
        self.write(f'{name}.md', f'# {posixpath.basename(name)}\n\n{listed}')

    def linked_file(self, name):
        if name.endswith(PICTURES):
            path = self.folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, path)
            return
        text = (ROOT / name).read_text(encoding='utf-8')
        language = LANGUAGES.get(pathlib.PurePath(name).suffix, 'text')
        head = f'# {posixpath.basename(name)}\n\n`{name}`\n\n'
        self.write(f'{name}.md', f'{head}~~~~{language}\n{text.rstrip()}\n~~~~\n')

    def output(self, out, stem, number):
        """An output of a notebook's cell as Markdown."""
        data = out.get('data', {})
        if 'text/html' in data:
            return f'<div class="shown">{"".join(data["text/html"])}</div>\n'
        if 'image/png' in data:
            picture = f'{stem}-{number}.png'
            (self.folder / picture).write_bytes(base64.b64decode(data['image/png']))
            return f'![Output of the cell above]({posixpath.basename(picture)})\n'
        text = ''.join(out.get('text') or data.get('text/plain', ''))
        return f'<div class="output" markdown>\n~~~~text\n{text.rstrip()}\n~~~~\n</div>\n'

    def notebook(self, name):
        stem = name.removesuffix('.ipynb')
        (self.folder / stem).parent.mkdir(parents=True, exist_ok=True)
        parts, number = [], 0
        for cell in json.loads((ROOT / name).read_text(encoding='utf-8'))['cells']:
            source = ''.join(cell['source'])
            if cell['cell_type'] == 'markdown':
                parts.append(source)
                continue
            parts.append(f'~~~~python\n{source}\n~~~~')
            for out in cell['outputs']:
                number += 1
                parts.append(self.output(out, stem, number))
        self.write(f'{stem}.md', '\n\n'.join(parts) + '\n')

    def lay_out(self):
        if self.folder.exists():
            shutil.rmtree(self.folder)
        for name in self.files:
            if name.startswith(LEFT_OUT):
                continue
            if name.endswith('.md'):
                self.page(name)
            elif name.endswith('.ipynb'):
                self.notebook(name)
        there = set(self.files)
        for name in sorted(self.linked):  # what is not there mkdocs tells, with page and link
            if name in there:
                self.linked_file(name)
            elif within := [each for each in self.files if each.startswith(name + '/')]:
                self.folder_page(name, within)
        shutil.copyfile(ROOT / 'docs/site.css', self.folder / 'site.css')


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    Site(os.fspath(sys.argv[1])).lay_out()


if __name__ == '__main__':
    main()
