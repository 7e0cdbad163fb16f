#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests of tools/readme that need no build: links and paths that are not there are found, folded
output has the shape of unfolded output, links of measured tables lead from where they are put."""

import importlib.machinery
import importlib.util
import pathlib
import tempfile
import unittest

TOOL = pathlib.Path(__file__).resolve().parents[2] / 'tools/readme'


def load():
    loader = importlib.machinery.SourceFileLoader('readme', str(TOOL))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader('readme', loader))
    loader.exec_module(module)
    return module


class Readme(unittest.TestCase):
    def setUp(self):
        self.readme = load()
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        root = self.readme.ROOT = pathlib.Path(self.folder.name)
        for name in ('docs/page.md', 'docs/other.md', 'code/file.cpp'):
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text('# A heading, with `code`\n', encoding='utf-8')
        self.page = root / 'docs/page.md'

    def links(self, text):
        return sorted(self.readme.missing_links(self.page, text))

    def paths(self, text):
        return sorted(self.readme.missing_paths(self.page, text))

    def test_links_that_lead_somewhere_are_fine(self):
        self.assertEqual(
            self.links(
                '[a](other.md), [b](../code/file.cpp), [c](https://x.org/y)\n'
                '[d](other.md#a-heading-with-code)\n\n[e]: other.md\n'
            ),
            [],
        )

    def test_links_to_missing_files_and_headings_are_found(self):
        self.assertEqual(
            self.links('[a](gone.md) [b](other.md#gone)\n\n[e]: lost.md\n'),
            ['gone.md', 'lost.md', 'other.md#gone'],
        )

    def test_links_in_code_are_no_links(self):
        self.assertEqual(self.links('```\n[a](gone.md)\n```\n'), [])

    def test_paths_count_from_root_folder_and_tests_with_any_extension(self):
        self.assertEqual(
            self.paths('`code/file` `code/file.cpp` `runs/x` `code/NAME.cpp` `docs/`'), []
        )
        (self.readme.ROOT / 'docs/sub').mkdir()
        (self.readme.ROOT / 'docs/sub/x.hpp').touch()
        (self.readme.ROOT / 'tests/docs/sub').mkdir(parents=True)
        (self.readme.ROOT / 'tests/docs/sub/x_test.cpp').touch()
        self.assertEqual(self.paths('`sub/x` `sub/x_test`'), [])

    def test_missing_paths_are_found(self):
        self.assertEqual(
            self.paths('`code/gone.cpp` and `tools/io/gone`'), ['code/gone.cpp', 'tools/io/gone']
        )

    def test_folding_changes_no_shape_but_words_do(self):
        line = 'robot: FAILS  ' + 'word ' * 40 + '12 mm'
        folded = self.readme.fenced(line, ' ' * 8)
        self.assertGreater(folded.count('\n'), 3)
        self.assertLessEqual(max(map(len, folded.splitlines())), self.readme.COLUMNS)
        self.assertEqual(
            self.readme.shape(folded),
            self.readme.shape(f'```text\n{line.replace("12", "7.5")}\n```\n'),
        )
        self.assertNotEqual(
            self.readme.shape(folded),
            self.readme.shape(f'```text\n{line.replace("mm", "m")}\n```\n'),
        )

    def test_links_of_measured_tables_lead_from_their_page(self):
        text = '| [a](code/file.cpp) | [b](https://x.org) |'
        self.assertEqual(
            self.readme.relinked(text, self.page), '| [a](../code/file.cpp) | [b](https://x.org) |'
        )
        self.assertEqual(self.links(self.readme.relinked(text, self.page)), [])

    def test_seconds_are_those_of_the_whole_command_where_they_are_told(self):
        self.assertEqual(self.readme.seconds({'seconds': {'command': 6.3, 'motion': 1.3}}), 6.3)
        self.assertEqual(self.readme.seconds({'seconds': {'total': 1.7}}), 1.7)

    def test_stale_blocks_are_told_and_filled(self):
        text = 'x\n<!-- tools/readme: table -->\nold 1\n<!-- /tools/readme -->\ny\n'
        self.page.write_text(text, encoding='utf-8')
        stale = self.readme.stale_blocks
        self.assertEqual(len(list(stale(self.page, text, {'table': 'new 2\n'}))), 1)
        self.assertEqual(list(stale(self.page, text, {'table': 'old 2\n'})), [])
        self.readme.fill(self.page, text, {'table': 'new 2\n'})
        self.assertEqual(self.page.read_text(encoding='utf-8'), text.replace('old 1', 'new 2'))

    def test_keys_are_compared_to_the_letter_and_others_left_alone(self):
        text = (
            '<!-- tools/readme: keys -->\nbelow 5\n<!-- /tools/readme -->\n'
            '<!-- tools/readme: table -->\nold 1\n<!-- /tools/readme -->\n'
        )
        stale = self.readme.stale_blocks
        self.assertEqual(len(list(stale(self.page, text, {'keys': 'below 6\n'}))), 1)
        self.assertEqual(list(stale(self.page, text, {'keys': 'below 5\n'})), [])
        self.readme.fill(self.page, text, {'keys': 'below 6\n'})
        self.assertEqual(self.page.read_text(encoding='utf-8'), text.replace('5', '6'))

    def test_keys_of_a_task_file_become_a_table_for_each_of_the_file(self):
        form = {'type': 'number', 'unit': 's', 'low': 0.0, 'low_open': True, 'high': 20.0}
        form['high_open'] = False
        key = {'key': 'gait.period', 'in': 'task', 'forms': [form, dict(form, type='list')]}
        key |= {'default': 'needed', 'example': '1.0', 'meaning': 'One cycle.'}
        page = self.readme.key_tables({'keys': [key], 'terms': []})
        self.assertIn('## `[gait]`\n', page)
        self.assertIn(
            '| `period` | number or list | s | 0 < x ≤ 20 | needed | One cycle. `1.0` |', page
        )
        self.assertIn('Stands in each `[[task]]`', page)

    def test_keys_of_other_files_do_not_speak_of_tasks(self):
        form = {'type': 'tables', 'unit': '', 'low': None, 'low_open': False, 'high': None}
        form['high_open'] = False
        key = {'key': 'outline', 'in': 'file', 'forms': [form], 'default': 'needed'}
        key |= {'example': '[]', 'meaning': 'Its shape.'}
        part = key | {'key': 'outline.shape', 'forms': [form | {'type': 'text'}]}
        page = self.readme.key_tables({'keys': [key, part]})
        self.assertIn('## `[[outline]]`\n', page)
        self.assertNotIn('task', page)


if __name__ == '__main__':
    unittest.main()
