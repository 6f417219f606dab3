"""Growth of time and alpha with n: marks, fitted lines, their bands, and the exponents at their ends."""
import math

import matplotlib.pyplot as plt

from .data import WIDTH, legend_below, mark, panel_height

MOST_FAMILIES = 3
Y_LABELS = {"time": "time in s", "alpha": r"mean $\alpha$"}
LEAST_EXPONENT = 0.02  # of alpha: what grows less is flat, and left out
FONT_SIZE = 5.5  # of the exponents, points
TEXT_HEIGHT = 1.2 * FONT_SIZE


def growth(data):
    if not data.has("growth_points") or not data.has("growth_lines"):
        return None
    points, lines = data.table("growth_points"), data.table("growth_lines")
    grows = lines[(lines["measure"] == "time") | (lines["exponent"] >= LEAST_EXPONENT)]
    looks = data.looks()
    families = list(dict.fromkeys(grows["family"]))[:MOST_FAMILIES]
    measures = [measure for measure in ("time", "alpha") if (grows["measure"] == measure).any()]
    height = panel_height(grows["label"])
    figure, all_axes = plt.subplots(
        len(measures), len(families), figsize=(WIDTH, height * len(measures)), squeeze=False, sharey="row"
    )
    for row, measure in zip(all_axes, measures):
        for axes, family in zip(row, families):
            chosen = grows[(grows["measure"] == measure) & (grows["family"] == family)]
            of_panel = points[(points["measure"] == measure) & (points["family"] == family)]
            if measure == "alpha":
                of_panel = of_panel[of_panel["label"].isin(chosen["label"])]
            axes.set_xscale("log")
            axes.set_yscale("log")
            for label, of_label in of_panel.groupby("label", sort=False):
                axes.plot(of_label["n"], of_label["value"], **mark(looks[label]))
            draw_lines(axes, chosen, looks)
            axes.set_title(family, loc="left", style="italic")
        row[0].set_ylabel(Y_LABELS[measure])
    for axes in all_axes[-1]:
        axes.set_xlabel("points $n$")
    legend_below(figure, looks, list(dict.fromkeys(points["label"])))
    for row, measure in zip(all_axes, measures):
        for axes, family in zip(row, families):
            name_exponents(axes, grows[(grows["measure"] == measure) & (grows["family"] == family)], looks)
    return figure


def draw_lines(axes, lines, looks):
    for label, line in lines.groupby("label", sort=False):
        law = line.iloc[0]
        colour = looks[label]["color"]
        style = (0, (3, 2)) if law["fits"] == "no" else "-"
        axes.plot(line["n"], line["value"], color=colour, linewidth=0.8, linestyle=style)
        if not math.isnan(law["lower"]):
            axes.fill_between(line["n"], line["lower"], line["upper"], color=colour, alpha=0.18, linewidth=0)


def name_exponents(axes, lines, looks):
    """At the lines' ends, one above the other where they would overlap."""
    ends = [(label, line.iloc[-1]) for label, line in lines.groupby("label", sort=False)]
    if not ends:
        return
    left, right = axes.get_xlim()
    axes.set_xlim(left, right * (right / left) ** 0.14)
    to_share = axes.transLimits.transform
    text_height = TEXT_HEIGHT / (axes.get_window_extent().height * 72 / axes.figure.dpi)
    places = []
    for label, end in ends:
        x, y = to_share((math.log10(end["n"]), math.log10(end["value"])))
        places.append([x, y, label, end])
    places.sort(key=lambda place: place[1])
    for below, above in zip(places, places[1:]):
        above[1] = max(above[1], below[1] + text_height)
    too_high = max(0, places[-1][1] - 0.97)  # the whole stack moves down, as far as its neighbours let it
    for place, above in zip(reversed(places), [None, *reversed(places)]):
        place[1] = min(place[1], 0.97 if above is None else above[1] - text_height) if too_high else place[1]
    for x, y, label, end in places:
        text = f"{end['exponent']:.2f}" + (r"$^\sim$" if end["fits"] == "no" else "")
        axes.text(x + 0.02, y, text, transform=axes.transAxes, fontsize=FONT_SIZE, va="center", color=looks[label]["color"])
