"""The tables of a study's page: cells with their intervals, failed runs, all runs."""
import os
import pathlib
import re
import shlex
import urllib.parse

import pandas as pd

from library.html_page import data_table, number
from library.records import OPTIMAL

SMALLEST_N = 20  # below, nearly every algorithm is optimal
MIB = 2**20
STUDIES = "harness/studies"
FOREIGN_FOLDER = "FOLDER_OF_THE_STUDY"
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


def is_minor(cells, results):
    """Whether a cell is one of those that readers look at last: trivially small ones beside larger ones, and families and sizes on
    which every algorithm is optimal."""
    small = cells["n"] < SMALLEST_N if results.summary["n"].max() >= SMALLEST_N else cells["n"] < 0
    worst = cells.groupby(["family", "n"])["alpha_max"].transform("max")
    return small | (worst <= OPTIMAL)


def sorted_cells(results):
    """The cells with runs: usual families, large sizes and small alphas first."""
    cells = results.summary[results.summary["runs"] > 0].copy()
    cells["is_minor"] = is_minor(cells, results)
    cells["rank"] = cells["family"].map(rank_of(results.families))
    cells["max_first"] = -cells["n"]
    keys = ["is_minor", "rank", "max_first", "alpha_mean", "wall_time_median_s"]
    return cells.sort_values(keys, kind="stable", na_position="last")


def summary_table(results):
    """Time, alpha, memory and failures per family, algorithm and n; None if no cell has a run."""
    columns = [
        {"title": "family", "filter": True},
        {"title": "algorithm", "filter": True},
        {"title": "n", "number": True, "filter": True},
        {"title": "alpha mean", "number": True},
        {"title": "the mean’s 95% interval", "interval": True},
        {"title": "alpha median", "number": True, "hidden": True},
        {"title": "the alpha median’s 95% interval", "interval": True, "hidden": True},
        {"title": "alpha p95", "number": True},
        {"title": "the p95’s 95% interval", "interval": True, "hidden": True},
        {"title": "alpha max", "number": True},
        {"title": "optimal in %", "number": True},
        {"title": "the share’s 95% interval", "interval": True, "hidden": True},
        {"title": "rated", "number": True},
        {"title": "median time in ms", "number": True},
        {"title": "the median’s 95% interval", "interval": True},
        {"title": "time over Delaunay’s", "number": True},
        {"title": "the ratio’s 95% interval", "interval": True, "hidden": True},
        {"title": "memory in MiB", "number": True, "hidden": True},
        {"title": "runs", "number": True},
        {"title": "failed", "number": True},
        {"title": "stopped early", "number": True},
        {"title": "not applicable", "number": True, "hidden": True},
    ]
    rows = [
        [
            cell["family"],
            cell["label"],
            cell["n"],
            number(cell["alpha_mean"]),
            interval(cell, "alpha_mean"),
            number(cell["alpha_median"]),
            interval(cell, "alpha_median"),
            number(cell["alpha_p95"]),
            interval(cell, "alpha_p95"),
            number(cell["alpha_max"]),
            number(100 * cell["optimal_share"], 3),
            interval(cell, "optimal_share", 100, 3),
            cell["rated_instances"],
            number(1e3 * cell["wall_time_median_s"], 3),
            interval(cell, "wall_time_median_s", 1e3, 3),
            number(cell["time_over_delaunay_median"], 3),
            interval(cell, "time_over_delaunay_median", 1, 3),
            number(cell["peak_rss_median_bytes"] / MIB, 3),
            cell["runs"],
            cell["failures"],
            cell["stopped_early"],
            cell["not_applicable"],
        ]
        for _, cell in sorted_cells(results).iterrows()
    ]
    if not rows:
        return None
    return data_table("summary-data", "alpha and time by family, algorithm and n", *without_empty(columns, rows))


MEASURES = {"wall_time_s": "time", "alpha": "alpha"}


