# SPDX-License-Identifier: Apache-2.0
"""Tests of what the page says, names and proposes; browser_test.py runs them."""

import json
import pathlib
import re
import shutil
import tempfile

from own_studio import OwnStudio
from studio_browser import ROOT

STATE = 'legwrightStudio.store.get("state")'


class Telling(OwnStudio):
    def test_a_line_of_the_verdict_is_shown_on_the_robot(self):
        studio = self.open('puppy/sideways.toml')
        studio.workspace('Simulate')
        joint = studio.js('legwrightStudio.store.get("document").joints[1]')
        foot = studio.js('legwrightStudio.store.get("document").feet[0]')
        said = f'{joint["name"]}: servo at its limit for 12 % of the time'
        marks = [
            {'kind': 'joint', 'name': joint['name'], 'words': said},
            {'kind': 'foot', 'name': foot, 'words': f'{foot}: slips'},
        ]
        studio.js(
            """marks => legwrightStudio.take('judge', {
              running: false, verdict: {word: 'FAIL', words: 'FAIL  walk'},
              lines: [{words: 'saturated', passed: false, marks, numbers: {gains: 'half gains'},
                       moment: {task: 0, time: 0.3}}]})""",
            marks,
        )
        studio.button('Show me').click()
        labels = '[...document.querySelectorAll(".mark-label:not([hidden])")]'
        shown = f'{labels}.map((each) => each.textContent)'
        held = 'legwrightStudio.physics.held'
        for _ in range(2):  # a second time, from what is held
            studio.until(held)
            self.assertEqual(studio.js(shown), [said, f'{foot}: slips'])
            self.assertEqual(studio.js('legwrightStudio.view.pointed[0].body'), joint['body'])
            at = studio.js('legwrightStudio.view.recording.end')
            self.assertAlmostEqual(at, 0.3, delta=0.2)
            studio.button('Show me').click()
            studio.until(f'!{held}')
        studio.until(held)
        studio.button('Go on').click()
        studio.until(f'({shown}).length === 0')
        self.assertEqual(studio.console, [])

    def test_what_fails_over_a_whole_walk_is_shown_at_its_end(self):
        studio = self.open('puppy/sideways.toml')
        studio.workspace('Simulate')
        said = 'speed, of the planned one: 80 %'
        line = {
            'words': said + ' at double gains (95 % to 105 % passes)',
            'term': 'speed_ratio: measured over planned speed, along its heading',
            'passed': False,
            'marks': [{'kind': 'trunk', 'name': '', 'words': said}],
            'numbers': {'gains': 'double gains'},
            'moment': {'task': 0, 'time': 0.4, 'whole': True},
        }
        studio.js(
            """line => legwrightStudio.take('judge', {
              running: false, verdict: {word: 'FAIL', words: 'FAIL  walk'}, lines: [line]})""",
            line,
        )
        self.assertTrue(studio.page.get_by_title(line['term']).is_visible())
        studio.button('Show the walk').click()
        studio.until('legwrightStudio.physics.held')
        label = studio.page.locator('.workspace .mark-label:visible')
        self.assertEqual(label.all_text_contents(), [said])
        self.assertAlmostEqual(studio.js('legwrightStudio.view.recording.end'), 0.4, delta=0.2)
        self.assertEqual(studio.js('legwrightStudio.physics.values.stiffness'), 2)
        self.assertEqual(studio.console, [])

    def set_by_hand(self, studio, name, value):
        studio.js('([n, v]) => legwrightStudio.edit(n, v, "once")', [name, value])
        studio.until('legwrightStudio.edits.idle')
        studio.until('([n, v]) => legwrightStudio.readParameter(n).value === v', [name, value])
        studio.settled()

    def test_what_was_set_by_hand_is_locked_before_a_search(self):
        studio = self.open('puppy/sideways.toml')
        note = studio.page.locator('.hand-note')
        self.assertFalse(note.is_visible())
        names = ['front_thigh_length', 'hind_thigh_length']
        for name in names:
            self.set_by_hand(studio, name, studio.value(name) + 0.003)
        studio.page.get_by_text('Optimise may change 2 lengths that you set.').wait_for()
        studio.page.keyboard.press('Control+z')
        studio.page.get_by_text('Optimise may change 1 length that you set.').wait_for()
        studio.button('Lock it').click()
        note.wait_for(state='hidden')
        studio.until('n => legwrightStudio.readParameter(n).locked', names[0])
        frozen = [studio.js('n => legwrightStudio.readParameter(n).locked', n) for n in names]
        self.assertEqual(frozen, [True, False])
        self.assertEqual(studio.console, [])

    def test_what_was_set_by_hand_is_known_when_the_page_is_loaded_anew(self):
        studio = self.open('puppy/sideways.toml')
        name = 'front_thigh_length'
        wanted = studio.value(name) + 0.003
        self.set_by_hand(studio, name, wanted)
        said = 'Optimise may change 1 length that you set.'
        studio.page.get_by_text(said).wait_for()
        studio.page.reload()
        studio.ready()
        studio.page.get_by_text(said).wait_for()
        studio.button('Step').click()
        studio.until(f'{STATE}.iterations === 1')
        studio.settled()
        studio.page.reload()
        studio.ready()
        studio.page.get_by_text('The search has changed 1 length that you set.').wait_for()
        studio.button('Put it back and lock').click()
        studio.until('n => legwrightStudio.readParameter(n).locked', name)
        self.assertEqual(studio.value(name), wanted)
        studio.page.reload()
        studio.ready()
        self.assertFalse(studio.page.locator('.hand-note').is_visible())
        self.assertEqual(studio.console, [])

    def test_what_a_search_has_changed_is_put_back_and_locked(self):
        studio = self.open('puppy/sideways.toml')
        name = 'front_thigh_length'
        wanted = studio.value(name) + 0.003
        self.set_by_hand(studio, name, wanted)
        # The worst order: the answer comes after what the search has changed.
        studio.js("""() => {
          const { fetch } = globalThis;
          globalThis.fetch = async (url, options) => {
            const answer = await fetch(url, options);
            const step = options?.body?.includes?.('"do":"step"');
            while (step && legwrightStudio.store.get('state').iterations < 1)
              await new Promise((resolve) => setTimeout(resolve, 10));
            return answer;
          };
          const take = legwrightStudio.take.bind(legwrightStudio);
          legwrightStudio.take = (kind, data) => {
            if (kind !== 'state' || data.phase !== 'searching') take(kind, data);
          };
        }""")
        studio.button('Step').click()
        studio.until(f'{STATE}.iterations === 1')
        studio.settled()
        self.assertNotEqual(studio.value(name), wanted)
        studio.page.get_by_text('The search has changed 1 length that you set.').wait_for()
        studio.button('Put it back and lock').click()
        studio.until('n => legwrightStudio.readParameter(n).locked', name)
        self.assertEqual(studio.value(name), wanted)
        studio.page.locator('.hand-note').wait_for(state='hidden')
        self.assertEqual(studio.console, [])

    def test_folders_that_are_proposed_are_free_and_named_after_what_they_are(self):
        studio = self.open('puppy/sideways.toml')
        folder = studio.page.get_by_label('Folder')

        def proposed(item):
            studio.button('File').click()
            studio.page.get_by_role('menuitem', name=item).click()
            folder.wait_for()
            return folder.input_value()

        self.assertEqual(proposed('Save'), 'runs/puppy')
        studio.page.keyboard.press('Enter')
        studio.page.get_by_text('Saved: ').wait_for()
        self.assertEqual(proposed('Save'), 'runs/puppy_2')
        studio.page.keyboard.press('Escape')
        self.assertEqual(proposed('Report'), 'runs/puppy_report')
        studio.page.keyboard.press('Escape')
        self.assertEqual(proposed('Export'), 'exports/puppy')
        studio.page.keyboard.press('Escape')
        self.assertEqual(studio.console, [])

    def test_a_search_for_one_that_passes_tells_how_far_it_is(self):
        studio = self.open('puppy/sideways.toml')
        studio.workspace('Simulate')
        panel = studio.page.get_by_label('Judge', exact=True)
        bar = panel.get_by_label('Progress', exact=True)
        shares = []
        for job, words in [
            ({'words': 'searching', 'done': 6, 'of': 24}, 'searching, 6 of about 24'),
            ({'words': 'playing', 'done': 3, 'of': 0}, 'playing, 3 so far'),
            ({'words': 'playing', 'done': 4, 'of': 0}, 'playing, 4 so far'),
        ]:
            job = {'what': 'optimize', 'running': True, **job}
            studio.js('job => legwrightStudio.take("job", job)', job)
            panel.get_by_text(words).wait_for()
            shares.append(bar.evaluate('bar => bar.value'))
        self.assertTrue(0 < shares[0] < shares[1] < shares[2] < 1, shares)
        self.assertTrue(studio.button('Find one that passes…').is_disabled())
        done = {'what': 'optimize', 'running': False, 'path': '/runs/found', 'passes': True}
        studio.js('job => legwrightStudio.take("job", job)', done)
        studio.button('Open the one that passes').wait_for()
        self.assertFalse(bar.is_visible())
        asked = []
        studio.page.route('**/api/export', lambda route: (asked.append(route), route.abort()))
        studio.button('Export the one that passes…').click()
        studio.page.get_by_label('Folder').wait_for()
        studio.page.keyboard.press('Enter')
        studio.page.get_by_text('does not answer').wait_for()
        self.assertEqual(asked[0].request.post_data_json['run'], '/runs/found')
        studio.js('job => legwrightStudio.take("job", job)', {**done, 'passes': False})
        studio.button('Open the best, which fails').wait_for()
        self.assertFalse(studio.button('Export the one that passes…').is_visible())
        studio.console.clear()  # of the request that was cut off
        self.assertEqual(studio.console, [])

    def test_a_document_that_cannot_be_told_is_said_to_be_so(self):
        studio = self.open('puppy/sideways.toml')
        body = json.dumps({'error': {'message': "MuJoCo refuses the body of 'front_left_shin'"}})
        refused = {'status': 400, 'content_type': 'application/json', 'body': body}
        studio.page.route('**/api/document', lambda route: route.fulfill(**refused))
        studio.page.reload()
        studio.page.get_by_text('What is open cannot be worked on: MuJoCo refuses').wait_for()
        panes = studio.page.locator('.workspace > .panes')
        self.assertEqual(panes.get_attribute('inert'), '')
        studio.button('File').click()
        studio.page.get_by_role('menuitem', name='Open another…').wait_for()
        studio.console.clear()  # of the answer 400
        studio.page.unroute('**/api/document')

    def test_a_value_at_its_bound_is_marked(self):
        studio = self.open('puppy/sideways.toml')
        name = 'front_thigh_length'
        row = studio.page.locator(f'.parameter[data-name="{name}"]')
        mark = row.locator('.at-bound')
        self.assertFalse(mark.is_visible())
        upper = studio.js('n => legwrightStudio.readParameter(n).upper', name)
        self.set_by_hand(studio, name, upper)
        mark.wait_for()
        said = f'At its upper bound {upper:.4f} m'
        self.assertEqual(mark.locator('.unseen').text_content(), said + ", of the robot's file")
        self.assertTrue(mark.get_attribute('title').startswith(said))
        self.assertIn(said, row.locator('.slider').get_attribute('aria-valuetext'))
        lower = upper - 0.01
        studio.js('([n, low, high]) => legwrightStudio.setBounds(n, low, high)',
                  [name, lower, upper])
        self.set_by_hand(studio, name, lower)
        said = f'At its lower bound {lower:.4f} m, set here'
        studio.until('text => document.querySelector(".at-bound .unseen").textContent === text',
                     said)
        self.set_by_hand(studio, name, upper - 0.005)
        mark.wait_for(state='hidden')
        self.assertEqual(studio.console, [])

    def test_words_are_those_of_people(self):
        studio = self.open('puppy/sideways.toml')
        studio.js('legwrightStudio.selection.set(["front_thigh_length"])')
        studio.page.get_by_text('slope of the cost: ').wait_for()
        told = studio.js(
            """() => [...document.querySelectorAll("#app, #app *")].flatMap((each) => [
              ...(each.id === "app" ? [each.textContent] : []),
              ...["title", "aria-label", "placeholder"].map((key) => each.getAttribute(key)),
            ]).filter(Boolean)"""
        )
        text = '\n'.join(told)
        for shown in ('slope of the cost: ', 'slip of stance feet', 'What the cost F consists of'):
            self.assertIn(shown, text)  # so texts, titles and names are looked through
        for odd in ('fall of F', 'misfit', 'terms of F', 'undefined', 'NaN', '[]'):
            self.assertNotIn(odd, text)
        names = studio.js(f'{STATE}.terms.map((term) => term.name)')
        self.assertIn('stance_foot', names)
        odd = [each for each in told[1:] if any(name in each for name in names if '_' in name)]
        terms = studio.js(
            """() => [...document.querySelectorAll('.terms tr')].map((row) =>
                 [row.title, row.querySelector('th').textContent])"""
        )
        self.assertEqual(odd, [title for title, _ in terms if '_' in title])
        for title, words in terms:
            self.assertRegex(title, rf'^{words} \(term ({"|".join(names)}) of F\)$')
            self.assertNotIn('_', words)
        self.assertEqual(studio.console, [])

    def test_what_the_plan_makes_up_for_is_said_until_the_way_is_another(self):
        studio = self.open('puppy/sideways.toml')
        studio.workspace('Simulate')
        aim = studio.page.get_by_text('Planned 1.05 times as fast as wanted, to make up')
        self.assertFalse(aim.is_visible())
        studio.page.get_by_text('Style, limits, weights').click()
        for label, value in (('planned speed [×]', '1.05'), ('stance width [×]', '1.2')):
            studio.page.get_by_label(label).fill(value)
            studio.page.keyboard.press('Enter')
        aim.wait_for()
        task = 'legwrightStudio.store.get("document").tasks[0]'
        studio.until(f'{task}.stance_width === 1.2 && {task}.aim_speed === 1.05')
        studio.page.get_by_label('left [m/s]').fill('0.08')
        studio.page.keyboard.press('Enter')
        aim.wait_for(state='hidden')
        self.assertEqual(studio.js(f'[{task}.aim_speed, {task}.stance_width]'), [1, 1.2])
        self.assertEqual(studio.console, [])

    def test_nothing_is_said_to_be_right_that_was_not_judged(self):
        studio = self.open('hexapod/wave.toml')
        passes = studio.page.get_by_text('and MuJoCo passes it.')
        studio.page.get_by_text('MuJoCo is asked under Simulate, Judge.').wait_for()
        studio.workspace('Simulate')
        studio.button('Judge').click()
        studio.workspace('Design')
        passes.wait_for()
        studio.js('legwrightStudio.command("step")')
        passes.wait_for(state='hidden')
        self.assertEqual(studio.console, [])

    def test_the_task_is_told_beside_the_body_and_changed_under_simulate(self):
        studio = self.open('puppy/sideways.toml')
        told = studio.page.get_by_label('What it is to do', exact=True)
        told.get_by_text('walk sideways at 0.100 m/s').wait_for()
        studio.button('Change…').click()
        studio.page.get_by_label('left [m/s]').fill('0.08')
        studio.page.keyboard.press('Enter')
        studio.until('legwrightStudio.store.get("document").tasks[0].velocity[1] === 0.08')
        studio.workspace('Design')
        told.get_by_text('walk sideways at 0.080 m/s').wait_for()
        self.assertEqual(studio.console, [])

    def test_the_verdict_is_seen_after_a_search_without_scrolling(self):
        studio = self.open('puppy/sideways.toml')
        studio.workspace('Simulate')
        studio.js(f'legwrightStudio.take("point", {{iteration: 1, F: 2, terms: {STATE}.terms}})')
        studio.page.locator('.legend:visible span').first.wait_for()
        kept = {'words': 'no fall', 'passed': True}
        missed = {'words': 'tilted by 0.4 rad', 'passed': False}
        lost = {'words': 'speed: unknown', 'passed': False, 'numbers': {'value': None}}
        lines = [missed, lost, *[kept] * 8]
        studio.js(
            """lines => legwrightStudio.take('judge', {
              running: false, verdict: {word: 'FAIL', words: 'FAIL  walk'}, lines})""",
            lines,
        )
        reason = studio.page.get_by_text('tilted by 0.4 rad')
        for seen in (studio.button('Judge'), reason):
            box = seen.bounding_box()
            self.assertLess(box['y'] + box['height'], 720)
        self.assertEqual(studio.page.get_by_text('no fall').count(), 8)
        self.assertFalse(studio.page.get_by_text('no fall').first.is_visible())
        self.assertFalse(studio.page.get_by_text('speed: unknown').is_visible())
        studio.page.get_by_text('8 limits are kept, 1 could not be measured').click()
        studio.page.get_by_text('no fall').first.wait_for()
        self.assertEqual(studio.console, [])

    def beside_a_table(self, task):
        """A task of the hexapod, in whose file something else stands first."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        begin, table = '<worldbody>', '<body pos="2 2 .2"><geom size=".2"/></body>'
        robot = (ROOT / 'examples/hexapod/robot.xml').read_text(encoding='utf-8')
        here = pathlib.Path(folder.name)
        (here / 'robot.xml').write_text(robot.replace(begin, begin + table), encoding='utf-8')
        shutil.copy(ROOT / 'examples/hexapod' / task, here)
        return str(here / task)

    def test_physics_tell_how_fast_the_robot_goes_and_was_to_go(self):
        for task, said in (
            ('hexapod/turning_on_the_spot.toml', r'turns (\S+) rad/s, planned 0\.80'),
            (self.beside_a_table('tripod_0.1.toml'), r'(\S+) m/s, planned 0\.100'),
        ):
            with self.subTest(task):
                studio = self.open(task)
                studio.workspace('Simulate')
                studio.button('Play in MuJoCo').click()
                panel = studio.page.get_by_label('Physics', exact=True)
                panel.get_by_text(re.compile(said)).wait_for()
                planned = 0.8 if 'turns' in said else 0.1
                speeds = []
                for _ in range(10):
                    studio.page.wait_for_timeout(100)
                    status = panel.locator('.status').inner_text()
                    speeds.append(float(re.search(said, status)[1]))
                self.assertAlmostEqual(speeds[-1], planned, delta=0.15 * planned)
                studio.page.get_by_label('Speed', exact=True).select_option('0.25')
                studio.until('legwrightStudio.store.get("physics").speed < 0.5')
                self.assertEqual(studio.console, [])
