# SPDX-License-Identifier: Apache-2.0
"""A robot is made of modules in the page; browser_test.py runs it."""

import unittest

from studio_browser import ROOT, Page, Server, browser

DESK = 'legwrightStudio.assembly'


class Assembling(unittest.TestCase):
    def setUp(self):
        self.stack = browser()
        self.server = None

    def tearDown(self):
        self.stack.__exit__(None, None, None)
        if self.server:
            self.server.close()

    def open(self, *arguments):
        self.server = Server(*arguments)
        self.studio = Page(self.stack.__enter__(), self.server.url)
        return self.studio

    def until_told(self, expression):
        self.studio.until(f'(() => {{ const t = {DESK}.told; return t && ({expression}); }})()')

    def card(self, name):
        card = self.studio.page.locator(f'button.module-card[data-module="{name}"]')
        card.scroll_into_view_if_needed()
        return card

    def place_of_spot(self, kind, spot):
        """Where a spot is on the screen while a module of a kind is carried."""
        return self.studio.js(
            """([kind, id]) => {
              const { assembly, assemblyScene: scene } = legwrightStudio;
              assembly.carry({ name: 'x', kind }, { dragged: true });
              scene.view.pose();
              const { stage } = scene.view;
              const spot = scene.spots.all.find((each) => each.spot.id === id);
              const at = spot.centre.clone().project(stage.camera);
              assembly.carry(null);
              const box = stage.canvas.getBoundingClientRect();
              return [box.left + (at.x / 2 + 0.5) * box.width,
                      box.top + (0.5 - at.y / 2) * box.height];
            }""",
            [kind, spot],
        )

    def drag_onto(self, module, kind, spot):
        x, y = self.place_of_spot(kind, spot)
        box = self.card(module).bounding_box()
        mouse = self.studio.page.mouse
        mouse.move(box['x'] + 20, box['y'] + 20)
        mouse.down()
        mouse.move(box['x'] + 90, box['y'] + 30)
        mouse.move(x - 9, y + 4)
        self.assertEqual(self.studio.js(f'{DESK}.aimed'), spot)
        mouse.up()

    def test_a_quadruped_by_keys_and_by_dragging(self):
        studio = self.open()
        studio.button('New robot…').click()
        self.until_told('t.limbs.length === 0')
        self.card('XL430-W250').focus()
        studio.page.keyboard.press('Enter')  # takes it up; the first place has the focus
        studio.page.keyboard.press('ArrowDown')
        studio.page.keyboard.press('ArrowUp')
        self.assertEqual(studio.js(f'{DESK}.aimed'), 'side/front')
        studio.page.keyboard.press('Enter')
        self.until_told('t.servos === 2')
        self.drag_onto('XL430-W250', 'servo', 'limb/0/end')
        self.until_told('t.servos === 4')
        studio.until(f'{DESK}.selected === "limb/0/joint/1"')
        studio.page.locator('.outline-row[data-item="limb/0"]').click()
        studio.button('Another like it…').click()
        studio.page.locator('[data-spot="side/hind"]').click()
        self.until_told('t.servos === 8')
        studio.page.keyboard.press('Delete')
        self.until_told('t.servos === 4')
        studio.page.keyboard.press('Control+z')
        self.until_told('t.servos === 8')
        self.drag_onto('lipo_3s_2200', 'battery', 'ride/top')
        self.until_told('t.parts.length === 1')
        studio.button('Build and design').click()
        studio.ready()
        self.assertEqual(studio.js('legwrightStudio.store.get("document").feet.length'), 4)
        studio.button('Modules').click()
        self.until_told('t.servos === 8 && t.parts.length === 1')
        self.assertEqual(studio.console, [])

    def test_an_axis_is_turned_and_a_foot_dragged_by_handles(self):
        studio = self.open(str(ROOT / 'examples/assemblies/puppy.toml'))
        self.until_told('t.limbs.length === 1')
        row = studio.page.locator('.outline-row[data-item="limb/0/joint/0"]')
        row.click()
        studio.until('legwrightStudio.assemblyScene.view.handles.all.length > 3')
        self.drag_handle('turn z', 40)
        self.until_told('Math.abs(t.limbs[0].joints[0].axis[0]) > 0.05')
        axis = studio.js(f'{DESK}.told.limbs[0].joints[0].axis')
        self.assertAlmostEqual(sum(a * a for a in axis), 1.0, places=5)
        self.assertEqual(axis[2], 0)
        studio.page.keyboard.press('Control+z')
        self.until_told('t.limbs[0].joints[0].axis[0] === 0')
        studio.page.locator('.outline-row[data-item="limb/0/foot"]').click()
        self.drag_handle('z', 40)
        self.until_told('t.limbs[0].foot.offset[2] !== -0.09')
        self.assertEqual(studio.js(f'{DESK}.told.limbs[0].foot.offset[0]'), 0)
        studio.page.keyboard.press('Control+z')  # all of the drag is one step
        self.until_told('t.limbs[0].foot.offset[2] === -0.09 && !t.can_undo')
        self.assertEqual(studio.console, [])

    def test_undo_comes_after_the_drag_that_still_waits(self):
        studio = self.open(str(ROOT / 'examples/assemblies/puppy.toml'))
        self.until_told('t.limbs.length === 1')
        studio.js(
            f"""async () => {{
              const desk = {DESK};
              desk.begin();
              for (const z of [-0.10, -0.11, -0.12]) desk.drag('limb/0/foot', 'offset', [0, 0, z]);
              await desk.obey({{ do: 'undo' }});
              await legwrightStudio.sender.sent();
            }}"""
        )
        self.until_told('t.limbs[0].foot.offset[2] === -0.09 && !t.can_undo && t.can_redo')
        self.assertEqual(studio.console, [])

    def test_escape_puts_back_what_is_under_the_hand(self):
        studio = self.open(str(ROOT / 'examples/assemblies/puppy.toml'))
        self.until_told('t.limbs.length === 1')
        studio.page.locator('.outline-row[data-item="limb/0/foot"]').click()
        self.drag_handle('z', 40, 'Escape')
        self.until_told('t.limbs[0].foot.offset[2] === -0.09 && !t.can_undo && !t.can_redo')
        self.assertEqual(studio.console, [])

    def drag_handle(self, name, pixels, key=None):
        x, y = self.studio.js(
            """(name) => {
              const { view } = legwrightStudio.assemblyScene;
              view.pose();
              const handle = view.handles.all.find((each) => each.name === name);
              const { canvas, camera } = view.stage;
              const at = handle.held.clone().applyMatrix4(view.handles.root.matrixWorld);
              at.project(camera);
              const box = canvas.getBoundingClientRect();
              return [box.left + (at.x / 2 + 0.5) * box.width,
                      box.top + (0.5 - at.y / 2) * box.height];
            }""",
            name,
        )
        mouse = self.studio.page.mouse
        mouse.move(x, y)
        mouse.down()
        for share in (0.3, 0.6, 1.0):
            mouse.move(x + pixels * share, y + pixels * share)
            self.studio.page.wait_for_timeout(120)
        if key:
            self.until_told('t.limbs[0].foot.offset[2] !== -0.09')
            self.studio.page.keyboard.press(key)
            mouse.move(x + 2 * pixels, y + 2 * pixels)
        mouse.up()

    def test_fields_set_what_the_file_says_and_refuse_what_it_cannot(self):
        studio = self.open(str(ROOT / 'examples/assemblies/puppy.toml'))
        self.until_told('t.limbs.length === 1')
        studio.page.locator('.outline-row[data-item="limb/0/joint/1"]').click()
        studio.page.locator('[data-field="servo"]').select_option('XM430-W350')
        self.until_told('t.limbs[0].joints[1].servo === "XM430-W350"')
        name = studio.page.locator('[data-field="name"]')
        name.fill('two words')
        name.press('Tab')
        studio.page.get_by_role('alert').wait_for()
        self.assertEqual(studio.page.locator('[data-field="name"]').input_value(), 'knee')
        self.assertEqual(studio.js(f'{DESK}.told.limbs[0].joints[1].name'), 'knee')
        studio.page.keyboard.press('Control+s')
        studio.page.get_by_label('File').fill(str(self.server.output / 'made.toml'))
        studio.page.keyboard.press('Enter')
        studio.page.get_by_text('Saved: ').wait_for()
        saved = self.server.output / 'made.toml'
        self.assertIn('XM430-W350', saved.read_text())
        studio.page.reload()  # a page that does not know who wrote the file
        self.until_told('t.limbs.length === 1')
        saved.write_text('# of somebody else\n')
        for answer, begin in (('Cancel', '# of'), ('Replace', 'name = ')):
            studio.page.keyboard.press('Control+s')
            studio.page.get_by_label('File').fill(str(saved))
            studio.page.keyboard.press('Enter')
            studio.button(answer).click()
            studio.page.wait_for_timeout(300)
            self.assertTrue(saved.read_text().startswith(begin), answer)
