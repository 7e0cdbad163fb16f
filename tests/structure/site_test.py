#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests of tools/site_pages.py, which lays out the pages of the site: links lead where they did."""

import importlib.machinery
import importlib.util
import json
import pathlib
import tempfile
import unittest

TOOL = pathlib.Path(__file__).resolve().parents[2] / 'tools/site_pages.py'


def load():
    loader = importlib.machinery.SourceFileLoader('site_pages', str(TOOL))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader('site_pages', loader))
    loader.exec_module(module)
    return module


class SitePages(unittest.TestCase):
    def setUp(self):
        self.pages = load()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = self.pages.ROOT = pathlib.Path(folder.name) / 'root'
        self.site = self.root.parent / 'site'
        self.files = {'docs/site.css': ''}
        self.pages.repository_files = lambda: sorted(self.files)

    def lay_out(self, **files):
        for name, text in files.items():
            self.files[name.replace('__', '/').replace('_md', '.md')] = text
        for name, text in self.files.items():
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).write_text(text, encoding='utf-8')
        self.pages.Site(self.site).lay_out()

    def text(self, name):
        return (self.site / name).read_text(encoding='utf-8')

    def test_files_that_pages_link_to_become_pages(self):
        self.files['code/a.toml'] = 'x = 1\n'
        self.files['docs/p.png'] = 'a picture'
        self.lay_out(
            docs__a_md='# A\n[f](../code/a.toml) [b](b.md#x) [w](https://x.org) ![p](p.png)\n\n'
            '[r]: ../code/a.toml\n```\n[c](../code/a.toml)\n```\n',
            docs__b_md='# B\n',
        )
        text = self.text('docs/a.md')
        self.assertIn('[f](../code/a.toml.md) [b](b.md#x) [w](https://x.org) ![p](p.png)', text)
        self.assertIn('[r]: ../code/a.toml.md', text)
        self.assertIn('[c](../code/a.toml)\n', text)
        self.assertIn('~~~~toml\nx = 1\n~~~~', self.text('code/a.toml.md'))
        self.assertEqual(self.text('docs/p.png'), 'a picture')

    def test_folders_that_pages_link_to_become_lists(self):
        self.files |= {'code/a.cpp': '', 'code/b/c.cpp': '', 'coder.cpp': ''}
        self.lay_out(docs__a_md='[f](../code)\n')
        self.assertIn('(../code.md)', self.text('docs/a.md'))
        self.assertEqual(self.text('code.md'), '# code\n\n- `code/a.cpp`\n- `code/b/c.cpp`\n')

    def test_a_link_to_nothing_stays_for_mkdocs_to_find(self):
        self.lay_out(docs__a_md='[f](../gone.toml)\n')
        self.assertIn('(../gone.toml.md)', self.text('docs/a.md'))
        self.assertFalse((self.site / 'gone.toml.md').exists())

    def test_tables_lists_and_code_get_their_blank_line(self):
        self.assertEqual(
            self.pages.spaced('a\n| b |\n|---|\n| c |\nd\n- e\n  f\n- g\nh\n```\n- i\n| j |\n```'),
            'a\n\n| b |\n|---|\n| c |\nd\n\n- e\n  f\n- g\nh\n\n```\n- i\n| j |\n```',
        )

    def test_bars_in_code_of_tables_stay_bars(self):
        self.assertEqual(self.pages.bars('| `a \\| <b>` |'), '| <code>a &#124; &lt;b&gt;</code> |')
        self.assertEqual(self.pages.bars('`a \\| b`'), '`a \\| b`')

    def test_notebooks_become_pages_with_their_outputs(self):
        shown = {'output_type': 'execute_result', 'data': {'text/html': ['<b>', 'x</b>']}}
        drawn = {'output_type': 'display_data', 'data': {'image/png': 'aGVsbG8='}}
        said = {'output_type': 'stream', 'text': ['one\n', 'two\n']}
        cells = [
            {'cell_type': 'markdown', 'source': ['# T\n', 'words']},
            {'cell_type': 'code', 'source': ['f()'], 'outputs': [said, shown, drawn]},
        ]
        self.files['n/a.ipynb'] = json.dumps({'cells': cells})
        self.lay_out(docs__a_md='[n](../n/a.ipynb)\n')
        page = self.text('n/a.md')
        for part in ('# T\nwords', '~~~~python\nf()\n~~~~', 'one\ntwo', '<b>x</b>', '(a-3.png)'):
            self.assertIn(part, page)
        self.assertEqual(self.text('n/a-3.png'), 'hello')
        self.assertIn('(../n/a.md)', self.text('docs/a.md'))


class Order(unittest.TestCase):
    def test_every_page_of_docs_has_its_place(self):
        root = TOOL.parents[1]
        order = (root / 'mkdocs.yml').read_text(encoding='utf-8')
        for page in sorted((root / 'docs').glob('*.md')):
            self.assertIn(f' docs/{page.name}\n', order)


if __name__ == '__main__':
    unittest.main()
