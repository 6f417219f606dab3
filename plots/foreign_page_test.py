#!/usr/bin/python3
"""Tests the page of a study of one's own, with an algorithm and a family of one's own: plots/foreign_page_test.py MWT

Runs a small study, puts a copy of an algorithm under a new name, a renamed family and a failed run into its records, makes
the page and looks at it in a headless Chromium. Exit code 77 (skipped) without Chromium or
Selenium.
"""
import csv
import pathlib
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import browser  # noqa: E402  (beside this file)
from page_testing import Keys, PageTestCase, main, program, run  # noqa: E402

OWN_ALGORITHM, OWN_FAMILY = "my_heuristic", "my_family"
FAILURE = "a failure made up by the test"
ARCS = ("delaunay_arc coordinates=integer", "delaunay_arc coordinates=circle")
CHARTS = ("alpha_distribution", "alpha_by_n", "trade_off", "time_by_n")


def rewrite(path, change):
    """Replaces the rows of a CSV file by those that change(rows) returns."""
    with open(path, newline="", encoding="utf-8") as file:
        reader = csv.DictReader(file)
        rows = list(reader)
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, reader.fieldnames, lineterminator="\n")
        writer.writeheader()
        writer.writerows(change(rows))


def with_own_family(rows):
    return [dict(row, generator=OWN_FAMILY) if row["generator"] == "normal" else row for row in rows]


def with_own_algorithm_and_a_failure(rows):
    rows = with_own_family(rows)
    own = [
        dict(row, algorithm=OWN_ALGORITHM, run_id=f"own-{row['run_id']}") for row in rows if row["algorithm"] == "delaunay"
    ]
    kept = ("schema_version", "run_id", "study", "env_id", "recorded_at", "git_commit", "binary_sha256", "algorithm",
            "params", "generator", "generator_params", "n", "seed", "instance_id", "repetition", "threads", "time_limit_s",
            "memory_limit_bytes")
    failed = {column: rows[-1][column] if column in kept else "" for column in rows[-1]}
    return [*rows[:-1], dict(failed, status="crashed", message=FAILURE), *own]


