#!/usr/bin/python3
"""Makes a study's page: plots/make_page.py RESULTS_FOLDER [-o PAGE.html]

Reads the files of `mwt run`, `mwt report` and, if present, plots/gallery.sh. Writes one self-contained HTML file, by default
RESULTS_FOLDER/report.html, and the figures to RESULTS_FOLDER/figures as SVG and PNG. The page has verdicts on the source report's
claims if the study judges them. Needs python3-pandas,
python3-matplotlib and python3-jinja2.
"""
import argparse
import pathlib

import matplotlib.pyplot as plt

import figures
import page_claims
import page_optima
import page_tables
from library import html_page, style
from library.html_page import Figure, Section
from library.records import Results

SECTIONS = [
    Section("verdicts", "Verdicts", "study/verdicts.html"),
    Section("figures", "Figures", "study/figures.html"),
    Section("explorer", "Explore", "study/explorer.html"),
    Section("gallery", "Gallery", "study/gallery.html"),
    Section("optima", "What is proved", "study/optima.html"),
    Section("tables", "Tables", "study/tables.html"),
    Section("growth", "Growth", "study/growth.html"),
    Section("failures", "Failures", "study/failures.html"),
    Section("runs", "All runs", "study/runs.html"),
    Section("reproduce", "Reproduce", "study/reproduce.html"),
]
REPRODUCED = {"claims": "./reproduce", "claims_full": "./reproduce --full"}  # studies with a command of their own


def title(results):
    what = "the source report’s claims, measured" if results.judges_claims else f"study “{results.study['name']}”"
    return f"Minimum weight triangulation: {what}"


def counts(results):
    """How many runs and instances there are, and how many runs have no full result."""
    runs, instances = results.runs, results.instances
    return {
        "runs": len(runs),
        "instances": len(instances),
        "proved": int(results.optima["proved"].sum()),
        "verified": int(results.optima["verified"].sum()),
        "refused": int(results.optima["refused"].sum()),
        "failed": int(page_tables.is_failure(runs).sum()),
        "not_applicable": int((runs["status"] == "not_applicable").sum()),
        "stopped": int((runs["stopped_early"] == 1).sum()),
    }


def draw(results, name, module, layout):
    """The figure as SVG for the page, None if the results have nothing for it. On the wide page it is also written beside the
    page."""
    drawn = module.draw(results, layout)
    if drawn is None:
        return None
    if not layout.is_narrow:
        style.save(drawn, results.folder / "figures" / name)
    prefix = f"{name}-narrow" if layout.is_narrow else name
    width = drawn.get_figwidth() * 112  # CSS pixels
    svg = style.inline_svg(style.svg_text(drawn), prefix, figures.title(module, results), width)
    plt.close(drawn)
    return svg


def draw_figures(results, modules):
    """The figures that the results have something for."""
    drawn = []
    for name, module in modules.items():
        wide = draw(results, name, module, style.WIDE)
        if wide is None:
            continue
        narrow = draw(results, name, module, style.NARROW)
        texts = figures.title(module, results), figures.caption(module, results)
        drawn.append(Figure(name, *texts, wide, narrow, getattr(module, "IS_FOLDED", False)))
    return drawn


def reproduce(results):
    """The commands from the study to this page."""
    name = results.study["name"]
    is_project_study = page_tables.project_study(results)
    return {
        "is_project_study": is_project_study,
        "command": REPRODUCED.get(name) if is_project_study else None,
        "study": name if is_project_study else "STUDY.toml",
        "folder": f"results/{name}",
    }


def timed_environment(results):
    """What ran the newest of the runs whose times are shown."""
    environments = results.environments
    timed = environments[environments["env_id"].isin(results.runs[results.runs["is_timed"] == 1]["env_id"])]
    return (timed if len(timed) else environments).iloc[-1].to_dict()


def explorer(results):
    """What figure_explorer.js needs besides the table of runs."""
    colour = {style.INK: ""}
    looks = {name: [colour.get(look[0], look[0]), *look[1:]] for name, look in style.ALGORITHMS.items()}
    values = {"looks": looks, "others": style.OTHERS, "study": results.study["name"], "folder": page_tables.FOREIGN_FOLDER}
    return html_page.json_script(values)


def tour(results):
    """The page of recorded steps that plots/gallery.sh made, empty without one. Its examples are the source report's."""
    path = results.folder / "gallery" / "tour.html"
    if not results.judges_claims or not path.is_file():
        return ""
    return path.read_text(encoding="utf-8").replace("</head>", "<style>header { display: none; } #look canvas { height: 50vh; }</style></head>", 1)


def claim_values(results, claim_rows):
    if not results.judges_claims:
        return {"question": None, "verdicts": None}
    return {
        "question": page_claims.question(results),
        "verdicts": page_claims.claims(results, claim_rows),
        "verdict_counts": page_claims.verdict_counts(results),
    }


def make(results):
    """The page's text. A section without content is left out."""
    claim_rows = results.optional("claim_rows.csv")
    values = claim_values(results, claim_rows) | {
        "title": title(results),
        "study": results.study,
        "counts": counts(results),
        "figures": draw_figures(results, figures.CHARTS),
        "gallery": draw_figures(results, figures.GALLERY),
        "tour": tour(results),
        "optima": page_optima.matrix(results),
        "tables": page_tables.summary_table(results),
        "growth": page_tables.growth_table(results),
        "failures": page_tables.failures_table(results),
        "runs": page_tables.runs_table(results, claim_rows),
        "explorer": explorer(results),
        "reproduce": reproduce(results),
        "environment": timed_environment(results),
        "untimed": int((results.runs["is_timed"] == 0).sum()),
    }
    sections = [section for section in SECTIONS if values[section.name]]
    return html_page.render("study.html", values | {"sections": sections}, {"pretty": page_claims.pretty})


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
