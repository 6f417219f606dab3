#!/usr/bin/python3
"""Tests the dashboard as its readers use it: plots/dashboard_test.py MWT

Tracks 40 synthetic nightly runs, makes their dashboard and looks at it in a headless Chromium. Exit code 77 (skipped) without
Chromium or Selenium.
"""
import json
import math
import pathlib
import random
import re
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import browser  # noqa: E402  (beside this file)
from page_testing import Keys, PageTestCase, main, program, run  # noqa: E402

NIGHTLY_RUNS, CHANGED = 40, 25
COLUMNS = ("schema_version,study,env_id,recorded_at,git_commit,algorithm,params,generator,n,seed,repetition,threads,status,"
           "wall_time_s,delaunay_time_s,peak_rss_bytes,weight_lower,weight_upper,optimality,alpha_lower,alpha_upper,callgrind_instructions")
OLD_SCHEMA = 1  # files of this version are read by column name
ALGORITHMS = ("delaunay", "flip", "greedy", "patch")


def rows_of(nightly_run, noise):
    """From the nightly run CHANGED on greedy takes 10% longer, patch a fifth more memory, and flip is a thousandth heavier; the last nightly run
    delaunay has 1.5% more instructions."""
    late = nightly_run >= CHANGED
    for algorithm in ALGORITHMS:
        for family in ("uniform", "clustered"):
            for n in (100, 1000):
                time = 1e-5 * n * math.exp(noise.gauss(0, 0.02)) * (1.1 if late and algorithm == "greedy" else 1) * (1.6 if nightly_run == 13 else 1)
                memory = 10_000_000 + 4096 * noise.randrange(20) + (2_000_000 if late and algorithm == "patch" else 0)
                instructions = 10_000 * n + noise.randrange(n) + (150 * n if nightly_run == NIGHTLY_RUNS - 1 and algorithm == "delaunay" else 0)
                alpha = 1.05 * (1.001 if late and algorithm == "flip" else 1)
                yield (f"{OLD_SCHEMA},synthetic,e,2026-{1 + nightly_run // 28:02}-{1 + nightly_run % 28:02}T03:00:00Z,{nightly_run:02x}{'0' * 38},{algorithm},,{family},{n},1,0,1,ok,"
                       f"{time},2e-6,{memory},{100 * alpha},{100 * alpha},proved,{alpha},{alpha},{instructions}")


