#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The studio as its user has it: Chromium before `legwright studio`. tools/page --test runs all, or
the classes and tests that are named; CTest leaves out LONG unless LEGWRIGHT_LONG_TESTS is set."""

import base64
import hashlib
import json
import os
import pathlib
import sys
import unittest

from assembling import Assembling  # noqa: F401
from by_chance import ByChance  # noqa: F401
from editing import Editing  # noqa: F401
from new_users import NewUsers  # noqa: F401
from other_designs import OtherDesigns  # noqa: F401
from studio_browser import ROOT, Page, Server, browser, chromium
from tablet import Tablet  # noqa: F401
from telling import Telling  # noqa: F401
from touch_and_crash import Apart  # noqa: F401
from whole_way import Whole  # noqa: F401

SKIPPED = 77
LONG = ('Apart', 'Assembling', 'ByChance', 'OtherDesigns', 'Tablet')  # for `tools/test --long`


class Studio(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Server(str(ROOT / 'examples/puppy/sideways.toml'))
        cls.stack = browser()
        cls.browser = cls.stack.__enter__()
        cls.studio = Page(cls.browser, cls.server.url)
        cls.studio.ready()

    @classmethod
    def tearDownClass(cls):
        cls.studio.close()
        cls.stack.__exit__(None, None, None)
        cls.server.close()

    def setUp(self):
        self.studio.workspace('Design')
        reset = self.studio.js('legwrightStudio.command("reset")')
        # What is present may look the same: what the reset brings must be here, too.
        reached = 'r => legwrightStudio.store.get("state").revision >= r'
        self.studio.until(reached, reset['revision'])
        self.studio.until(
            'legwrightStudio.store.get("document").parameters.every((p) => '
            'legwrightStudio.readParameter(p.name).value === p.given)'
        )
        self.studio.settled()

    def tearDown(self):
        self.assertEqual(self.studio.console, [])

    def drag(self, name, metres):
        at = self.studio.handle(name)
        mouse = self.studio.page.mouse
        mouse.move(at['x'], at['y'])
        mouse.down()
        for share in (0.25, 0.5, 0.75, 1.0):
            steps = 100 * metres * share
            mouse.move(at['x'] + at['dx'] * steps, at['y'] + at['dy'] * steps)
        mouse.up()
        self.studio.settled()

    def test_a_link_is_dragged_and_comes_back_by_one_undo(self):
        before = self.studio.value('front_foot_length')
        self.drag('front_foot_length', 0.02)
        self.assertAlmostEqual(self.studio.value('front_foot_length'), before + 0.02, delta=0.003)
        self.studio.button('Undo (ctrl z)').click()
        self.studio.until(
            'v => legwrightStudio.readParameter("front_foot_length").value === v', before
        )

    def test_a_handle_stops_at_its_bound(self):
        upper = self.studio.js('legwrightStudio.readParameter("front_foot_length").upper')
        self.drag('front_foot_length', 0.3)
        self.assertEqual(self.studio.value('front_foot_length'), upper)
        self.studio.page.keyboard.press('Control+z')
        self.studio.until(
            'v => legwrightStudio.readParameter("front_foot_length").value !== v', upper
        )

    def test_a_ring_turns_an_axis(self):
        self.studio.js('legwrightStudio.selection.set(["front_hip_axis_roll"])')
        at = self.studio.handle('front_hip_axis_roll')
        centre = self.studio.js(
            """() => {
              const { handles, stage } = legwrightStudio.view;
              const one = handles.all.find((each) => each.name === "front_hip_axis_roll");
              const p = one.centre.clone().applyMatrix4(handles.root.matrixWorld);
              p.project(stage.camera);
              const box = stage.canvas.getBoundingClientRect();
              return [box.left + (p.x / 2 + 0.5) * box.width,
                      box.top + (0.5 - p.y / 2) * box.height];
            }"""
        )
        mouse = self.studio.page.mouse
        mouse.move(at['x'], at['y'])
        mouse.down()
        mouse.move(2 * centre[0] - at['x'] + 30, at['y'] + 30)
        mouse.up()
        self.studio.settled()
        self.assertNotEqual(self.studio.value('front_hip_axis_roll'), 0.0)
        self.studio.page.keyboard.press('Control+z')
        self.studio.until('legwrightStudio.readParameter("front_hip_axis_roll").value === 0')

    def test_a_locked_parameter_stays(self):
        lock = self.studio.button('Lock hind thigh length')
        lock.click()
        self.studio.button('Unlock hind thigh length').wait_for()
        before = self.studio.value('hind_thigh_length')
        self.drag('hind_thigh_length', 0.02)
        self.assertEqual(self.studio.value('hind_thigh_length'), before)
        self.studio.button('Unlock hind thigh length').click()
        lock.wait_for()

    def test_keys_reach_every_parameter(self):
        names = self.studio.js(
            'legwrightStudio.store.get("document").parameters.map((p) => p.name)'
        )
        self.studio.page.locator('canvas').first.focus()
        self.studio.js('legwrightStudio.selection.set([])')
        for name in names:
            self.studio.page.keyboard.press(']')
            self.assertEqual(self.studio.js('legwrightStudio.selection.first'), name)
        before = self.studio.value(names[-1])
        self.studio.page.keyboard.press('+')
        self.studio.until(
            '([n, v]) => legwrightStudio.readParameter(n).value > v', [names[-1], before]
        )
        self.studio.page.keyboard.press('Escape')
        self.studio.settled()
        self.studio.page.keyboard.press('Control+z')
        self.studio.until(
            '([n, v]) => legwrightStudio.readParameter(n).value === v', [names[-1], before]
        )

    def test_a_paused_picture_stays_the_same(self):
        def picture():
            self.studio.page.locator('canvas').first.focus()
            self.studio.page.keyboard.press('1')
            self.studio.js('legwrightStudio.view.setPlaying(false)')
            self.studio.js('legwrightStudio.view.seek(0.25)')
            return hashlib.sha256(
                self.studio.js('legwrightStudio.view.stage.picture()').encode()
            ).hexdigest()

        first = picture()
        self.studio.page.keyboard.press('2')
        self.studio.js('legwrightStudio.view.seek(0.6)')
        self.assertNotEqual(
            first,
            hashlib.sha256(
                self.studio.js('legwrightStudio.view.stage.picture()').encode()
            ).hexdigest(),
        )
        self.assertEqual(first, picture())

    def test_search_pause_edit_continue(self):
        self.studio.workspace('Simulate')
        self.studio.button('Optimise').click()
        self.studio.until('legwrightStudio.store.get("state").iterations > 2')
        self.studio.press_while_it_serves('Pause')
        self.studio.settled()
        F = self.studio.state('F')
        self.studio.workspace('Design')
        self.drag('hind_foot_length', 0.005)
        self.assertNotEqual(self.studio.state('F'), F)
        before = self.studio.state('iterations')
        self.studio.page.locator('.search-buttons .primary').click()
        self.studio.until('n => legwrightStudio.store.get("state").iterations > n', before)
        self.studio.press_while_it_serves('Stop')
        self.studio.settled()
        self.studio.until('!legwrightStudio.store.get("paused")')
        self.assertTrue(self.studio.button('Optimise').first.is_enabled())
        self.assertTrue(self.studio.button('Stop').is_disabled())


    def task(self, key):
        return self.studio.js('key => legwrightStudio.store.get("document").tasks[0][key]', key)

    def until_task(self, key, value):
        self.studio.until(
            '([key, value]) => JSON.stringify(legwrightStudio.store.get("document").tasks[0][key])'
            ' === JSON.stringify(value)',
            [key, value],
        )

    def test_a_task_is_set_by_words_numbers_and_keys(self):
        self.studio.workspace('Simulate')
        before = self.task('velocity')
        self.studio.button('Walk').click()
        self.until_task('velocity', [before[1], 0])
        self.studio.page.get_by_label('left [m/s]').fill('0.08')
        self.studio.page.keyboard.press('Enter')
        self.until_task('velocity', [before[1], 0.08])
        self.studio.page.get_by_label('Velocity: arrow keys change it').focus()
        self.studio.page.keyboard.press('ArrowUp')
        self.studio.until(
            'v => legwrightStudio.store.get("document").tasks[0].velocity[0] > v', before[1]
        )
        self.studio.page.keyboard.press('Control+z')
        self.until_task('velocity', [before[1], 0.08])
        self.studio.page.get_by_label('payload [kg]').fill('0.2')
        self.studio.page.keyboard.press('Enter')
        self.until_task('payload', 0.2)
        self.studio.settled()
        for _ in range(3):
            self.studio.js('legwrightStudio.command("undo")')
        self.until_task('velocity', before)
        self.until_task('payload', None)

    def test_footfalls_are_drawn(self):
        self.studio.workspace('Simulate')
        before = self.task('footfalls')
        row = self.studio.page.locator('.footfall-row').first
        off = before[0]['cells'].index(0)
        row.locator('.cell').nth(off).click()
        self.studio.until(
            'n => legwrightStudio.store.get("document").tasks[0].footfalls[0].cells[n] === 1', off
        )
        self.assertEqual(self.task('gait_kind'), 'own')
        self.studio.page.get_by_label('Gait').select_option('trot')
        self.until_task('gait', 'trot')
        self.assertEqual(self.task('gait_kind'), 'library')
        for _ in range(2):
            self.studio.js('legwrightStudio.command("undo")')
        self.until_task('footfalls', before)

    def test_physics_play_and_are_pushed(self):
        self.studio.workspace('Simulate')
        self.studio.button('Play in MuJoCo').click()
        self.studio.until(
            'legwrightStudio.view.live && legwrightStudio.store.get("physics").time > 0.1'
        )
        self.studio.button('Nudge').click()
        self.studio.button('Start again').click()
        self.studio.button('Back to the plan').click()
        self.studio.until('!legwrightStudio.view.live')

    def test_a_film_is_recorded(self):
        self.studio.js('legwrightStudio.view.setPlaying(true)')
        self.studio.button('Record').click()
        drawn = self.studio.js('legwrightStudio.view.stage.drawn')
        self.studio.until('n => legwrightStudio.view.stage.drawn > n + 8', drawn)
        with self.studio.page.expect_download() as download:
            self.studio.button('Record').click()
        self.studio.js('legwrightStudio.view.setPlaying(false)')
        self.assertEqual(download.value.suggested_filename, 'puppy.webp')
        film = pathlib.Path(download.value.path()).read_bytes()
        frames = self.studio.js(
            """async (base64) => {
              const data = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
              const decoder = new ImageDecoder({ data, type: "image/webp" });
              await decoder.tracks.ready;
              const count = decoder.tracks.selectedTrack.frameCount;
              const shades = [];
              for (const frameIndex of [0, count - 1]) {
                const { image } = await decoder.decode({ frameIndex });
                const pen = new OffscreenCanvas(64, 64).getContext("2d");
                pen.drawImage(image, 0, 0, 64, 64);
                image.close();
                shades.push(pen.getImageData(0, 0, 64, 64).data.join());
              }
              return { count, moved: shades[0] !== shades[1] };
            }""",
            base64.b64encode(film).decode(),
        )
        self.assertGreater(frames['count'], 2)
        self.assertTrue(frames['moved'])

    def test_a_long_job_shows_how_far_it_is(self):
        status = self.studio.page.locator('.top-bar .job-status')
        self.studio.js(
            """path => fetch("/api/export", {
                 method: "POST", body: JSON.stringify({ path }),
                 headers: { "Content-Type": "application/json" } })""",
            str(self.server.output / 'exported'),
        )
        self.studio.until('legwrightStudio.store.get("job")?.path', seconds=60)
        self.assertTrue(status.is_hidden())
        self.assertTrue((self.server.output / 'exported').is_dir())

    def test_a_lost_connection_is_taken_up_again(self):
        lost = []

        def cut(route):
            lost.append(route)
            return route.abort() if len(lost) < 3 else route.continue_()

        other = Page(self.browser, self.server.url, cut=('**/api/events', cut))
        other.ready()
        self.assertEqual(len(lost), 3)
        self.assertEqual(other.page.locator('.connection').inner_text(), '')
        other.close()

    def test_a_snapshot_is_compared_and_gone_on_from(self):
        self.studio.button('Keep…').click()
        self.studio.page.get_by_label('Name').fill('kept')
        self.studio.page.keyboard.press('Enter')
        self.studio.until('legwrightStudio.store.get("state").names.includes("kept")')
        before = self.studio.value('body_length')
        self.drag('body_length', 0.02)
        self.assertNotEqual(self.studio.value('body_length'), before)
        self.studio.button('Compare').click()
        table = self.studio.page.locator('.compared')
        table.wait_for()
        self.assertIn('body length [m]', table.inner_text())
        self.assertIn('not judged', table.inner_text())
        shown = 'document.querySelector(".compared").getBoundingClientRect().top < innerHeight - 60'
        self.studio.until(shown)
        self.assertTrue(self.studio.js('legwrightStudio.view.ghost.root.visible'))
        self.studio.button('Beside').click()
        view = 'legwrightStudio.view'
        self.assertFalse(self.studio.js(f'{view}.ghost.root.visible'))
        self.assertTrue(self.studio.js(f'{view}.neighbour.root.visible'))
        apart = self.studio.js(f'{view}.neighbour.root.position.y / {view}.size')
        self.assertLess(apart, -0.5, 'two robots, side by side')
        self.studio.button('Within').click()
        self.assertFalse(self.studio.js(f'{view}.neighbour.root.visible'))
        self.studio.button('Compare').click()
        self.studio.button('Go on from').click()
        self.studio.until('v => legwrightStudio.readParameter("body_length").value === v', before)

    def test_a_second_page_follows(self):
        other = Page(self.browser, self.server.url, scheme='dark')
        other.ready()
        before = self.studio.value('body_width')
        self.drag('body_width', 0.01)
        wanted = self.studio.value('body_width')
        self.assertNotEqual(wanted, before)
        other.until('v => legwrightStudio.readParameter("body_width").value === v', wanted)
        self.assertEqual(other.console, [])
        other.close()
        self.studio.page.keyboard.press('Control+z')
        self.studio.until('v => legwrightStudio.readParameter("body_width").value === v', before)

    def test_nothing_is_without_a_name(self):
        for workspace in ('Design', 'Simulate'):
            self.studio.workspace(workspace)
            nameless = self.studio.js(
                """() => [...document.querySelectorAll("button, input, select, [tabindex]")]
                  .filter((each) => each.offsetParent && each.type !== "file")
                  .filter((each) => !(each.getAttribute("aria-label") || each.textContent.trim() ||
                                      each.labels?.length))
                  .map((each) => each.outerHTML.slice(0, 120))"""
            )
            self.assertEqual(nameless, [])

    def test_the_viewer_plays_embedded_designs(self):
        embedded = self.studio.js(
            """async () => {
              const get = async (path) => (await fetch(path)).json();
              return [{ name: "here", design: await get("/api/design"),
                        motion: await get("/api/motion?task=0") }];
            }"""
        )
        embedded.append(dict(embedded[0], name='there'))
        viewer = (ROOT / 'tools/studio/page/dist/viewer.js').read_text(encoding='utf-8')
        file = self.server.output / 'viewer.html'
        file.write_text(
            '<!doctype html><meta charset="utf-8"><div id="robot" style="height:400px"></div>'
            f'<script>{viewer}</script><script>const designs = {json.dumps(embedded)};'
            'globalThis.viewer = legwrightViewer(document.getElementById("robot"), {designs});'
            '</script>',
            encoding='utf-8',
        )
        self.assertLess(file.stat().st_size, 3e6)
        page = Page(self.browser, file.as_uri())
        page.until('() => viewer.view.stage.drawn > 2')
        page.page.get_by_role('button', name='here', exact=True).click()
        self.assertEqual(page.js('() => viewer.index'), 0)
        page.js('() => { viewer.view.setPlaying(false); viewer.view.seek(0.1); }')
        light = page.js('() => viewer.view.stage.picture()')
        page.js('() => viewer.setTheme("dark")')
        self.assertNotEqual(light, page.js('() => viewer.view.stage.picture()'))
        self.assertEqual(page.console, [])
        page.close()


def main():
    if not chromium():
        print('browser_test: SKIPPED: no chromium on this machine', file=sys.stderr)
        return 1 if os.environ.get('CI') == 'true' else SKIPPED
    if '--each-change' in sys.argv:
        sys.argv.remove('--each-change')
        if 'LEGWRIGHT_LONG_TESTS' not in os.environ:
            for name in LONG:
                del globals()[name]
    unittest.main()
    return 0


if __name__ == '__main__':
    sys.exit(main())
