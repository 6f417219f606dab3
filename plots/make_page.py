#!/usr/bin/python3
"""Makes the report's page: plots/make_page.py RESULTS_FOLDER [-o PAGE.html]

Reads what `mwt run` and `mwt report` wrote and, if it is there, what plots/gallery.sh did. Writes one self-contained HTML
file, by default RESULTS_FOLDER/report.html, and the figures to RESULTS_FOLDER/figures as SVG and PNG. Needs
python3-pandas and python3-matplotlib.
"""
import argparse
import os
import pathlib
import re
import tomllib

import matplotlib.pyplot as plt
import pandas as pd

import figures
from library import html_page, style
from library.html_page import escape, number
from library.records import Results

TITLE = "Minimum weight triangulation: the report’s claims, measured"
QUESTION_CLAIM, WORST_CASE_CLAIM = "C4", "C5"
BADGES = {
    "reproduced": "good",
    "holds": "good",
    "refuted": "bad",
    "refuted (better than claimed)": "bad",
    "ill-posed": "open",
    "by citation": "open",
    "undecided": "open",
}
START_FILE = re.compile(r"start=(\S+\.csv)")  # sought beside the study file
GENERATE_COMMAND = (
    "build/release/mwt generate {family} --n {n} --seed {seed}{family parameters options} -o points.csv\n"
)
SOLVE_COMMAND = (
    "build/release/mwt solve points.csv --algorithm {algorithm} --seed {seed}{parameters options} --with-optimum"
)


def badge(verdict):
    return f'<span class="badge {BADGES[verdict]}">{escape(verdict)}</span>'


def pretty(text):
    """A claim's plain text with the signs that a terminal does without."""
    text = escape(text)
    for plain, sign in (
        ("-&gt;", "→"),
        ("&gt;=", "≥"),
        ("&lt;=", "≤"),
        ("alpha", "α"),
        (" eps", " ε"),
        ("+eps", "+ε"),
        ("delta", "δ"),
        ("Omega", "Ω"),
        ("Theta", "Θ"),
        ("sqrt ", "√"),
        ("1.1-1.5", "1.1–1.5"),
        (" - ", " − "),
    ):
        text = text.replace(plain, sign)
    return re.sub(r"\^(-?[\w.]*\w)", r"<sup>\1</sup>", text)


def lead(results):
    """The first screen: the question that most readers come with."""
    claims = results.claims.set_index("claim")
    claim, worst_case = claims.loc[QUESTION_CLAIM], claims.loc[WORST_CASE_CLAIM]
    instances = results.instances
    proved = int((instances["optimality"] == "proved").sum())
    answers = {"reproduced": "Yes.", "refuted": "No:", "refuted (better than claimed)": "No, greedy is far better:"}
    return (
        '<div class="answer"><p><strong>Is greedy’s α 1.1–1.5, as the report says?</strong>'
        f' <strong>{answers.get(claim["verdict"], "Undecided:")}</strong> {pretty(claim["measured"])}.'
        f' {badge(claim["verdict"])}</p><p>On points built against it: {pretty(worst_case["measured"])}.</p></div><p'
        ' class="soft">α is the weight of a triangulation divided by the weight of a lightest one. Measured in'
        f" {len(results.runs):,} isolated runs on {len(instances):,} instances, {proved:,} of them with a proved"
        " optimum; every triangulation was checked, every verdict is computed from the records by a rule fixed"
        " beforehand.</p>"
    )


def other_machines(results):
    if results.machine_count <= 1:
        return ""
    return f": the runs are of {results.machine_count} machines, and all times shown are of one ({escape(results.machine)})"


def footer(results):
    environment = results.environments.iloc[-1]
    return (
        f'<p>Study “{escape(environment["study"])}”, {escape(environment["recorded_at"])}, commit'
        f' {escape(environment["git_commit"])}, {escape(environment["cpu_model"])}, {escape(environment["compiler"])}.'
        f" α does not depend on the machine, times do{other_machines(results)}.</p>"
    )


