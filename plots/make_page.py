#!/usr/bin/python3
"""Makes a study's page: plots/make_page.py RESULTS_FOLDER [-o PAGE.html]

Reads what `mwt run` and `mwt report` wrote and, if it is there, what plots/gallery.sh did. Writes one self-contained HTML
file, by default RESULTS_FOLDER/report.html, and the figures to RESULTS_FOLDER/figures as SVG and PNG. The page shows what the
study has; verdicts on the source report's claims, where the study is made for them. Needs python3-pandas and
python3-matplotlib.
"""
import argparse
import pathlib

import matplotlib.pyplot as plt

import figures
import page_claims
import page_tables
from library import html_page, style
from library.html_page import counted, escape
from library.records import Results

SUMMARY_TEXT = (
    "Cells by family, algorithm and n. α is against proved optima: the upper ends of certified intervals. Means and medians"
    " have 95% bootstrap intervals where there are at least five instances. First the usual families and the largest sizes;"
    " last what every algorithm solves optimally."
)
REPRODUCED = {"claims": "./reproduce", "claims_full": "./reproduce --full"}  # studies with a command of their own


def title(results):
    what = "the report’s claims, measured" if results.judges_claims else f"study “{results.study['name']}”"
    return f"Minimum weight triangulation: {what}"


def lead(results):
    first = page_claims.answer(results) if results.judges_claims else f"<p>{escape(results.study['summary'])}</p>"
    instances = results.instances
    proved = int((instances["optimality"] == "proved").sum())
    verdicts = ", every verdict is computed from the records by a rule fixed beforehand" if results.judges_claims else ""
    return (
        f'{first}<p class="soft">α is the weight of a triangulation divided by the weight of a lightest one. Measured in'
        f" {counted(len(results.runs), 'isolated run')} on {counted(len(instances), 'instance')}, {proved:,} of them with a"
        f" proved optimum; every triangulation was checked{verdicts}. {outcomes(results)}</p>"
    )


def outcomes(results):
    """How many runs have no full result, and why."""
    runs = results.runs
    failed = int(page_tables.is_failure(runs).sum())
    inapplicable = int((runs["status"] == "not_applicable").sum())
    stopped = int((runs["stopped_early"] == 1).sum())
    sentences = [f'<a href="#failures">{counted(failed, "run")} failed</a>' if failed else "No run failed"]
    if inapplicable:
        sentences.append(f"{inapplicable:,} were not applicable: the algorithm does not take such points, or not so many")
    if stopped:
        sentences.append(f"{stopped:,} stopped early with a valid result, which the figures leave out")
    return "; ".join(sentences) + "."


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


def draw(results, name, module, layout):
    """The figure as SVG for the page with its width in CSS pixels, None if the results have nothing for it. On the wide page
    it is also written beside the page."""
    drawn = module.draw(results, layout)
    if drawn is None:
        return None
    if not layout.is_narrow:
        style.save(drawn, results.folder / "figures" / name)
    prefix = f"{name}-narrow" if layout.is_narrow else name
    svg = style.inline_svg(style.svg_text(drawn), prefix, escape(figures.title(module, results)))
    width = drawn.get_figwidth() * 112
    plt.close(drawn)
    return svg, width


def draw_figures(results, modules):
    """The figures that the results have something for: html, and files beside the page."""
    parts = []
    for name, module in modules.items():
        wide = draw(results, name, module, style.WIDE)
        if wide is None:
            continue
        narrow = draw(results, name, module, style.NARROW)
        texts = figures.title(module, results), figures.caption(module, results)
        parts.append(html_page.figure(name, wide, narrow, *texts, is_folded=getattr(module, "IS_FOLDED", False)))
    return "\n".join(parts)


def reproduce_section(results):
    name = results.study["name"]
    folder = f"results/{name}"
    study = name if page_tables.project_study(results) else "STUDY.toml"
    whole = ""
    if page_tables.project_study(results) and name in REPRODUCED:
        whole = (
            "<p>On Debian 12, from a clone of the repository; it installs what it needs:</p><pre"
            f' class="copy"><code>{REPRODUCED[name]}</code></pre><p>or, step by step, from the study to this page:</p>'
        )
    elif study != name:
        whole = (
            f"<p>The study’s file is <code>study.toml</code> among the results, here called {study}; it belongs beside the"
            " files that it names.</p>"
        )
    claims = "The rows behind a verdict: <code>claim_rows.csv</code> names the ids of the runs. " if results.judges_claims else ""
    return (
        f'{whole}<pre class="copy"><code>build/release/mwt run {study} --out {folder} --resume\nbuild/release/mwt report'
        f" {folder}\nplots/gallery.sh build/release/mwt {folder}\nplots/make_page.py {folder}</code></pre>"
        f"<p>{claims}<code>runs.csv</code> has all columns of all runs.</p>"
    )


def add_tables(page, results, claim_rows):
    cells = page_tables.summary_table(page, results)
    if cells:
        page.add_section("tables", "Tables", f"<p>{SUMMARY_TEXT}</p>{cells}")
    failures = page_tables.failures_table(page, results)
    if failures:
        page.add_section("failures", "Failures", "<p>Every run that failed.</p>" + failures)
    choice = " Choose a claim to see what it was judged by." if results.judges_claims else ""
    page.add_section(
        "runs",
        "All runs",
        f"<p>Every run with its own command.{choice}</p>" + page_tables.runs_table(page, results, claim_rows),
    )


def make(results):
    page = html_page.Page(title(results), lead(results), footer(results))
    claim_rows = results.optional("claim_rows.csv")
    if results.judges_claims:
        page.add_section("verdicts", "Verdicts", page_claims.verdicts(page, results, claim_rows))
    for name, heading, modules in (
        ("figures", "Figures", figures.CHARTS),
        ("gallery", "Gallery", figures.GALLERY),
    ):
        drawn = draw_figures(results, modules)
        if drawn:
            page.add_section(name, heading, drawn)
    add_tables(page, results, claim_rows)
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
