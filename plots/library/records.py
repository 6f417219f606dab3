"""Reading a results folder (schema: results/README.md)."""
import functools
import pathlib
import sys

import pandas as pd

KNOWN_SCHEMAS = {1, 2}
TIME_COLUMNS = ["wall_time_s", "cpu_time_s", "yardstick_time_s"]
TEXT_COLUMNS = ("params", "generator_params", "message", "counters", "phases", "triangulation_count", "optimum_note")
RANDOM_FAMILIES = ("uniform", "normal", "clustered")


class Results:
    """A results folder. Tables are read when they are first asked for."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)

    def _read(self, name):
        path = self.folder / name
        if not path.is_file():
            sys.exit(f"{path}: no such file; make it with: mwt run STUDY --out {self.folder}")
        table = pd.read_csv(path, dtype={column: str for column in TEXT_COLUMNS}, low_memory=False)
        if "schema_version" in table and set(table["schema_version"]) - KNOWN_SCHEMAS:
            sys.exit(f"{path}: a schema version that this script does not know")
        for column in set(TEXT_COLUMNS) & set(table.columns):
            table[column] = table[column].fillna("")
        return table

    @functools.cached_property
    def runs(self):
        """All runs, those of other machines than `machine` without times, with a `label` per algorithm and a `family` per generator: names alone where the study has one
        configuration of it, with what tells them apart otherwise."""
        runs = self._read("runs.csv")
        elsewhere = self._machines(runs) != self.machine
        runs.loc[elsewhere, [column for column in TIME_COLUMNS if column in runs]] = float("nan")
        runs["label"] = labels(runs["algorithm"], runs["params"])
        runs["family"] = labels(runs["generator"], runs["generator_params"])
        is_file = runs["generator"] == "file"
        runs.loc[is_file, "family"] = runs.loc[is_file, "generator_params"].str.removeprefix("file=")
        return runs

    def _machines(self, runs):
        """What ran each run: processor, CPUs, memory to the gigabyte, runs side by side."""
        environments = self.environments.drop_duplicates("env_id").set_index("env_id")
        described = environments[["cpu_model", "logical_cpus", "memory_bytes", "jobs"]].copy()
        described["memory_bytes"] = (described["memory_bytes"] / 2**30).round()
        names = described.astype(str).agg(", ".join, axis=1)
        return runs["env_id"].map(names).fillna("unknown")

    @functools.cached_property
    def machine(self):
        """The machine whose times are shown: that of most successful runs, as in `mwt report`."""
        runs = self._read("runs.csv")
        counts = self._machines(runs[runs["status"] == "ok"]).value_counts()
        return min(counts[counts == counts.max()].index) if len(counts) else "unknown"

    @functools.cached_property
    def machine_count(self):
        runs = self._read("runs.csv")
        return self._machines(runs[runs["status"] == "ok"]).nunique()

    @functools.cached_property
    def rated(self):
        """The runs whose alpha is certified against a proved optimum; not those that the deadline cut short."""
        return self.runs[
            (self.runs["status"] == "ok") & (self.runs["optimality"] == "proved") & (self.runs["stopped_early"] == 0)
        ]

    @functools.cached_property
    def instances(self):
        return self._read("instances.csv")

    @functools.cached_property
    def environments(self):
        return self._read("environments.csv")

    @functools.cached_property
    def claims(self):
        return self._read("claims.csv").fillna("")

    def optional(self, name):
        """A table that may be missing: empty then."""
        path = self.folder / name
        return pd.read_csv(path) if path.is_file() else pd.DataFrame()


def labels(names, parameters):
    """A name alone where only one configuration has it; else with the parameters in which its configurations differ. The
    commonest configuration keeps the bare name."""
    configurations = pd.DataFrame({"name": names, "parameters": parameters})
    result = {}
    for name, group in configurations.groupby("name", sort=False):
        counts = group["parameters"].value_counts()
        usual = dict(part.split("=", 1) for part in counts.index[0].split() if "=" in part)
        for text in counts.index:
            values = dict(part.split("=", 1) for part in text.split() if "=" in part)
            differing = [f"{key}={value}" for key, value in values.items() if usual.get(key) != value]
            result[name, text] = " ".join([name, *differing])
    return [result[key] for key in zip(configurations["name"], configurations["parameters"])]