def claim_details(page, results, claim):
    path = results.folder / "claim_details" / f"{claim['claim']}.csv"
    if not path.is_file():
        return ""
    table = pd.read_csv(path, dtype=str).fillna("")
    columns, converted = [], {}
    for title in table.columns:
        values = pd.to_numeric(table[title].replace("", float("nan")), errors="coerce")
        is_number = values.notna().sum() == (table[title] != "").sum() and (values.abs() < 2**53).all()
        columns.append(
            {"title": title, "number": bool(is_number), "filter": 1 < table[title].nunique() <= 30 and not is_number}
        )
        converted[title] = list(table[title])  # numbers as they were written, with all their digits
    return page.data_table(
        f"details-{claim['claim']}", f"details of {claim['claim']}", columns, zip(*converted.values())
    )


def claim_html(page, results, claim, row_count):
    name = claim["claim"]
    rows = (
        f'<a href="#runs" data-table="runs-data" data-set="{name}">Show the {row_count:,} runs</a>'
        if row_count
        else "no runs"
    )
    command = (
        f'<dt>by yourself</dt><dd><pre class="copy"><code>{escape(command_line(claim["command"]))}</code></pre></dd>'
        if claim["command"]
        else ""
    )
    return (
        f'<details class="claim" id="{name}" data-verdict="{escape(claim["verdict"])}"><summary><span'
        f' class="claim-id">{name}</span><span class="statement">{pretty(claim["statement"])} <span'
        f' class="soft">(section {escape(claim["section"])})</span></span>{badge(claim["verdict"])}<span'
        f' class="measured">{pretty(claim["measured"])}</span></summary><div'
        f' class="inside"><dl><dt>rule</dt><dd>{pretty(claim["rule"])}</dd><dt>evidence</dt><dd>{pretty(claim["evidence"])}.'
        f" {rows}</dd>{command}</dl>{claim_details(page, results, claim)}</div></details>"
    )


def command_line(command):
    return command.replace("mwt ", "build/release/mwt ").replace(" && ", "\n")


def verdicts(page, results, claim_rows):
    claims = results.claims
    counts = claims["verdict"].value_counts()
    buttons = "".join(
        f'<button type="button" data-verdict="{escape(verdict)}"'
        f' aria-pressed="false">{count} {escape(verdict)}</button>'
        for verdict, count in counts.items()
    )
    counted = claim_rows["claim"].value_counts() if len(claim_rows) else {}
    return f'<div class="choices"><span class="soft">Show only:</span>{buttons}</div>' + "\n".join(
        claim_html(page, results, claim, int(counted.get(claim["claim"], 0))) for _, claim in claims.iterrows()
    )


def draw_figures(results, modules):
    """The figures that the results have something for: html, and files beside the page."""
    parts = []
    for name, module in modules.items():
        drawn = module.draw(results)
        if drawn is None:
            continue
        style.save(drawn, results.folder / "figures" / name)
        svg = style.inline_svg(style.svg_text(drawn), name, escape(module.TITLE))
        caption = module.caption(results) if hasattr(module, "caption") else module.CAPTION
        parts.append(html_page.figure(name, svg, module.TITLE, caption, drawn.get_figwidth() * 112))
        plt.close(drawn)
    return "\n".join(parts)


def summary_table(page, results):
    """alpha and time per family, algorithm and n."""
    finished = results.runs[results.runs["status"] == "ok"]
    cells = finished.groupby(["family", "label", "n"], sort=False)
    rated = results.rated.groupby(["family", "label", "n"])["alpha_upper"].agg(["count", "mean", "max"])
    p95 = results.rated.groupby(["family", "label", "n"])["alpha_upper"].quantile(0.95)
    rows = []
    for key, cell in cells:
        count, mean, largest = rated.loc[key] if key in rated.index else (0, None, None)
        rows.append(
            [
                *key,
                len(cell),
                number(1e3 * cell["wall_time_s"].median(), 3),
                int(count),
                number(mean),
                number(p95.get(key)),
                number(largest),
            ]
        )
    columns = [
        {"title": "family", "filter": True},
        {"title": "algorithm", "filter": True},
        {"title": "n", "number": True, "filter": True},
        {"title": "runs", "number": True},
        {"title": "median time in ms", "number": True},
        {"title": "rated", "number": True},
        {"title": "alpha mean", "number": True},
        {"title": "alpha p95", "number": True},
        {"title": "alpha max", "number": True},
    ]
    return page.data_table("summary-data", "alpha and time by family, algorithm and n", columns, rows)


