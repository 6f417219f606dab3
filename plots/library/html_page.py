"""Self-contained pages: style and scripts inline, no network, light and dark, tables that sort and filter.

plots/templates/ has the markup (Jinja2, which escapes every text that is not marked as markup): page.html is the skeleton, a page's
own template extends it, and its sections are templates in a folder of that name. page.css and page.js hold the rest.
"""
import dataclasses
import json
import math
import pathlib

import jinja2
from markupsafe import Markup

HERE = pathlib.Path(__file__).parent
TEMPLATES = HERE.parent / "templates"


@dataclasses.dataclass(frozen=True)
class Section:
    """A part of a page with an anchor of its own."""

    name: str
    title: str
    template: str


@dataclasses.dataclass(frozen=True)
class Figure:
    """A figure drawn twice, as SVG for wide and for narrow screens."""

    name: str
    title: str
    caption: str
    wide: Markup
    narrow: Markup
    is_folded: bool = False


@dataclasses.dataclass(frozen=True)
class DataTable:
    """A table for page.js, which describes `json`."""

    name: str
    label: str
    json: Markup


def render(template, values, filters=None):
    """The text of the page that `template` makes of `values`."""
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATES),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters.update(counted=counted, grouped=grouped, **(filters or {}))
    environment.globals["file_text"] = file_text
    return environment.get_template(template).render(values)


def file_text(name):
    """A file beside this one, as it is."""
    return Markup((HERE / name).read_text(encoding="utf-8"))


def data_table(name, label, columns, rows, **more):
    """`columns` are dicts as page.js describes them; texts of a column with few values are kept once."""
    columns = [dict(column) for column in columns]
    rows = [list(row) for row in rows]
    for position, column in enumerate(columns):
        if not column.get("number"):
            share_texts(column, rows, position)
    return DataTable(name, label, json_script({"columns": columns, "rows": rows, **more}))


def json_script(content):
    """JSON for a script element."""
    text = json.dumps(content, ensure_ascii=False, separators=(",", ":"), default=plain)
    return Markup(text.replace("</", "<\\/"))


def share_texts(column, rows, position):
    """Replaces a column's texts by their positions in a list of the distinct ones, where that is shorter."""
    values = list(dict.fromkeys(row[position] for row in rows))
    if len(values) * 3 > len(rows):
        return
    column["values"] = values
    number = {value: index for index, value in enumerate(values)}
    for row in rows:
        row[position] = number[row[position]]


def plain(value):
    """For json, which has no NumPy numbers."""
    return value.item()


def number(value, digits=6):
    """A number for a table: rounded to significant digits, None for a missing one."""
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return None
    return float(f"{value:.{digits}g}") if isinstance(value, float) else value


def grouped(count):
    return f"{count:,}"


def counted(count, what):
    return f"{count:,} {what}{'' if count == 1 else 's'}"
