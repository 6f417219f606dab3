#!/usr/bin/python3
"""Draws the figures of a paper: plots/draw_paper.py FOLDER [--only NAME,...]

FOLDER is what `mwt report RESULTS --paper FOLDER` wrote. Every figure becomes FOLDER/figures/NAME.pdf, and NAME.pgf, whose text
LaTeX sets in the paper's own fonts, if pdflatex is there. Needs python3-pandas and python3-matplotlib.
"""
import argparse
import pathlib
import shutil
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import paper

STYLE = {
    "pgf.texsystem": "pdflatex",
    "pgf.rcfonts": False,  # those of the document
    "pdf.fonttype": 42,
    "font.family": "serif",
    "font.serif": ["STIXGeneral"],
    "mathtext.fontset": "stix",
    "axes.formatter.use_mathtext": True,
    "font.size": 8,
    "axes.labelsize": 8,
    "axes.titlesize": 8,
    "xtick.labelsize": 7,
    "ytick.labelsize": 7,
    "legend.fontsize": 7,
    "legend.frameon": False,
    "axes.linewidth": 0.6,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#dddddd",
    "grid.linewidth": 0.4,
    "lines.linewidth": 1.1,
    "lines.markersize": 4,
    "axes.unicode_minus": False,
}


def save(draw, folder, path, ending, for_latex):
    """Draws and writes one figure, if its data are there. The same data give the same file."""
    figure = draw(paper.Data(folder, for_latex))
    if figure is None:
        return
    figure.savefig(path.with_suffix(ending), **({} if for_latex else {"metadata": {"CreationDate": None}}))
    plt.close(figure)
    print(path.with_suffix(ending))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path, help="the folder that mwt report --paper wrote")
    parser.add_argument("--only", default="", help="comma-separated; of: " + ", ".join(paper.FIGURES))
    arguments = parser.parse_args()

    names = arguments.only.split(",") if arguments.only else list(paper.FIGURES)
    unknown = [name for name in names if name not in paper.FIGURES]
    if unknown:
        sys.exit(f"no figure {', '.join(unknown)}; there are: {', '.join(paper.FIGURES)}")
    data = paper.Data(arguments.folder / "data")
    if not data.has("outcomes"):
        sys.exit(f"{data.folder / 'outcomes.csv'}: no such file; make it with: mwt report RESULTS --paper {arguments.folder}")
    (arguments.folder / "figures").mkdir(exist_ok=True)
    has_latex = shutil.which("pdflatex") is not None
    plt.rcParams.update(STYLE)
    for name in names:
        path = arguments.folder / "figures" / name
        save(paper.FIGURES[name], data.folder, path, ".pdf", for_latex=False)
        if has_latex:
            save(paper.FIGURES[name], data.folder, path, ".pgf", for_latex=True)
    if not has_latex:
        print("PDF only: PGF needs pdflatex (texlive-latex-base, texlive-pictures)", file=sys.stderr)


if __name__ == "__main__":
    main()
