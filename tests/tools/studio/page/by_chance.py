# SPDX-License-Identifier: Apache-2.0
"""The page under a hand that knows nothing: what is in sight is clicked, dragged, typed into and
left by chance. Nothing of that may end up on the console, be refused without a word, or leave a
session that never rests. A seed is repeated by `tools/page --test ByChance` with LEGWRIGHT_SEEDS,
as "7" or "7-20"."""

import os
import random
import re
import shutil
import tempfile
import unittest

from studio_browser import ROOT, Page, Server, browser

ROBOTS = ('puppy/sideways.toml', 'quadruped/both.toml', 'assemblies/puppy.toml', '')
ACTIONS = 80
# What can be acted on, and is not covered; of an open dialog where there is one.
IN_SIGHT = """() => {
  const kinds = "button, input, select, textarea, summary, [role=tab], [tabindex='0'], canvas";
  const above = document.querySelector("dialog[open]") ?? document;
  return [...above.querySelectorAll(kinds)].flatMap((each) => {
    const { left, top, width, height } = each.getBoundingClientRect();
    const [x, y] = [left + width / 2, top + height / 2];
    const hit = width > 2 && height > 2 && document.elementFromPoint(x, y);
    if (!hit || each.disabled || !(each.contains(hit) || hit.contains(each))) return [];
    const words = each.getAttribute("aria-label") || each.title || each.textContent;
    return [{ x, y, width, height, tag: each.tagName, type: each.type ?? "",
              words: words.trim().slice(0, 50) }];
  });
}"""
NOTICES = """() => [...document.querySelectorAll(".notice, dialog[open] [role=alert]")]
    .map((each) => each.innerText.trim()).filter(Boolean)"""
KEYS = ('Escape', 'Control+z', 'Control+y', 'Space', 'Enter', 'ArrowLeft', 'Tab', 'Delete', 's')
TYPED = ('0', '1', '-1', '0.1', '1e9', 'abc', '', '0,5', 'ü x', '  ')
REFUSED = re.compile(r'Failed to load resource.* (400|409) ')
NO_WORDS = re.compile(r'\b(undefined|NaN|Infinity|null)\b|\[object ')


class Hand:
    """What a hand does by chance."""

    def __init__(self, page, seed):
        self.page, self.mouse, self.keys = page.page, page.page.mouse, page.page.keyboard
        self.random = random.Random(seed)

    def act(self, at):
        if self.random.random() < 0.05:
            self.keys.press(self.random.choice(KEYS))
        elif at['tag'] == 'CANVAS' or at['type'] == 'range':
            self.drag(at)
        else:
            self.mouse.click(at['x'], at['y'])
            if at['type'] in ('number', 'text', 'search', 'textarea'):
                self.keys.press('Control+a')
                self.keys.type(self.random.choice(TYPED))
                self.keys.press(self.random.choice(('Enter', 'Tab', 'Escape')))
            elif at['tag'] == 'SELECT':
                for _ in range(self.random.randrange(5)):
                    self.keys.press('ArrowDown')
                self.keys.press('Enter')
        self.page.wait_for_timeout(self.random.choice((0, 30, 100, 400, 1500)))

    def drag(self, at):
        def place():
            aside = 0.0 if at['type'] == 'range' else self.random.uniform(-0.4, 0.4)
            along = self.random.uniform(-0.4, 0.4)
            return at['x'] + along * at['width'], at['y'] + aside * at['height']

        self.mouse.move(*place())
        self.mouse.down()
        for _ in range(3):
            self.mouse.move(*place())
        self.mouse.up()


def seeds():
    first, _, last = os.environ.get('LEGWRIGHT_SEEDS', '1-4').partition('-')
    return range(int(first), int(last or first) + 1)


class ByChance(unittest.TestCase):
    def test_nothing_that_a_hand_does_is_an_error(self):
        for seed in seeds():
            with self.subTest(seed=seed), tempfile.TemporaryDirectory() as folder:
                examples = shutil.copytree(ROOT / 'examples', folder + '/examples')  # it may save
                robot = ROBOTS[seed % len(ROBOTS)]
                self.server = Server(*([f'{examples}/{robot}'] if robot else []))
                try:
                    with browser() as started:
                        self.play(Page(started, self.server.url), seed)
                finally:
                    self.server.close()

    def play(self, page, seed):
        hand = Hand(page, seed)
        page.until('document.body.dataset.page')
        told = 0
        for step in range(ACTIONS):
            controls = page.js(IN_SIGHT)
            if not controls:
                page.page.wait_for_timeout(300)
                continue
            at = hand.random.choice(controls)
            what = f'step {step}, {at["tag"]} "{at["words"]}"'
            hand.act(at)
            new, told = page.console[told:], len(page.console)
            self.assertEqual([each for each in new if not REFUSED.search(each)], [], what)
            if new:
                self.assertTrue(page.js(NOTICES), f'{what}: refused without a word')
            self.assertNotRegex(page.js('document.body.innerText'), NO_WORDS, what)
            self.assertIsNone(self.server.process.poll(), what)
        self.assertEqual([each for each in page.console if not REFUSED.search(each)], [])
        for _ in range(3):  # out of dialogs
            page.page.keyboard.press('Escape')
        if page.js('document.body.dataset.page') == 'workspace':
            page.js('legwrightStudio.command("pause")')
            page.settled()
