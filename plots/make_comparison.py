#!/usr/bin/python3
"""Makes the page of two studies side by side: plots/make_comparison.py FOLDER

FOLDER is what `mwt report A --compare B --out FOLDER` wrote: cells.csv and plan.csv. Writes FOLDER/comparison.html, one
self-contained file. Needs python3-pandas, python3-matplotlib and python3-jinja2.
"""
import argparse
import pathlib
import sys

import matplotlib.pyplot as plt
import pandas as pd

import figures.ratios as ratios
from library import html_page, style
from library.html_page import Figure, Section, data_table, number
from library.records import USUAL_FAMILIES
from library.style import name_of

SECTIONS = [
    Section("plan", "What differs", "comparison/plan.html"),
    Section("figures", "Figures", "study/figures.html"),
    Section("cells", "Cells", "comparison/cells.html"),
]
PLAN_ROWS = ("folder", "runs", "warning")  # of plan.csv that are no differences
TEXTS = {"params": str, "generator_params": str}


def read(path, types):
    if not path.is_file():
        sys.exit(f"{path}: no such file; make it with: mwt report A --compare B --out {path.parent}")
    return pd.read_csv(path, dtype=types)


def values_of(plan, aspect):
    """[(A, B), ...]: the rows of plan.csv of that name."""
    return list(plan[plan["aspect"] == aspect][["a", "b"]].itertuples(index=False, name=None))


def interval(low, high, digits):
    return "" if pd.isna(low) else f"{low:.{digits}g} – {high:.{digits}g}"


def instances_text(cell):
    if pd.isna(cell.a_runs) or pd.isna(cell.b_runs):
        return "only B" if pd.isna(cell.a_runs) else "only A"
    most = int(max(cell.a_instances, cell.b_instances))
    return "all" if cell.common_instances == most else f"{cell.common_instances} of {most}"


def cells_table(cells):
    """The cells of both studies, in their order."""
    columns = [
        {"title": "family", "filter": True},
        {"title": "algorithm", "filter": True},
        {"title": "n", "number": True, "filter": True},
        {"title": "same instances", "filter": True},
        {"title": "time A in ms", "number": True},
        {"title": "time B in ms", "number": True},
        {"title": "B / A", "number": True},
        {"title": "the ratio’s 95% interval", "interval": True},
        {"title": "alpha A", "number": True},
        {"title": "alpha B", "number": True},
        {"title": "change of alpha", "number": True},
        {"title": "the change’s 95% interval", "interval": True},
        {"title": "failed A", "number": True},
        {"title": "failed B", "number": True},
        {"title": "runs A", "number": True, "hidden": True},
        {"title": "runs B", "number": True, "hidden": True},
    ]
    count = lambda value: None if pd.isna(value) else int(value)  # noqa: E731
    rows = [
        [
            cell.family,
            cell.label,
            cell.n,
            instances_text(cell),
            number(1e3 * cell.a_wall_time_median_s, 3),
            number(1e3 * cell.b_wall_time_median_s, 3),
            number(cell.time_ratio, 4),
            interval(cell.time_ratio_lower, cell.time_ratio_upper, 4),
            number(cell.a_alpha_mean),
            number(cell.b_alpha_mean),
            number(cell.alpha_change, 4),
            interval(cell.alpha_change_lower, cell.alpha_change_upper, 4),
            count(cell.a_failures),
            count(cell.b_failures),
            count(cell.a_runs),
            count(cell.b_runs),
        ]
        for cell in cells.itertuples()
    ]
    return data_table("cells-data", "cells of both studies", columns, rows)


def sorted_cells(cells):
    """The usual families and the large sizes first; last what one study lacks."""
    is_one_sided = cells["a_runs"].isna() | cells["b_runs"].isna()
    families = sorted(dict.fromkeys(cells["family"]), key=lambda family: name_of(family) not in USUAL_FAMILIES)
    order = {family: position for position, family in enumerate(families)}
    keys = pd.DataFrame({"one": is_one_sided, "family": cells["family"].map(order), "n": -cells["n"]})
    return cells.loc[keys.sort_values(["one", "family", "n"], kind="stable").index]


def drawn(cells):
    wide, narrow = (ratios.draw(cells, layout) for layout in (style.WIDE, style.NARROW))
    if wide is None:
        return []
    svgs = [
        style.inline_svg(style.svg_text(figure), prefix, ratios.TITLE, figure.get_figwidth() * 112)
        for figure, prefix in ((wide, "ratios"), (narrow, "ratios-narrow"))
    ]
    plt.close("all")
    return [Figure("ratios", ratios.TITLE, ratios.caption(cells), *svgs)]


def make(folder):
    plan = read(folder / "plan.csv", str).fillna("")
    cells = sorted_cells(read(folder / "cells.csv", TEXTS))
    names, counts = values_of(plan, "folder")[0], values_of(plan, "runs")[0]
    both = int((cells["a_runs"].notna() & cells["b_runs"].notna()).sum())
    values = {
        "title": "Two studies side by side",
        "names": names,
        "run_counts": counts,
        "cell_counts": {
            "both": both,
            "a": int(cells["b_runs"].isna().sum()),
            "b": int(cells["a_runs"].isna().sum()),
        },
        "plan": plan[~plan["aspect"].isin(PLAN_ROWS)].to_dict("records"),
        "warnings": [a for a, _ in values_of(plan, "warning")],
        "figures": drawn(cells),
        "cells": cells_table(cells),
    }
    sections = [section for section in SECTIONS if values[section.name] or section.name == "plan"]
    return html_page.render("comparison.html", values | {"sections": sections})


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path, help="the folder that mwt report A --compare B --out FOLDER wrote")
    folder = parser.parse_args().folder
    style.use_style()
    (folder / "comparison.html").write_text(make(folder), encoding="utf-8")
    print(folder / "comparison.html")


if __name__ == "__main__":
    main()
