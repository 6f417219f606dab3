#!/usr/bin/python3
"""Tests what `mwt report --paper` writes: plots/paper_test.py MWT [--compile]

Its statistics against SciPy and NumPy on the same CSV, and that every figure is drawn. With --compile also that LaTeX accepts
figures.tex. Exit code 77 (skipped) without SciPy, or without pdflatex where it is needed.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import pandas as pd

try:
    from scipy import stats
except ImportError:
    stats = None

SKIPPED = 77
EXACT = 100  # up to so many pairs the program's p-values are exact
COMPILE = "--compile" in sys.argv


def run(*command, folder=None):
    outcome = subprocess.run([str(part) for part in command], capture_output=True, text=True, cwd=folder)
    if outcome.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))}\n{outcome.stdout[-3000:]}{outcome.stderr[-2000:]}")
    return outcome.stdout


def exact_p_value(differences):
    """Of the signed-rank test, two-sided, zeros ranked and then left out: over all signs, by convolution."""
    ranks = np.rint(2 * stats.rankdata(np.abs(differences))).astype(int)
    ranks, signs = ranks[differences != 0], np.sign(differences[differences != 0])
    counts = np.array([1.0])
    for rank in ranks:
        longer = np.zeros(len(counts) + rank)
        longer[: len(counts)] += counts / 2
        longer[rank:] += counts / 2
        counts = longer
    positive = ranks[signs > 0].sum()
    return min(1.0, 2 * min(counts[positive:].sum(), counts[: positive + 1].sum()))


def p_value(differences):
    if not differences.any():
        return 1.0
    if len(differences) > EXACT:
        return stats.wilcoxon(differences, zero_method="pratt", correction=True, method="approx").pvalue
    if differences.all() and len(set(np.abs(differences))) == len(differences) <= 50:
        return stats.wilcoxon(differences, method="exact").pvalue
    return exact_p_value(differences)


def effect(differences):
    ranks = stats.rankdata(np.abs(differences))
    positive, negative = ranks[differences > 0].sum(), ranks[differences < 0].sum()
    return (positive - negative) / (positive + negative) if positive + negative else 0.0


def holm(p_values):
    order = np.argsort(p_values, kind="stable")
    scaled = np.asarray(p_values)[order] * np.arange(len(order), 0, -1)
    adjusted = np.empty(len(order))
    adjusted[order] = np.minimum(1, np.maximum.accumulate(scaled))
    return adjusted


class Paper:
    """What --paper wrote, and the values by instance of its outcomes."""

    def __init__(self, folder):
        self.folder = folder
        self.outcomes = self.table("data/outcomes")

    def table(self, name):
        return pd.read_csv(self.folder / f"{name}.csv", dtype={"label": str, "family": str}, float_precision="round_trip")

    def values(self, column, measure):
        chosen = self.outcomes[self.outcomes[f"in_{measure}"] == 1]
        return chosen.pivot(index=["family", "n", "seed"], columns="label", values=column)

    def differences(self, measure, first, second):
        if measure == "time":
            time = np.log(self.values("time_s", "time"))
            return (time[second] - time[first]).to_numpy()
        lower, upper = self.values("alpha_lower", "gap"), self.values("alpha_upper", "gap")
        overlap = (lower[first] <= upper[second]) & (lower[second] <= upper[first])
        return np.where(overlap, 0.0, upper[second] - upper[first])


class Statistics(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        program = pathlib.Path(sys.argv[1]).resolve()
        cls.temporary = tempfile.TemporaryDirectory()
        cls.results = pathlib.Path(cls.temporary.name) / "results"
        run(program, "run", pathlib.Path(__file__).parent / "testdata" / "paper_test.toml", "--out", cls.results)
        cls.outputs = {}
        choice = pathlib.Path(cls.temporary.name) / "choice.toml"
        choice.write_text('families = ["clustered"]\nsizes = [20, 40, 60]\n')
        for name, options in {"all": [], "uniform": ["--choice", choice, "--families", "uniform"]}.items():
            out = pathlib.Path(cls.temporary.name) / name
            cls.outputs[name] = run(program, "report", cls.results, "--paper", out, *options)
        cls.papers = [Paper(pathlib.Path(cls.temporary.name) / name) for name in cls.outputs]

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def close(self, a, b, what=""):
        self.assertLessEqual(abs(a - b), 1e-9 * max(1, abs(b)), what)

    def test_pairs(self):
        for paper in self.papers:
            for measure in ("gap", "time"):
                table = paper.table(f"data/pairs_{measure}")
                expected = []
                for row in table.itertuples():
                    differences = paper.differences(measure, row.first, row.second)
                    self.assertEqual(row.instances, len(differences))
                    self.assertEqual(row.first_better, (differences > 0).sum())
                    self.assertEqual(row.equal, (differences == 0).sum())
                    expected.append(p_value(differences))
                    self.close(row.p_value, expected[-1], row)
                    self.close(row.effect, effect(differences), row)
                    means = np.add.outer(differences, differences)[np.triu_indices(len(differences))] / 2
                    self.close(row.shift, np.median(means), row)
                for value, adjusted in zip(holm(expected), table["p_adjusted"]):
                    self.close(adjusted, value)

    def test_ranks(self):
        for paper in self.papers:
            time = paper.values("time_s", "time")
            table = paper.table("data/ranks_time").set_index("label")
            friedman = stats.friedmanchisquare(*(time[label] for label in time))
            ranks = stats.rankdata(time.to_numpy(), axis=1).mean(axis=0)
            for label, rank in zip(time, ranks):
                self.close(table["mean_rank"][label], rank)
            self.close(table["friedman"].iloc[0], friedman.statistic)
            self.close(table["p_value"].iloc[0], friedman.pvalue)
            k, blocks = time.shape[1], len(time)
            quantile = stats.studentized_range.ppf(0.95, k, np.inf) / np.sqrt(2)
            self.close(table["critical_difference"].iloc[0], quantile * np.sqrt(k * (k + 1) / (6 * blocks)))

    def test_quality(self):
        for paper in self.papers:
            gaps = paper.values("gap", "gap")
            for row in paper.table("tables/quality").itertuples():
                own = gaps[row.label] if row.family == "*" else gaps[row.label].loc[row.family]
                self.assertEqual(row.instances, len(own))
                self.close(row.gap_mean, own.mean())
                self.close(row.gap_median, own.median())
                self.close(row.gap_p95, own.quantile(0.95))
                self.close(row.gap_max, own.max())
                if own.std() > 0:  # resampling error: each end within a sixth of the interval's width
                    interval = stats.bootstrap((own,), np.mean, n_resamples=4000, method="percentile", random_state=1)
                    low, high = interval.confidence_interval
                    self.assertLess(abs(row.gap_mean_lower - low), (high - low) / 6)
                    self.assertLess(abs(row.gap_mean_upper - high), (high - low) / 6)

    def test_equal_algorithms_are_not_best(self):
        """greedy_naive makes the triangulations of greedy; exact ones are better than all others."""
        table = self.papers[0].table("tables/quality")
        self.assertEqual(set(table[table["is_best"] == 1]["label"]), {"exact"})
        pair = self.papers[0].table("data/pairs_gap").set_index(["first", "second"]).loc[("greedy_naive", "greedy")]
        self.assertEqual(pair["equal"], pair["instances"])
        self.assertEqual(pair["p_adjusted"], 1)

    def test_curves(self):
        for paper in self.papers:
            gaps, times = paper.values("gap", "gap"), paper.values("time_s", "time")
            ratios = {"gap": (1 + gaps).div((1 + gaps).min(axis=1), axis=0) - 1, "time": times.div(times.min(axis=1), axis=0)}
            per_point = times.div(times.index.get_level_values("n"), axis=0)
            for name, values in {
                "profile_gap": ratios["gap"],
                "profile_time": ratios["time"],
                "distribution_gap": gaps,
                "distribution_time": per_point,
            }.items():
                column = "ratio" if name.startswith("profile") else "value"
                for label, steps in paper.table(f"data/{name}").groupby("label"):
                    for x, share in zip(steps[column], steps["share"]):
                        # Values closer than rounding errors may be counted as equal or not.
                        least, most = ((values[label] <= x * (1 + sign * 1e-12) + sign * 1e-15).mean() for sign in (-1, 1))
                        self.assertTrue(least - 1e-9 <= share <= most + 1e-9, (name, label))

    def test_growth(self):
        time = self.papers[0].values("time_s", "time")
        lines = self.papers[0].table("tables/growth")
        self.assertGreater(len(lines), 0)
        for row in lines[lines["measure"] == "time"].itertuples():
            own = time[row.label].loc[row.family]
            slope = np.polyfit(np.log(own.index.get_level_values("n").to_numpy(float)), np.log(own), 1)[0]
            self.close(row.exponent, slope, row)
        bands = self.papers[0].table("data/growth_lines")
        known = bands.dropna()
        self.assertTrue(((known["lower"] <= known["value"]) & (known["value"] <= known["upper"])).all())

    def test_figures_and_commands(self):
        for paper, output in zip(self.papers, self.outputs.values()):
            for name in ("profiles", "distributions", "trade_off", "growth", "pairs", "ranks"):
                self.assertGreater((paper.folder / "figures" / f"{name}.pdf").stat().st_size, 1000)
                self.assertIn(f"{name}.pdf", output)
            self.assertIn("mwt report ", (paper.folder / "README.md").read_text())

    def test_colours_do_not_carry_the_meaning_alone(self):
        sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
        import paper

        looks = paper.Data(self.papers[0].folder / "data").looks()
        marks = {(look["marker"], look["markerfacecolor"] == "white") for look in looks.values()}
        self.assertEqual(len(marks), len(looks))

    @unittest.skipUnless(COMPILE, "slow")
    def test_latex_accepts_the_document(self):
        for paper in self.papers:
            self.assertTrue((paper.folder / "figures" / "pairs.pgf").is_file())
            log = run("pdflatex", "-interaction=nonstopmode", "-halt-on-error", "figures.tex", folder=paper.folder)
            self.assertNotIn("is not drawn", log)
            self.assertTrue((paper.folder / "figures.pdf").is_file())


if __name__ == "__main__":
    arguments = [argument for argument in sys.argv[1:] if argument != "--compile"]
    if len(arguments) != 1:
        sys.exit("usage: paper_test.py MWT [--compile]")
    lacking = "SCIPY" if stats is None else "PDFLATEX" if COMPILE and not shutil.which("pdflatex") else None
    if lacking:
        print(f"SKIPPED: {lacking} IS MISSING, --paper WAS NOT TESTED. Install it: setup/packages_for_checks.txt")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2)
