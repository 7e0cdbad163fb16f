# SPDX-License-Identifier: Apache-2.0
"""Tests of the page on a tablet; browser_test.py runs them."""

import contextlib

from own_studio import OwnStudio
from studio_browser import ROOT

SMALLEST = 39.5  # pixels, of what a finger shall hit

# What a finger would miss, what ends in an ellipsis, what stands beyond the edge of its panel.
FOUND = """least => {
  const found = [];
  const tell = (what, each) => {
    const { width, height } = each.getBoundingClientRect();
    const words = each.getAttribute('aria-label') ?? each.textContent;
    found.push(`${what}: ${each.tagName} ${words.slice(0, 30)} ${width} x ${height}`);
  };
  for (const each of document.querySelectorAll('button, select, input, summary')) {
    if (!each.checkVisibility({ visibilityProperty: true }) || each.type === 'file') continue;
    const target = each.type === 'checkbox' ? each.closest('label') ?? each : each;
    const { width, height } = target.getBoundingClientRect();
    if (Math.min(width, height) < least) tell('small', target);
  }
  for (const each of document.querySelectorAll('.side *, dialog *, .top-bar *')) {
    if (!each.checkVisibility() || each.closest('.unseen, svg, .u-wrap')) continue;
    const hides = getComputedStyle(each).overflowX === 'hidden';
    if (hides && each.scrollWidth > each.clientWidth + 1) tell('cut off', each);
    const { right, width } = each.getBoundingClientRect();
    const edge = each.closest('.side, dialog, .top-bar').getBoundingClientRect().right;
    if (width && right > edge + 1) tell('beyond the edge', each);
  }
  if (document.documentElement.scrollWidth > innerWidth) found.push('the page scrolls sideways');
  return found;
}"""


