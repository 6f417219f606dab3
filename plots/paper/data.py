"""The CSV files, and what all figures share: a look per algorithm, the width of the page, a legend below."""
import pathlib

import matplotlib.pyplot as plt
import pandas as pd

from library.style import INK, base_style, name_of

WIDTH = 6.69  # inches: the text of A4 with margins of 2 cm
DASHES = ["-", (0, (5, 1.5)), (0, (1, 1)), (0, (5, 1, 1, 1)), (0, (8, 2)), (0, (3, 1, 1, 1, 1, 1))]
MARKERS = ["o", "s", "^", "v", "D", "P", "X", "*", "<", ">", "p", "h"]
NAMES = ("label", "family", "first", "second")
LATEX = str.maketrans(
    {character: "\\" + character for character in "_#$%&{}"}
    | {"\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}", "<": "$<$", ">": "$>$"}
)
LABEL_WIDTH = 0.056  # inches of a character in a legend, with what stands beside it below
HANDLE_WIDTH = 0.55


class Data:
    """`for_latex`: LaTeX sets the names of algorithms and families, so its special characters are escaped."""

    def __init__(self, folder, for_latex=False):
        self.folder = pathlib.Path(folder)
        self.for_latex = for_latex

    def has(self, name):
        return (self.folder / f"{name}.csv").is_file()

    def table(self, name):
        table = pd.read_csv(self.folder / f"{name}.csv", dtype={column: str for column in NAMES})
        for column in set(NAMES) & set(table.columns):
            table[column] = table[column].map(self.shown)
        return table

    def shown(self, name):
        return name.translate(LATEX) if self.for_latex else name

    def measures(self, name):
        """Those that have this table, in the order in which they are drawn."""
        return [measure for measure in ("gap", "time") if self.has(f"{name}_{measure}")]

    def looks(self):
        """{label: look}: colours as everywhere (Okabe and Ito's), but every algorithm has a marker and a dash of its own, so that
        a print in grey tells them apart."""
        plain = pd.read_csv(self.folder / "outcomes.csv", dtype=str)["label"]
        looks, taken = {}, set()
        for position, label in enumerate(dict.fromkeys(plain)):
            colour, wish, filled = base_style(name_of(label))
            free = [marker for marker in (wish, *MARKERS) if (marker, filled) not in taken] or [wish]
            taken.add((free[0], filled))
            looks[self.shown(label)] = {
                "color": colour if colour != INK else "black",
                "marker": free[0],
                "markerfacecolor": colour if filled else "white",
                "markeredgecolor": colour,
                "markeredgewidth": 0.8,
                "linestyle": DASHES[position % len(DASHES)],
            }
        return looks


def mark(look):
    return dict(look, linestyle="")


def panel_height(labels):
    """Inches: low where a few algorithms leave much room, higher for many."""
    return min(2.1, 1.45 + 0.1 * max(0, len(set(labels)) - 4))


def panels(count, height, rows=1):
    figure, axes = plt.subplots(rows, -(-count // rows), figsize=(WIDTH, height * rows), squeeze=False)
    return figure, list(axes.flat)


def legend_below(figure, looks, labels, room=0):
    """One legend for all panels; `room` inches more for what stands between."""
    longest = max(len(label) for label in labels)
    columns = max(1, min(len(labels), int(WIDTH / (HANDLE_WIDTH + LABEL_WIDTH * longest))))
    rows = -(-len(labels) // columns)
    height = 0.06 + 0.15 * rows + room
    figure.set_figheight(figure.get_figheight() + height)
    handles = [plt.Line2D([], [], label=label, **looks[label]) for label in labels]
    figure.legend(handles=handles, loc="lower center", ncol=columns, handlelength=2.8, columnspacing=1.2)
    figure.tight_layout(rect=(0, height / figure.get_figheight(), 1, 1))
