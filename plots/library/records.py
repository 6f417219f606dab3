"""Reading a results folder (schema: results/README.md)."""
import dataclasses
import functools
import math
import pathlib
import sys
import tomllib

import pandas as pd

from library.style import name_of, report_first

KNOWN_SCHEMAS = {3}
TEXT_COLUMNS = (
    "params",
    "generator_params",
    "message",
    "checker",
    "counters",
    "phases",
    "triangulation_count",
    "optimum_note",
    "optimal",
)
NUMBER_COLUMNS = (
    "alpha_lower",
    "alpha_upper",
    "weight_upper",
    "wall_time_s",
    "cpu_time_s",
    "delaunay_time_s",
    "peak_rss_bytes",
    "stopped_early",
    "alpha_mean",
    "alpha_median",
    "alpha_max",
    "wall_time_median_s",
    "r_squared",
)
NEWEST_COLUMNS = {"summary.csv": ("stopped_early",), "ratings.csv": ("is_timed",)}
TIME_COLUMNS = ("wall_time_s", "cpu_time_s", "delaunay_time_s")
CELL = ["family", "label", "n"]
USUAL_FAMILIES = ("uniform", "normal", "clustered")  # what readers look for first, where a study has it
OPTIMAL = 1 + 1e-9  # an alpha up to here is drawn and counted as optimal


@dataclasses.dataclass(frozen=True)
class Law:
    """A row of exponents.csv: factor n^exponent, with the exponent's 95% interval, NaN where it has none."""

    exponent: float
    lower: float
    upper: float
    factor: float
    min_n: int
    max_n: int
    fits: bool  # false: the values lie on a curve, and the exponent is its mean slope

    def at(self, n):
        return self.factor * n**self.exponent

    def interval(self):
        """ " (1.03–1.07)" for a legend, empty of a curve."""
        has_interval = self.fits and not math.isnan(self.lower)
        return f" ({self.lower:.2f}–{self.upper:.2f})" if has_interval else ""

    @property
    def line_style(self):
        return "-" if self.fits else "--"


class Results:
    """A results folder after `mwt report`. Tables are read when they are first used."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)

    def _read(self, name, maker="mwt run STUDY --out"):
        path = self.folder / name
        if not path.is_file():
            sys.exit(f"{path}: no such file; make it with: {maker} {self.folder}")
        table = pd.read_csv(path, dtype={column: str for column in TEXT_COLUMNS}, low_memory=False)
        missing = [column for column in NEWEST_COLUMNS.get(name, ()) if column not in table]
        if missing:
            sys.exit(f"{path}: written by an older mwt, without {missing[0]}; make it anew with: {maker} {self.folder}")
        if "schema_version" in table and set(table["schema_version"]) - KNOWN_SCHEMAS:
            sys.exit(f"{path}: a schema version that this script cannot read")
        for column in set(TEXT_COLUMNS) & set(table.columns):
            table[column] = table[column].fillna("")
        for column in set(NUMBER_COLUMNS) & set(table.columns):
            table[column] = table[column].astype(float)  # also where every field is empty
        return table

    @functools.cached_property
    def runs(self):
        """All runs, rated by the tightest bounds in the records, without the times that the report leaves out (of other machines),
        with the `label` of their algorithm and the `family` of their points as in summary.csv."""
        runs = self._read("runs.csv")
        for name, keys in (("label", ["algorithm", "params"]), ("family", ["generator", "generator_params"])):
            known = self.summary.drop_duplicates(keys).set_index(keys)[name]
            runs[name] = known.loc[list(zip(*(runs[key] for key in keys)))].to_numpy()
        ratings = self._read("ratings.csv", "mwt report").set_index("run_id")
        of_runs = ratings.reindex(runs["run_id"])
        for column in ("optimality", "alpha_lower", "alpha_upper", "optimal", "is_timed"):
            runs[column] = of_runs[column].to_numpy()
        runs["optimal"] = runs["optimal"].fillna("")
        runs.loc[runs["is_timed"] == 0, [column for column in TIME_COLUMNS if column in runs]] = float("nan")
        return runs

    @functools.cached_property
    def cells(self):
        """The cells of summary.csv with runs that are ok, none of which stopped early: time and alpha of those that did are of the
        limit."""
        return self.summary[(self.summary["instances"] > 0) & (self.summary["stopped_early"] == 0)]

    @functools.cached_property
    def rated_cells(self):
        """Those of them with alphas against proved optima."""
        return self.cells[self.cells["rated_instances"] > 0]

    @functools.cached_property
    def observations(self):
        """One row per algorithm and instance of these cells: medians over the repetitions."""
        observations = self._read("observations.csv", "mwt report")
        keys = pd.MultiIndex.from_frame(observations[CELL])
        is_drawn = keys.isin(pd.MultiIndex.from_frame(self.rated_cells[CELL])) & observations["alpha_upper"].notna()
        return observations[is_drawn]

    @functools.cached_property
    def families(self):
        """The families, those that readers look for first: the usual random ones, then the others by the largest alpha."""
        worst = self.rated_cells.groupby("family")["alpha_max"].max()
        usual = {family: position for position, family in enumerate(USUAL_FAMILIES)}
        present = dict.fromkeys(self.runs["family"])
        return sorted(present, key=lambda family: (usual.get(name_of(family), len(usual)), -worst.get(family, 0)))

    @functools.cached_property
    def labels(self):
        """The algorithms and their variants, from the crude to the exact, unknown ones after them."""
        return report_first(set(self.runs["label"]))

    @functools.cached_property
    def summary(self):
        return self._read("summary.csv", "mwt report")

    @functools.cached_property
    def optima(self):
        """What is proved, one row per family and n."""
        return self._read("optima.csv", "mwt report")

    @functools.cached_property
    def exponents(self):
        """The power laws that `mwt report` fitted, one row per family, algorithm and measure."""
        return self._read("exponents.csv", "mwt report")

    @functools.cached_property
    def laws(self):
        """{(family, label, measure): Law}, as `mwt report` fitted them; measures are "wall_time_s" and "alpha". Without the
        series in which a run stopped early: its time and alpha are those of the limit."""
        stopped = self.summary[self.summary["stopped_early"] > 0]
        without_law = set(zip(stopped["family"], stopped["label"]))
        return {
            (row.family, row.label, row.measure): Law(
                row.exponent, row.exponent_lower, row.exponent_upper, row.factor, row.min_n, row.max_n, row.fits != "no"
            )
            for row in self.exponents.itertuples()
            if (row.family, row.label) not in without_law
        }

    @functools.cached_property
    def instances(self):
        return self._read("instances.csv")

    @functools.cached_property
    def environments(self):
        return self._read("environments.csv")

    @functools.cached_property
    def study_text(self):
        return (self.folder / "study.toml").read_text(encoding="utf-8")

    @functools.cached_property
    def study(self):
        """The study file's content."""
        return tomllib.loads(self.study_text)

    @functools.cached_property
    def judges_claims(self):
        """Whether `mwt report` judged the source report's claims by this study: it does so where the study is made for it."""
        return (self.folder / "claims.csv").is_file()

    @functools.cached_property
    def claims(self):
        return self._read("claims.csv").fillna("")

    def optional(self, name):
        """A table that may be missing: empty then."""
        path = self.folder / name
        return pd.read_csv(path) if path.is_file() else pd.DataFrame()

