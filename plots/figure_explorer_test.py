#!/usr/bin/python3
"""Tests the figure explorer of a study's page as its readers use it: plots/figure_explorer_test.py MWT

Runs a small study, makes its page and looks at it in a headless Chromium. Exit code 77 (skipped) without Chromium or
Selenium.
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import browser  # noqa: E402  (beside this file)
from page_testing import Keys, PageTestCase, main, program, run  # noqa: E402

EXPLORER = "document.querySelector('.figure-explorer').explorer"
DETAILS = "document.querySelector('.explorer-details').textContent"
MESSAGE = "document.querySelector('.explorer-message').textContent"
MANY = 100_000
PATIENCE_S = 60


class FigureExplorerTest(PageTestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="mwt_explorer_")
        cls.results = pathlib.Path(cls.folder.name) / "results"
        run(program(), "run", HERE / "testdata" / "explorer_test.toml", "--out", cls.results, "--no-cache")
        run(program(), "report", cls.results)
        run(HERE / "make_page.py", cls.results)
        cls.page = cls.results / "report.html"
        cls.csv = (cls.results / "runs.csv").read_text(encoding="utf-8")
        cls.browser = cls.enterClassContext(browser.Browser())

    def explorer(self, expression):
        return self.value(f"{EXPLORER}.{expression}")

    def status(self):
        return self.value("document.querySelector('.figure-explorer [role=status]').textContent")

    def wait_for(self, expression):
        end = time.monotonic() + PATIENCE_S
        while not self.value(expression):
            self.assertLess(time.monotonic(), end, f"{expression}; {self.value(MESSAGE)}")
            time.sleep(0.02)

    def open_file(self, text, name="runs.csv"):
        path = pathlib.Path(self.folder.name) / name
        path.write_text(text, encoding="utf-8")
        self.browser.choose_file(".figure-explorer input[type=file]", path)

    def refusal(self, text, name="runs.csv"):
        """The message about a file that the page refuses."""
        self.browser.open(self.page)
        self.open_file(text, name)
        self.wait_for(f"{MESSAGE} && !document.querySelector('.explorer-message').classList.contains('soft')")
        self.assertIn("study “explorer_test”", self.status(), "the runs from before are still there")
        return self.value(MESSAGE)

    def choose_axes(self, x, y):
        for axis, measure in (("x", x), ("y", y)):
            self.browser.run(
                f"const select = {EXPLORER}.axisChoice.{axis}.select; select.value = {measure!r};"
                " select.dispatchEvent(new Event('change'));"
            )

    def mouse(self, kind, x, y, **more):
        left, top = self.value("(() => { const box = document.querySelector('.explorer-frame canvas').getBoundingClientRect();"
                               " return [box.left, box.top]; })()")
        self.browser.dispatch("dispatchMouseEvent", type=kind, x=left + x, y=top + y, **more)

    def click(self, x, y):
        self.mouse("mousePressed", x, y, button="left", buttons=1, clickCount=1)
        self.mouse("mouseReleased", x, y, button="left", clickCount=1)

    def show_canvas(self):
        self.browser.run("document.querySelector('.explorer-frame').scrollIntoView({ block: 'center' });")

    def place_of(self, row):
        return self.value(f"[{EXPLORER}.px[{row}], {EXPLORER}.py[{row}]]")

    def test_every_run_is_a_mark(self):
        rows = list(csv.DictReader(self.csv.splitlines()))
        self.choose_axes("n", "time")
        self.assertIn(f": {len(rows)} of {len(rows)} runs shown", self.status())
        labels = self.texts(".explorer-lists fieldset:first-child label")
        names = [label.split(" (")[0].strip() for label in labels]
        self.assertEqual(names[:2] + sorted(names[2:4]) + names[4:], ["delaunay", "greedy", "patch k=14", "patch k=6", "fan_sweep"])
        axes = [title for title in self.texts(".figure-explorer select:first-of-type option")]
        for title in ("points n", "wall time in ms", "excess over the optimum in %", "memory in MiB"):
            self.assertIn(title, axes)

    def test_algorithms_and_families_are_chosen(self):
        self.value("document.querySelectorAll('.explorer-lists fieldset')[0].querySelectorAll('button')[1].click()")
        self.assertEqual(self.explorer("shown.length"), 0)
        self.value("[...document.querySelectorAll('.explorer-lists label')].find((one) =>"
                   " one.textContent.includes('greedy')).querySelector('input').click()")
        shown = self.explorer("shown.map((row) => X.text('algorithm', row))".replace("X", EXPLORER))
        self.assertEqual(set(shown), {"greedy"})
        self.value("[...document.querySelectorAll('.explorer-lists label')].find((one) =>"
                   " one.textContent.includes('uniform')).querySelector('input').click()")
        self.assertLess(self.explorer("shown.length"), len(shown))

    def test_pointing_at_a_mark_tells_its_run_and_command(self):
        self.choose_axes("n", "time")
        self.show_canvas()
        row = self.explorer("shown.find((row) => X.text('algorithm', row) === 'patch' && X.text('generator', row) === 'uniform')"
                            .replace("X", EXPLORER))
        self.mouse("mouseMoved", *self.place_of(row))
        shown = self.explorer("current")
        self.assertIn(self.explorer(f"text('variant', {shown})"), self.value(DETAILS))
        self.assertIn("mwt solve points.csv --algorithm", self.value(DETAILS))
        self.assertFalse(self.value("document.querySelector('.explorer-hint').hidden"))
        self.mouse("mouseMoved", 2, 2)
        self.assertIn("Point at a mark", self.value(DETAILS))
        self.click(*self.place_of(row))
        self.mouse("mouseMoved", 2, 2)
        self.assertIn("mwt solve", self.value(DETAILS), "a click keeps the run")

    def test_the_command_of_a_program_of_one_s_own_names_its_study(self):
        row = self.explorer("shown.find((row) => X.text('algorithm', row) === 'fan_sweep')".replace("X", EXPLORER))
        self.assertIn("--algorithm fan_sweep --commands FOLDER_OF_THE_STUDY/STUDY.toml", self.explorer(f"command({row})"))

    def test_a_command_works(self):
        row = self.explorer("shown.find((row) => X.text('variant', row) === 'patch k=6' && X.text('generator', row) ==="
                            " 'delaunay_arc')".replace("X", EXPLORER))
        command = self.explorer(f"command({row})").replace("build/release/mwt", str(program()))
        solved = subprocess.run(["/bin/sh", "-ec", command], cwd=self.folder.name, capture_output=True, text=True)
        self.assertEqual(solved.returncode, 0, solved.stderr)
        self.assertIn("patch", solved.stdout)

    def test_clicks_go_through_runs_at_one_place(self):
        self.choose_axes("n", "seed")
        self.show_canvas()
        row = self.explorer("shown[0]")
        seen = set()
        for _ in range(4):
            self.click(*self.place_of(row))
            seen.add(self.explorer("current"))
        self.assertEqual(len(seen), 4)
        self.assertIn("at this place", self.value(DETAILS))

    def test_keys(self):
        self.choose_axes("n", "time")
        self.value("document.querySelector('.explorer-frame canvas').focus()")
        self.browser.press(Keys.ARROW_RIGHT)
        first = self.explorer("current")
        self.assertGreaterEqual(first, 0)
        self.assertIn("mwt solve", self.value(DETAILS))
        self.browser.press(Keys.ARROW_RIGHT)
        self.assertNotEqual(self.explorer("current"), first)
        self.assertGreaterEqual(self.explorer(f"px[{self.explorer('current')}]"), self.explorer(f"px[{first}]"))
        everything = self.explorer("shown.length")
        for _ in range(3):
            self.browser.press("+")
        self.assertLess(self.explorer("shown.length"), everything)
        self.browser.press("0")
        self.assertEqual(self.explorer("shown.length"), everything)

    def test_a_rectangle_zooms(self):
        self.choose_axes("n", "time")
        self.show_canvas()
        everything = self.explorer("shown.length")
        width = self.explorer("width")
        self.mouse("mousePressed", width / 2, 20, button="left", buttons=1)
        self.mouse("mouseMoved", width - 40, 300, button="left", buttons=1)
        self.assertFalse(self.value("document.querySelector('.explorer-box').hidden"))
        self.mouse("mouseReleased", width - 40, 300, button="left")
        self.assertLess(self.explorer("shown.length"), everything)
        self.assertIn("outside of the part shown", self.status())
        self.value("[...document.querySelectorAll('.zoom button')].at(-1).click()")
        self.assertEqual(self.explorer("shown.length"), everything)

    def test_a_file_shows_what_the_page_shows(self):
        measures = ("n", "time", "memory", "excess", "weight", "seed")
        values = [self.explorer(f"runs.numbers.{measure}.reduce((sum, value) => sum + (value || 0), 0)") for measure in measures]
        labels = self.explorer("runs.texts.variant.values.slice().sort()")
        self.open_file(self.csv)
        self.wait_for(f"{EXPLORER}.runs.name === 'runs.csv'")
        for measure, value in zip(measures, values):
            of_file = self.explorer(f"runs.numbers.{measure}.reduce((sum, value) => sum + (value || 0), 0)")
            self.assertLess(abs(of_file - value), 1e-2 * abs(value), measure)  # the page's are rounded
        self.assertEqual(self.explorer("runs.texts.variant.values.slice().sort()"), labels)
        self.value("[...document.querySelectorAll('.figure-explorer button')].at(-1).click()")
        self.assertIn("explorer_test", self.status())

    def drop(self, text):
        self.browser.run(
            "const data = new DataTransfer(); data.items.add(new File([" + json.dumps(text) + "], 'dropped.csv'));"
            " for (const type of ['dragover', 'drop']) document.body.dispatchEvent(new DragEvent(type, { bubbles: true,"
            " cancelable: true, dataTransfer: data }));"
        )

    def test_a_file_is_dropped(self):
        lines = self.csv.splitlines()
        self.drop("\ufeff" + "\r\n".join(lines[:11]) + "\r\n")
        self.wait_for(f"{EXPLORER}.runs.name === 'dropped.csv'")
        self.assertEqual(self.explorer("runs.size"), 10)

    def test_a_line_that_is_cut_off_counts(self):
        self.open_file("\n".join(self.csv.splitlines()[:4]))
        self.wait_for(f"{EXPLORER}.runs.name === 'runs.csv'")
        self.assertEqual(self.explorer("runs.size"), 3)
        self.assertIn("last line is cut off", self.status())

    def test_other_files_are_refused_in_one_line(self):
        lines = self.csv.splitlines()
        self.assertIn("points.txt: not a runs.csv of mwt", self.refusal("0 0\n1 0\n0 1\n", "points.txt"))
        self.assertIn("not a runs.csv of mwt", self.refusal(""))
        self.assertIn("summary.csv: not a runs.csv of mwt: its first line has no column",
                      self.refusal((self.results / "summary.csv").read_text(), "summary.csv"))
        self.assertIn("no runs", self.refusal(lines[0] + "\n"))
        self.assertIn("line 2 has schema version 2; this page reads version 3", self.refusal(lines[0] + "\n2" + lines[1][1:] + "\n"))
        self.assertRegex(self.refusal("\n".join([*lines[:3], lines[3] + ",1"]) + "\n"), r"line 4 has \d+ fields, and the first line \d+")
        cells = lines[1].split(",")
        cells[lines[0].split(",").index("n")] = "many"
        self.assertIn("line 2: n is “many”, which is no number", self.refusal("\n".join([lines[0], ",".join(cells)]) + "\n"))

    def test_many_runs_are_usable(self):
        lines = self.csv.splitlines()
        rows = lines[1:]
        self.open_file("\n".join([lines[0], *(rows[i % len(rows)] for i in range(MANY))]) + "\n")
        self.wait_for(f"{EXPLORER}.runs.size === {MANY}")
        drawing = self.value(f"(() => {{ const begin = performance.now(); {EXPLORER}.draw(); return performance.now() - begin; }})()")
        pointing = self.value(
            f"(() => {{ const begin = performance.now(); for (let i = 0; i < 20; ++i) {EXPLORER}.point({EXPLORER}.near(100 + 10 * i,"
            " 200, 40)[0] ?? -1); return (performance.now() - begin) / 20; })()"
        )
        print(f"{MANY} runs: drawing {drawing:.0f} ms, pointing {pointing:.0f} ms", file=sys.stderr)
        self.assertLess(drawing, 3000)  # 130 on an idle machine
        self.assertLess(pointing, 1000)

    def test_dark_colours(self):
        self.value("document.getElementById('theme').click()")
        self.wait_for(f"{EXPLORER}.colours.ink === '#e6e7e9'")

    def test_nothing_is_cut_off(self):
        for width in (390, 768, 1440):
            self.assert_fits(width)

    def test_axe_finds_no_violation(self):
        self.assert_accessible()


if __name__ == "__main__":
    main("THE FIGURE EXPLORER")
