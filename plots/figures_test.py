#!/usr/bin/python3
"""Tests what the figures compute before they draw: plots/figures_test.py"""
import math
import pathlib
import sys
import types
import unittest

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from figures import growth, panels, time_by_n, trade_off  # noqa: E402  (beside this file)
from library import style  # noqa: E402
from library.records import Law  # noqa: E402


def observations(alphas):
    """{label: alphas of the instances 0, 1, ...; None where it did not run}."""
    return pd.DataFrame(
        {"family": "f", "label": label, "instance_id": instance, "n": 20, "alpha_upper": alpha}
        for label, of_label in alphas.items()
        for instance, alpha in enumerate(of_label)
        if alpha is not None
    )


class SideBySide(unittest.TestCase):
    def setUp(self):
        self.figure, self.axes = plt.subplots(figsize=(3, 2))
        self.axes.set_xscale("log")
        self.axes.set_yscale("log")
        self.axes.set_xlim(10, 10000)
        self.axes.set_ylim(1e-5, 1)
        self.figure.tight_layout()

    def tearDown(self):
        plt.close(self.figure)

    def test_equal_marks_do_not_hide_each_other(self):
        placed = panels.side_by_side(self.axes, [(100, 0.1), (100, 0.1), (100, 0.1)])
        points = sorted(self.axes.transData.transform(placed)[:, 0] * 72 / self.figure.dpi)
        self.assertGreater(min(np.diff(points)), 0.99 * panels.MARK_WIDTH)
        self.assertTrue(math.isclose(placed[1][0], 100))
        self.assertEqual({y for _, y in placed}, {0.1})

    def test_marks_apart_stay_where_they_are(self):
        marks = [(100, 0.1), (100, 0.001), (1000, 0.1)]
        for (x, y), (placed_x, placed_y) in zip(marks, panels.side_by_side(self.axes, marks)):
            self.assertTrue(math.isclose(x, placed_x))
            self.assertEqual(y, placed_y)

    def test_many_marks_stay_between_their_neighbours(self):
        marks = [(100, 0.1)] * 20 + [(130, 0.1)] * 20
        placed = [x for x, _ in panels.side_by_side(self.axes, marks)]
        self.assertLess(max(placed[:20]), min(placed[20:]))


class EqualLabels(unittest.TestCase):
    def test_the_one_with_most_instances_stands_for_the_others(self):
        found = panels.equal_labels(
            observations({"report": [1.1, 1.2, 1.3, None], "fast": [1.1, 1.2, 1.3, 1.4], "other": [1.1, 1.2, 1.3, 1.5]}),
            ["report", "fast", "other"],
        )
        self.assertEqual(found, {"fast": ["report"], "other": []})

    def test_instances_of_its_own_keep_a_label_apart(self):
        found = panels.equal_labels(observations({"a": [1.1, 1.2, 1.3, None], "b": [None, 1.2, 1.3, 1.4]}), ["a", "b"])
        self.assertEqual(found, {"a": [], "b": []})


class Coincident(unittest.TestCase):
    def test_the_first_stands_for_those_with_equal_values(self):
        found = panels.coincident({"a": [1, 2], "b": [1, 3], "c": [1, 2], "d": [1, 2, 3]})
        self.assertEqual(found, {"a": ["c"], "b": [], "d": []})


def law(exponent, factor=1.0, min_n=10, max_n=1000, lower=math.nan, upper=math.nan, fits=True):
    return Law(exponent, lower, upper, factor, min_n, max_n, fits)


class Laws(unittest.TestCase):
    def test_a_legend_states_the_interval(self):
        self.assertEqual(law(1.054, lower=1.03, upper=1.07).interval(), " (1.03–1.07)")
        self.assertEqual(law(1.054).interval(), "", "every size was observed once")

    def test_a_curve_has_a_dashed_line_and_no_interval(self):
        curve = law(1.5, lower=1.4, upper=1.6, fits=False)
        self.assertEqual((curve.line_style, curve.interval()), ("--", ""))
        self.assertEqual(growth.exponent_text(curve).split(), ["e", "≈", "1.50"])


class Growth(unittest.TestCase):
    def test_no_line_falls_below_one(self):
        ends, heights = growth.line(law(0.5, factor=0.25))
        self.assertEqual(list(ends), [16, 1000])
        self.assertGreaterEqual(min(heights), 1)

    def test_a_line_spans_what_it_is_fitted_to(self):
        ends, heights = growth.line(law(1.0, min_n=20, max_n=640))
        self.assertEqual((list(ends), list(heights)), ([20, 640], [20, 640]))


class Times(unittest.TestCase):
    def results(self, *laws):
        return types.SimpleNamespace(laws={("uniform", "flip", "wall_time_s"): one for one in laws})

    def test_the_line_is_the_law_that_the_program_fitted(self):
        fitted = law(1.5)
        self.assertIs(time_by_n.law_of(self.results(fitted), "uniform", "flip"), fitted)
        self.assertIsNone(time_by_n.law_of(self.results(), "uniform", "flip"))

    def test_sizes_of_a_small_range_have_no_line(self):
        self.assertIsNone(time_by_n.law_of(self.results(law(9.3, min_n=8, max_n=13)), "uniform", "flip"))


class TradeOff(unittest.TestCase):
    def test_large_sizes_and_those_of_nearly_all_algorithms_are_compared(self):
        self.assertEqual(trade_off.sizes_of(pd.Series({20: 13, 100: 12, 1000: 12, 100000: 9, 1000000: 3})), [100000, 1000])
        self.assertEqual(trade_off.sizes_of(pd.Series({20: 2, 100: 2})), [100])


class Looks(unittest.TestCase):
    def test_algorithms_of_one_s_own_look_like_no_other(self):
        looks = [style.base_style(name)[:2] for name in ("exact", "patch", "mine", "yours", "theirs")]
        self.assertEqual(len(set(looks)), len(looks))
        self.assertEqual(style.base_style("mine")[:2], looks[2], "the same in every figure")

    def test_variants_look_different(self):
        styles = style.Styles(["patch", "patch k=10", "patch k=14"])
        fills = {styles[label]["fillstyle"] for label in ("patch", "patch k=10", "patch k=14")}
        self.assertEqual(len(fills), 3)

    def test_a_legend_has_as_many_columns_as_fit(self):
        self.assertEqual(style.legend_columns(3, ["a" * 40, "b" * 40], 8), 1)
        self.assertEqual(style.legend_columns(9, ["a", "b", "c"], 8), 3)


if __name__ == "__main__":
    unittest.main()
