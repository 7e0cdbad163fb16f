# SPDX-License-Identifier: Apache-2.0
"""The page of a study, as text and in a real browser: headless Chromium, its console empty."""

import json
import re
import shutil
import subprocess
from pathlib import Path

import pytest
from legwright import study
from legwright.study import _page
from tiny_study import heights, tiny

BROWSERS = ('chromium', 'chromium-browser', 'google-chrome')
HARNESS = """<!DOCTYPE html><html><body><pre id="said"></pre><script>
const said = {}, frame = document.createElement('iframe');
frame.style.cssText = 'border: 0; width: WIDTHpx; height: 720px';
frame.onload = () => {
  const page = frame.contentDocument, find = (each) => page.querySelector(each);
  const all = (each) => [...page.querySelectorAll(each)];
  for (const fold of all('details')) fold.open = true;
  said.lines = all('.design-line').length;
  said.dots = all('.dot').length;
  said.tiles = all('.tile').length;
  said.wide = all('body *').filter((one) => one.getBoundingClientRect().right > WIDTH + 1
    && !one.closest('.scroll') && one.getBoundingClientRect().width > 0).map((one) => one.tagName);
  said.before = find('#count').textContent;
  const key = (node, name) => node.dispatchEvent(
    new frame.contentWindow.KeyboardEvent('keydown', { key: name, bubbles: true }));
  for (let i = 0; i < 20; ++i) key(find('.handle'), 'ArrowUp');  // the least of the first axis
  said.after = find('#count').textContent;
  said.out = all('.design-line.out').length;
  said.hidden = all('#table tbody tr').filter((row) => row.hidden).length;
  find('#reset').click();
  said.reset = find('#count').textContent;
  all('#table tbody button').at(-1).click();
  said.chosen = find('#chosen h3').textContent;
  all('#table th button').at(-1).click();
  said.sorted = all('#table tbody tr').map((row) => Number(row.lastElementChild.textContent));
  key(find('#front'), 'ArrowRight');
  said.front = find('#front-words').textContent;
  find('#colour').value = 'F';
  find('#colour').dispatchEvent(new Event('change'));
  said.colours = new Set(all('.design-line').map((line) => line.style.stroke)).size;
  document.getElementById('said').textContent = JSON.stringify(said);
};
frame.src = 'study.html';
document.body.append(frame);
</script></body></html>
"""


@pytest.fixture(scope='module')
def folder(tmp_path_factory) -> Path:
    """Of a study of five points, one without a design and one whose name is markup."""
    folder = tmp_path_factory.mktemp('page') / 'study'
    listed = [{'name': f'<b>&{i}'} for i in range(1)]
    listed += [{'limits': {'swing_height': 0.02 + 0.005 * i}} for i in range(3)]
    listed += [{'name': 'bad', 'design': {'freeze': ['<i>none']}}]
    study.run(tiny(grid={}, points=listed), folder, workers=1)
    return folder


def test_the_page_holds_everything_and_escapes_what_it_is_told(folder):
    page = (folder / 'study.html').read_text(encoding='utf-8')
    assert '<b>&0' not in page and '&lt;b&gt;&amp;0' in page
    assert not re.search(r'(?:src|href)="(?!data:)', page) and 'http' not in page.replace(
        'http-equiv', ''
    ).replace('http://www.w3.org/2000/svg', '')
    island = re.search(r'id="legwright-study">(.*?)</script>', page, re.DOTALL).group(1)
    data = json.loads(island)
    assert '<' not in island and len(data['rows']) == 5 == page.count('<tr data-row=')
    names = [column['name'] for column in data['columns']]
    statuses = [row[names.index('status')] for row in data['rows']]
    assert statuses == ['done'] * 4 + ['refused']
    assert 'limits.swing_height' in data['varying'] and data['x'] == 'limits.swing_height'
    assert 'refused: ' in page and 'script-src &#x27;' not in page


@pytest.mark.parametrize('width', [1280, 390])
def test_it_works_in_a_browser_with_an_empty_console(folder, width):
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser is None:
        pytest.skip('NOT LOOKED AT: no chromium on this machine')
    harness = folder / 'harness.html'
    harness.write_text(HARNESS.replace('WIDTH', str(width)), encoding='utf-8')
    done = subprocess.run(
        [
            browser,
            '--headless',
            '--no-sandbox',
            '--disable-gpu',
            '--disable-dev-shm-usage',
            '--allow-file-access-from-files',
            '--enable-logging=stderr',
            '--v=0',
            '--host-resolver-rules=MAP * ~NOTFOUND',
            f'--user-data-dir={folder / "profile"}',
            '--virtual-time-budget=5000',
            '--dump-dom',
            f'file://{harness}',
        ],
        capture_output=True,
        text=True,
        timeout=120,
        check=True,
    )
    assert 'CONSOLE' not in done.stderr, done.stderr
    text = re.search(r'<pre id="said">(.*?)</pre>', done.stdout, re.DOTALL).group(1)
    said = json.loads(text.replace('&lt;', '<').replace('&gt;', '>').replace('&amp;', '&'))
    assert (said['lines'], said['dots'], said['tiles']) == (4, 3, 4)  # one has no swing height
    assert said['wide'] == []
    assert said['before'] == said['reset'] == '4 of 4 designs'
    kept = int(said['after'].split()[0])
    assert kept < 4 and said['out'] == said['hidden'] == 4 - kept
    assert said['chosen'] == 'limits.swing_height = 0.03'
    assert said['sorted'][:4] == sorted(said['sorted'][:4])
    assert said['front'].startswith('On the front: ') and said['colours'] == 4


def test_pictures_end_where_a_page_would_grow_too_large(folder, monkeypatch):
    found = study.run(tiny(grid=heights(3)), folder.parent / 'pictures', workers=1)
    for point in found.points:
        run = found.folder / 'points' / point.hash
        (run / 'result/small.webp').write_bytes(b'RIFF' + bytes(96))
        found.records[point.hash]['measures']['picture'] = 'result/small.webp'
    monkeypatch.setattr(_page, '_PICTURES', 250)
    page = _page.page_of(found)
    assert page.count('"data:image/webp;base64,') == 2
