#!/usr/bin/python3
"""Tests the explorer's page as its readers use it: harness/explore/page_test.py MWT

Starts `mwt explore` and looks at its page in a headless Chromium. Exit code 77 (skipped) without Chromium or Selenium.
"""
import csv
import json
import pathlib
import shlex
import signal
import socket
import statistics
import struct
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "plots"))
import browser  # noqa: E402  (in plots/)
from page_testing import PageTestCase, main, program  # noqa: E402

PATIENCE_S = 60
AXE = pathlib.Path(__file__).resolve().parents[2] / "setup/axe/node_modules/axe-core/axe.min.js"
STATE = "window.explorer && {}"


class Explorer:
    """A running `mwt explore`."""

    def __init__(self, *arguments):
        command = [str(program()), "explore", *map(str, arguments)]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        self.address = self.process.stdout.readline().strip()

    def stop(self):
        self.process.terminate()
        self.process.stdout.close()
        return self.process.wait(timeout=PATIENCE_S)


def descendants(process):
    children = pathlib.Path(f"/proc/{process}/task/{process}/children").read_text().split()
    return [each for child in children for each in (int(child), *descendants(child))]


def is_alive(process):
    try:
        state = pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0]
    except FileNotFoundError:
        return False
    return state != "Z"


def long_job(address):
    """A connection whose job takes a minute."""
    host, path = address.removeprefix("http://").split("/", 1)
    algorithm = {"name": "annealing", "parameters": {"proposals": "100000000000"}}
    text = json.dumps({"job": "solve", "algorithms": [algorithm], "optimum": False, "time_limit_s": 60}).encode()
    text += b" " * (-len(text) % 8)
    points = struct.pack("<8d", 0, 0, 4, 0, 4.5, 3, 0, 3)
    body = struct.pack("<II", len(text), len(points)) + text + points
    connection = socket.create_connection(host.split(":"))
    head = f"POST /{path}job HTTP/1.1\r\nHost: {host}\r\nContent-Type: application/octet-stream\r\nContent-Length: {len(body)}\r\n\r\n"
    connection.sendall(head.encode() + body)
    return connection