def growth_table(results):
    """The power laws of exponents.csv; None if there are none. A constant series has no R²: there is no variance to explain."""
    laws = results.exponents
    if laws.empty:
        return None
    columns = [
        {"title": "family", "filter": True},
        {"title": "algorithm", "filter": True},
        {"title": "of", "filter": True},
        {"title": "exponent", "number": True},
        {"title": "95% interval", "interval": True},
        {"title": "R²", "number": True},
        {"title": "a power law"},
        {"title": "largest misfit", "number": True},
        {"title": "smallest n", "number": True},
        {"title": "largest n", "number": True},
        {"title": "sizes", "number": True, "hidden": True},
        {"title": "observations", "number": True, "hidden": True},
        {"title": "factor", "number": True, "hidden": True},
        {"title": "p of lack of fit", "number": True, "hidden": True},
    ]
    laws = laws.assign(family_rank=laws["family"].map(rank_of(results.families)), is_alpha=laws["measure"] == "alpha")
    laws = laws.sort_values(["family_rank", "is_alpha", "exponent"], kind="stable")
    rows = [
        [
            law["family"],
            law["label"],
            MEASURES[law["measure"]],
            number(settled_zero(law["exponent"]), 3),
            exponent_interval(law),
            number(law["r_squared"], 4),
            {"yes": "fits", "no": "a curve"}.get(law["fits"], ""),
            number(law["max_misfit"], 3),
            law["min_n"],
            law["max_n"],
            law["sizes"],
            law["observations"],
            number(law["factor"], 3),
            number(law["lack_of_fit_p"], 2),
        ]
        for _, law in laws.iterrows()
    ]
    return data_table("growth-data", "growth of time and alpha with n", *without_empty(columns, rows))


def settled_zero(exponent):
    """0 for what differs from it by rounding only."""
    return 0.0 if abs(exponent) < 5e-4 else exponent


def exponent_interval(law):
    low, high = law["exponent_lower"], law["exponent_upper"]
    return "" if pd.isna(low) else f"{settled_zero(low):.3f} – {settled_zero(high):.3f}"


def without_empty(columns, rows):
    """The columns, and the rows' cells in them, that have a value anywhere; R² stays where every series is constant."""
    kept = [
        position
        for position in range(len(columns))
        if columns[position]["title"] == "R²" or any(row[position] not in ("", None) for row in rows)
    ]
    return [columns[position] for position in kept], [[row[position] for position in kept] for row in rows]


def project_file(results):
    """Where a study of the project of this name would be."""
    return pathlib.Path(__file__).parent.parent / STUDIES / f"{results.study['name']}.toml"


def project_study(results):
    """Whether the study is one of the project's own, as they are now."""
    path = project_file(results)
    return path.is_file() and path.read_text(encoding="utf-8") == results.study_text


def study_folder(results):
    """Where the study file is, for commands that are typed in the project's folder."""
    return STUDIES if project_study(results) else FOREIGN_FOLDER


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


def command_options(results):
    """{name of a program of one's own: what `mwt solve` needs to run it}."""
    entries = [entry for entry in results.study.get("algorithms", []) if isinstance(entry, dict) and "command" in entry]
    name = f"{results.study['name']}.toml" if project_study(results) else "STUDY.toml"
    return {entry["name"]: f" --commands {study_folder(results)}/{name}" for entry in entries}


def command_templates(results):
    return {
        "algorithm_options": command_options(results),
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
    return data_table("failures-data", "failed runs", *without_empty(columns, rows), **command_templates(results))


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
        {"title": "CPU time in ms", "number": True, "hidden": True},
        {"title": "memory in MiB", "number": True, "hidden": True},
        {"title": "time over Delaunay’s", "number": True, "hidden": True},
        *parameter_columns(),
        {"title": "variant", "hidden": True},
        {"title": "points", "hidden": True},
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
            number(1e3 * run.cpu_time_s, 3),
            number(run.peak_rss_bytes / MIB, 3),
            number(run.wall_time_s / run.delaunay_time_s, 3),
            *parameter_cells(results, run),
            run.label,
            run.family,
            run.repetition,
            run.run_id,
        ]
        for run in runs.itertuples()
    ]
    more = claim_sets(runs, claim_rows) | command_templates(results)
    return data_table("runs-data", "all runs", *without_empty(columns, rows), **more)
