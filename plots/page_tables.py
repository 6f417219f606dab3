"""The tables of a study's page: cells with their intervals, failed runs, all runs."""
import os
import pathlib
import re
import shlex
import urllib.parse

import pandas as pd

from library.html_page import data_table, number
from library.records import OPTIMAL

STUDIES = "harness/studies"
START_FILE = re.compile(r"start=(\S+\.csv)")  # sought beside the study file
GENERATE_COMMAND = (
    "build/release/mwt generate {family} --n {n} --seed {seed}{family parameters options} -o points.csv\n"
)
SOLVE_COMMAND = (
    "build/release/mwt solve points.csv --algorithm {algorithm} --seed {seed}{parameters options} --with-optimum"
)


def rank_of(values):
    return {value: position for position, value in enumerate(values)}


def interval(row, name, scale=1.0, digits=6):
    """The ends of a statistic's 95% interval, empty where the statistic has none."""
    low, high = row[f"{name}_lower"], row[f"{name}_upper"]
    return "" if pd.isna(low) else f"{scale * low:.{digits}g} – {scale * high:.{digits}g}"


def sorted_cells(results):
    """The cells with runs: usual families, large sizes and small alphas first; last the families and sizes on which every
    algorithm is optimal."""
    cells = results.summary[results.summary["runs"] > 0].copy()
    worst = cells.groupby(["family", "n"])["alpha_max"].transform("max")
    cells["is_trivial"] = worst <= OPTIMAL
    cells["rank"] = cells["family"].map(rank_of(results.families))
    cells["max_first"] = -cells["n"]
    keys = ["is_trivial", "rank", "max_first", "alpha_mean", "wall_time_median_s"]
    return cells.sort_values(keys, kind="stable", na_position="last")


def summary_table(results):
    """Time, alpha and failures per family, algorithm and n; None if no cell has a run."""
    columns = [
        {"title": "family", "filter": True},
        {"title": "algorithm", "filter": True},
        {"title": "n", "number": True, "filter": True},
        {"title": "alpha mean", "number": True},
        {"title": "the mean’s 95% interval"},
        {"title": "alpha p95", "number": True},
        {"title": "alpha max", "number": True},
        {"title": "optimal in %", "number": True},
        {"title": "rated", "number": True},
        {"title": "median time in ms", "number": True},
        {"title": "the median’s 95% interval"},
        {"title": "runs", "number": True},
        {"title": "failed", "number": True},
    ]
    rows = [
        [
            cell["family"],
            cell["label"],
            cell["n"],
            number(cell["alpha_mean"]),
            interval(cell, "alpha_mean"),
            number(cell["alpha_p95"]),
            number(cell["alpha_max"]),
            number(100 * cell["optimal_share"], 3),
            cell["rated_instances"],
            number(1e3 * cell["wall_time_median_s"], 3),
            interval(cell, "wall_time_median_s", 1e3, 3),
            cell["runs"],
            cell["failures"],
        ]
        for _, cell in sorted_cells(results).iterrows()
    ]
    if not rows:
        return None
    return data_table("summary-data", "alpha and time by family, algorithm and n", *without_empty(columns, rows))


def without_empty(columns, rows):
    """The columns, and the rows' cells in them, that have a value anywhere."""
    kept = [position for position in range(len(columns)) if any(row[position] not in ("", None) for row in rows)]
    return [columns[position] for position in kept], [[row[position] for position in kept] for row in rows]


def project_study(results):
    """Whether the study is one of the project's own, as they are now."""
    path = pathlib.Path(__file__).parent.parent / STUDIES / f"{results.study['name']}.toml"
    return path.is_file() and path.read_text(encoding="utf-8") == results.study_text


def study_folder(results):
    """Where the study file is, for commands that are typed in the project's folder."""
    return STUDIES if project_study(results) else "FOLDER_OF_THE_STUDY"


def instance_folder(results):
    """Where the study's point files are, in the same way."""
    folder = results.study.get("instances", {}).get("folder", ".")
    return os.path.normpath(os.path.join(study_folder(results), folder)) + "/"