def ranges(positions):
    """[3, 4, 5, 9] as [[3, 5], [9, 9]]."""
    result = []
    for position in sorted(positions):
        if result and result[-1][1] == position - 1:
            result[-1][1] = position
        else:
            result.append([position, position])
    return result


def instance_folder(results):
    """Where the study's point files are, for commands that are typed in the project's folder."""
    study = tomllib.loads((results.folder / "study.toml").read_text(encoding="utf-8"))
    folder = study.get("instances", {}).get("folder", ".")
    return os.path.normpath(os.path.join("harness/studies", folder)) + "/"


def runs_table(page, results, claim_rows):
    runs = results.runs.reset_index(drop=True)
    files = instance_folder(results)
    place = {run_id: position for position, run_id in enumerate(runs["run_id"])}
    sets = {
        claim: ranges(place[run_id] for run_id in group["run_id"])
        for claim, group in claim_rows.groupby("claim", sort=False)
    }
    columns = [
        {"title": "algorithm", "filter": True},
        {"title": "parameters"},
        {"title": "family", "filter": True},
        {"title": "family parameters"},
        {"title": "n", "number": True, "filter": True},
        {"title": "seed", "number": True},
        {"title": "status", "filter": True},
        {"title": "time in ms", "number": True},
        {"title": "alpha at most", "number": True},
        {"title": "optimal"},
        {"title": "weight", "number": True},
        {"title": "run"},
    ]
    rows = [
        [
            run.algorithm,
            START_FILE.sub(r"start=harness/studies/\1", run.params),
            run.generator,
            run.generator_params.replace("file=", files),
            run.n,
            run.seed,
            run.status,
            number(1e3 * run.wall_time_s, 3),
            number(run.alpha_upper, 8),
            run.optimal if isinstance(run.optimal, str) else "",
            number(run.weight_upper, 12),
            run.run_id,
        ]
        for run in runs.itertuples()
    ]
    return page.data_table(
        "runs-data",
        "all runs",
        columns,
        rows,
        sets=sets,
        sets_title="judged for claim",
        templates={
            "": GENERATE_COMMAND + SOLVE_COMMAND,
            "file": SOLVE_COMMAND.replace("points.csv", "{family parameters}"),
        },
        template_column="family",
    )


def reproduce_section(results):
    study = escape(results.environments.iloc[-1]["study"])
    return (
        "<p>On Debian 12, from a clone of the repository; everything that is needed is installed:</p><pre"
        ' class="copy"><code>./reproduce</code></pre><p>or, step by step, from the study to this page:</p><pre'
        f' class="copy"><code>build/release/mwt run {study} --out results/{study} --resume\nbuild/release/mwt report'
        f" results/{study}\nplots/gallery.sh build/release/mwt results/{study}\nplots/make_page.py"
        f" results/{study}</code></pre><p>The rows behind a verdict: <code>claim_rows.csv</code> names the ids of the"
        " runs, <code>runs.csv</code> has all their columns.</p>"
    )


def make(results):
    page = html_page.Page(TITLE, lead(results), footer(results))
    claim_rows = results.optional("claim_rows.csv")
    page.add_section("verdicts", "Verdicts", verdicts(page, results, claim_rows))
    page.add_section("figures", "Figures", draw_figures(results, figures.CHARTS))
    gallery = draw_figures(results, figures.GALLERY)
    if gallery:
        page.add_section("gallery", "Gallery", gallery)
    page.add_section(
        "tables",
        "Tables",
        "<p>α by family, algorithm and n, against proved optima: the upper ends of certified intervals.</p>"
        + summary_table(page, results),
    )
    page.add_section(
        "runs",
        "All runs",
        "<p>Every run with its own command. Choose a claim to see what it was judged by.</p>"
        + runs_table(page, results, claim_rows),
    )
    page.add_section("reproduce", "Reproduce", reproduce_section(results))
    return page.text()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", help="results folder of a study, after mwt report")
    parser.add_argument("-o", "--output", help="the page; RESULTS_FOLDER/report.html if not given")
    arguments = parser.parse_args()
    results = Results(arguments.folder)
    style.use_style()
    output = pathlib.Path(arguments.output or results.folder / "report.html")
    output.write_text(make(results), encoding="utf-8")
    print(output)


if __name__ == "__main__":
    main()
