"""The skeleton of a self-contained page: style and scripts inline, no network, light and dark, tables that sort and filter.

A page is made of sections (html texts); data_table() makes a table, figure() a figure. page.css and page.js hold the rest.
"""
import html
import json
import math
import pathlib

HERE = pathlib.Path(__file__).parent

SKELETON = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:">
<link rel="icon" href="data:,">
<title>{title}</title>
<style>
{style}
</style>
</head>
<body>
<a class="skip" href="#main">Skip to the content</a>
<header>
<h1>{title}</h1>
{lead}
</header>
<nav aria-label="sections"><ul>
{links}
<li><button type="button" id="theme">light / dark</button></li>
</ul></nav>
<main id="main">
<noscript><p>The figures are below; the tables need scripts, which this page brings along.</p></noscript>
{sections}
</main>
<footer class="soft">
{footer}
</footer>
{data}
<script>
{script}
</script>
</body>
</html>
"""


class Page:
    """Collects sections and the tables' data; text() is the whole file."""

    def __init__(self, title, lead, footer):
        self._title, self._lead, self._footer = title, lead, footer
        self._sections = []
        self._data = []

    def add_section(self, name, title, body):
        """`name` is its anchor."""
        self._sections.append((name, title, body))

    def data_table(self, name, label, columns, rows, **more):
        """HTML of a table. `columns` are dicts as page.js describes them; texts of a column with few values are kept once."""
        columns = [dict(column) for column in columns]
        rows = [list(row) for row in rows]
        for position, column in enumerate(columns):
            if not column.get("number"):
                share_texts(column, rows, position)
        content = json.dumps(
            {"columns": columns, "rows": rows, **more}, ensure_ascii=False, separators=(",", ":"), default=plain
        )
        content = content.replace("</", "<\\/")
        self._data.append(f'<script type="application/json" id="{name}">{content}</script>')
        return f'<div class="data-table" data-source="{name}" data-label="{escape(label)}"></div>'

    def text(self):
        return SKELETON.format(
            title=escape(self._title),
            lead=self._lead,
            footer=self._footer,
            style=(HERE / "page.css").read_text(encoding="utf-8"),
            script=(HERE / "page.js").read_text(encoding="utf-8"),
            links="\n".join(f'<li><a href="#{name}">{escape(title)}</a></li>' for name, title, _ in self._sections),
            sections="\n".join(
                f'<section id="{name}"><h2>{escape(title)}</h2>\n{body}\n</section>'
                for name, title, body in self._sections
            ),
            data="\n".join(self._data),
        )


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


def counted(count, what):
    return f"{count:,} {what}{'' if count == 1 else 's'}"


def escape(text):
    return html.escape(str(text), quote=True)


def figure(name, wide, narrow, title, caption, is_folded=False):
    """A figure drawn twice, for wide and for narrow screens: page.css shows one. Each drawing is an SVG and its natural width
    in CSS pixels; what is still narrower scales it. A folded one shows its title only, until the reader opens it."""
    pictures = "".join(
        f'<div class="picture {kind}">{svg.replace("<svg ", f"""<svg width="{width:.0f}" """, 1)}</div>'
        for kind, (svg, width) in (("wide", wide), ("narrow", narrow))
    )
    heading = f'<h3 id="figure-{name}">{escape(title)}</h3>'
    body = f"<figure>{pictures}<figcaption>{escape(caption)}</figcaption></figure>"
    return f"<details><summary>{heading}</summary>\n{body}</details>" if is_folded else f"{heading}\n{body}"
