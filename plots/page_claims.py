"""What a page says about the source report's claims, of a study that is made to judge them."""
import re

import pandas as pd

from library.html_page import counted, escape

QUESTION_CLAIM, WORST_CASE_CLAIM = "C4", "C5"
BADGES = {
    "reproduced": "good",
    "holds": "good",
    "refuted": "bad",
    "refuted (better than claimed)": "bad",
    "ill-posed": "open",
    "by citation": "open",
    "undecided": "open",
}


def badge(verdict):
    return f'<span class="badge {BADGES[verdict]}">{escape(verdict)}</span>'


def pretty(text):
    """A claim's plain text with the signs that a terminal does without."""
    text = escape(text)
    for plain, sign in (
        ("-&gt;", "→"),
        ("&gt;=", "≥"),
        ("&lt;=", "≤"),
        ("alpha", "α"),
        (" eps", " ε"),
        ("+eps", "+ε"),
        ("delta", "δ"),
        ("Omega", "Ω"),
        ("Theta", "Θ"),
        ("sqrt ", "√"),
        ("1.1-1.5", "1.1–1.5"),
        (" - ", " − "),
    ):
        text = text.replace(plain, sign)
    return re.sub(r"\^(-?[\w.]*\w)", r"<sup>\1</sup>", text)


def answer(results):
    """The first screen: the question that most readers come with."""
    claims = results.claims.set_index("claim")
    claim, worst_case = claims.loc[QUESTION_CLAIM], claims.loc[WORST_CASE_CLAIM]
    answers = {"reproduced": "Yes.", "refuted": "No:", "refuted (better than claimed)": "No, greedy is far better:"}
    return (
        '<div class="answer"><p><strong>Is greedy’s α 1.1–1.5, as the report says?</strong>'
        f' <strong>{answers.get(claim["verdict"], "Undecided:")}</strong> {pretty(claim["measured"])}.'
        f' {badge(claim["verdict"])}</p><p>On points built against it: {pretty(worst_case["measured"])}.</p></div>'
    )


def claim_details(page, results, claim):
    path = results.folder / "claim_details" / f"{claim['claim']}.csv"
    if not path.is_file():
        return ""
    table = pd.read_csv(path, dtype=str).fillna("")
    columns, converted = [], {}
    for title in table.columns:
        values = pd.to_numeric(table[title].replace("", float("nan")), errors="coerce")
        is_number = values.notna().sum() == (table[title] != "").sum() and (values.abs() < 2**53).all()
        columns.append(
            {"title": title, "number": bool(is_number), "filter": 1 < table[title].nunique() <= 30 and not is_number}
        )
        converted[title] = list(table[title])  # numbers as they were written, with all their digits
    return page.data_table(
        f"details-{claim['claim']}", f"details of {claim['claim']}", columns, zip(*converted.values())
    )


def claim_html(page, results, claim, row_count):
    name = claim["claim"]
    rows = (
        f'<a href="#runs" data-table="runs-data" data-set="{name}">Show the {counted(row_count, "run")}</a>'
        if row_count
        else "no runs"
    )
    command = (
        f'<dt>by yourself</dt><dd><pre class="copy"><code>{escape(command_line(claim["command"]))}</code></pre></dd>'
        if claim["command"]
        else ""
    )
    return (
        f'<details class="claim" id="{name}" data-verdict="{escape(claim["verdict"])}"><summary><span'
        f' class="claim-id">{name}</span><span class="statement">{pretty(claim["statement"])} <span'
        f' class="soft">(section {escape(claim["section"])})</span></span>{badge(claim["verdict"])}<span'
        f' class="measured">{pretty(claim["measured"])}</span></summary><div'
        f' class="inside"><dl><dt>rule</dt><dd>{pretty(claim["rule"])}</dd><dt>evidence</dt><dd>{pretty(claim["evidence"])}.'
        f" {rows}</dd>{command}</dl>{claim_details(page, results, claim)}</div></details>"
    )


def command_line(command):
    return command.replace("mwt ", "build/release/mwt ").replace(" && ", "\n")


def verdicts(page, results, claim_rows):
    claims = results.claims
    counts = claims["verdict"].value_counts()
    buttons = "".join(
        f'<button type="button" data-verdict="{escape(verdict)}"'
        f' aria-pressed="false">{count} {escape(verdict)}</button>'
        for verdict, count in counts.items()
    )
    counted = claim_rows["claim"].value_counts() if len(claim_rows) else {}
    return f'<div class="choices"><span class="soft">Show only:</span>{buttons}</div>' + "\n".join(
        claim_html(page, results, claim, int(counted.get(claim["claim"], 0))) for _, claim in claims.iterrows()
    )
