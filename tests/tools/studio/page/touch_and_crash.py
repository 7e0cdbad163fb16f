# SPDX-License-Identifier: Apache-2.0
"""Tests of pages that are touched, that are killed or kept out; browser_test.py runs them."""

import unittest

from studio_browser import ROOT, Page, Server, browser


class Apart(unittest.TestCase):
    def setUp(self):
        self.server = Server(str(ROOT / 'examples/puppy/sideways.toml'))
        self.stack = browser()
        self.browser = self.stack.__enter__()

    def tearDown(self):
        self.stack.__exit__(None, None, None)
        self.server.close()

    def test_fingers_drag_handles_and_turn_the_camera(self):
        page = Page(self.browser, self.server.url, width=1024, height=768, touch=True)
        page.ready()
        before = page.value('front_foot_length')
        at = page.handle('front_foot_length')
        end = at['x'] + 2 * at['dx'], at['y'] + 2 * at['dy']
        page.swipe((at['x'], at['y']), end)
        page.settled()
        self.assertAlmostEqual(page.value('front_foot_length'), before + 0.02, delta=0.004)
        camera = page.js('legwrightStudio.view.stage.camera.position.toArray()')
        box = page.page.locator('canvas').first.bounding_box()
        left, top = box['x'] + 20, box['y'] + box['height'] / 2
        page.swipe((left, top), (left + 150, top))
        self.assertNotEqual(
            camera, page.js('legwrightStudio.view.stage.camera.position.toArray()')
        )
        page.workspace('Simulate')
        joystick = page.page.locator('.joystick svg')
        joystick.scroll_into_view_if_needed()
        box = joystick.bounding_box()
        x, y = box['x'] + box['width'] / 2, box['y'] + box['height'] / 2
        page.swipe((x, y), (x, y - 0.2 * box['height']))
        page.until('legwrightStudio.store.get("document").tasks[0].velocity[0] > 0')
        for _ in range(2):
            page.js('legwrightStudio.command("undo")')
        page.until('v => legwrightStudio.readParameter("front_foot_length").value === v', before)
        self.assertEqual(page.console, [])
        page.close()

    def test_a_finger_slides_a_slider_sideways_and_scrolls_past_it(self):
        page = Page(self.browser, self.server.url, width=1024, height=600, touch=True)
        page.ready()
        name = 'hind_foot_length'
        slider = page.page.locator(f'.parameter[data-name="{name}"] .slider')
        slider.scroll_into_view_if_needed()
        box = slider.bounding_box()
        x, y = box['x'] + 0.8 * box['width'], box['y'] + box['height'] / 2
        top, before = box['y'], page.value(name)
        page.swipe((x, y), (x + 4, y - 150))
        page.until(f'top => document.querySelector(\'[data-name="{name}"] .slider\')'
                   '.getBoundingClientRect().y < top - 60', top)
        self.assertEqual(page.value(name), before)
        box = page.still(slider)
        y = box['y'] + box['height'] / 2
        page.swipe((box['x'] + 0.5 * box['width'], y), (box['x'] + 0.8 * box['width'], y + 4))
        page.until('([n, v]) => legwrightStudio.readParameter(n).value > v', [name, before])
        page.settled()
        self.assertEqual(page.console, [])
        page.close()

    def test_a_finger_scrolls_modules_by_their_words_and_drags_them_by_their_pictures(self):
        server = Server()
        page = Page(self.browser, server.url, width=820, height=1180, touch=True)
        page.button('New robot…').click()
        page.until('legwrightStudio.assembly.told?.limbs.length === 0')
        card = page.page.locator('button.module-card[data-module="XL430-W250"]')
        card.scroll_into_view_if_needed()
        top = card.locator('strong').bounding_box()['y']
        words, picture = (card.locator(part).bounding_box() for part in ('strong', 'img'))
        x, y = words['x'] + 20, words['y'] + 6
        page.swipe((x, y), (x, y - 120))
        page.until(
            'y => document.querySelector(\'button.module-card[data-module="XL430-W250"] strong\')'
            '.getBoundingClientRect().y < y - 40',
            top,
        )
        self.assertTrue(page.js('legwrightStudio.assembly.told.limbs.length === 0'))
        picture = page.still(card.locator('img'))
        stage = page.page.locator('.assembly canvas').first.bounding_box()
        start = picture['x'] + 20, picture['y'] + 20
        end = stage['x'] + stage['width'] / 2, stage['y'] + stage['height'] / 2
        page.js("""() => {
          globalThis.carried = [];
          const { assembly } = legwrightStudio;
          assembly.on((what) => what === 'carried' && carried.push(assembly.carried?.name));
        }""")
        page.swipe(start, end)
        page.until('carried.includes("XL430-W250")')
        self.assertEqual(page.console, [])
        page.close()
        server.close()

    def test_a_killed_page_leaves_the_session_as_it_was(self):
        studio = Page(self.browser, self.server.url)
        studio.ready()
        before = studio.value('body_length')
        other = Page(self.browser, self.server.url)
        other.ready()
        other.js('legwrightStudio.edit("body_length", legwrightStudio.readParameter('
                 '"body_length").value + 0.01, "begin")')
        studio.until(
            'v => legwrightStudio.readParameter("body_length").value !== v', before
        )
        other.crash()  # in the middle of a drag
        studio.settled()
        again = Page(self.browser, self.server.url)
        again.ready()
        self.assertAlmostEqual(again.value('body_length'), before + 0.01, places=9)
        again.js('legwrightStudio.command("undo")')
        studio.until('v => legwrightStudio.readParameter("body_length").value === v', before)
        again.close()

    def test_a_fifth_page_says_why_it_is_empty_and_goes_on_once_there_is_room(self):
        pages = [Page(self.browser, self.server.url) for _ in range(4)]
        for page in pages:
            page.ready()
        fifth = Page(self.browser, self.server.url)
        line = fifth.page.locator('.connection')
        line.get_by_text('4 pages follow this studio already').wait_for()
        pages[0].close()
        fifth.ready()
        self.assertEqual(line.inner_text(), '')
        for page in [*pages[1:], fifth]:
            page.close()

    def test_a_page_of_a_studio_that_was_started_anew_says_which_address_it_needs(self):
        task = str(ROOT / 'examples/puppy/sideways.toml')
        old = Server(task)
        page = Page(self.browser, old.url)
        page.ready()
        old.close()
        line = page.page.locator('.connection')
        line.get_by_text('Connection lost').wait_for()
        port = old.url.split(':')[2].split('/')[0]
        new = Server(task, '--port', port)
        line.get_by_text('open the URL that the program printed').wait_for()
        page.page.goto(new.url)
        page.ready()
        self.assertEqual(line.inner_text(), '')
        page.close()
        new.close()

    def test_a_notice_that_comes_again_and_again_is_one_that_counts(self):
        page = Page(self.browser, self.server.url)
        page.ready()
        page.js("""() => {
          for (let k = 0; k < 3; ++k) legwrightStudio.notices.show('error', 'It flew apart.');
          legwrightStudio.notices.show('error', 'Another.');
        }""")
        notices = page.page.locator('.notice > span').all_inner_texts()
        self.assertEqual(notices, ['It flew apart. (3 times)', 'Another.'])
        page.close()
