"""What is proved: a matrix of family by size for a study's page."""
import math

MIB = 2**20


def percent(width):
    """An upper end of a relative width, in percent, rounded up to two digits."""
    value = 100 * width
    if value < 1e-4:
        return f"{value * 1.05:.1e} %"
    digits = 1 - math.floor(math.log10(value))
    factor = 10.0**digits
    return f"{math.ceil(value * factor - 1e-9) / factor:.{max(digits, 0)}f} %"


def status(cell):
    """What is known of the optima, as a word for the style and a text."""
    count = int(cell.instances)
    if cell.proved == count:
        return "proved", "proved" if count == 1 else f"{count} proved"
    if cell.without_bounds:
        return "open", f"no bound for {int(cell.without_bounds)} of {count}"
    proved = f"{int(cell.proved)} of {count} proved, " if cell.proved else ""
    return "bounded", f"{proved}within {percent(cell.max_relative_width)}"


def verification(cell):
    """What the verifier says of the proofs; empty without proofs."""
    if cell.refused:
        return f"{int(cell.refused)} refused"
    if cell.no_verdict:
        return f"no verdict on {int(cell.no_verdict)}"
    verified = int(cell.verified + cell.verified_bounds)
    if not verified:
        return ""
    return "verified" if verified == cell.instances else f"{verified} verified"


def duration(seconds):
    """With two digits at least: 7.6 µs, 0.17 s, 128 s."""
    for unit, factor in (("s", 1), ("ms", 1e3), ("µs", 1e6)):
        value = factor * seconds
        if value >= 0.995 or unit == "µs":
            return f"{value:.0f} {unit}" if value >= 9.95 else f"{value:.1f} {unit}"


def cost(cell):
    """Time and memory of the hardest instance, as far as they are known."""
    parts = []
    if not math.isnan(cell.max_time_s):
        parts.append(duration(cell.max_time_s))
    if not math.isnan(cell.max_peak_rss_bytes):
        parts.append(f"{math.ceil(cell.max_peak_rss_bytes / MIB)} MiB")
    return ", ".join(parts)


def cell_values(cell):
    kind, text = status(cell)
    return {
        "kind": "refused" if cell.refused else kind,
        "text": text,
        "verification": verification(cell),
        "cost": cost(cell),
    }


def matrix(results):
    """Families by sizes, the usual families and the large sizes first; None if the study has no instances. Families of one size only, such as named instances and files, share
    a list."""
    optima = results.optima
    if optima.empty:
        return None
    cells = {(cell.family, cell.n): cell_values(cell) for cell in optima.itertuples()}
    sizes_of = optima.groupby("family", sort=False)["n"].nunique()
    wide = [family for family, sizes in sizes_of.items() if sizes > 1]
    sizes = sorted(set(optima[optima["family"].isin(wide)]["n"]), reverse=True)
    wide = [family for family in results.families if family in wide] + [family for family in wide if family not in results.families]
    return {
        "sizes": sizes,
        "rows": [{"family": family, "cells": [cells.get((family, n)) for n in sizes]} for family in wide],
        "single": [
            {"family": cell.family, "n": cell.n, "cell": cells[cell.family, cell.n]}
            for cell in optima.sort_values(["n", "family"], ascending=[False, True]).itertuples()
            if cell.family not in wide
        ],
        "has_proofs": bool((optima[["verified", "verified_bounds", "refused", "no_verdict"]].sum(axis=1) > 0).any()),
    }
