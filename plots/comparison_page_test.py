#!/usr/bin/python3
"""Tests the page of two studies side by side: plots/comparison_page_test.py MWT

Runs two small studies, lets mwt report --compare make their page and looks at it in a headless Chromium. Exit code 77
(skipped) without Chromium or Selenium.
"""
import csv
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import browser  # noqa: E402  (beside this file)
from page_testing import PageTestCase, main, program, run  # noqa: E402

STUDY = """name = "{name}"
summary = "One of two"
families = ["uniform", "{family}"]
sizes = [20, {size}]
seeds = [1, 2, 3, 4, 5]
algorithms = ["delaunay", "greedy", {algorithm}]
min_time_s = 0.0001

[optimum]
sources = ["exact"]
"""


class ComparisonPageTest(PageTestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="mwt_comparison_")
        home = pathlib.Path(cls.folder.name)
        for name, family, size, algorithm in (("first", "clustered", 50, '"flip"'), ("second", "normal", 40, '"quadtree"')):
            study = home / f"{name}.toml"
            study.write_text(STUDY.format(name=name, family=family, size=size, algorithm=algorithm))
            run(program(), "run", study, "--out", home / name, "--no-cache")
        cls.command = [program(), "report", home / "first", "--compare", home / "second"]
        run(*cls.command, "--out", home / "both")
        cls.home = home
        cls.page = home / "both" / "comparison.html"
        cls.browser = cls.enterClassContext(browser.Browser())

    def test_what_differs_is_named(self):
        rows = dict(zip(self.texts("#plan tbody th"), self.texts("#plan tbody tr")))
        self.assertEqual(rows["study"], "studyfirstsecond")
        self.assertEqual(rows["families"], "familiesclusterednormal")
        self.assertEqual(rows["sizes"], "sizes5040")
        self.assertEqual(rows["algorithms"], "algorithmsflipquadtree")
        self.assertNotIn("seeds", rows)
        self.assertNotIn("program", rows)

    def test_cells_of_both_come_first_with_ratios(self):
        cells = list(csv.DictReader((self.home / "both" / "cells.csv").read_text(encoding="utf-8").splitlines()))
        both = [cell for cell in cells if cell["a_runs"] and cell["b_runs"]]
        self.assertEqual({(cell["family"], cell["label"], cell["n"]) for cell in both},
                         {("uniform", "delaunay", "20"), ("uniform", "greedy", "20")})
        for cell in both:
            self.assertEqual((cell["common_instances"], float(cell["alpha_change"])), ("5", 0))
            self.assertLessEqual(float(cell["time_ratio_lower"]), float(cell["time_ratio"]))
        self.assertEqual(self.texts("#cells tbody tr:nth-child(-n+2) td:nth-child(4)"), ["all", "all"])
        self.assertEqual(self.texts("#cells tbody tr:nth-child(3) td:nth-child(4)"), ["only A"])
        self.assertEqual(len(self.texts("#cells tbody tr")), len(cells))
        self.assertIn("2 cells", self.value("document.querySelector('header').textContent"))

    def test_there_is_a_figure(self):
        self.assert_no_panel_is_empty()

    def test_the_text_has_the_same(self):
        text = subprocess.run([str(part) for part in self.command], capture_output=True, text=True, check=True).stdout
        self.assertIn("algorithms  flip       quadtree", text)
        self.assertIn("B / A", text)
        self.assertIn("only A", text)

    def test_mistakes_are_one_line(self):
        for more, words in ((["--tables", "t.txt"], "without --paper, --tables and --page"), (["--families", "uniform"], "--paper")):
            made = subprocess.run([str(part) for part in [*self.command, *more]], capture_output=True, text=True)
            self.assertEqual((made.returncode, len(made.stderr.splitlines())), (2, 1), made.stderr)
            self.assertIn(words, made.stderr)
        alone = subprocess.run([str(program()), "report", str(self.home / "first"), "--out", "x"], capture_output=True, text=True)
        self.assertEqual(alone.returncode, 2)
        self.assertIn("--compare", alone.stderr)

    def test_nothing_is_cut_off(self):
        for width in (390, 768, 1440):
            self.assert_fits(width)

    def test_axe_finds_no_violation(self):
        self.assert_accessible()


if __name__ == "__main__":
    main("THE PAGE OF TWO STUDIES")