class ForeignPageTest(PageTestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="mwt_page_")
        results = pathlib.Path(cls.folder.name) / "results"
        run(program(), "run", HERE / "testdata" / "foreign_study.toml", "--out", results, "--no-cache")
        rewrite(results / "runs.csv", with_own_algorithm_and_a_failure)
        rewrite(results / "instances.csv", with_own_family)
        run(program(), "report", results, "--page")
        cls.results = results
        cls.page = results / "report.html"
        cls.browser = cls.enterClassContext(browser.Browser())

    def test_nothing_is_said_about_the_report(self):
        words = ("1.1–1.5", "source report", "undecided", "Verdict", "hull insertion")
        found = self.value(f"{list(words)}.filter((words) => document.body.innerText.includes(words))")
        self.assertEqual(found, [])
        self.assertEqual(self.value("document.querySelectorAll('.answer, details.claim').length"), 0)
        self.assertIn("my_study", self.value("document.querySelector('h1').textContent"))
        self.assertIn("one of them in two variants", self.value("document.querySelector('header').textContent"))
        self.assertFalse((self.results / "claims.csv").exists())

    def figure_text(self, name, selector=""):
        text = self.value(f"document.querySelector('#figure-{name} + figure {selector}').textContent")
        return " ".join(text.split())

    def test_own_algorithm_and_variants_are_in_every_figure(self):
        for name in CHARTS:
            for kind in (".wide", ".narrow"):
                text = self.figure_text(name, kind)
                missing = [label for label in (OWN_ALGORITHM, "patch k=6", "delaunay", "quadtree") if label not in text]
                self.assertEqual(missing, [], f"{name}, {kind}")

    def test_an_optimal_variant_is_named_if_not_drawn(self):
        for name in ("alpha_distribution", "alpha_by_n"):
            self.assertTrue("patch k=14" in self.figure_text(name), name)

    def test_an_algorithm_for_special_points_has_times_too(self):
        self.assertTrue("polygon_dp on delaunay_arc" in self.figure_text("time_by_n", ".wide"))

    def test_own_family_has_a_panel(self):
        for name in ("alpha_by_n", "trade_off"):
            self.assertTrue(OWN_FAMILY in self.figure_text(name, ".wide"), name)

    def test_the_gallery_shows_the_study_s_algorithms(self):
        text = self.figure_text("same_points", ".wide")
        for label in ("delaunay", "patch k=14", "flip_naive improvement=first start=sweep"):
            self.assertTrue(f"{label}:" in text, label)
        self.assertFalse("polygon_dp" in text, "it does not take these points")
        self.assertEqual(self.value("document.querySelectorAll('#gallery figure').length"), 1, "none of the source report's")

    def test_algorithms_with_equal_alphas_are_both_named(self):
        self.assertTrue(f"delaunay = {OWN_ALGORITHM}" in self.figure_text("alpha_by_n", ".wide"))

    def test_no_panel_is_empty(self):
        self.assert_no_panel_is_empty()

    def test_marks_are_instances_not_repetitions(self):
        self.assertTrue("n = 20 to 100: 38 instances" in self.figure_text("alpha_distribution"), "3 x 5 + 3 x 5 + 2 + 3 + 3")
        marks = self.value(
            "document.querySelector('#figure-alpha_distribution + figure .wide g[id*=PathCollection_1]')"
            ".querySelectorAll('use').length"
        )
        self.assertEqual(marks, 38)

    def column(self, table, position):
        return self.texts(f"#{table} tbody tr td:nth-child({position})")

    def show_all_cells(self):
        self.value(
            "(() => { const more = [...document.querySelectorAll('#tables button')].find((one) => one.textContent ==="
            " 'show more rows'); while (!more.hidden) more.click(); })()"
        )

    def test_cells_are_sorted_by_what_matters(self):
        self.show_all_cells()
        rows = list(zip(self.column("tables", 1), (int(n) for n in self.column("tables", 3))))
        self.assertEqual(rows[0], ("uniform", 100))
        of_first_family = [n for family, n in rows if family == "uniform"]
        self.assertEqual(of_first_family, sorted(of_first_family, reverse=True))
        self.assertEqual(
            list(dict.fromkeys(family for family, _ in rows)),
            ["uniform", *ARCS, "circle", OWN_FAMILY],
            "the usual family first, the others by the largest alpha",
        )
        alphas = [float(text) for text in self.column("tables", 4)[:6]]
        self.assertEqual(alphas, sorted(alphas), "the best algorithm of a family and size first")

    def test_cells_have_intervals_and_failures(self):
        titles = self.texts("#tables th button")
        self.assertIn("failed", titles)
        self.assertIn("the mean’s 95% interval", titles)
        self.assertRegex(self.column("tables", titles.index("the mean’s 95% interval") + 1)[0], r"^1\S* – 1\S*$")
        self.show_all_cells()
        self.assertEqual(sum(int(text) for text in self.column("tables", titles.index("failed") + 1)), 1)

    def click_head(self, title):
        self.value(f"[...document.querySelectorAll('#tables th button')].find((one) => one.textContent === {title!r}).click()")

    def test_a_click_sorts_and_the_third_restores(self):
        before = self.column("tables", 1)
        for wanted in ("ascending", "descending", None):
            self.click_head("alpha mean")
            found = self.value("[...document.querySelectorAll('#tables th')].map((one) => one.getAttribute('aria-sort'))"
                               ".filter(Boolean)")
            self.assertEqual(found, [wanted] if wanted else [])
        self.assertEqual(self.column("tables", 1), before)

    def test_the_keyboard_sorts(self):
        self.value("document.querySelectorAll('#tables th button')[2].focus()")
        self.browser.press(Keys.ENTER)
        sizes = [int(text) for text in self.column("tables", 3)]
        self.assertEqual(sizes, sorted(sizes))

    def test_trivially_small_cells_come_last(self):
        self.show_all_cells()
        sizes = [int(n) for n in self.column("tables", 3)]
        self.assertEqual(set(sizes[sizes.index(10):]) - {10}, set(sizes[-3:]) - {10}, "only what is optimal everywhere with them")
        self.assertNotIn(10, sizes[:30])

    def test_columns_are_chosen(self):
        self.assertNotIn("alpha median", self.texts("#tables th button"))
        self.value("[...document.querySelectorAll('#tables .column-list label')].find((one) =>"
                   " one.textContent.trim() === 'alpha median').querySelector('input').click()")
        self.assertIn("alpha median", self.texts("#tables th button"))
        self.assertEqual(len(self.texts("#tables tbody tr:first-child td")), len(self.texts("#tables th")))

    def test_a_table_is_downloaded_as_csv(self):
        self.browser.save_downloads_in(self.folder.name)
        self.value("[...document.querySelectorAll('#tables button')].find((one) => one.textContent.includes('CSV')).click()")
        path = pathlib.Path(self.folder.name) / "summary_table.csv"
        end = time.monotonic() + 20
        while not path.is_file() and time.monotonic() < end:
            time.sleep(0.05)
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        with open(self.results / "summary.csv", newline="", encoding="utf-8") as file:
            cells = [row for row in csv.DictReader(file) if int(row["runs"])]
        self.assertEqual(len(rows), len(cells))
        self.assertEqual((rows[0]["family"], rows[0]["n"]), ("uniform", "100"))
        cell = next(one for one in cells if (one["family"], one["label"], one["n"]) ==
                    ("uniform", rows[0]["algorithm"], "100"))
        self.assertAlmostEqual(float(rows[0]["the mean’s 95% interval, lower"]), float(cell["alpha_mean_lower"]), places=5)

    def test_a_constant_series_has_no_r_squared(self):
        with open(self.results / "exponents.csv", newline="", encoding="utf-8") as file:
            laws = list(csv.DictReader(file))
        constant = {(law["family"], law["label"]) for law in laws if law["measure"] == "alpha" and not law["r_squared"]}
        self.assertIn(("uniform", "patch k=14"), constant)
        titles = self.texts("#growth th button")
        rows = self.value("[...document.querySelectorAll('#growth tbody tr')].map((row) => [...row.cells].map((cell) => cell.textContent))")
        for row in rows:
            is_constant = row[2] == "alpha" and (row[0], row[1]) in constant
            self.assertEqual(row[titles.index("R²")] == "–", is_constant, row)

    def test_coincident_series_are_named_together(self):
        for name in ("alpha_by_n", "time_by_n", "trade_off"):
            self.assertTrue(f"delaunay = {OWN_ALGORITHM}" in self.figure_text(name, ".wide").replace("\n", " "), name)

    def test_figures_take_their_statistics_from_the_program(self):
        made = self.results / "summary.csv"
        before = made.read_text(encoding="utf-8")
        rewrite(made, lambda rows: [dict(row, wall_time_median_s="123") for row in rows])
        try:
            found = subprocess.run(
                [sys.executable, "-c", "import sys; sys.path.insert(0, sys.argv[1]); from library.records import Results;"
                 " from figures import time_by_n; print(time_by_n.medians(Results(sys.argv[2]))['uniform']['delaunay'].tolist())",
                 str(HERE), str(self.results)], capture_output=True, text=True, check=True)
        finally:
            made.write_text(before, encoding="utf-8")
        self.assertEqual(set(found.stdout.strip("[]\n").split(", ")), {"123.0"})

    def test_failures_are_listed(self):
        self.assertIn("1 run failed", self.value("document.querySelector('header').textContent"))
        self.assertEqual(len(self.column("failures", 1)), 1)
        self.assertIn(FAILURE, self.value("document.querySelector('#failures tbody').textContent"))
        self.assertEqual(self.column("runs", 5)[0], "crashed", "first among all runs too")

    def test_nothing_is_cut_off(self):
        for width in (360, 390, 768, 1440):
            self.assert_fits(width)

    def test_axe_finds_no_violation(self):
        self.assert_accessible()


if __name__ == "__main__":
    main("THE PAGE OF A STUDY OF ONE'S OWN")