def file_path(parameters, folder):
    """The path of the file that "file=NAME" names, as a shell takes it."""
    return shlex.quote(folder + urllib.parse.unquote(parameters.removeprefix("file=")))


def sorted_runs(results):
    """Failed runs first, then usual families, large sizes, and the algorithms from the crude to the exact."""
    runs = results.runs
    keys = pd.DataFrame(
        {
            "status": ~is_failure(runs),
            "not_applicable": runs["status"] == "not_applicable",
            "family": runs["family"].map(rank_of(results.families)),
            "n": -runs["n"],
            "seed": runs["seed"],
            "label": runs["label"].map(rank_of(results.labels)),
            "repetition": runs["repetition"],
        }
    )
    return runs.loc[keys.sort_values(list(keys.columns), kind="stable").index]


def is_failure(runs):
    return ~runs["status"].isin(["ok", "not_applicable"])


def run_columns():
    """What every table of runs begins with."""
    return [
        {"title": "algorithm", "filter": True},
        {"title": "family", "filter": True},
        {"title": "n", "number": True, "filter": True},
        {"title": "seed", "number": True},
        {"title": "status", "filter": True},
    ]


def run_cells(results, run):
    return [
        run.algorithm,
        run.generator,
        run.n,
        run.seed,
        run.status,
    ]


def parameter_columns():
    """What every table of runs has too; the runs' commands are made of these."""
    return [{"title": "parameters"}, {"title": "family parameters"}]


def parameter_cells(results, run):
    return [
        START_FILE.sub(rf"start={study_folder(results)}/\1", run.params),
        file_path(run.generator_params, instance_folder(results)) if run.generator == "file" else run.generator_params,
    ]


def command_templates():
    return {
        "templates": {
            "": GENERATE_COMMAND + SOLVE_COMMAND,
            "file": SOLVE_COMMAND.replace("points.csv", "{family parameters}"),
        },
        "template_column": "family",
    }


def failures_table(results):
    """Every failed run with what is known about it; None if none failed."""
    runs = sorted_runs(results)
    failed = runs[is_failure(runs)]
    if failed.empty:
        return None
    columns = [*run_columns(), {"title": "cause"}, *parameter_columns()]
    rows = [
        [*run_cells(results, run), run.message or run.checker, *parameter_cells(results, run)]
        for run in failed.itertuples()
    ]
    return data_table("failures-data", "failed runs", *without_empty(columns, rows), **command_templates())


def ranges(positions):
    """[3, 4, 5, 9] as [[3, 5], [9, 9]]."""
    result = []
    for position in sorted(positions):
        if result and result[-1][1] == position - 1:
            result[-1][1] = position
        else:
            result.append([position, position])
    return result


def claim_sets(runs, claim_rows):
    """The rows of the table that each claim was judged by."""
    if claim_rows.empty:
        return {}
    place = rank_of(runs["run_id"])
    sets = {
        claim: ranges(place[run_id] for run_id in group["run_id"])
        for claim, group in claim_rows.groupby("claim", sort=False)
    }
    return {"sets": sets, "sets_title": "behind claim"}


def runs_table(results, claim_rows):
    runs = sorted_runs(results)
    columns = [
        *run_columns(),
        {"title": "time in ms", "number": True},
        {"title": "alpha at least", "number": True},
        {"title": "alpha at most", "number": True},
        {"title": "optimal"},
        {"title": "weight", "number": True},
        *parameter_columns(),
        {"title": "repetition", "number": True},
        {"title": "run"},
    ]
    rows = [
        [
            *run_cells(results, run),
            number(1e3 * run.wall_time_s, 3),
            number(run.alpha_lower, 8),
            number(run.alpha_upper, 8),
            run.optimal,
            number(run.weight_upper, 12),
            *parameter_cells(results, run),
            run.repetition,
            run.run_id,
        ]
        for run in runs.itertuples()
    ]
    more = claim_sets(runs, claim_rows) | command_templates()
    return data_table("runs-data", "all runs", *without_empty(columns, rows), **more)
