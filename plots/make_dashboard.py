#!/usr/bin/python3
"""Makes the dashboard of the nightly runs: plots/make_dashboard.py SERIES.json -o PAGE.html

Reads what `mwt history series --json` wrote: regressions and improvements in words, then a sparkline of every series with its
steps marked. With --comparison, what `mwt compare --verdict` wrote of the last nightly run stands above them, and with --state what
followed from it. Writes one self-contained HTML file. Only the last nightly run's environment and study are shown, or those given
with --environment and --study.
"""
import argparse
import json
import os
import pathlib

from library import html_page
from library.html_page import escape

TITLE = "Minimum weight triangulation: night by night"
LIBRARY = pathlib.Path(html_page.__file__).parent
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
            told = {"nightly_run": step["nightly_run"], "before": step["before"], "after": step["after"], "worse": change["regression"]}
            steps.setdefault(identity(change["algorithm"], step), []).append(told)
    for told in steps.values():
        told.sort(key=lambda step: step["nightly_run"])
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
    return json.dumps({"nightly_runs": nightly_runs, "series": series}, ensure_ascii=False, separators=(",", ":")).replace("</", "<\\/")


def change_item(history, change):
    kind, badge = ("regression", "bad") if change["regression"] else ("improvement", "good")
    told = change["text"].replace(f" {kind} ", " ", 1)
    return (f'<li><span class="badge {badge}">{kind}</span><span class="told">{escape(told)}</span>'
            f'<a href="#series" data-algorithm="{escape(history.algorithms[change["algorithm"]])}" data-measure="{escape(change["steps"][0]["measure"])}">'
            "show</a></li>")


def changes_section(history):
    if not history.changes:
        return f"<p>Nothing has changed for good in {len(history.own_nightly_runs)} nightly runs.</p>"
    latest_first = sorted(history.changes, key=lambda change: -change["nightly_run"])
    return '<ul class="changes">' + "\n".join(change_item(history, change) for change in latest_first) + "</ul>"


def series_section(history):
    return ('<p class="soft">One line per algorithm, family and size, all seeds together; dashed where it stepped. relative_time is the time '
            "divided by that of CGAL’s Delaunay triangulation in the same run. Every line has a scale of its own, which need not begin at zero "
            "and leaves single spikes out: they are cut off at its ends. Point at a line, or focus it and use the arrow keys, for commit "
            "and value.</p>"
            '<div id="series-choices" class="choices"></div><div><div id="sparklines" class="sparklines"></div></div>'
            f'<script type="application/json" id="series-data">{series_data(history)}</script>'
            f"<style>{(LIBRARY / 'dashboard.css').read_text(encoding='utf-8')}</style>"
            f"<script>{(LIBRARY / 'dashboard.js').read_text(encoding='utf-8')}</script>")


def counted(count, what):
    return f"{count} {what}{'' if count == 1 else 's'}"


class LastNight:
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

    def text(self):
        if not self.comparison:
            return f"<p><strong>The last nightly run was not compared with another.</strong> {escape(self.state)}</p>"
        loads = "".join(f'<p class="soft">{escape(note[0].upper() + note[1:])}.</p>' for note in self.loads())
        return (f'<p><strong>The last nightly run: {escape(self.outcome)}.</strong> {escape(self.comparison["verdict"])}. '
                f"{escape(self.state)}</p>{loads}")


def lead(history, last_nightly_run):
    if not history.own_nightly_runs:
        return f"<p>There is no nightly run yet. {escape(last_nightly_run.state)}</p>"
    last = history.own_nightly_runs[-1]
    worse = sum(change["regression"] for change in history.changes)
    better = len(history.changes) - worse
    colour = "bad" if worse else last_nightly_run.colour()
    return (f'<div class="answer" style="border-color: var(--{colour})">{last_nightly_run.text()}'
            f'<p><strong>Steps that stayed: {counted(worse, "regression")}, {counted(better, "improvement")}</strong> '
            f'in {counted(len(history.own_nightly_runs), "nightly run")}. The last one: {escape(last["recorded_at"])}, '
            f'commit {escape(last["commit"][:10])}.</p></div>')


def footer(history):
    machine = history.own_nightly_runs[-1]["machine"] if history.own_nightly_runs else ""
    return f"<p>Study “{escape(history.study)}” on {escape(machine)}. A spike of a nightly run or two is no change; see harness/tracking/README.md.</p>"


def make(history, last_nightly_run):
    page = html_page.Page(TITLE, lead(history, last_nightly_run), footer(history))
    page.add_section("changes", "What changed", changes_section(history))
    page.add_section("series", "Every series", series_section(history))
    return page.text()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("series", type=pathlib.Path)
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True)
    parser.add_argument("--study")
    parser.add_argument("--environment")
    parser.add_argument("--comparison", type=pathlib.Path, help="of the last nightly run, by mwt compare --verdict; it may be missing")
    parser.add_argument("--state", help="what followed from the comparison, a sentence")
    arguments = parser.parse_args()
    history = History(json.loads(arguments.series.read_text(encoding="utf-8")), arguments.study, arguments.environment)
    has_comparison = arguments.comparison and arguments.comparison.is_file()
    comparison = json.loads(arguments.comparison.read_text(encoding="utf-8")) if has_comparison else None
    written = arguments.output.with_name(arguments.output.name + ".new")
    written.write_text(make(history, LastNight(comparison, arguments.state)), encoding="utf-8")
    os.replace(written, arguments.output)


if __name__ == "__main__":
    main()