class ExplorerTest(PageTestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="mwt_explorer_")
        cls.explorer = Explorer()
        cls.addClassCleanup(cls.explorer.stop)
        cls.page = cls.explorer.address
        cls.browser = cls.enterClassContext(browser.Browser())
        cls.browser.save_downloads_in(cls.folder.name)

    def setUp(self):
        super().setUp()
        self.wait_until_complete()

    def wait_for(self, expression, what=""):
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            value = self.value(STATE.format(f"({expression})"))
            if value:
                return value
            time.sleep(0.02)
        return self.fail(f"{what or expression}; status: {self.status()}")

    def wait_until_complete(self):
        self.wait_for(
            "!explorer.isLoading && explorer.solving.isIdle && explorer.shown && explorer.shown.isComplete && explorer.shown.size =="
            " explorer.points.size"
        )

    def open_view(self, view):
        self.browser.open(f"{self.explorer.address}#{view}")
        self.wait_until_complete()

    def status(self):
        return self.value("document.getElementById('status').textContent")

    def choose(self, name, value, event="change"):
        self.value(
            f"(() => {{ const input = document.getElementById({name!r}); input.value = {value!r};"
            f" input.dispatchEvent(new Event({event!r}, {{bubbles: true}})); }})()"
        )

    def generate(self, family, n, seed=1):
        """By the form, as a reader does it."""
        self.value(f"document.getElementById('family').value = {family!r}")
        self.value("document.getElementById('n').value = " + repr(str(n)))
        self.value("document.getElementById('seed').value = " + repr(str(seed)))
        self.value("document.getElementById('generate').click()")

    def coordinates(self):
        return self.value("[...explorer.points.coordinates]")

    def shown_numbers(self):
        """The bounds in the first row: weight and alpha."""
        row = "document.querySelector('#rows tr')"
        return [float(self.value(f"{row}.querySelectorAll('td')[{cell}].dataset.{end}")) for cell in (0, 1) for end in ("lower", "upper")]

    def solve(self, coordinates, *options):
        """What `mwt solve` states about these points."""
        points = pathlib.Path(self.folder.name) / "compared.csv"
        pairs = zip(coordinates[::2], coordinates[1::2])
        points.write_text("x,y\n" + "".join(f"{x!r},{y!r}\n" for x, y in pairs))
        command = [program(), "solve", points, "--json", "--with-optimum", "--no-cache", *options]
        return json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)

    def assert_equals_solve(self, algorithm="greedy"):
        solved = self.solve(self.coordinates(), "--algorithm", algorithm)
        expected = [solved[key] for key in ("weight_lower", "weight_upper", "alpha_lower", "alpha_upper")]
        self.assertEqual(self.shown_numbers(), expected)

    def on_screen(self, point):
        """Where a point is in the window."""
        return self.value(
            f"(() => {{ const box = document.getElementById('picture').getBoundingClientRect(); const c ="
            f" explorer.points.coordinates; const [x, y] = explorer.picture.toScreen(c[{2 * point}], c[{2 * point + 1}]);"
            " return [box.left + x, box.top + y]; })()"
        )

    def mouse(self, kind, x, y, pressed=True):
        self.browser.dispatch("dispatchMouseEvent", type=kind, x=x, y=y, button="left" if pressed else "none", clickCount=1)

    def drag(self, point, dx, dy, steps=5):
        x, y = self.on_screen(point)
        self.mouse("mousePressed", x, y)
        for step in range(1, steps + 1):
            self.mouse("mouseMoved", x + dx * step / steps, y + dy * step / steps)
        self.mouse("mouseReleased", x + dx, y + dy)

    def save(self, selector, name):
        """The path of the file of that name that a button saves."""
        path = pathlib.Path(self.folder.name) / name
        path.unlink(missing_ok=True)
        self.value(f"document.querySelector({selector!r}).click()")
        end = time.monotonic() + PATIENCE_S
        while not path.is_file() and time.monotonic() < end:
            time.sleep(0.05)
        return path

    def saved(self, selector, name):
        return self.save(selector, name).read_text()

    def test_numbers_are_those_of_solve(self):
        self.assert_equals_solve()
        self.assertIn("proved by exact", self.value("document.getElementById('rows').textContent"))

    def test_dragging_changes_alpha_to_what_solve_states(self):
        before = self.shown_numbers()
        self.drag(7, 60, -35)
        self.wait_until_complete()
        self.assertNotEqual(self.shown_numbers(), before)
        self.assert_equals_solve()

    def test_points_are_added_deleted_and_brought_back(self):
        x, y = self.on_screen(50)
        self.value("document.querySelector('input[value=delete]').click()")
        self.mouse("mousePressed", x, y)
        self.mouse("mouseReleased", x, y)
        self.wait_until_complete()
        self.assertEqual(len(self.coordinates()), 198)
        self.value("document.querySelector('input[value=add]').click()")
        self.mouse("mousePressed", x + 1, y + 1)
        self.mouse("mouseReleased", x + 1, y + 1)
        self.wait_until_complete()
        self.assertEqual(len(self.coordinates()), 200)
        self.assert_equals_solve()
        for _ in range(2):
            self.value("document.getElementById('undo').click()")
        self.wait_until_complete()
        self.assertEqual(len(self.coordinates()), 200)
        self.assertFalse(self.value("explorer.points.isEdited"))

    def test_touch(self):
        x, y = self.on_screen(3)
        self.browser.dispatch("dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x, "y": y}])
        self.browser.dispatch("dispatchTouchEvent", type="touchMove", touchPoints=[{"x": x + 20, "y": y + 20}])
        self.browser.dispatch("dispatchTouchEvent", type="touchMove", touchPoints=[{"x": x + 40, "y": y + 30}])
        self.browser.dispatch("dispatchTouchEvent", type="touchEnd", touchPoints=[])
        self.wait_until_complete()
        self.assertTrue(self.value("explorer.points.isEdited"))
        self.assert_equals_solve()

    def test_a_finger_needs_not_be_precise(self):
        self.browser.show_as(390, 844, dark=False)
        self.open_view("family=circle&n=12&seed=1&first=greedy&second=optimum&time_limit=10")
        x, y = self.on_screen(3)
        self.browser.dispatch("dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x + 14, "y": y - 14}])
        self.browser.dispatch("dispatchTouchEvent", type="touchMove", touchPoints=[{"x": x + 30, "y": y - 40}])
        self.browser.dispatch("dispatchTouchEvent", type="touchEnd", touchPoints=[])
        self.wait_until_complete()
        self.assertTrue(self.value("explorer.points.isEdited"))
        self.assertEqual(self.value("explorer.picture.chosen"), 3)

    def press(self, *keys):
        for key in keys:
            event = {"key": key, "text": key} if len(key) == 1 else {"key": key, "code": key}
            if key == "Tab":
                event["windowsVirtualKeyCode"] = 9
            self.browser.dispatch("dispatchKeyEvent", type="keyDown", **event)
            self.browser.dispatch("dispatchKeyEvent", type="keyUp", **event)

    def test_by_keyboard_alone(self):
        for _ in range(20):
            self.press("Tab")
            if self.value("document.activeElement.id") == "picture":
                break
        self.assertEqual(self.value("document.activeElement.id"), "picture")
        self.press("n", "n", "ArrowRight", "ArrowUp", "a", "ArrowLeft", "n", "Delete", "+", "0")
        self.wait_until_complete()
        self.assertEqual(len(self.coordinates()), 200)
        self.assertTrue(self.value("explorer.points.isEdited"))
        self.assert_equals_solve()

    def test_a_link_restores_the_view(self):
        self.choose("first", "flip")
        self.wait_until_complete()
        self.drag(7, 60, -35)
        self.wait_until_complete()
        self.value("document.getElementById('zoom-in').click()")
        self.value("document.getElementById('copy-link').click()")
        before = [self.coordinates(), self.value("explorer.picture.view"), self.shown_numbers(), self.value("[...explorer.shown.runs[0].edges]")]
        link = self.value("location.hash")
        self.open_view("family=circle&n=8&seed=1&first=greedy&second=none&time_limit=10")
        self.assertEqual(len(self.coordinates()), 16)
        self.open_view(link[1:])
        self.assertEqual(self.value("document.getElementById('first').value"), "flip")
        after = [self.coordinates(), self.value("explorer.picture.view"), self.shown_numbers(), self.value("[...explorer.shown.runs[0].edges]")]
        self.assertEqual(after, before)

    def test_the_commands_repeat_it(self):
        self.open_view("family=clustered&n=60&seed=5&first=flip&first.start=sweep&second=quadtree&time_limit=10")
        commands = self.value("document.getElementById('command').textContent")
        for command in commands.splitlines():
            words = shlex.split(command)
            subprocess.run([str(program()), *words[1:]], cwd=self.folder.name, check=True, capture_output=True)
        for slot, name in enumerate(("first.csv", "second.csv")):
            path = pathlib.Path(self.folder.name) / name
            with path.open() as file:
                triangles = [int(index) for row in csv.reader(line for line in file if line[0].isdigit()) for index in row]
            path.unlink()
            self.assertEqual(triangles, self.value(f"[...explorer.shown.runs[{slot}].triangles]"))

    def test_files_are_saved_and_opened(self):
        self.drag(7, 60, -35)
        self.wait_until_complete()
        before = self.coordinates()
        self.assertEqual(self.saved("[data-save=svg]", "triangulations.svg").count("<circle"), 100)
        self.assertEqual(len(self.saved("[data-save=first]", "first.csv").splitlines()), 2 * 100 - 2 - self.value("explorer.shown.instance.hull_size"))
        points = pathlib.Path(self.folder.name) / "again.csv"
        points.write_text(self.saved("[data-save=points]", "points.csv"))
        self.generate("circle", 9)
        self.wait_for("explorer.points.size == 9")
        self.wait_until_complete()
        self.browser.choose_file("#file", points)
        self.wait_for("explorer.points.size == 100")
        self.wait_until_complete()
        self.assertEqual(self.coordinates(), before)
        self.assert_equals_solve()

    def test_mistakes_are_told(self):
        self.generate("uniform", 10**9)
        self.wait_for("document.getElementById('status').textContent.includes('the explorer takes at most')")
        self.generate("uniform", 2)
        self.wait_for("document.getElementById('status').classList.contains('failed')")
        broken = pathlib.Path(self.folder.name) / "broken.csv"
        broken.write_text("1,2\n3,x\n")
        self.browser.choose_file("#file", broken)
        self.wait_for("document.getElementById('status').textContent.includes('broken.csv:2')")
        broken.write_text("0,0\n1e308,0\n0,1e308\n")
        self.browser.choose_file("#file", broken)
        self.wait_for("document.getElementById('status').textContent.includes('scale the points down')")
        self.generate("uniform", 50)
        self.wait_until_complete()
        self.assert_equals_solve()

    def test_dragging_in_a_thousand_points(self):
        self.open_view("family=uniform&n=1000&seed=1&first=greedy&second=optimum&time_limit=10")
        self.value("explorer.solving.latency.length = 0")
        self.drag(500, 60, -35, steps=60)
        self.wait_until_complete()
        latency = self.value("explorer.solving.latency")
        print(f"{len(latency)} triangulations while dragging in 1,000 points, median {statistics.median(latency):.0f} ms", end=" ... ")
        self.assert_equals_solve()
        self.assertLess(statistics.median(latency), 1000)  # 50 on an idle machine

    def play(self, view):
        self.open_view(view)
        self.value("document.getElementById('play').click()")
        self.wait_for("explorer.player.isOpen")

    def assert_played_to_the_shown_triangulation(self):
        self.value("explorer.player.show(explorer.player.trace.size)")
        self.assertEqual(self.value("[...explorer.player.trace.sortedEdges()]"), self.value("[...explorer.shown.runs[0].edges]"))

    def test_flips_are_played_to_the_end(self):
        self.play("family=uniform&n=60&seed=2&first=flip&first.start=sweep&second=none&time_limit=10")
        self.assertIn("shorter by", self.value("(explorer.player.step(1), document.getElementById('play-text').textContent)"))
        self.value("document.getElementById('picture').focus()")
        self.press(".", ".", ",")
        self.assertEqual(self.value("explorer.player.trace.position"), 2)
        self.assert_played_to_the_shown_triangulation()

    def test_the_stages_of_exact_end_in_its_triangulation(self):
        self.play("family=uniform&n=100&seed=1&first=exact&second=none&time_limit=10")
        names = self.value("explorer.player.trace.stages.map((stage) => stage.name)")
        self.assertEqual(names[:2] + names[-1:], ["diamond test", "LMT-skeleton", "optimum"])
        self.assert_played_to_the_shown_triangulation()
        self.value("explorer.player.show(800)")
        edge = self.value("[...explorer.player.trace.edges.values()][0]")
        history = self.value(f"explorer.player.trace.historyOf({edge['a']}, {edge['b']})")
        self.assertIn("passes the diamond test", history[0])
        self.value("document.getElementById('play-close').click()")
        self.assertFalse(self.value("explorer.player.isOpen"))

    def test_the_lesson_shows_the_worked_examples(self):
        self.value("document.getElementById('lesson').click()")
        weights = []
        for step in range(10):
            self.wait_for(f"document.getElementById('lesson-title').textContent.startsWith('{step + 1} of 10')")
            self.wait_until_complete()
            self.assertIn("checked", self.value("document.getElementById('rows').textContent"))
            self.assertNotIn("failed", self.value("document.getElementById('status').className"))
            weights.append(self.shown_numbers()[0])
            self.value("document.getElementById('lesson-next').click()")
        self.assertAlmostEqual(weights[1], 70.9586, places=4)
        self.assertAlmostEqual(weights[2], 86.5447479007, places=9)
        self.assertAlmostEqual(weights[7], 846.822, places=3)

    @unittest.skipUnless(AXE.is_file(), "axe-core is not installed: setup/ensure_axe.sh")
    def test_axe_finds_no_violation(self):
        for dark in (False, True):
            for width in (390, 1440):
                self.browser.show_as(width, 900, dark)
                self.play("family=uniform&n=40&seed=1&first=exact&second=greedy&time_limit=10")
                self.value("document.getElementById('lesson').click()")
                self.wait_until_complete()
                self.value("document.querySelectorAll('details').forEach((one) => { one.open = true; })")
                self.browser.run(AXE.read_text())
                self.browser.run("axe.run().then((found) => { window.axeFound = found.violations; })")
                self.wait_for("window.axeFound ? 'done' : ''")
                found = self.value("window.axeFound.map((one) => `${one.id}: ${one.nodes.map((node) => node.html.slice(0, 200)).join(' | ')}`)")
                self.assertEqual(found, [], f"{width} pixels, dark: {dark}")

    def test_a_hunt_finds_bad_points_and_its_command_repeats_it(self):
        self.value("document.getElementById('hunt-budget').value = '60'")
        self.value("document.getElementById('hunt-n').value = '6'")
        self.value("document.getElementById('hunt-start').click()")
        self.wait_for("explorer.points.size === 6 && document.getElementById('hunt-text').textContent.includes('worst α 1.')")
        self.value("document.getElementById('hunt-start').click()")
        command = self.wait_for("document.getElementById('hunt-command').textContent")
        self.wait_until_complete()
        self.assert_equals_solve()
        words = shlex.split(command)
        subprocess.run([str(program()), *words[1:]], cwd=self.folder.name, check=True, capture_output=True)
        lines = (pathlib.Path(self.folder.name) / "bad.txt").read_text().splitlines()
        found = [float(number) for line in lines if line[0] != "#" for number in line.split()]
        self.assertEqual(found, self.coordinates())

    def test_the_saved_proof_is_accepted(self):
        points = self.save("[data-save=points]", "points.csv")
        proof = self.save("#save-proof", "points.mwtproof")
        verifier = program().with_name("mwt_verify")
        verified = subprocess.run([verifier, points, proof], capture_output=True, text=True)
        self.assertEqual(verified.returncode, 0, verified.stdout + verified.stderr)

    def test_flat_points_can_be_stretched(self):
        self.open_view("family=greedy_corridor&n=40&seed=1&first=greedy&second=optimum&time_limit=10&stretch")
        view = self.value("explorer.picture.view")
        self.assertGreater(view["stretch"], 2)
        self.drag(7, 0, 30)
        self.wait_until_complete()
        self.assert_equals_solve()

    def play_and_compare(self, algorithm, more=""):
        self.play(f"family=lattice&n=60&seed=3&first={algorithm}{more}&second=none&time_limit=10")
        self.assert_played_to_the_shown_triangulation()

    def test_all_algorithms_with_steps_are_played_to_the_end(self):
        for algorithm in ("greedy", "greedy_naive", "hull_insertion", "patch", "quadtree", "annealing"):
            self.play_and_compare(algorithm)
        self.play("family=uniform&n=50&seed=3&first=greedy&second=none&time_limit=10")
        self.assertIn("crosses none", self.value("(explorer.player.step(1), document.getElementById('play-text').textContent)"))

    def step_texts(self, view, count):
        self.play(view + "&second=none&time_limit=10")
        return [self.value("(explorer.player.step(1), document.getElementById('play-text').textContent)") for _ in range(count)]

    def test_steps_say_what_they_do(self):
        self.assertRegex(self.step_texts("family=uniform&n=50&seed=1&first=hull_insertion", 1)[0], r"point \d+ is inserted, with 3 edges")
        self.assertRegex(self.step_texts("family=uniform&n=300&seed=1&first=patch", 1)[0], r"edges? of a patch (is|are) replaced, shorter by 0")
        cells = self.step_texts("family=uniform&n=50&seed=1&first=quadtree", 12)
        self.assertIn("a cell that is split", cells[0])
        self.assertTrue(any("a leaf and its" in text for text in cells), cells)
        self.assertEqual(self.value("explorer.picture.boxes.length"), 4 * 12)
        annealed = " ".join(self.step_texts("family=uniform&n=20&seed=1&first=annealing", 40))
        self.assertIn("longer by", annealed)
        self.assertIn("shorter by", annealed)

    def test_pointing_at_an_edge_tells_why_it_left(self):
        self.play("family=uniform&n=100&seed=1&first=exact&second=none&time_limit=10")
        stages = self.value("explorer.player.trace.stages")
        self.value(f"explorer.player.show({stages[1]['begin']})")  # the diamond test is done, the LMT-skeleton begins
        edge = self.value(
            "(() => { for (const { a, b } of explorer.player.trace.edges.values()) { const hint = explorer.player.trace.hintOf(a, b);"
            " if (hint.apexes && hint.apexes[0] >= 0 && hint.apexes[1] >= 0 && hint.inside.some((point) => point >= 0)) return [a, b]; } })()"
        )
        (ax, ay), (bx, by) = self.on_screen(edge[0]), self.on_screen(edge[1])
        self.mouse("mouseMoved", (ax + bx) / 2, (ay + by) / 2, pressed=False)
        text = self.wait_for("document.getElementById('play-edge').textContent")
        self.assertRegex(text, r"is empty, the other one holds point \d+")
        self.assertRegex(text, r"the empty triangles with \d+ and \d+ have the shorter diagonal \d+–\d+")

    def test_links_to_many_opened_points_hold_while_the_program_runs(self):
        points = pathlib.Path(self.folder.name) / "many.csv"
        points.write_text("".join(f"{(i * 7919) % 1009},{(i * i * 31 + i) % 1013}\n" for i in range(700)))
        self.browser.choose_file("#file", points)
        self.wait_for("explorer.points.size == 700")
        self.wait_until_complete()
        self.wait_for("location.hash.includes('kept=')")
        self.drag(7, 20, -15)
        self.wait_until_complete()
        self.wait_for("location.hash.includes('edits=')")
        self.assertIn("while this program runs", self.value("document.getElementById('link-note').textContent"))
        before = self.coordinates()
        link = self.value("location.hash")
        self.open_view("family=circle&n=8&seed=1&first=greedy&second=none&time_limit=10")
        self.open_view(link[1:])
        self.assertEqual(self.coordinates(), before)
        self.value("location.hash = 'kept=none&first=greedy&second=none'")
        self.wait_for("document.getElementById('status').textContent.includes('this program does not have')")
        self.browser.collect()
        self.browser.problems = [each for each in self.browser.problems if "404" not in each]  # which the browser logs

    def test_what_has_no_steps_is_told(self):
        self.value("document.getElementById('first').value = 'delaunay'")
        self.value("document.getElementById('play').click()")
        self.wait_for("document.getElementById('status').textContent.includes('delaunay has no steps')")

    def test_nothing_is_cut_off(self):
        for width in (360, 390, 768, 1440):
            self.assert_fits(width)


class OfItsOwnTest(PageTestCase):
    """With programs of their own."""

    def test_ends_with_all_that_it_started(self):
        for ending in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
            explorer = Explorer()
            with long_job(explorer.address):
                started = self.started_by(explorer.process.pid)
                explorer.process.send_signal(ending)
                self.assertEqual(explorer.process.wait(timeout=5), -ending if ending == signal.SIGKILL else 0)
                explorer.process.stdout.close()
            end = time.monotonic() + 5
            while any(is_alive(process) for process in started) and time.monotonic() < end:
                time.sleep(0.02)
            self.assertEqual([process for process in started if is_alive(process)], [], ending)

    def started_by(self, process):
        """The processes below this one, once there are three: that of the jobs, a job, its worker."""
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            all_of_them = descendants(process)
            if len(all_of_them) == 3:
                return all_of_them
            time.sleep(0.02)
        return self.fail(f"{len(all_of_them)} processes")

    def test_begins_with_the_given_file_and_ends_in_order(self):
        with tempfile.TemporaryDirectory(prefix="mwt_explorer_") as folder, browser.Browser() as page:
            points = pathlib.Path(folder) / "my points.csv"
            points.write_text("0,0\n4,0\n4,3\n0,3\n1,1\n")
            explorer = Explorer(points, "--time-limit", 5)
            page.open(explorer.address)
            end = time.monotonic() + PATIENCE_S
            while not page.value("window.explorer && explorer.shown && explorer.shown.isComplete") and time.monotonic() < end:
                time.sleep(0.05)
            self.assertEqual(page.value("explorer.points.size"), 5)
            self.assertIn("my points.csv'", page.value("document.getElementById('command').textContent"))
            self.assertIn("--time-limit 5 ", page.value("document.getElementById('command').textContent"))
            self.assertEqual(explorer.stop(), 0)

    def setUp(self):
        pass

    def tearDown(self):
        pass

    @classmethod
    def tearDownClass(cls):
        pass


if __name__ == "__main__":
    main("THE EXPLORER'S PAGE")
