"""What the tests of pages share: a browser on the page, and silence in its console and on the network.

A test module has a subclass of PageTestCase, whose setUpClass makes the page, and ends with main(). Exit code 77 (skipped)
without Chromium.
"""
import pathlib
import subprocess
import sys
import unittest

import chromium

SKIPPED = 77


def run(*command):
    outcome = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    if outcome.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{outcome.stdout[-2000:]}{outcome.stderr[-2000:]}")


def program():
    """The mwt that the test was called with."""
    return pathlib.Path(sys.argv[1]).resolve()


class PageTestCase(unittest.TestCase):
    """Its class attributes, to be set by setUpClass: folder (temporary), page (path) and browser."""

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def setUp(self):
        self.browser.show_as(1280, 900, dark=False)
        self.browser.open(self.page)

    def tearDown(self):
        self.assertEqual(self.browser.problems, [], "the console is silent")
        self.assertEqual(self.browser.requests, [], "nothing is fetched")

    def value(self, expression):
        return self.browser.value(expression)

    def texts(self, selector):
        return self.value(f"[...document.querySelectorAll({selector!r})].map((element) => element.textContent)")


def main(what):
    if len(sys.argv) != 2:
        sys.exit(f"usage: {pathlib.Path(sys.argv[0]).name} MWT")
    if chromium.find() is None:
        print(f"SKIPPED: NO CHROMIUM ON THIS MACHINE, {what} WAS NOT TESTED. Install it: setup/packages_for_checks.txt")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2)
