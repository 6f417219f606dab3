#!/usr/bin/python3
"""Tests what the figures compute before they draw: plots/figures_test.py"""
import math
import pathlib
import sys
import unittest

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from figures import growth, panels, time_by_n, trade_off  # noqa: E402  (beside this file)
from figures.fits import is_exponential, power_law  # noqa: E402
from library import records, style  # noqa: E402


def observations(alphas):
    """{label: alphas of the instances 0, 1, ...; None where it did not run}."""
    return pd.DataFrame(
        {"family": "f", "label": label, "instance_id": instance, "n": 20, "alpha_upper": alpha}
        for label, of_label in alphas.items()
        for instance, alpha in enumerate(of_label)
        if alpha is not None
    )


class Labels(unittest.TestCase):
    def test_a_single_configuration_has_the_bare_name(self):
        self.assertEqual(records.labels(["flip", "flip"], ["start=x", "start=x"]), ["flip", "flip"])

    def test_the_commonest_configuration_keeps_the_bare_name(self):
        found = records.labels(["flip"] * 3, ["order=a start=x", "order=a start=y", "order=a start=x"])
        self.assertEqual(found, ["flip", "flip start=y", "flip"])

    def test_equally_common_variants_all_say_what_they_are(self):
        self.assertEqual(records.labels(["patch"] * 2, ["k=6 m=1", "k=14 m=1"]), ["patch k=6", "patch k=14"])


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


class Growth(unittest.TestCase):
    def test_no_line_falls_below_one(self):
        n = np.array([20.0, 50, 100, 1000])
        alpha = pd.Series([1, 1, 1.3, 10], index=n)
        exponent, factor = power_law(n, alpha.to_numpy())
        self.assertLess(factor * 20**exponent, 1, "the law itself does")
        ends, heights = growth.line(alpha, exponent, factor)
        self.assertGreater(ends[0], 20)
        self.assertGreaterEqual(min(heights), 1 - 1e-12)

    def test_a_line_spans_what_it_is_fitted_to(self):
        n = [20, 40, 80, 160, 320, 640]
        ends, _ = growth.line(pd.Series([float(x) for x in n], index=n), 1.0, 1.0)
        self.assertEqual(list(ends), [160, 640], "the larger half of more than five sizes")


class Times(unittest.TestCase):
    def test_exponential_growth_is_told_from_a_power(self):
        n = np.array([8.0, 12, 16, 24, 32])
        self.assertTrue(is_exponential(n, 1e-6 * 2**n))
        self.assertFalse(is_exponential(n, 1e-6 * n**3))
        self.assertFalse(is_exponential(n[:3], 1e-6 * 2 ** n[:3]), "three sizes fit anything")

    def test_sizes_of_a_small_range_have_no_slope(self):
        n = [8, 9, 10, 11, 12, 13]
        self.assertIsNone(time_by_n.fitted(pd.Series([1e-3 * 3.0**x for x in n], index=n)))

    def test_a_power_is_found(self):
        n = [10, 100, 1000]
        exponent, _, sizes = time_by_n.fitted(pd.Series([1e-4 * x**1.5 for x in n], index=n))
        self.assertAlmostEqual(exponent, 1.5)
        self.assertEqual(list(sizes), n)


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
