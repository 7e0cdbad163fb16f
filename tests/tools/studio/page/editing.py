# SPDX-License-Identifier: Apache-2.0
"""Edits on their way from the page to the server, which a thread of their own sends."""

from own_studio import OwnStudio
from studio_browser import ROOT, Page, Server

NAME = 'front_thigh_length'


class Editing(OwnStudio):
    def drafts(self, studio):
        return studio.js('legwrightStudio.edits.drafts.size')

    def test_of_what_waits_the_latest_is_sent(self):
        studio = self.open('puppy/sideways.toml')
        held, sent = [], []

        def hold(route):
            sent.append(route.request.post_data_json)
            if len(sent) == 1:
                held.append(route)
            else:
                route.continue_()

        studio.page.route('**/api/command', hold)
        for value, phase in ((0.061, 'begin'), (0.062, 'drag'), (0.063, 'drag'), (0.064, 'end')):
            studio.js('([n, v, p]) => legwrightStudio.edit(n, v, p)', [NAME, value, phase])
            if value == 0.061:
                while not held:
                    studio.page.wait_for_timeout(20)
        studio.page.wait_for_timeout(100)
        self.assertEqual(len(sent), 1)  # one on its way
        self.assertFalse(studio.js('legwrightStudio.edits.idle'))
        self.assertEqual(studio.value(NAME), 0.064)  # what is under the hand
        held[0].continue_()
        studio.until('legwrightStudio.edits.idle')
        studio.until('n => legwrightStudio.edits.drafts.size === 0', NAME)
        studio.settled()
        self.assertEqual([each['values'] for each in sent], [{NAME: 0.061}, {NAME: 0.064}])
        self.assertEqual([each['goes_on'] for each in sent], [False, True])
        self.assertEqual([each['held'] for each in sent], [True, False])
        self.assertEqual(studio.value(NAME), 0.064)
        studio.page.unroute('**/api/command')
        studio.js('legwrightStudio.command("undo")')  # one step, as it was one drag
        studio.until('n => legwrightStudio.readParameter(n).value === 0.06', NAME)

    def test_a_refused_edit_is_told_and_taken_back(self):
        studio = self.open('puppy/sideways.toml')
        studio.js('legwrightStudio.edits.set({ no_such_length: 0.1 })')
        studio.until('legwrightStudio.edits.idle')
        self.assertEqual(self.drafts(studio), 0)
        notice = studio.page.locator('.notice', has_text='no_such_length')
        notice.wait_for()
        studio.js('([n, v]) => legwrightStudio.edit(n, v, "once")', [NAME, 0.062])
        studio.until('n => legwrightStudio.store.get("state").s.includes(0.062)', NAME)

    def test_nothing_is_asked_of_a_robot_that_is_not_known_yet(self):
        came = []
        self.server = Server(str(ROOT / 'examples/puppy/sideways.toml'))
        self.addCleanup(self.server.close)
        hold = ('**/api/document', lambda route: came.append(route))
        studio = Page(self.browser, self.server.url, cut=hold)
        self.addCleanup(studio.close)
        while not came:
            studio.page.wait_for_timeout(20)
        studio.until('document.body.dataset.page === "workspace"')
        self.assertTrue(studio.js('document.querySelector(".workspace > .panes").inert'))
        for key in ('s', 'o', 'ArrowDown', 'l', '+', 'Control+z'):
            studio.page.keyboard.press(key)
        came[0].continue_()
        studio.page.unroute('**/api/document')
        studio.ready()
        self.assertFalse(studio.js('document.querySelector(".workspace > .panes").inert'))
        self.assertEqual(studio.console, [])

    def hold_one(self, studio):
        """Holds the next command; gives what answers it in the place of the server."""
        came = []
        studio.page.route('**/api/command', lambda route: came.append(route), times=1)

        def answer(status, body):
            while not came:
                studio.page.wait_for_timeout(20)
            came[0].fulfill(status=status, body=body)

        return answer

    def test_a_refusal_leaves_what_the_hand_has_set_since(self):
        studio = self.open('puppy/sideways.toml')
        answer = self.hold_one(studio)
        for value, phase in ((0.061, 'begin'), (0.062, 'end')):
            studio.js('([n, v, p]) => legwrightStudio.edit(n, v, p)', [NAME, value, phase])
        shown = """n => {
          window.shown = [];
          legwrightStudio.store.on("state", () =>
            window.shown.push(legwrightStudio.readParameter(n).value));
        }"""
        studio.js(shown, NAME)
        answer(400, '{"error": {"message": "not this one"}}')
        studio.page.locator('.notice', has_text='not this one').wait_for()
        studio.until('n => legwrightStudio.store.get("state").s.includes(0.062)', NAME)
        self.assertEqual(set(studio.js('window.shown')), {0.062})

    def test_an_answer_that_cannot_be_read_is_told_and_edits_go_on(self):
        studio = self.open('puppy/sideways.toml')
        answer = self.hold_one(studio)
        studio.js('([n, v]) => legwrightStudio.edit(n, v, "once")', [NAME, 0.062])
        answer(500, '{"error": null}')
        studio.page.locator('.notice.error').wait_for()
        studio.until('legwrightStudio.edits.idle')
        self.assertEqual(self.drafts(studio), 0)
        studio.js('([n, v]) => legwrightStudio.edit(n, v, "once")', [NAME, 0.063])
        studio.until('n => legwrightStudio.store.get("state").s.includes(0.063)', NAME)

    def test_a_server_that_is_gone_is_told(self):
        studio = self.open('puppy/sideways.toml')
        studio.page.route('**/api/command', lambda route: route.abort())
        studio.js('([n, v]) => legwrightStudio.edit(n, v, "once")', [NAME, 0.062])
        studio.page.get_by_text('legwright studio does not answer').wait_for()
        self.assertTrue(studio.js('legwrightStudio.edits.idle'))
        self.assertEqual(studio.value(NAME), 0.06)

    def test_a_number_that_is_typed_takes_the_place_of_what_stands(self):
        studio = self.open('puppy/sideways.toml')
        studio.workspace('Simulate')
        left = studio.page.get_by_label('left [m/s]')
        self.assertEqual(left.input_value(), '0.1')
        left.click()
        studio.page.keyboard.type('0.12')
        studio.page.keyboard.press('Enter')
        studio.until('legwrightStudio.store.get("document").tasks[0].velocity[1] === 0.12')
        left.click()  # a second one puts the caret
        studio.page.keyboard.press('End')
        studio.page.keyboard.type('5')
        self.assertEqual(left.input_value(), '0.125')

    def test_a_field_whose_value_is_refused_shows_what_holds(self):
        studio = self.open('puppy/sideways.toml')
        studio.workspace('Simulate')
        left = studio.page.get_by_label('left [m/s]')
        left.fill('50')
        studio.page.keyboard.press('Enter')
        studio.page.get_by_text('expected -10 <= velocity <= 10').wait_for()
        studio.until(
            '() => document.querySelector("[aria-label=\'left [m/s]\']").value === "0.1"'
        )

    def test_a_hand_that_does_not_move_changes_nothing(self):
        studio = self.open('puppy/sideways.toml')
        sent = []

        def keep(route):
            sent.append(route.request.post_data_json)
            route.continue_()

        studio.page.route('**/api/command', keep)
        given = studio.value(NAME)
        for value, phase in ((given, 'begin'), (given, 'drag'), (given, 'end')):
            studio.js('([n, v, p]) => legwrightStudio.edit(n, v, p)', [NAME, value, phase])
        studio.js('([n, v]) => legwrightStudio.edit(n, v, "begin")', [NAME, given])
        for value, phase in ((0.061, 'drag'), (given, 'drag'), (given, 'end')):
            studio.js('([n, v, p]) => legwrightStudio.edit(n, v, p)', [NAME, value, phase])
            studio.until('legwrightStudio.edits.idle')
        studio.settled()
        self.assertEqual([each['values'][NAME] for each in sent], [0.061, given, given])
        self.assertEqual([each['goes_on'] for each in sent], [False, True, True])

    def test_a_page_without_the_thread_that_sends_edits_says_so(self):
        studio = self.open('puppy/sideways.toml')
        studio.js('legwrightStudio.edits.worker.dispatchEvent(new ErrorEvent("error"))')
        studio.page.get_by_text('load this page anew').wait_for()
        studio.js('([n, v]) => legwrightStudio.edit(n, v, "once")', [NAME, 0.062])
        self.assertTrue(studio.js('legwrightStudio.edits.idle'))
        self.assertEqual(studio.value(NAME), 0.06)
