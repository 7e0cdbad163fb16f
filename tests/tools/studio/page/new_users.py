# SPDX-License-Identifier: Apache-2.0
"""Tests of what new users stumble over; browser_test.py runs them."""

from own_studio import OwnStudio


class NewUsers(OwnStudio):
    """Help, hints, and what would be too much to read."""

    def test_help_begins_with_the_way_from_a_robot_to_its_export(self):
        studio = self.open('puppy/sideways.toml')
        studio.page.keyboard.press('?')
        way = studio.page.locator('dialog ol li')
        self.assertEqual(
            [each.split(' ')[0] for each in way.all_text_contents()],
            ['Open', 'Ask', 'Optimise', 'Judge', 'Export…'],
        )
        self.assertTrue(studio.page.locator('dialog kbd').last.is_visible())

    def test_physics_hint_at_pushing_and_keep_what_was_set(self):
        studio = self.open('puppy/sideways.toml')
        studio.workspace('Simulate')
        hint = studio.page.get_by_text('Shift and drag on the robot pushes it')
        self.assertFalse(hint.is_visible())
        friction = studio.page.get_by_label('friction in physics')
        friction.fill('0.4')
        studio.button('Backwards').click()
        studio.until('legwrightStudio.store.get("document").tasks[0].velocity[0] < 0')
        studio.settled()
        self.assertEqual(friction.input_value(), '0.4')
        studio.button('Play in MuJoCo').click()
        hint.wait_for()
        studio.button('Push').click()
        studio.page.get_by_text('Drag on the robot: it is pushed that way').wait_for()
        self.assertEqual(studio.console, [])

    def test_of_a_long_run_one_cycle_is_told_in_full(self):
        studio = self.open('puppy/sideways.toml')
        studio.workspace('Simulate')
        studio.button('Play in MuJoCo').click()
        studio.until('legwrightStudio.view.live?.time > 0.3')
        studio.js('legwrightStudio.physics.hold()')
        drawn = studio.js(
            """() => {
              const { view, timeline } = legwrightStudio;
              const { recording: run, player: { period, weight } } = view;
              const frame = { ...run.frames[0] };
              const feet = (k) => frame.feet.map((foot, i) => {
                const stands = (k + 2 * i) % 8 < 5;
                return { ...foot, force: [0, 0, stands ? weight / 3 : 0] };
              });
              run.frames = Array.from({ length: 321 }, (_, k) => (
                { ...frame, time: k * period / 8, phase: (k / 8) % 1, feet: feet(k), fell: null }));
              run.shown = true;
              run.at = 20.4 * period;
              timeline.drawRun();
              const count = (kind) => timeline.drawing.querySelectorAll(kind).length;
              const ticks = [...timeline.ticks.children].map((each) => each.textContent);
              return { walked: count('.walked'), stance: count('.stance'), ticks };
            }"""
        )
        self.assertEqual(drawn['walked'], 4, 'a band for each foot')
        self.assertLessEqual(drawn['stance'], 8, 'those of the cycle at the playhead')
        self.assertGreaterEqual(drawn['stance'], 4)
        self.assertEqual(drawn['ticks'][0], 'cycle 5')
        self.assertLessEqual(len(drawn['ticks']), 8)

    def test_dark_parts_are_lifted_on_a_dark_ground(self):
        studio = self.open('puppy/sideways.toml')
        lift = """() => {
          const { material } = legwrightStudio.view.robot.meshes[0];
          const shader = { uniforms: {} };
          material.onBeforeCompile(shader);
          return shader.uniforms.lift.value;
        }"""
        self.assertEqual(studio.js(lift), 0)
        studio.js('legwrightStudio.view.setTheme("dark")')
        self.assertGreater(studio.js(lift), 0.03)
