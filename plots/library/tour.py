"""The page of recorded steps (plots/make_tour.py) within another page."""
import pathlib

from markupsafe import Markup

NAME = "tour.html"  # in RESULTS_FOLDER/gallery


def frame(results):
    """The tour of a folder of results as an element of a page, all of it within; None if plots/gallery.sh has written none.

    It needs no network and no other file, follows the theme of the page around it, and works under the Content-Security-Policy of
    templates/page.html."""
    path = pathlib.Path(results) / "gallery" / NAME
    if not path.is_file():
        return None
    title = "Algorithms step by step, a page of its own within this one"
    style = "display: block; width: 100%; height: 58rem; border: 0; color-scheme: normal"
    return Markup('<iframe class="tour" title="{}" loading="lazy" style="{}" srcdoc="{}"></iframe>').format(
        title, style, path.read_text(encoding="utf-8")
    )
