#!/usr/bin/python3
"""Draws the figures of a study: plots/draw_figures.py RESULTS_FOLDER [-o FOLDER] [--only NAME,...]

Writes NAME.svg and NAME.png, by default to RESULTS_FOLDER/figures. Needs python3-pandas and python3-matplotlib.
"""
import argparse
import pathlib
import sys

import figures
from library import style
from library.records import Results


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", help="results folder of a study")
    parser.add_argument("-o", "--output", help="folder for the figures; RESULTS_FOLDER/figures if not given")
    parser.add_argument("--only", default="", help="comma-separated; of: " + ", ".join(figures.ALL))
    arguments = parser.parse_args()

    names = arguments.only.split(",") if arguments.only else list(figures.ALL)
    unknown = [name for name in names if name not in figures.ALL]
    if unknown:
        sys.exit(f"no figure {', '.join(unknown)}; there are: {', '.join(figures.ALL)}")
    results = Results(arguments.folder)
    output = pathlib.Path(arguments.output or results.folder / "figures")
    style.use_style()
    for name in names:
        figure = figures.ALL[name].draw(results, style.WIDE)
        if figure is None:
            print(f"{name}: nothing to draw in {results.folder}")
            continue
        style.save(figure, output / name)
        print(output / f"{name}.svg")


if __name__ == "__main__":
    main()
