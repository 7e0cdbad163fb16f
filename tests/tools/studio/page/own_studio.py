# SPDX-License-Identifier: Apache-2.0
"""What tests share that open studios of their own, in one browser."""

import unittest

from studio_browser import ROOT, Page, Server, browser


class OwnStudio(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.stack = browser()
        cls.browser = cls.stack.__enter__()

    @classmethod
    def tearDownClass(cls):
        cls.stack.__exit__(None, None, None)

    def open(self, task, **options):
        """The page of an example, once it is solved; without a task the first page."""
        self.server = Server(*([str(ROOT / 'examples' / task)] if task else []))
        self.addCleanup(self.server.close)
        studio = Page(self.browser, self.server.url, **options)
        self.addCleanup(studio.close)
        if task:
            studio.ready()
        return studio
