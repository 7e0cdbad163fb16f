# SPDX-License-Identifier: Apache-2.0
"""Tests that begin on the first page; browser_test.py runs them."""

import unittest

from studio_browser import ROOT, Page, Server, browser


class Whole(unittest.TestCase):
    """From the first page to a saved run and back."""

    def setUp(self):
        self.stack = browser()
        self.browser = self.stack.__enter__()

    def tearDown(self):
        self.stack.__exit__(None, None, None)

    def test_start_judge_save_reopen(self):
        server = Server()
        studio = Page(self.browser, server.url)
        studio.page.get_by_role('button', name='sideways trot').click()
        studio.ready()
        studio.button('Step').click()
        studio.until('legwrightStudio.store.get("state").iterations === 1')
        studio.settled()
        before = studio.state('s')
        studio.workspace('Simulate')
        studio.button('Judge').click()
        studio.until('legwrightStudio.store.get("judge")?.verdict', seconds=60)
        self.assertGreater(studio.page.locator('.verdict-lines li').count(), 2)
        verdict = studio.js('legwrightStudio.store.get("judge").verdict.word')
        self.assertIn(verdict, ('PASS', 'FAIL'))
        studio.page.keyboard.press('Control+s')
        studio.page.get_by_label('Folder').fill(str(server.output / 'run'))
        studio.page.keyboard.press('Enter')
        studio.page.get_by_text('Done: ').wait_for()
        self.assertTrue((server.output / 'run/run.json').is_file())
        studio.button('File').click()
        studio.page.get_by_role('menuitem', name='Open another…').click()
        studio.page.get_by_label('Path').fill(str(server.output / 'run'))
        studio.page.keyboard.press('Enter')
        studio.page.locator('.workspace').wait_for()
        studio.ready()
        self.assertEqual(studio.state('s'), before)
        self.assertEqual(studio.console, [])
        studio.close()
        server.close()

    def test_another_robot_takes_the_place_in_every_page(self):
        server = Server(str(ROOT / 'examples/puppy/sideways.toml'))
        pages = [Page(self.browser, server.url) for _ in range(2)]
        for studio in pages:
            studio.ready()
        pages[0].button('File').click()
        pages[0].page.get_by_role('menuitem', name='Open another…').click()
        pages[0].page.get_by_role('button', name='walk', exact=True).click()
        for studio in pages:
            studio.until('legwrightStudio.store.get("document")?.name === "biped"')
            studio.ready()
            self.assertEqual(studio.js('legwrightStudio.view.player.feet.length'), 2)
            self.assertEqual(studio.console, [])
            studio.close()
        server.close()

    def test_a_dropped_robot_is_proposed_for(self):
        server = Server()
        studio = Page(self.browser, server.url)
        studio.page.locator('.examples img[src]').first.wait_for()
        robot = (ROOT / 'examples/puppy/robot.xml').read_text(encoding='utf-8')
        bare = robot[: robot.index('  <custom>')] + '</mujoco>\n'
        studio.page.locator('input[type=file]').first.set_input_files(
            {'name': 'mine.xml', 'mimeType': 'text/xml', 'buffer': bare.encode()}
        )
        boxes = studio.page.locator('.proposals input[type=checkbox]')
        boxes.first.wait_for()
        proposed = boxes.count()
        boxes.first.uncheck()
        studio.button('Write and go on').click()
        studio.ready()
        names = studio.js('legwrightStudio.store.get("document").parameters.length')
        self.assertEqual(names, proposed - 1)
        self.assertEqual(studio.console, [])
        studio.close()
        server.close()
