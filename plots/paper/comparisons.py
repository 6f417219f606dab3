"""Pairs of algorithms as a matrix of effects, and mean ranks on a line with the groups that cannot be told apart."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LinearSegmentedColormap

from .data import WIDTH

LEVEL = 0.05
# Orange and blue, which the colour-blind can tell apart; in grey both ends are as dark, so every cell states its sign, too.
COLOURS = LinearSegmentedColormap.from_list("worse_better", ["#e69f00", "#ffffff", "#56b4e9"])
TITLES = {"gap": "gap", "time": "time"}


def pairs(data):
    measures = data.measures("pairs")
    if not measures:
        return None
    tables = {measure: data.table(f"pairs_{measure}") for measure in measures}
    labels = list(dict.fromkeys(data.table("outcomes")["label"]))
    height = 0.2 * len(labels) + 0.95
    figure, all_axes = plt.subplots(1, len(measures), figsize=(WIDTH, height), squeeze=False)
    for axes, measure in zip(all_axes[0], measures):
        draw_matrix(axes, tables[measure], labels)
        instances = tables[measure]["instances"].iloc[0]
        axes.set_title(f"{TITLES[measure]}, {instances} instances", loc="left")
    for axes in all_axes[0][1:]:
        axes.set_yticklabels([])
    figure.tight_layout()
    return figure


def draw_matrix(axes, table, labels):
    place = {label: position for position, label in enumerate(labels)}
    effects = np.full((len(labels), len(labels)), np.nan)
    for row in table.itertuples():
        first, second = place[row.first], place[row.second]
        effects[first, second], effects[second, first] = row.effect, -row.effect
        for y, x, effect in ((first, second, row.effect), (second, first, -row.effect)):
            is_sure = row.p_adjusted <= LEVEL
            text = effect_text(effect) + ("*" if is_sure else "")
            axes.text(x, y, text, ha="center", va="center", fontsize=5 if len(labels) > 6 else 7, fontweight="bold" if is_sure else "normal")
    axes.pcolormesh(np.arange(len(labels) + 1) - 0.5, np.arange(len(labels) + 1) - 0.5, np.ma.masked_invalid(effects), cmap=COLOURS, vmin=-1, vmax=1, edgecolor="white", linewidth=0.5)
    axes.set_xticks(range(len(labels)), labels, rotation=45, ha="right", rotation_mode="anchor")
    axes.set_yticks(range(len(labels)), labels)
    axes.set_ylim(len(labels) - 0.5, -0.5)
    axes.tick_params(length=0)
    axes.grid(False)
    for side in axes.spines.values():
        side.set_visible(False)


def effect_text(effect):
    """ "+.89", "−1", "0": short, since cells are small."""
    text = f"{abs(effect):.2f}"
    if text == "0.00":
        return "0"
    return ("+" if effect > 0 else "\N{MINUS SIGN}") + ("1" if text == "1.00" else text[1:])


def ranks(data):
    measures = data.measures("ranks")
    if not measures:
        return None
    tables = {measure: data.table(f"ranks_{measure}") for measure in measures}
    rows = max(-(-len(table) // 2) for table in tables.values())
    figure, all_axes = plt.subplots(1, len(measures), figsize=(WIDTH, 0.17 * rows + 0.9), squeeze=False)
    for axes, measure in zip(all_axes[0], measures):
        has_groups = data.has(f"rank_groups_{measure}")
        groups = data.table(f"rank_groups_{measure}") if has_groups else None
        draw_ranks(axes, tables[measure], groups)
        first = tables[measure].iloc[0]
        p = "$p<10^{-6}$" if first["p_value"] < 1e-6 else f"$p={first['p_value']:.2g}$"
        axes.set_title(f"{TITLES[measure]}, {first['instances']} instances, {p}", loc="left", pad=14)
    figure.tight_layout(w_pad=2)
    return figure


def draw_ranks(axes, table, groups):
    """The best on the left. Names hang on both sides, in two columns; the bars of groups lie between the line and them."""
    count = len(table)
    axes.axis("off")
    bar = 0.28
    bars = len(groups) if groups is not None else 0
    top = 0.5 + bar * bars
    half = -(-count // 2)
    axes.set_xlim(-0.9 - 0.16 * count, count + 1.9 + 0.16 * count)
    axes.set_ylim(top + 0.62 * half + 0.2, -1.3)
    axes.plot([1, count], [0, 0], color="black", linewidth=0.8)
    for rank in range(1, count + 1):
        axes.plot([rank, rank], [0, -0.15], color="black", linewidth=0.8)
        axes.text(rank, -0.25, str(rank), ha="center", va="bottom", fontsize=6.5)
    for place, row in enumerate(table.itertuples()):
        is_left = place < half
        y = top + 0.62 * (place if is_left else count - 1 - place)
        x = 0.7 if is_left else count + 0.3
        axes.plot([row.mean_rank, row.mean_rank, x], [0, y, y], color="#444444", linewidth=0.6)
        text = f"{row.label}  {row.mean_rank:.2f}" if is_left else f"{row.mean_rank:.2f}  {row.label}"
        axes.text(x + (-0.1 if is_left else 0.1), y, text, ha="right" if is_left else "left", va="center", fontsize=6.5)
    for position in range(bars):
        y = 0.3 + bar * position
        ends = groups.iloc[position]
        axes.plot([ends["first_rank"] - 0.04, ends["last_rank"] + 0.04], [y, y], color="black", linewidth=2, solid_capstyle="butt")
    critical = table["critical_difference"].iloc[0]
    axes.plot([1, 1 + critical], [-1.0, -1.0], color="black", linewidth=0.8)
    for x in (1, 1 + critical):
        axes.plot([x, x], [-1.1, -0.9], color="black", linewidth=0.8)
    axes.text(1 + critical + 0.12, -1.0, f"CD = {critical:.2f}", va="center", fontsize=6.5)
