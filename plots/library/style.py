"""One look for all figures: a colour and a marker per algorithm, the same in every figure; sizes; saving.

Colours are Okabe and Ito's, which the colour-blind can tell apart, with two more for algorithms that never share a panel
with their neighbours in hue; markers carry the same distinction for print in grey. An algorithm of the source report and its
fast counterpart share a colour and differ in the marker. Algorithms without a line here get one that is still free.
"""
import dataclasses
import io
import re

import matplotlib
from markupsafe import Markup, escape

matplotlib.use("Agg")
import matplotlib.pyplot as plt

# Colours that a page replaces by those of its mode, light or dark. They occur nowhere else.
INK = "#1b1c1e"
FAINT = "#d6d7d9"
PAPER = "#fefefe"
OPTIMUM = "#9ad0f4"

BLUE, SKY, GREEN, ORANGE = "#0072b2", "#56b4e9", "#009e73", "#e69f00"
VERMILION, PINK, PURPLE, GREY = "#d55e00", "#cc79a7", "#7a5195", "#8a8a8a"
BROWN, OLIVE = "#a6761d", "#7f8f00"

# algorithm: (colour, marker, whether the marker is filled)
ALGORITHMS = {
    "hull_insertion": (VERMILION, "s", True),
    "sweep": (GREY, "h", True),
    "quadtree": (ORANGE, "v", True),
    "delaunay": (BLUE, "o", True),
    "flip_naive": (PINK, "D", True),
    "flip": (PINK, "D", False),
    "greedy_naive": (GREEN, "^", True),
    "greedy": (GREEN, "^", False),
    "annealing": (PURPLE, "X", True),
    "patch": (SKY, "P", True),
    "brute_force": (GREY, "*", True),
    "subset_dp": (GREY, "<", False),
    "polygon_dp": (GREY, ">", False),
    "triangle_lp": (GREY, "d", False),
    "two_chains": (GREY, "8", False),
    "exact": (INK, "*", True),
}
OTHERS = [(BROWN, "p"), (OLIVE, "H"), (SKY, "p"), (PURPLE, "8"), (ORANGE, "<"), (BLUE, ">"), (VERMILION, "D"), (GREEN, "s")]
LINES = ["-", "--", ":", "-."]
FILLS = ["full", "left", "right", "top", "bottom"]  # of markers, for the variants of one algorithm


@dataclasses.dataclass(frozen=True)
class Layout:
    """The room that a figure has: how many panels side by side, and inches for each of them and beside them."""

    columns: int
    panel_width: float
    margin: float

    def width(self, columns):
        return columns * self.panel_width + self.margin

    def divided(self, columns):
        """The same room for fewer or more panels side by side; a narrow page keeps one column."""
        if self.is_narrow:
            return self
        return Layout(columns, self.columns * self.panel_width / columns, self.margin)

    @property
    def is_narrow(self):
        return self.columns == 1


WIDE = Layout(columns=3, panel_width=3.0, margin=0.4)
NARROW = Layout(columns=1, panel_width=3.16, margin=0)  # a phone of 390 pixels


def name_of(label):
    """The algorithm of a label "name parameter=value ..."."""
    return label.split(" ")[0]


def base_style(name):
    """An algorithm's (colour, marker, whether the marker is filled). A name without a line in ALGORITHMS gets one."""
    if name not in ALGORITHMS:
        taken = {look[:2] for look in ALGORITHMS.values()}
        free = [look for look in OTHERS if look not in taken] or OTHERS
        ALGORITHMS[name] = (*free[0], True)
    return ALGORITHMS[name]


class Styles:
    """How to draw each of `labels`: an algorithm's colour and marker; its further variants differ by line and fill."""

    def __init__(self, labels):
        self._styles = {}
        variants = {}
        for label in labels:
            colour, marker, filled = base_style(name_of(label))
            variant = variants[name_of(label)] = variants.get(name_of(label), -1) + 1
            self._styles[label] = {
                "color": colour,
                "marker": marker,
                "markerfacecolor": colour if filled or variant > 0 else PAPER,
                "markerfacecoloralt": PAPER,
                "markeredgecolor": colour,
                "fillstyle": FILLS[variant % len(FILLS)],
                "linestyle": LINES[variant % len(LINES)],
            }

    def __getitem__(self, label):
        return self._styles[label]

    def colour(self, label):
        return self._styles[label]["color"]

    def mark(self, label):
        """The marker alone, without a line."""
        return dict(self._styles[label], linestyle="")


def report_first(labels):
    """The labels in the order of ALGORITHMS, which is from the crude to the exact; unknown ones at the end."""
    order = {name: position for position, name in enumerate(ALGORITHMS)}
    return sorted(labels, key=lambda label: (order.get(name_of(label), len(order)), label))


