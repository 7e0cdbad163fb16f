# SPDX-License-Identifier: Apache-2.0
"""Changes of the body, fronts of tasks, ghosts of bounds, slopes, runs that are scrubbed."""

from own_studio import OwnStudio

STATE = 'legwrightStudio.store.get("state")'
VIEW = 'legwrightStudio.view'
CHANGES = (
    'legwrightStudio.store.get("document").parameters.filter((p) => '
    'Math.abs(legwrightStudio.readParameter(p.name).value - p.given) > 1e-9).length'
)
PRESENT = (
    '[...document.querySelectorAll(".front-point")]'
    '.findIndex((each) => each.classList.contains("present"))'
)


class OtherDesigns(OwnStudio):
    def search(self, studio):
        studio.button('Optimise').click()
        studio.until(f'{STATE}.phase === "searching"')
        studio.until(f'{STATE}.phase === "idle"', seconds=120)
        studio.settled()

    def changes(self, studio):
        return studio.js(CHANGES)

    def test_fewest_changes_are_gone_through_and_one_is_put_back(self):
        studio = self.open('puppy/sideways.toml')
        panel = studio.page.get_by_label('Changes', exact=True)
        self.assertIn('as it was given', panel.inner_text())
        self.search(studio)
        all_of_them = self.changes(studio)
        self.assertGreater(all_of_them, 6)
        studio.button('Fewest changes').click()
        studio.until(f'{STATE}.alternatives.includes("fewest")', seconds=120)
        slider = panel.get_by_label('Design with fewer changes')
        slider.focus()
        studio.page.keyboard.press('End')
        studio.until(f'{CHANGES} < 4')
        studio.settled()
        few = self.changes(studio)
        self.assertIn('of the gain', slider.get_attribute('aria-valuetext'))
        back = panel.get_by_role('button', name='Put').first
        back.click()
        studio.until('legwrightStudio.edits.idle')
        studio.settled()
        self.assertEqual(self.changes(studio), few - 1)
        for wanted in (few, all_of_them):
            studio.page.keyboard.press('Control+z')
            studio.until(f'{CHANGES} === {wanted}')
        self.assertEqual(studio.console, [])

    def test_fewest_changes_say_why_they_are_not_worked_out(self):
        studio = self.open('puppy/sideways.toml')
        asked = []
        studio.page.on('request', lambda request: asked.append(request.post_data or ''))
        notices = studio.page.locator('.notices')
        studio.page.locator('canvas').first.focus()
        studio.page.keyboard.press('f')
        notices.get_by_text('The body is as it was given').wait_for()
        studio.button('Optimise').click()
        studio.until(
            f"""() => {{
              if ({STATE}?.phase !== "searching") return false;
              const init = {{ key: "f", bubbles: true }};
              document.body.dispatchEvent(new KeyboardEvent("keydown", init));
              return true;
            }}"""
        )
        notices.get_by_text('A search goes on: pause it').wait_for()
        studio.until(f'{STATE}.phase === "idle"', seconds=120)
        self.assertGreater(studio.state('iterations'), 2, 'the search went on')
        self.assertEqual([each for each in asked if 'work_out' in each], [])
        studio.settled()
        studio.page.keyboard.press('f')
        studio.until(f'{STATE}.alternatives.includes("fewest")', seconds=120)
        self.assertEqual(len([each for each in asked if 'work_out' in each]), 1)
        self.assertEqual(studio.console, [])

    def test_a_selected_parameter_is_put_back_by_a_key(self):
        studio = self.open('puppy/sideways.toml')
        name = 'front_thigh_length'
        studio.js(f'legwrightStudio.edit("{name}", 0.065, "once")')
        studio.until('legwrightStudio.edits.idle')
        studio.js(f'legwrightStudio.selection.set(["{name}"])')
        studio.page.locator('canvas').first.focus()
        studio.page.keyboard.press('p')
        studio.until(f'legwrightStudio.readParameter("{name}").value === 0.06')
        studio.settled()
        studio.page.keyboard.press('Control+z')
        studio.until(f'legwrightStudio.readParameter("{name}").value === 0.065')
        self.assertEqual(studio.console, [])

    def test_the_weights_of_two_tasks_move_along_their_front(self):
        studio = self.open('quadruped/both.toml')
        studio.workspace('Simulate')
        studio.button('Work out the front').click()
        studio.until(f'{STATE}.alternatives.includes("front")', seconds=240)
        studio.settled()
        slider = studio.page.get_by_label('Weight of sideways')
        slider.focus()
        last = studio.js('legwrightStudio.store.get("alternatives front").designs.length - 1')
        shown = []
        for key, design in (('Home', last), ('End', 0)):
            studio.page.keyboard.press(key)
            studio.until(f'k => {PRESENT} === k', design)
            studio.settled()
            shown.append(studio.state('task_F'))
        (pace_home, sideways_home), (pace_end, sideways_end) = shown
        self.assertLess(pace_home, pace_end, 'all weight on the pace')
        self.assertLess(sideways_end, sideways_home)
        self.assertEqual(studio.page.locator('.front-point.present').count(), 1)
        studio.page.locator('.front-point').nth(3).click()
        studio.until(f'k => {PRESENT} === k', 3)
        studio.settled()
        self.assertIn('Design 4 of', studio.page.locator('.front-plot .told').inner_text())
        weights = studio.state('weights')
        studio.button('Along the front').click()
        slider.focus()
        studio.page.keyboard.press('Home')
        studio.until('w => legwrightStudio.store.get("state").weights[0] !== w', weights[0])
        studio.button('Undo (ctrl z)').click()
        studio.until('w => legwrightStudio.store.get("state").weights[0] === w', weights[0])
        self.assertAlmostEqual(float(slider.input_value()), weights[1], delta=0.006)
        self.assertEqual(studio.console, [])

    def test_work_that_takes_a_while_is_cancelled(self):
        studio = self.open('quadruped/both.toml')
        studio.workspace('Simulate')
        studio.button('Work out the front').click()
        studio.until(f'{STATE}.phase === "working out"')
        studio.page.locator('.trade-off').get_by_role('button', name='Cancel').click()
        studio.until(f'{STATE}.phase === "idle"')
        self.assertEqual(studio.state('alternatives'), [])
        studio.page.get_by_text('No other designs were worked out').wait_for()
        self.assertEqual(studio.console, [])

    def test_the_bodies_at_the_bounds_are_seen_while_a_slider_is_held(self):
        studio = self.open('puppy/sideways.toml')
        # As the slider's own first input: a key lets go by itself, on a busy machine too soon.
        studio.js('legwrightStudio.edit("front_thigh_length", 0.061, "begin")')
        ghosts = f'{VIEW}.bounds.sides.map(({{ robot }}) => robot)'
        studio.until(f'{VIEW}.bounds.shown')
        seen = studio.js(f'{ghosts}.map((robot) => robot.meshes.filter((m) => m.visible).length)')
        drawn = studio.js(f'{VIEW}.robot.meshes.filter((m) => m.visible).length')
        self.assertEqual(seen[0], seen[1])
        self.assertGreater(seen[0], 2, 'both front legs')
        self.assertLess(seen[0], drawn, 'what stays is not drawn again')
        apart = studio.js(
            f"""() => {{
              const [low, high] = {ghosts};
              const k = low.meshes.findLastIndex((mesh) => mesh.visible);
              return high.groups[low.meshes[k].userData.body].position.distanceTo(
                low.groups[low.meshes[k].userData.body].position);
            }}"""
        )
        self.assertGreater(apart, 0.0)
        studio.js('legwrightStudio.edit("front_thigh_length", 0.061, "end")')
        studio.until(f'!{VIEW}.bounds.shown')
        self.assertEqual(studio.console, [])

    def test_pictures_in_software_have_fewer_pixels_while_a_slider_is_held(self):
        studio = self.open('puppy/sideways.toml')
        pixels = (
            f'Math.round(100 * {VIEW}.stage.canvas.width / {VIEW}.stage.host.clientWidth) / 100'
        )
        studio.js('legwrightStudio.edit("front_thigh_length", 0.061, "begin")')
        studio.until(f'{pixels} === 0.5')
        studio.js('legwrightStudio.edit("front_thigh_length", 0.061, "end")')
        studio.until(f'{pixels} > 0.5')
        self.assertEqual(studio.console, [])

    def test_the_ground_of_a_slope_is_tilted_and_a_step_is_seen(self):
        studio = self.open('tasks/slope.toml')
        up = studio.js(f'{VIEW}.stage.up.toArray()')
        self.assertNotEqual(up, [0, 0, 1])
        tilted = studio.js(
            f'{VIEW}.stage.up.clone().applyQuaternion({VIEW}.stage.tilted.quaternion).z'
        )
        self.assertAlmostEqual(tilted, 1.0, places=9)
        tag = studio.page.locator('.slope-tag')
        self.assertIn('rad', tag.inner_text())
        studio.js(
            'legwrightStudio.setTask(0, { ground: null, limits: { step_over: 0.01 } })'
        )
        studio.until(f'{VIEW}.hurdles.root.children.length > 0')
        self.assertTrue(tag.is_hidden())
        self.assertEqual(studio.js(f'{VIEW}.stage.tilted.quaternion.w'), 1)
        self.assertEqual(studio.console, [])

    def test_a_run_in_physics_is_scrubbed_and_goes_on(self):
        studio = self.open('puppy/sideways.toml')
        studio.workspace('Simulate')
        studio.button('Play in MuJoCo').click()
        studio.until(f'{VIEW}.recording.seconds > 0.6', seconds=60)
        scrub = studio.page.get_by_label('Time of the run')
        scrub.focus()
        studio.page.keyboard.press('ArrowLeft')
        studio.until(f'{VIEW}.recording.shown')
        studio.until('!legwrightStudio.store.get("physics").running')
        end = studio.js(f'{VIEW}.recording.end')
        studio.js(f'{VIEW}.seekRecording({VIEW}.recording.begin + 0.2)')
        at = studio.js(f'{VIEW}.recording.at')
        self.assertLess(at, end)
        self.assertIn('run', scrub.get_attribute('aria-valuetext'))
        studio.page.get_by_label('Speed', exact=True).select_option('0.25')
        studio.button('Play the run').click()
        studio.until(f'at => {VIEW}.recording.at > at', at)
        studio.until(f'{VIEW}.recording.at === {VIEW}.recording.end', seconds=60)
        studio.button('Go on').click()
        studio.until(f'end => !{VIEW}.recording.shown && {VIEW}.recording.end > end', end)
        studio.button('Back to the plan').click()
        studio.until(f'!{VIEW}.live')
        studio.page.get_by_label('Phase of the cycle').wait_for()
        self.assertEqual(studio.console, [])