class Tablet(OwnStudio):
    def tablet(self, task, width=1024, height=768):
        return self.open(task, width=width, height=height, touch=True)

    @contextlib.contextmanager
    def fingers(self, studio):
        """What fingers do: `move('touchStart', (x, y), …)`, then 'touchMove' and 'touchEnd'."""
        devtools = studio.context.new_cdp_session(studio.page)

        def move(kind, *points):
            points = [{'x': x, 'y': y, 'id': i} for i, (x, y) in enumerate(points)]
            devtools.send('Input.dispatchTouchEvent', {'type': kind, 'touchPoints': points})

        yield move
        devtools.detach()

    def middle(self, locator):
        box = locator.bounding_box()
        return box['x'] + box['width'] / 2, box['y'] + box['height'] / 2

    def all_is_well(self, studio, where):
        self.assertEqual(studio.js(FOUND, SMALLEST), [], where)

    def test_fingers_hit_all_and_nothing_is_cut_off(self):
        for width, height in ((1024, 768), (820, 1180)):
            studio = self.tablet('puppy/sideways.toml', width, height)
            name = 'front_thigh_length'
            studio.page.locator(f'.parameter[data-name="{name}"] .parameter-name').tap()
            upper = studio.js('n => legwrightStudio.readParameter(n).upper', name)
            studio.js('([n, v]) => legwrightStudio.edit(n, v, "once")', [name, upper])
            studio.page.locator(f'[data-name="{name}"] .at-bound').wait_for()
            studio.settled()
            studio.button('Keep…').tap()
            studio.page.get_by_label('Name').fill('as it was')
            self.all_is_well(studio, f'dialog, {width}')
            studio.page.keyboard.press('Enter')
            studio.button('Compare').tap()
            studio.page.locator('.compared').wait_for()
            self.all_is_well(studio, f'design, {width}')
            studio.workspace('Simulate')
            studio.page.get_by_text('Style, limits, weights').tap()
            self.all_is_well(studio, f'simulate, {width}')
            self.assertEqual(studio.console, [])

    def test_fingers_hit_all_where_a_robot_begins(self):
        studio = self.tablet(None, 820, 1180)
        studio.button('New robot…').wait_for()
        self.all_is_well(studio, 'first page')
        robot = str(ROOT / 'tests/robots/servo_dog/robot.xml')
        studio.page.locator('input[type=file]').first.set_input_files(robot)
        box = studio.page.get_by_role('checkbox', name='front upper length')
        box.wait_for()
        self.all_is_well(studio, 'proposal')
        x, y = self.middle(box)
        studio.page.touchscreen.tap(x - 18, y - 18)  # beside the box, within a finger's reach
        self.assertFalse(box.is_checked())
        studio.button('Back').tap()
        studio.button('New robot…').tap()
        card = studio.page.locator('button.module-card[data-module="XL430-W250"]')
        card.tap()
        studio.page.locator('.place-buttons button').first.tap()
        studio.page.get_by_role('heading', name='Joint hip').wait_for()
        self.all_is_well(studio, 'modules')
        self.assertEqual(studio.console, [])

    def test_words_of_marks_stay_within_the_picture(self):
        studio = self.tablet('puppy/sideways.toml')
        seen = 0
        for phase in (0.1, 0.3, 0.47, 0.6, 0.8):
            studio.js(
                """phase => {
                  legwrightStudio.view.seekPhase(phase);
                  const pictures = (n, then) =>
                    n ? requestAnimationFrame(() => pictures(n - 1, then)) : then();
                  return new Promise((then) => pictures(3, then));
                }""",
                phase,
            )
            labels = studio.js(
                """[...document.querySelectorAll('.workspace .mark-label:not([hidden])')]
                  .map((each) => [each.textContent, each.getBoundingClientRect(),
                                  each.parentNode.getBoundingClientRect()])
                  .map(([words, own, all]) =>
                    [words, own.left < all.left || own.right > all.right])"""
            )
            seen += len(labels)
            self.assertEqual([words for words, beyond in labels if beyond], [], phase)
        self.assertGreater(seen, 0)
        self.assertEqual(studio.console, [])

    def test_the_picture_stays_while_a_panel_scrolls(self):
        studio = self.tablet('puppy/sideways.toml', 820, 1180)
        canvas = studio.page.locator('.workspace canvas').first
        before = canvas.bounding_box()
        panel = studio.page.locator('.workspace .side.left:visible')
        x, y = self.middle(panel)
        studio.swipe((x, y), (x, y - 250))
        studio.until('document.querySelector(".workspace .side.left").scrollTop > 100')
        self.assertEqual(canvas.bounding_box(), before)
        self.assertEqual(studio.js('scrollY'), 0)
        self.assertTrue(studio.button('Optimise').is_visible())
        self.assertEqual(studio.console, [])

    def test_two_fingers_zoom_wherever_they_come_down(self):
        studio = self.tablet('puppy/sideways.toml')
        stage = 'legwrightStudio.view.stage'
        far = f'{stage}.camera.position.distanceTo({stage}.controls.target)'
        name = 'front_foot_length'
        at = studio.handle(name)
        before = studio.value(name), studio.js(far)
        self.assertFalse(studio.state('can_undo'))
        first, second = (at['x'], at['y']), (at['x'] + 120, at['y'] + 60)
        with self.fingers(studio) as move:
            move('touchStart', first)
            move('touchStart', first, second)
            for i in range(1, 7):
                move('touchMove', (first[0] - 10 * i, first[1] - 5 * i), second)
            move('touchEnd')
        studio.settled()
        self.assertEqual(studio.value(name), before[0])
        self.assertFalse(studio.state('can_undo'))
        self.assertFalse(studio.page.locator('.hand-note').is_visible())
        self.assertLess(studio.js(far), 0.9 * before[1])
        turned = studio.js(f'{stage}.camera.position.toArray()')
        box = studio.page.locator('.workspace canvas').first.bounding_box()
        left, middle = box['x'] + 20, box['y'] + box['height'] / 2
        studio.swipe((left, middle), (left + 150, middle))
        self.assertNotEqual(studio.js(f'{stage}.camera.position.toArray()'), turned)
        self.assertEqual(studio.console, [])

    def test_a_second_finger_that_comes_late_changes_nothing(self):
        studio = self.tablet('puppy/sideways.toml')
        name = 'front_foot_length'
        at = studio.handle(name)
        before = studio.value(name)
        first, second = (at['x'], at['y']), (at['x'] + 120, at['y'] + 60)
        held = first[0] + 2 * at['dx'], first[1] + 2 * at['dy']
        with self.fingers(studio) as move:
            move('touchStart', first)
            move('touchMove', held)
            studio.page.wait_for_timeout(600)
            move('touchStart', held, second)
            move('touchMove', held, (second[0] + 60, second[1] + 60))
            move('touchEnd', held)
            move('touchEnd')
        studio.settled()
        self.assertAlmostEqual(studio.value(name), before + 0.02, delta=0.004)
        self.assertEqual(studio.console, [])

    def test_a_finger_that_rests_is_told_what_it_rests_on(self):
        studio = self.tablet('puppy/sideways.toml')
        told = studio.page.locator('.held-title')
        step = self.middle(studio.button('Step'))
        with self.fingers(studio) as move:
            move('touchStart', step)
            told.get_by_text('One design iteration').wait_for()
            move('touchEnd')
            studio.page.wait_for_timeout(300)
            self.assertEqual(studio.state('iterations'), 0)
            studio.page.touchscreen.tap(*step)
            told.wait_for(state='hidden')
            studio.until('legwrightStudio.store.get("state").iterations === 1')
            studio.settled()
            title = studio.page.get_by_role('heading', name='Cost F')
            studio.page.touchscreen.tap(*self.middle(title))
            told.get_by_text('F sums up how far').wait_for()
            studio.button('How to, and keys (?)').tap()
            studio.page.get_by_role('dialog', name='How to').wait_for()
            self.assertFalse(told.is_visible())
        self.assertEqual(studio.console, [])

    def test_a_key_presses_after_a_finger_has_rested(self):
        studio = self.tablet('puppy/sideways.toml')
        x, y = self.middle(studio.button('Step'))
        with self.fingers(studio) as move:
            move('touchStart', (x, y))
            studio.page.locator('.held-title').get_by_text('One design iteration').wait_for()
            move('touchMove', (x, y + 300))  # no press comes of it
            move('touchEnd')
        studio.button('Step').press('Enter')
        studio.until('legwrightStudio.store.get("state").iterations === 1')
        self.assertEqual(studio.console, [])

    def test_a_finger_paints_footfalls_sideways_and_scrolls_past_them(self):
        studio = self.tablet('puppy/sideways.toml', 1024, 600)
        studio.workspace('Simulate')
        footfalls = 'legwrightStudio.store.get("document").tasks[0].footfalls[0].cells'
        before = studio.js(footfalls)
        row = studio.page.locator('.footfall-row').first
        row.scroll_into_view_if_needed()
        off = row.locator('.cell').nth(before.index(0))
        x, y = self.middle(off)
        studio.swipe((x, y), (x, y - 150))
        studio.until('document.querySelector(".workspace .side.left:not([hidden])").scrollTop > 60')
        self.assertEqual(studio.js(footfalls), before)
        self.assertNotIn('on', off.get_attribute('class').split())
        studio.still(off)
        x, y = self.middle(off)
        studio.swipe((x, y), (x + 10, y))
        studio.until(f'was => {footfalls}.join() !== was', ','.join(map(str, before)))
        self.assertEqual(studio.console, [])

    def test_a_fall_is_not_told_of_the_plan(self):
        studio = self.tablet('puppy/sideways.toml')
        studio.workspace('Simulate')
        studio.button('Play in MuJoCo').tap()
        status = studio.page.get_by_label('Physics', exact=True).locator('.status')
        studio.until('legwrightStudio.store.get("physics")?.fell', seconds=90)
        studio.button('Back to the plan').tap()
        status.get_by_text('The plan is shown.').wait_for()
        self.assertEqual(status.get_attribute('class'), 'status')
        self.assertEqual(studio.console, [])