def use_style():
    plt.rcParams.update(
        {
            # Text as text, and no random ids: the same results give the same file.
            "svg.fonttype": "none",
            "svg.hashsalt": "mwt",
            # Verdana is as wide as matplotlib's own DejaVu Sans, in which the figures are laid out.
            "font.family": "DejaVu Sans",
            "font.size": 8.5,
            "text.color": INK,
            "axes.labelcolor": INK,
            "axes.edgecolor": INK,
            "xtick.color": INK,
            "ytick.color": INK,
            "axes.titlesize": 9,
            "axes.titleweight": "bold",
            "axes.titlelocation": "left",
            "axes.linewidth": 0.7,
            "axes.spines.top": False,
            "axes.spines.right": False,
            "axes.grid": True,
            "grid.color": FAINT,
            "grid.linewidth": 0.5,
            "axes.axisbelow": True,
            "axes.facecolor": "none",
            "figure.facecolor": PAPER,
            "savefig.facecolor": PAPER,
            "legend.frameon": False,
            "legend.fontsize": 8.5,
            "lines.linewidth": 1.3,
            "lines.markersize": 5,
            "lines.markeredgewidth": 1.0,
        }
    )


def columns_of(items, count):
    """How matplotlib divides the entries of a legend: the first columns have one more where they cannot be equal."""
    rows, longer = divmod(len(items), count)
    ends = [sum(rows + (column < longer) for column in range(end)) for end in range(count + 1)]
    return [items[begin:end] for begin, end in zip(ends, ends[1:])]


def legend_columns(width, names, font_size):
    """How many columns a legend of these names may have, so that it is no wider than `width` inches."""
    widths = [max(len(line) for line in name.split("\n")) * 0.55 * font_size + 30 for name in names]  # points, with the handle
    fitting = [
        count for count in range(1, len(names) + 1) if sum(map(max, columns_of(widths, count))) + 12 * count <= 72 * width
    ]
    return max(fitting, default=1)


def legend_below(figure, handles, labels):
    """One legend for all panels, under them: the figure grows by the room that it takes."""
    size = plt.rcParams["legend.fontsize"]
    columns = legend_columns(figure.get_figwidth(), labels, size)
    lines = -(-len(labels) // columns) + sum(label.count("\n") for label in labels)
    room = 0.15 + 0.19 * lines
    figure.set_figheight(figure.get_figheight() + room)
    figure.legend(handles, labels, loc="lower center", ncol=columns, columnspacing=1.4, handletextpad=0.4)
    figure.tight_layout(rect=(0, room / figure.get_figheight(), 1, 1))


def svg_text(figure):
    buffer = io.StringIO()
    figure.savefig(buffer, format="svg", metadata={"Date": None}, dpi=220)
    return buffer.getvalue().replace("'DejaVu Sans'", "'DejaVu Sans', Verdana, sans-serif")


def save(figure, path):
    """Writes path.svg and path.png, for print on white."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.with_suffix(".svg").write_text(svg_text(figure), encoding="utf-8")
    figure.savefig(path.with_suffix(".png"), dpi=160)


def rounded(attribute):
    """An attribute's numbers to a hundredth of a point."""
    return re.sub(r"-?\d+\.\d{3,}", lambda number: f"{float(number[0]):.2f}".rstrip("0").rstrip("."), attribute[0])


def inline_svg(svg, prefix, title, width):
    """An SVG for a page, `width` CSS pixels wide: no prologue, ids of its own, colours that follow the page's mode, a name for
    screen readers; small."""
    svg = svg[svg.index("<svg") :]
    svg = re.sub(r"<metadata>.*?</metadata>", "", svg, flags=re.S)
    svg = re.sub(r'\b(?:d|x|y|transform)="[^"]*"', rounded, svg)
    svg = re.sub(r'\bid="([^"]*)"', lambda match: f'id="{prefix}-{match[1]}"', svg)
    svg = re.sub(r'(href="#|url\(#)([^")]*)', lambda match: f"{match[1]}{prefix}-{match[2]}", svg)
    box = re.search(r'viewBox="[^"]*"', svg)[0]
    svg = re.sub(
        r"<svg[^>]*>",
        (
            f'<svg width="{width:.0f}" xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
            f'{box} role="img" aria-label="{escape(title)}">'
        ),
        svg,
        count=1,
    )
    for colour, variable in ((INK, "--ink"), (FAINT, "--faint"), (PAPER, "--paper"), (OPTIMUM, "--optimum")):
        svg = svg.replace(colour, f"var({variable})")
    return Markup(re.sub(r"\n\s*", "\n", svg))
