#!/usr/bin/python3
"""Tests the Python module: library/python/mwt_test.py FOLDER, the folder that has the package mwt."""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import xml.etree.ElementTree

import numpy

FOLDER = sys.argv.pop(1)
sys.path.insert(0, FOLDER)
import mwt  # noqa: E402  (from the folder above)

SQUARE = [[0, 0], [1, 0], [1, 1.25], [0, 1]]


class Results(unittest.TestCase):
    def test_arrays_have_their_shapes(self):
        points = mwt.generate("uniform", 50, seed=3)
        self.assertEqual((points.shape, points.dtype), ((50, 2), numpy.float64))
        result = mwt.triangulate(points)
        self.assertEqual(result.triangles.dtype, numpy.uint32)
        self.assertEqual(result.triangles.shape[1], 3)
        edges = result.edges()
        self.assertEqual(len(points) - len(edges) + len(result.triangles), 1)  # Euler
        self.assertAlmostEqual(numpy.hypot(*(points[edges[:, 0]] - points[edges[:, 1]]).T).sum(), result.weight.upper, places=9)
        self.assertIsNone(mwt.check(points, result.triangles))
        self.assertEqual(mwt.weight(points, result.triangles), result.weight)

    def test_optima_are_proved(self):
        points = mwt.generate("clustered", 200, clusters=3)
        optimum = mwt.solve(points, threads=2)
        self.assertTrue(optimum.is_proved)
        self.assertLessEqual(optimum.optimum.upper - optimum.optimum.lower, 1e-12 * optimum.optimum.upper)
        alpha = mwt.triangulate(points, "delaunay").alpha(optimum)
        self.assertGreater(alpha.lower, 1)
        self.assertLess(alpha.upper - alpha.lower, 1e-11)
        with self.assertRaisesRegex(ValueError, "nothing is certified"):
            optimum.alpha(mwt.triangulate(points))

    def test_proofs_are_verified(self):
        points = mwt.generate("uniform", 100)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "p.mwtproof"
            mwt.solve(points, proof=file)
            proof = mwt.verify(file, points)
            self.assertTrue(proof.is_optimal)
            with self.assertRaisesRegex(ValueError, "refused: instance"):
                mwt.verify(file, points + 1)

    def test_lists_and_other_layouts_are_taken(self):
        expected = mwt.triangulate(SQUARE).weight
        as_columns = numpy.asfortranarray(SQUARE)
        twice = numpy.repeat(numpy.array(SQUARE, dtype=numpy.float32), 2, axis=0)
        for points in (numpy.array(SQUARE), as_columns, twice[::2], numpy.array(SQUARE)[::-1], twice):
            self.assertAlmostEqual(mwt.triangulate(points).weight.upper, expected.upper)
        self.assertLess(mwt.triangulate(twice).triangles.max(), 8)

    def test_parameters_and_seeds_count(self):
        points = mwt.generate("uniform", 300)
        self.assertGreaterEqual(mwt.triangulate(points, "patch", k=6).weight.upper, mwt.triangulate(points, "patch", k=14).weight.lower)
        self.assertFalse(numpy.array_equal(points, mwt.generate("uniform", 300, seed=2)))
        self.assertIn("greedy", [entry.name for entry in mwt.algorithms()])
        patch = next(entry for entry in mwt.algorithms() if entry.name == "patch")
        self.assertIn("k", [parameter.name for parameter in patch.parameters])
        self.assertIn("uniform", [entry.name for entry in mwt.families()])

    def test_time_limits_give_bounds(self):
        result = mwt.solve(mwt.generate("circle", 3000), time_limit=0.01)
        self.assertEqual(result.stop_reason, "deadline")
        self.assertLess(result.optimum.lower, result.optimum.upper)

    def test_pictures_are_svg(self):
        points = mwt.generate("uniform", 20)
        picture = xml.etree.ElementTree.fromstring(mwt.triangulate(points)._repr_svg_())
        self.assertEqual(len(picture.findall("{http://www.w3.org/2000/svg}circle")), 20)

    def test_files_are_read(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "p.csv"
            file.write_text("name,lon,lat\na,1,2\nb,3,4.5\n", encoding="utf-8")
            self.assertEqual(mwt.read_points(file, "lon,lat").tolist(), [[1, 2], [3, 4.5]])


class Mistakes(unittest.TestCase):
    def test_are_value_errors_with_the_words_of_the_program(self):
        for words, work in (
            ("unknown algorithm 'greedily'; known: ", lambda: mwt.triangulate(SQUARE, "greedily")),
            ("kk", lambda: mwt.triangulate(SQUARE, "patch", kk=3)),
            ("on one line", lambda: mwt.triangulate([[0, 0], [1, 1], [2, 2]])),
            ("shape", lambda: mwt.triangulate([1, 2, 3])),
            ("shape", lambda: mwt.triangulate(numpy.zeros((3, 3)))),
            ("finite", lambda: mwt.triangulate([[0, 0], [1, 0], [0, numpy.nan]])),
            ("facing|face each other", lambda: mwt.triangulate(mwt.generate("uniform", 30), "two_chains")),
            ("unknown generator 'uniformly'", lambda: mwt.generate("uniformly", 3)),
            ("no such file", lambda: mwt.read_points("/none.txt")),
            ("integers from 0", lambda: mwt.check(SQUARE, [[0, 1, -1]])),
            ("integers from 0", lambda: mwt.check(SQUARE, [[0, 1, 2.5]])),
            ("time_limit_s", lambda: mwt.triangulate(SQUARE, time_limit=-1)),
        ):
            with self.assertRaisesRegex(ValueError, words):
                work()
        self.assertIn("indices_in_range", mwt.check(SQUARE, [[0, 1, 9]]))


class Threads(unittest.TestCase):
    def test_the_interpreter_goes_on_meanwhile(self):
        points = mwt.generate("uniform", 100_000)
        worker = threading.Thread(target=mwt.solve, args=(points,))
        worker.start()
        steps = 0
        while worker.is_alive():
            time.sleep(0.001)
            steps += 1
        self.assertGreater(steps, 10)

    def test_ctrl_c_ends_the_computation(self):
        program = """
import mwt, resource, sys, threading, time
points = mwt.generate("circle", 9000)
print("begun", flush=True)
try:
    WORK
except KeyboardInterrupt:
    time.sleep(0.01)
    print("interrupted", threading.active_count())
used = time.process_time()
time.sleep(1)
print(time.process_time() - used)
"""
        environment = dict(os.environ, PYTHONPATH=FOLDER)
        for work in ("mwt.solve(points)", "mwt.solve(points, time_limit=3600, threads=2)", "mwt.triangulate(points, 'polygon_dp')"):
            with subprocess.Popen([sys.executable, "-c", program.replace("WORK", work)], env=environment, stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True) as python:
                self.assertEqual(python.stdout.readline(), "begun\n")
                time.sleep(1)
                begin = time.monotonic()
                python.send_signal(signal.SIGINT)
                self.assertEqual(python.stdout.readline(), "interrupted 1\n", work)
                self.assertLess(time.monotonic() - begin, 20, work)  # idle: a fraction of a second
                idle, errors = python.communicate(timeout=60)
                self.assertEqual(errors, "")
                self.assertLess(float(idle), 0.2, work)  # no thread computes on


if __name__ == "__main__":
    unittest.main(verbosity=2)
