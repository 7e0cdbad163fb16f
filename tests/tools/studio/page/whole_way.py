# SPDX-License-Identifier: Apache-2.0
"""Tests of ways through several robots and requests; browser_test.py runs them."""

from own_studio import OwnStudio
from studio_browser import ROOT, Page


class Whole(OwnStudio):
    """What is opened, judged and undone in turn."""

    def test_start_judge_save_reopen(self):
        studio = self.open(None)
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
        studio.page.get_by_label('Folder').fill(str(self.server.output / 'run'))
        studio.page.keyboard.press('Enter')
        studio.page.get_by_text('Saved: ').wait_for()
        self.assertTrue((self.server.output / 'run/run.json').is_file())
        studio.button('File').click()
        studio.page.get_by_role('menuitem', name='Open another…').click()
        studio.page.get_by_label('Path').fill(str(self.server.output / 'run'))
        studio.page.keyboard.press('Enter')
        studio.page.locator('.workspace').wait_for()
        studio.ready()
        self.assertEqual(studio.state('s'), before)
        self.assertEqual(studio.console, [])

    def test_undo_comes_after_the_edits_that_still_wait(self):
        studio = self.open('puppy/sideways.toml')
        name = 'front_foot_length'
        before = studio.value(name)
        undone = studio.js(
            """([name, value]) => {
              const studio = legwrightStudio;
              for (const [i, phase] of ['begin', 'drag', 'end'].entries())
                studio.edit(name, value + 0.002 * (i + 1), phase);
              return studio.command('undo');
            }""",
            [name, before],
        )
        # What is present may look settled: what the undo brings must be here, too.
        reached = 'r => legwrightStudio.store.get("state").revision >= r'
        studio.until(reached, undone['revision'])
        studio.settled()
        self.assertEqual(studio.value(name), before)
        self.assertEqual(studio.console, [])

    def test_a_state_may_come_before_the_document_of_its_robot(self):
        studio = self.open('puppy/sideways.toml')
        studio.js(
            """() => {
              const { store } = legwrightStudio;
              const state = store.get('state');
              store.set('state', { ...state, s: state.s.slice(0, 3) });
            }"""
        )
        studio.page.wait_for_timeout(400)  # longer than panels wait
        self.assertEqual(studio.console, [])

    def judged(self, studio):
        """The heading over the verdict once it is there."""
        studio.button('Judge').click()
        studio.until('legwrightStudio.store.get("judge")?.running')
        studio.until('legwrightStudio.store.get("judge")?.verdict', seconds=60)
        return studio.page.locator('section[aria-label="Judge"] h2').inner_text()

    def test_verdict_and_physics_go_with_what_they_are_of(self):
        studio = self.open('puppy/sideways.toml')
        studio.workspace('Simulate')
        heading = 'document.querySelector(\'section[aria-label="Judge"] h2\').textContent'
        for speed in (0.1, 0.05):
            studio.page.get_by_label('left [m/s]').fill(str(speed))
            studio.page.keyboard.press('Enter')
            speeds = 'v => legwrightStudio.store.get("document").tasks[0].velocity[1] === v'
            studio.until(speeds, speed)
            studio.settled()
            self.assertEqual(self.judged(studio), 'Verdict')
        failing = studio.js('legwrightStudio.store.get("judge").verdict.word') == 'FAIL'
        self.assertEqual(studio.page.get_by_text('What helps as a rule').is_visible(), failing)
        name = 'front_foot_length'
        studio.js(
            'n => legwrightStudio.edit(n, legwrightStudio.readParameter(n).value + 0.001, "once")',
            name,
        )
        studio.until(f'{heading} === "Verdict of an earlier design"')
        studio.page.keyboard.press('Control+z')
        studio.until(f'{heading} === "Verdict"')
        studio.page.reload()
        studio.ready()
        studio.workspace('Simulate')
        studio.until(f'{heading} === "Verdict" && document.querySelector(".verdict").textContent')

        studio.page.get_by_label('stiffness in physics').fill('2')
        studio.button('Play in MuJoCo').click()
        studio.until('legwrightStudio.view.live?.time > 0.1')
        studio.js('legwrightStudio.physics.hold()')
        studio.js(
            'n => legwrightStudio.edit(n, legwrightStudio.readParameter(n).value + 0.001, "once")',
            name,
        )
        studio.until('legwrightStudio.view.live === null')  # poses of the body before
        studio.settled()
        studio.button('Play in MuJoCo').click()
        studio.until('legwrightStudio.view.live?.time > 0.1')
        studio.button('File').click()
        studio.page.get_by_role('menuitem', name='Open another…').click()
        studio.page.get_by_role('button', name='walk', exact=True).click()
        studio.until('legwrightStudio.store.get("document")?.name === "biped"')
        studio.ready()
        self.assertTrue(studio.js('legwrightStudio.view.live === null'))
        self.assertEqual(studio.page.get_by_label('stiffness in physics').input_value(), '1')
        self.assertTrue(studio.page.get_by_text('The plan is shown.').is_visible())
        self.assertEqual(studio.page.locator('.verdict-lines li').count(), 0)
        self.assertEqual(studio.console, [])

    def test_another_robot_takes_the_place_in_every_page(self):
        pages = [self.open('puppy/sideways.toml'), Page(self.browser, self.server.url)]
        self.addCleanup(pages[1].close)
        pages[1].ready()
        pages[0].button('File').click()
        pages[0].page.get_by_role('menuitem', name='Open another…').click()
        pages[0].page.get_by_role('button', name='walk', exact=True).click()
        for studio in pages:
            studio.until('legwrightStudio.store.get("document")?.name === "biped"')
            studio.ready()
            self.assertEqual(studio.js('legwrightStudio.view.player.feet.length'), 2)
            self.assertEqual(studio.console, [])

    def test_a_dropped_robot_is_proposed_for(self):
        studio = self.open(None)
        studio.page.locator('.examples img[src]').first.wait_for()
        robot = (ROOT / 'examples/puppy/robot.xml').read_text(encoding='utf-8')
        bare = robot[: robot.index('  <custom>')] + '</mujoco>\n'
        studio.page.locator('input[type=file]').first.set_input_files(
            {'name': 'mine.xml', 'mimeType': 'text/xml', 'buffer': bare.encode()}
        )
        boxes = studio.page.locator('.proposals input[type=checkbox]')
        boxes.first.wait_for()
        proposed = boxes.count()
        onwards = studio.button('Write and go on').bounding_box()
        self.assertLessEqual(onwards['y'] + onwards['height'], 720, 'it is seen without scrolling')
        ahead = studio.page.get_by_label('Ahead is the trunk’s')
        self.assertEqual(ahead.input_value(), '+x')
        ahead.select_option('-x')
        studio.page.get_by_text('Reading the robot').wait_for(state='detached')
        self.assertEqual(ahead.input_value(), '-x')
        boxes.first.uncheck()
        studio.button('Write and go on').click()
        studio.ready()
        task = studio.js('legwrightStudio.store.get("document").task_text')
        self.assertIn('forward = "-x"', task)
        names = studio.js('legwrightStudio.store.get("document").parameters.length')
        self.assertEqual(names, proposed - 1)
        self.assertEqual(studio.console, [])

    def test_one_goes_back_to_what_is_open_and_exports_it_with_its_verdict(self):
        studio = self.open('hexapod/turning_on_the_spot.toml')
        studio.page.get_by_text('kg, as the file has it').wait_for()
        studio.button('File').click()
        studio.page.get_by_role('menuitem', name='Open another…').click()
        studio.button('Back to hexapod').click()
        self.assertTrue(studio.page.locator('.workspace').is_visible())
        studio.button('File').click()
        studio.page.get_by_role('menuitem', name='Export…').click()
        studio.page.get_by_label('Folder').fill(str(self.server.output / 'mine'))
        studio.page.keyboard.press('Enter')
        studio.page.get_by_text('Exported: ').wait_for()
        told = (self.server.output / 'mine/README.md').read_text(encoding='utf-8')
        self.assertRegex(told, r'- (PASS|FAIL)  tripod turning at 0\.800 rad/s')
        self.assertNotIn('not validated', told)
        studio.page.wait_for_timeout(5500)  # what is merely told goes by then
        self.assertTrue(studio.page.get_by_text('Exported: ').is_visible())
        self.assertEqual(studio.console, [])

    def test_stop_ends_what_goes_on_in_the_background(self):
        studio = self.open('quadruped/sideways.toml')
        studio.workspace('Simulate')
        self.assertTrue(studio.button('Stop').is_disabled())
        studio.button('Find one that passes…').click()
        studio.page.get_by_label('Folder').fill(str(self.server.output / 'found'))
        studio.page.keyboard.press('Enter')
        studio.until('legwrightStudio.store.get("job")?.running')
        where = studio.button('Optimise').bounding_box()
        studio.button('Stop').click()
        studio.until('legwrightStudio.store.get("job").failed === "cancelled"')
        self.assertTrue(studio.button('Stop').is_disabled())
        self.assertEqual(studio.button('Optimise').bounding_box(), where, 'no button moves')
        studio.button('Judge').click()
        studio.until('legwrightStudio.store.get("judge")?.running')
        studio.button('Stop').click()
        studio.until('!legwrightStudio.store.get("judge").running')
        self.assertFalse(studio.js('Boolean(legwrightStudio.store.get("judge").verdict)'))
        self.assertEqual(studio.console, [])

    def test_a_document_that_comes_late_is_not_taken_for_that_of_another_robot(self):
        studio = self.open('puppy/sideways.toml')
        held = []

        def hold(route):
            if held:
                route.continue_()
            else:
                held.append((route, route.fetch()))

        studio.page.route('**/api/document', hold)
        studio.js('() => void legwrightStudio.loadDocument()')
        studio.button('File').click()
        studio.page.get_by_role('menuitem', name='Open another…').click()
        studio.page.get_by_role('button', name='walk', exact=True).click()
        studio.until('legwrightStudio.store.get("state")?.s.length > 0 && legwrightStudio.again')
        route, response = held[0]
        route.fulfill(response=response)
        studio.until('legwrightStudio.store.get("document")?.name === "biped"')
        studio.ready()
        self.assertEqual(studio.console, [])