class DashboardTest(PageTestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="mwt_dashboard_")
        home = pathlib.Path(cls.folder.name)
        noise = random.Random(1)
        nightly_runs = []
        for nightly_run in range(NIGHTLY_RUNS):
            nightly_runs.append(home / f"nightly_run{nightly_run}")
            nightly_runs[-1].mkdir()
            (nightly_runs[-1] / "runs.csv").write_text("\n".join([COLUMNS, *rows_of(nightly_run, noise)]) + "\n")
        run(program(), "track", *nightly_runs, "--history", home / "history.sqlite")
        run(program(), "history", "series", "--json", "--history", home / "history.sqlite", "-o", home / "series.json")
        cls.home = home
        cls.page = home / "dashboard.html"
        run(HERE / "make_dashboard.py", home / "series.json", "-o", cls.page)
        cls.browser = cls.enterClassContext(browser.Browser())

    def choose(self, title, value):
        self.value(f"(() => {{ const label = [...document.querySelectorAll('#series-choices label')].find((l) => l.textContent.startsWith({title!r}));"
                   f" const select = label.querySelector('select'); select.value = {value!r}; select.dispatchEvent(new Event('change')); }})()")

    def test_words_come_first(self):
        self.assertIn("4 regressions, 0 improvements in 40 nightly runs", self.value("document.querySelector('.answer').innerText"))
        texts = self.texts(".changes .text")
        self.assertEqual([text.split(":")[0] for text in texts], ["2026-02-12 delaunay", "2026-01-26 flip", "2026-01-26 greedy", "2026-01-26 patch"])
        self.assertRegex(texts[0], r"counts x1\.01[45]\d")
        self.assertRegex(texts[2], r"time x1\.(0[89]|1[01])\d \(1\.0\d\d \.\. 1\.1\d\d\)")
        self.assertEqual(self.texts(".changes .badge"), ["regression"] * 4)

    def banner(self, series, outcome, *options):
        """The text and the colour of the banner of a nightly run with this outcome."""
        comparison = self.home / "verdict.json"
        comparison.write_text(json.dumps({"outcome": outcome, "verdict": "1 regression (time of flip x3.000) in 24 cells",
                                          "suspected": {"notes": ["load: base 0.10; new results 3.99"]}, "confirmed": None}))
        page = self.home / "of_a_nightly_run.html"
        run(HERE / "make_dashboard.py", series, "-o", page, "--comparison", comparison, *options)
        answer = page.read_text(encoding="utf-8").split('<div class="answer"')[1].split("</div>")[0]
        return answer, re.search(r"var\(--(\w+)\)", answer)[1]

    def stable_series(self):
        """The history without any step."""
        content = json.loads((self.home / "series.json").read_text(encoding="utf-8"))
        content["changes"] = []
        series = self.home / "stable.json"
        series.write_text(json.dumps(content))
        return series

    def test_a_failing_nightly_run_is_not_green_without_steps(self):
        text, colour = self.banner(self.stable_series(), "regression", "--state", "Not accepted.")
        self.assertEqual(colour, "bad")
        for part in ("The last nightly run: regression", "time of flip x3.000", "Not accepted.", "0 regressions", "Load: base 0.10; new results 3.99"):
            self.assertIn(part, text)

    def test_only_a_nightly_run_with_nothing_open_is_green(self):
        self.assertEqual(self.banner(self.stable_series(), "not slower")[1], "good")
        self.assertEqual(self.banner(self.stable_series(), "unclear")[1], "open")
        self.assertEqual(self.banner(self.stable_series(), "not compared")[1], "open")
        self.assertEqual(self.banner(self.home / "series.json", "not slower")[1], "bad", "steps count, too")

    def test_series_with_steps_come_first_and_are_marked(self):
        steps = self.value("[...document.querySelectorAll('.sparkline')].map((figure) => figure.querySelectorAll('.step').length)")
        self.assertEqual(steps[:20], [1] * 20, "instructions of delaunay, alpha and weight of flip on four instances, time of greedy, memory of patch")
        self.assertEqual(sum(steps[20:]), 0)

    def test_filters(self):
        self.choose("algorithm", "greedy")
        self.choose("measure", "relative_time")
        self.assertEqual(self.texts(".sparkline figcaption")[0].split(" · ")[::2], ["greedy", "relative_time"])
        self.assertIn("4 of 4 series", self.value("document.querySelector('#series-choices [role=status]').textContent"))
        self.choose("family", "uniform")
        self.assertEqual(len(self.texts(".sparkline")), 2)

    def test_only_series_with_steps(self):
        self.value("[...document.querySelectorAll('#series-choices button')].find((button) => button.textContent === 'only with steps').click()")
        self.assertEqual(len(self.texts(".sparkline")), 20)

    def test_a_change_leads_to_its_series(self):
        self.value("document.querySelectorAll('.changes a')[2].click()")
        self.assertEqual({text.split(" · ")[0] for text in self.texts(".sparkline figcaption")}, {"greedy"})
        self.assertEqual(len(self.texts(".sparkline")), 4)

    def through(self, lens):
        self.value(f"[...document.querySelectorAll('#series-choices button')].find((button) => button.textContent === {lens!r}).click()")
        return [text.split(" · ") for text in self.texts(".sparkline figcaption")]

    def test_two_lenses_show_the_same_series_in_the_same_places(self):
        times, counts = self.through("times"), self.through("counts")
        self.assertEqual([caption[:2] for caption in times], [caption[:2] for caption in counts])
        self.assertEqual(len(times), 16, "every algorithm, family and size once")
        self.assertEqual({caption[2] for caption in times}, {"relative_time"})
        self.assertEqual({caption[2] for caption in counts}, {"callgrind_instructions"})
        self.assertEqual(counts[0][0], "delaunay", "what has a step under either comes first")
        told = self.texts(".sparkline output")[0]
        self.assertRegex(told, r"step ×1\.01\d \| relative_time [\d.]+ \(", "the other lens is in the text")
        self.assertGreater(len(self.through("counts")), 16, "a second click takes the lens away")

    def test_lenses_fit_a_phone(self):
        for lens in ("times", "counts"):
            self.through(lens)
            for width in (360, 390):
                self.assert_fits(width)

    def test_more_series_on_demand(self):
        shown = len(self.texts(".sparkline"))
        self.value("[...document.querySelectorAll('button')].find((button) => button.textContent === 'show more series').click()")
        self.assertGreater(len(self.texts(".sparkline")), shown)

    def test_keyboard_shows_commit_and_value(self):
        self.value("document.querySelector('.sparkline svg').focus()")
        self.browser.press(Keys.HOME)
        self.assertIn("2026-01-01, commit 0000000000: ", self.texts(".sparkline output")[0])
        self.browser.press(Keys.ARROW_RIGHT)
        self.assertIn("2026-01-02", self.texts(".sparkline output")[0])

    def test_pointing_shows_commit_and_value(self):
        self.value("(() => { const svg = document.querySelector('.sparkline svg'); const box = svg.getBoundingClientRect();"
                   " svg.dispatchEvent(new PointerEvent('pointermove', { clientX: box.left + 1, clientY: box.top + 5 })); })()")
        self.assertIn("2026-01-01", self.texts(".sparkline output")[0])

    def test_lines_stay_inside(self):
        self.assertTrue(self.value("[...document.querySelectorAll('.sparkline polyline')].every((line) => { const box = line.getBBox();"
                                   " return box.x >= 0 && box.y >= 0 && box.x + box.width <= 300 && box.y + box.height <= 60; })"))

    def test_dark_mode(self):
        self.browser.show_as(1280, 900, dark=True)
        self.assertEqual(self.value("getComputedStyle(document.body).backgroundColor"), "rgb(22, 24, 28)")

    def test_nothing_is_cut_off(self):
        for width in (360, 390, 768, 1440):
            self.assert_fits(width)

    def test_every_line_has_a_scale(self):
        charts = self.value(
            "[...document.querySelectorAll('.sparkline .chart')].map((chart) => [...chart.querySelectorAll('span')].map((span) =>"
            " [span.className, span.textContent]))"
        )
        for chart in charts:
            named = dict(chart)
            self.assertTrue({"high", "low"} <= set(named) or "only" in named, named)
            self.assertNotEqual(named.get("high"), named.get("low", ""), named)
            self.assertEqual(named["first"], "2026-01-01")
            self.assertEqual(named["last"], "2026-02-12")

    def test_a_scale_holds_what_it_shows(self):
        self.choose("algorithm", "flip")
        self.choose("measure", "alpha")
        high, low = (float(self.texts(f".sparkline .{end}")[0]) for end in ("high", "low"))
        self.assertLess(low, 1.05)
        self.assertGreater(high, 1.05105)
        self.assertLess(high - low, 0.01)


if __name__ == "__main__":
    main("THE DASHBOARD")
