#!/usr/bin/python3
"""Tests the page of recorded steps as its readers use it: plots/tour_test.py MWT

Makes the page and looks at it, alone, in a headless Chromium. Exit code 77 (skipped) without Chromium or Selenium.
"""
import pathlib
import tempfile

import browser
from page_testing import PageTestCase, main, program, run

HERE = pathlib.Path(__file__).resolve().parent


class TourTest(PageTestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="mwt_tour_")
        cls.page = pathlib.Path(cls.folder.name) / "tour.html"
        run(HERE / "make_tour.py", program(), cls.page)
        cls.browser = cls.enterClassContext(browser.Browser())

    def choose(self, example):
        self.value(
            f"(() => {{ const select = document.getElementById('example'); select.value = {example};"
            " select.dispatchEvent(new Event('change')); })()"
        )

    def test_every_example_is_played_to_its_end(self):
        count = self.value("tour.examples.length")
        self.assertGreater(count, 4)
        for example in range(count):
            self.choose(example)
            self.assertEqual(self.value("tour.player.trace.position"), 0)
            self.value("tour.player.show(tour.player.trace.size)")
            n = self.value("tour.points.coordinates.length / 2")
            edges = self.value("tour.player.trace.edges.size")
            self.assertTrue(2 * n - 3 <= edges <= 3 * n - 6, f"{edges} edges of {n} points")

    def test_its_buttons_step(self):
        self.value("document.getElementById('play-next').click()")
        self.assertIn("step 1 of", self.value("document.getElementById('play-text').textContent"))
        self.value("document.getElementById('play-back').click()")
        self.assertEqual(self.value("document.getElementById('play-text').textContent"), "the start")

    def test_is_small_and_fits(self):
        self.assertLess(self.page.stat().st_size, 500_000)
        for width in (360, 390, 768, 1440):
            self.assert_fits(width)


if __name__ == "__main__":
    main("THE TOUR")
