#!/usr/bin/python3
"""Tests the page of the claims as its readers use it: plots/page_test.py MWT

Runs a small study, makes its page and looks at it in a headless Chromium. Exit code 77 (skipped) without Chromium or
Selenium.
"""
import pathlib
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import browser  # noqa: E402  (beside this file)
from page_testing import Keys, PageTestCase, main, program, run  # noqa: E402

LARGEST_PAGE_BYTES = 5_000_000
CLAIMS = 15


class PageTest(PageTestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="mwt_page_")
        results = pathlib.Path(cls.folder.name) / "results"
        run(program(), "run", HERE / "testdata" / "page_test.toml", "--out", results, "--no-cache")
        run(program(), "report", results)
        run(HERE / "gallery.sh", program(), results)
        run(HERE / "make_page.py", results)
        cls.results = results
        # Elsewhere than its results: the page needs nothing beside it.
        cls.page = pathlib.Path(cls.folder.name) / "alone" / "page.html"
        cls.page.parent.mkdir()
        cls.page.write_bytes((results / "report.html").read_bytes())
        cls.browser = cls.enterClassContext(browser.Browser())

    def test_is_small(self):
        self.assertLess(self.page.stat().st_size, LARGEST_PAGE_BYTES)

    def test_the_question_is_answered_on_the_first_screen(self):
        self.assertIn("Is greedy’s α 1.1–1.5", self.value("document.querySelector('.answer').innerText"))
        self.assertLess(self.value("document.querySelector('.answer').getBoundingClientRect().bottom"), 900)

    def test_every_claim_has_a_verdict(self):
        self.assertEqual(self.texts("details.claim .claim-id"), [f"C{number + 1}" for number in range(CLAIMS)])
        verdicts = dict(zip(self.texts("details.claim .claim-id"), self.texts("details.claim .badge")))
        self.assertEqual(verdicts["C1"], "reproduced")
        self.assertEqual(verdicts["C14"], "by citation")

    def test_verdict_buttons_choose(self):
        self.value("document.querySelector('button[data-verdict=\"by citation\"]').click()")
        self.assertEqual(self.value("document.querySelectorAll('details.claim:not([hidden])').length"), 1)
        self.value("document.querySelector('button[data-verdict=\"by citation\"]').click()")
        self.assertEqual(self.value("document.querySelectorAll('details.claim:not([hidden])').length"), CLAIMS)

    def test_figures_are_drawn_and_written(self):
        names = self.value("[...document.querySelectorAll('figure')].map((figure) => figure.previousElementSibling.id)")
        for name in (
            "alpha_by_n",
            "alpha_distribution",
            "trade_off",
            "time_by_n",
            "growth",
            "worked_examples",
            "flips",
            "hull_bound",
            "same_points",
            "quadtree_grid",
        ):
            self.assertIn(f"figure-{name}", names)
            for ending in (".svg", ".png"):
                self.assertTrue((self.results / "figures" / (name + ending)).is_file(), name)
        self.assert_no_panel_is_empty()
        self.assertTrue(
            self.value("[...document.querySelectorAll('figure svg')].every((svg) => svg.getAttribute('aria-label'))")
        )

    def test_recorded_steps_are_played(self):
        self.assertEqual(self.value("document.activeElement.tagName"), "BODY", "it takes no focus before it is opened")
        self.value("document.getElementById('tour').click()")
        self.value("document.querySelector('iframe.tour').scrollIntoView()")
        inside = "document.querySelector('iframe.tour').contentDocument"
        end = time.monotonic() + 20
        while not self.value(f"{inside}.querySelectorAll('#example option').length") and time.monotonic() < end:
            time.sleep(0.05)
        self.assertEqual(self.value(f"{inside}.querySelectorAll('#example option').length"), 9)
        self.assertIn("greedy_naive", self.value(f"{inside}.getElementById('command').textContent"))
        self.value("document.getElementById('theme').click()")
        self.assertEqual(self.value(f"{inside}.documentElement.dataset.theme"), "dark")
        for width in (390, 768, 1440):
            self.browser.show_as(width, 900, dark=False)
            self.assertLessEqual(self.value(f"{inside}.documentElement.scrollWidth"), width)

    def test_ids_are_unique(self):
        self.assertEqual(
            self.value(
                "(() => { const ids = [...document.querySelectorAll('[id]')].map((e) => e.id);"
                " return ids.length - new Set(ids).size; })()"
            ),
            0,
        )

    def test_what_is_proved_is_a_matrix(self):
        rows = self.texts("#optima tr th[scope=row]")
        self.assertEqual(rows[:3], ["uniform", "greedy_corridor", "circle"], "the usual first, the others by the largest alpha")
        self.assertEqual(self.texts("#optima table:first-of-type th[scope=col]")[:3], ["family", "100", "50"])
        self.assertIn("report_example", rows[3:])
        cells = self.texts("#optima td:not(:empty)")
        statuses = self.texts("#optima .status")
        self.assertEqual(set(statuses), {"proved", "2 proved"})
        self.assertEqual(len(self.texts("#optima .verification")), len(statuses) - 2)  # n = 100: no proofs
        self.assertTrue(all(" s" in text or "ms" in text or "µs" in text for text in cells if "proved" in text), cells)
        self.assertIn("of the proofs verified", self.value("document.querySelector('header').textContent"))

    def column(self, position):
        return self.texts(f"#runs tbody tr td:nth-child({position})")

    def test_runs_sort(self):
        click = "[...document.querySelectorAll('#runs th button')].find((button) => button.textContent === 'n').click()"
        self.value(click)
        ascending = [int(text) for text in self.column(3)]
        self.assertEqual(ascending, sorted(ascending))
        self.assertEqual(self.value("document.querySelectorAll('#runs th[aria-sort=ascending]').length"), 1)
        self.value(click)
        descending = [int(text) for text in self.column(3)]
        self.assertEqual(descending, sorted(descending, reverse=True))
        self.assertGreater(descending[0], ascending[0])

    def choose(self, title, value):
        self.value(
            "(() => { const label = [...document.querySelectorAll('#runs label')].find((l) =>"
            f" l.textContent.startsWith({title!r})); const select = label.querySelector('select'); select.value ="
            f" {value!r}; select.dispatchEvent(new Event('change')); }})()"
        )

    def test_runs_filter(self):
        self.choose("algorithm", "greedy")
        self.choose("family", "uniform")
        self.assertEqual(set(self.column(1)), {"greedy"})
        self.assertEqual(set(self.column(2)), {"uniform"})
        self.value(
            "(() => { const input = document.querySelector('#runs input'); input.value = 'nothing like it';"
            " input.dispatchEvent(new Event('input')); })()"
        )
        self.assertEqual(self.column(1), [])
        self.assertIn("0 of 0 rows", self.value("document.querySelector('#runs [role=status]').textContent"))

    def test_a_verdict_leads_to_its_rows_and_their_commands(self):
        self.value(
            "(() => { const claim = document.getElementById('C1'); claim.open = true;"
            " claim.querySelector('a[data-set]').click(); })()"
        )
        self.assertEqual(self.column(1), ["greedy_naive"])
        self.assertEqual(self.column(2), ["report_example"])
        self.value("document.querySelector('#runs tbody button').click()")
        command = self.value("document.querySelector('#runs tr.command').textContent")
        self.assertIn("mwt generate report_example --n 10 --seed", command)
        self.assertIn("mwt solve points.csv --algorithm greedy_naive", command)

    def test_a_row_s_command_works(self):
        self.choose("algorithm", "flip_naive")
        self.choose("family", "uniform")
        self.value("document.querySelector('#runs tbody button').click()")
        command = self.value("document.querySelector('#runs tr.command').textContent").replace(
            "build/release/mwt", str(program())
        )
        solved = subprocess.run(["/bin/sh", "-ec", command], cwd=self.folder.name, capture_output=True, text=True)
        self.assertEqual(solved.returncode, 0, solved.stderr)
        self.assertIn("flip_naive", solved.stdout)

    def test_keyboard(self):
        self.value("document.querySelector('#C2 summary').focus()")
        self.browser.press(Keys.ENTER)
        self.assertTrue(self.value("document.getElementById('C2').open"))
        self.browser.press(Keys.TAB)
        self.assertTrue(self.value("document.getElementById('C2').contains(document.activeElement)"))

    def test_themes(self):
        paper = "getComputedStyle(document.body).backgroundColor"
        self.assertEqual(self.value(paper), "rgb(255, 255, 255)")
        self.value("document.getElementById('theme').click()")
        self.assertEqual(self.value(paper), "rgb(22, 24, 28)")
        axis = "getComputedStyle(document.querySelector('figure svg text')).fill"
        self.assertEqual(self.value(axis), "rgb(230, 231, 233)", "figures follow")

    def test_dark_mode(self):
        self.browser.show_as(1280, 900, dark=True)
        self.assertEqual(self.value("getComputedStyle(document.body).backgroundColor"), "rgb(22, 24, 28)")

    def test_nothing_is_cut_off(self):
        for width in (360, 390, 768, 1440):
            self.assert_fits(width)

    def test_axe_finds_no_violation(self):
        self.assert_accessible()


if __name__ == "__main__":
    main("THE REPORT'S PAGE")
