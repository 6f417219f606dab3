#!/usr/bin/python3
"""Makes the dashboard of the nightly runs: plots/make_dashboard.py SERIES.json -o PAGE.html

Reads the output of `mwt history series --json` and writes one self-contained HTML file: regressions and improvements in words, then a
sparkline of every series with its steps marked. --comparison adds the outcome of `mwt compare --verdict` for the last nightly run on top,
and --state what followed from it. The page shows the environment and study of the last nightly run, or those of --environment and
--study.
"""
import argparse
import json
import os
import pathlib

from library import html_page
from library.html_page import Section

TITLE = "Minimum weight triangulation: nightly runs"
SECTIONS = [
    Section("changes", "What changed", "dashboard/changes.html"),
    Section("series", "Every series", "dashboard/series.html"),
]
KEPT_DIGITS = 7


class History:
    """One study on one machine, from the file's object."""

    def __init__(self, content, study, environment):
        last = content["nightly_runs"][-1] if content["nightly_runs"] else {"study": "", "environment": "", "machine": ""}
        self.study = study or last["study"]
        self.environment = environment or last["environment"]
        self.nightly_runs = content["nightly_runs"]
        self.own_nightly_runs = [nightly_run for nightly_run in self.nightly_runs if self.is_own(nightly_run)]
        self.changes = [change for change in content["changes"] if self.is_own(change)]
        self.series = [series for series in content["series"] if self.is_own(series)]

        self.algorithms = short_names({series["algorithm"] for series in self.series})
        self.instances = short_names({series["instance"] for series in self.series})

    def is_own(self, item):
        return item["study"] == self.study and item["environment"] == self.environment


def short_names(labels):
    """Of labels "name parameter=value ...": the name alone where no other label has it."""
    names = [label.split(" ")[0] for label in labels]
    return {label: label.split(" ")[0] if names.count(label.split(" ")[0]) == 1 else label for label in labels}


def identity(algorithm, item):
    return algorithm, item["instance"], item["n"], item["measure"]


def steps_by_series(history):
    steps = {}
    for change in history.changes:
        for step in change["steps"]:
            entry = {"nightly_run": step["nightly_run"], "before": step["before"], "after": step["after"], "worse": change["regression"]}
            steps.setdefault(identity(change["algorithm"], step), []).append(entry)
    for of_series in steps.values():
        of_series.sort(key=lambda step: step["nightly_run"])
    return steps


def series_data(history):
    """The JSON for dashboard.js; series with steps first, those with the latest before the others."""
    steps = steps_by_series(history)
    series = []
    for one in history.series:
        kept = {"algorithm": history.algorithms[one["algorithm"]], "instance": history.instances[one["instance"]]}
        kept.update({key: one[key] for key in ("n", "measure", "aspect", "unit", "nightly_runs")})
        kept["values"] = [float(f"{value:.{KEPT_DIGITS}g}") if one["aspect"] != "quality" else value for value in one["values"]]
        kept["steps"] = steps.get(identity(one["algorithm"], one), [])
        series.append(kept)
    series.sort(key=lambda one: -one["steps"][-1]["nightly_run"] if one["steps"] else 1)
    nightly_runs = [{"date": nightly_run["recorded_at"][:10], "commit": nightly_run["commit"]} for nightly_run in history.nightly_runs]
    return html_page.json_script({"nightly_runs": nightly_runs, "series": series})


def changes_of(history):
    """What templates/dashboard/changes.html shows of every change, the latest first."""
    changes = []
    for change in sorted(history.changes, key=lambda change: -change["nightly_run"]):
        kind, colour = ("regression", "bad") if change["regression"] else ("improvement", "good")
        changes.append(
            {
                "kind": kind,
                "colour": colour,
                "text": change["text"].replace(f" {kind} ", " ", 1),
                "algorithm": history.algorithms[change["algorithm"]],
                "measure": change["steps"][0]["measure"],
            }
        )
    return changes


class LastNightlyRun:
    """How the last nightly run compares with the accepted one: the outcome of `mwt compare`, and what followed in words."""

    def __init__(self, comparison, state):
        self.comparison = comparison
        self.state = state or ""
        self.outcome = comparison["outcome"] if comparison else None

    def colour(self):
        """Good only where nothing is open: `None` stands for a comparison that was not made, or failed."""
        if self.outcome == "not slower":
            return "good"
        return "bad" if self.outcome == "regression" or "failed" in self.state else "open"

    def loads(self):
        """The notes about the machine's load, which belong to a verdict."""
        parts = [self.comparison] + [self.comparison.get(part) or {} for part in ("suspected", "confirmed")]
        notes = [note for part in parts for note in part.get("notes", []) if note.startswith("load: ")]
        return list(dict.fromkeys(notes))

    def values(self, worse):
        """What the banner shows; `worse` steps of the history that stayed colour it, too."""
        return {
            "outcome": self.outcome,
            "text": self.comparison["verdict"] if self.comparison else "",
            "loads": [note[0].upper() + note[1:] for note in self.loads()] if self.comparison else [],
            "state": self.state,
            "colour": "bad" if worse else self.colour(),
        }


def make(history, last_nightly_run):
    worse = sum(change["regression"] for change in history.changes)
    values = {
        "title": TITLE,
        "sections": SECTIONS,
        "study": history.study,
        "nightly_run_count": len(history.own_nightly_runs),
        "last": history.own_nightly_runs[-1] if history.own_nightly_runs else {"machine": ""},
        "verdict": last_nightly_run.values(worse),
        "regressions": worse,
        "improvements": len(history.changes) - worse,
        "changes": changes_of(history),
        "series_data": series_data(history),
        "has_counts": any(series["aspect"] == "counts" for series in history.series),
    }
    return html_page.render("dashboard.html", values)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("series", type=pathlib.Path)
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True)
    parser.add_argument("--study")
    parser.add_argument("--environment")
    parser.add_argument("--comparison", type=pathlib.Path, help="output of mwt compare --verdict for the last nightly run; the file may be missing")
    parser.add_argument("--state", help="a sentence: what followed from the comparison")
    arguments = parser.parse_args()
    history = History(json.loads(arguments.series.read_text(encoding="utf-8")), arguments.study, arguments.environment)
    has_comparison = arguments.comparison and arguments.comparison.is_file()
    comparison = json.loads(arguments.comparison.read_text(encoding="utf-8")) if has_comparison else None
    written = arguments.output.with_name(arguments.output.name + ".new")
    written.write_text(make(history, LastNightlyRun(comparison, arguments.state)), encoding="utf-8")
    os.replace(written, arguments.output)


if __name__ == "__main__":
    main()
