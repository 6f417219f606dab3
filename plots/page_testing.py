"""What the tests of pages share: a browser on the page, and silence in its console and on the network.

A test module has a subclass of PageTestCase, whose setUpClass makes the page, and ends with main(). Exit code 77 (skipped)
without Chromium or Selenium.
"""
import pathlib
import subprocess
import sys
import time
import unittest

import browser

if browser.missing() is None:
    from selenium.webdriver.common.keys import Keys
else:  # main() skips the tests
    Keys = None

SKIPPED = 77
AXE = pathlib.Path(__file__).resolve().parents[1] / "setup/axe/node_modules/axe-core/axe.min.js"
AXE_PATIENCE_S = 120


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
        self.browser.collect()
        self.assertEqual(self.browser.problems, [], "the console is silent")
        self.assertEqual(self.browser.requests, [], "nothing is fetched")

    def value(self, expression):
        return self.browser.value(expression)

    def texts(self, selector):
        return self.value(f"[...document.querySelectorAll({selector!r})].map((element) => element.textContent)")

    def assert_no_panel_is_empty(self):
        """Every panel of every figure, in both layouts, has a line or marks."""
        panels = self.value(
            "[...document.querySelectorAll('figure svg g[id*=\"-axes_\"]')].map((panel) =>"
            " panel.querySelectorAll(':scope > g[id*=\"line2d_\"], :scope > g[id*=\"Collection_\"]').length)"
        )
        self.assertGreater(len(panels), 1)
        self.assertGreater(min(panels), 0)

    def assert_accessible(self, widths=(390, 768, 1440)):
        """axe-core finds no violation, light and dark, with everything unfolded; the insides of figures, which have names, are left out."""
        if not AXE.is_file():
            self.skipTest("axe-core is not installed: setup/ensure_axe.sh")
        for dark in (False, True):
            for width in widths:
                self.browser.show_as(width, 900, dark)
                self.browser.open(self.page)
                self.value("document.querySelectorAll('details').forEach((one) => { one.open = true; })")
                self.value("document.querySelectorAll('figure svg').forEach((one) => one.replaceChildren())")
                self.browser.run(AXE.read_text(encoding="utf-8"))
                self.browser.run("axe.run({ iframes: false, resultTypes: ['violations'] }).then((found) => { window.axeFound = found.violations; })")
                end = time.monotonic() + AXE_PATIENCE_S
                while not self.value("Boolean(window.axeFound)"):
                    self.assertLess(time.monotonic(), end, "axe-core does not end")
                    time.sleep(0.05)
                found = self.value(
                    "window.axeFound.map((one) => `${one.id}: ${one.nodes.slice(0, 5).map((node) => node.html.slice(0, 200)).join(' | ')}`)"
                )
                self.assertEqual(found, [], f"{width} pixels, dark: {dark}")

    def assert_fits(self, width):
        """Nothing sticks out sideways or is cut off on a screen of this width; tables scroll in a frame of their own."""
        self.browser.show_as(width, 844, dark=False)
        self.browser.open(self.page)
        self.value("document.querySelectorAll('details').forEach((one) => { one.open = true; })")
        self.assertLessEqual(self.value("document.documentElement.scrollWidth"), width)
        cut_off = self.value(
            "[...document.body.querySelectorAll('*')].filter((one) => one.checkVisibility() &&"
            " !one.closest('.table-scroll, .skip, svg') && (one.getBoundingClientRect().right >"
            f" {width} || one.getBoundingClientRect().left < 0 || one.scrollWidth > one.clientWidth + 1 && one.clientWidth > 0 &&"
            " getComputedStyle(one).overflowX !== 'visible')).map((one) => one.outerHTML.slice(0, 120))"
        )
        self.assertEqual(cut_off, [], f"cut off at {width} pixels")
        texts = self.value(
            "[...document.querySelectorAll('svg')].filter((svg) => svg.checkVisibility()).flatMap((svg) => { const box ="
            " svg.getBoundingClientRect(); return [...svg.querySelectorAll('text')].filter((text) => { const inner ="
            " text.getBoundingClientRect(); return inner.left < box.left - 1 || inner.right > box.right + 1 || inner.top <"
            " box.top - 1 || inner.bottom > box.bottom + 1; }).map((text) => text.textContent); })"
        )
        self.assertEqual(texts, [], f"outside of their figures at {width} pixels")


def main(what):
    if len(sys.argv) != 2:
        sys.exit(f"usage: {pathlib.Path(sys.argv[0]).name} MWT")
    missing = browser.missing()
    if missing:
        print(f"SKIPPED: {missing} IS MISSING, {what} WAS NOT TESTED. Install it: setup/packages_for_checks.txt")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2)
