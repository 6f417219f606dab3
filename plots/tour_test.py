#!/usr/bin/python3
"""Tests the page of recorded steps as its readers use it: plots/tour_test.py MWT

Makes the page and looks at it, alone, in a headless Chromium. Exit code 77 (skipped) without Chromium or Selenium.
"""
import html
import pathlib
import re
import tempfile
import time

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

    def test_explains_edges(self):
        titles = self.value("tour.examples.map((example) => example.title)")
        self.choose(titles.index("How an optimum is proved"))
        self.value("tour.player.show(tour.player.trace.stages[1].begin)")
        edge = self.value("(() => { for (const { a, b } of tour.player.trace.edges.values()) return [a, b]; })()")
        self.assertIn("passes the diamond test", self.value(f"tour.player.trace.historyOf({edge[0]}, {edge[1]})[0]"))

    def test_works_within_another_page(self):
        """Under the policy of the report's page, following its theme."""
        results = pathlib.Path(self.folder.name)
        frame = f'<iframe style="width: 100%; height: 58rem; border: 0" title="tour" srcdoc="{html.escape(self.page.read_text())}"></iframe>'
        template = (HERE / "templates" / "page.html").read_text()
        policy = re.search("<meta http-equiv=.Content-Security-Policy.*", template)[0]
        outer = results / "outer.html"
        outer.write_text(
            f'<!doctype html><html lang="en" data-theme="dark"><head>{policy}<meta name="viewport" content="width=device-width"><link rel="icon" href="data:,"><title>report</title></head>'
            f"<body>{frame}</body></html>"
        )
        self.browser.collect()
        self.browser.open(outer)
        inner = "document.querySelector('iframe').contentWindow"
        self.value("document.querySelector('iframe').scrollIntoView()")
        end = time.monotonic() + 20
        while not self.value(f"Boolean({inner}.tour)") and time.monotonic() < end:
            time.sleep(0.05)
        self.value(f"{inner}.tour.player.step(1)")
        self.assertIn("step 1 of", self.value(f"{inner}.document.getElementById('play-text').textContent"))
        self.assertEqual(self.value(f"{inner}.document.documentElement.dataset.theme"), "dark")
        self.assertFalse(self.value(f"{inner}.document.querySelector('header').checkVisibility()"))
        for width in (360, 390, 768, 1440):
            self.browser.show_as(width, 900, dark=False)
            self.assertLessEqual(self.value(f"{inner}.document.documentElement.scrollWidth"), width)
            self.assertLessEqual(self.value(f"{inner}.document.documentElement.scrollHeight"), self.value(f"{inner}.innerHeight"))

    def test_is_small_and_fits(self):
        self.assertLess(self.page.stat().st_size, 500_000)
        for width in (360, 390, 768, 1440):
            self.assert_fits(width)


if __name__ == "__main__":
    main("THE TOUR")
