# SPDX-License-Identifier: Apache-2.0
"""A design as notebooks show it."""

import json
import shutil
from html.parser import HTMLParser

import legwright as lw
import pytest


class Page(HTMLParser):
    """Its texts and pictures; an element that is not closed, or not open, is a fault."""

    def __init__(self, text):
        super().__init__()
        self.open, self.texts, self.pictures = [], [], []
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attributes):
        if tag == 'img':
            self.pictures.append(dict(attributes)['src'])
        else:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, text):
        self.texts.append(text)


def test_it_tells_verdict_cost_and_what_changed(walk):
    page = Page(walk._repr_html_())
    assert page.texts[0] == 'PASS' and 'walk sideways' in page.texts[1]
    for number in (walk.motion_only_F, walk.F):
        assert f'{number:.4g}' in page.texts
    changed = [name for name, each in zip(walk.parameters, walk.s != walk.initial_s) if each]
    assert [text for text in page.texts if text in walk.parameters] == changed
    assert f'{len(changed)} of {len(walk.parameters)} parameters changed' in page.texts
    assert f'{walk.parameters["body_width"]:.3f}' in page.texts
    assert page.pictures == []


def test_a_failure_tells_its_reasons(walk, tmp_path):
    folder = walk.save(tmp_path / 'run')
    record = json.loads((folder / 'run.json').read_text(encoding='utf-8'))
    for each in record['choice']['candidates']:
        each['played'].update({'pass': False, 'line': 'FAIL  falls <b>& rolls'})
    record['reasons'] = ['MuJoCo does not pass it: <i>']
    record['parameters'][0]['name'] = '<script>'
    for each in record['parameters'][1:]:
        each['final'] = each['initial']
    (folder / 'run.json').write_text(json.dumps(record), encoding='utf-8')
    text = lw.Design.load(folder)._repr_html_()
    page = Page(text)
    assert page.texts[:2] == ['FAIL', ' falls <b>& rolls']
    assert 'MuJoCo does not pass it: <i>' in page.texts and '<script>' in page.texts
    assert '<script>' not in text and '<i>' not in text


def test_what_was_not_played_and_not_changed_is_told(puppy, sideways):
    quick = {'reasons': False, 'certificate': False, 'plan_only': True}
    design = lw.codesign(puppy, sideways, motion_only=True, **quick)
    page = Page(design._repr_html_())
    assert page.texts[0] == 'not played'
    assert 'The body is the given one.' in page.texts


@pytest.mark.long
def test_a_run_with_pictures_shows_the_first_and_the_last(puppy, sideways):
    quick = {'reasons': False, 'certificate': False, 'plan_only': True}
    design = lw.codesign(puppy, sideways, max_iterations=2, pictures=True, **quick)
    frames = sorted((design.folder / 'iterations').glob('*/frame.png'))
    if not frames:
        pytest.skip('no OpenGL here')
    page = Page(design._repr_html_())
    assert len(page.pictures) == 2
    assert page.pictures[0].startswith('data:image/png;base64,iVBOR')
    assert 'given body' in page.texts and 'iteration 2' in page.texts
    shutil.rmtree(frames[-1].parent)
    frames[0].write_bytes(bytes(1_000_000))  # no page gets a picture as large as that
    assert Page(design._repr_html_()).pictures[0] != page.pictures[0]


def test_several_tasks_have_a_row_each(examples):
    robot = lw.Robot(examples / 'quadruped/robot.xml')
    tasks = [lw.Task('trot', (0.2, 0.0), name='ahead'), lw.Task('trot', (0.0, 0.1), name='left')]
    quick = {'reasons': False, 'certificate': False, 'plan_only': True, 'one_start': True}
    design = lw.codesign(robot, tasks, max_iterations=1, **quick)
    texts = Page(design._repr_html_()).texts
    assert {'F of all tasks', 'F of ahead', 'F of left'} <= set(texts)
