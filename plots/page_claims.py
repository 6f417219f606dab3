"""What a page shows of the source report's claims, of a study that is made to judge them: values for templates/study/verdicts.html."""
import re

import pandas as pd
from markupsafe import Markup, escape

from library.html_page import data_table

QUESTION_CLAIM, WORST_CASE_CLAIM = "C4", "C5"
COLOURS = {
    "reproduced": "good",
    "holds": "good",
    "refuted": "bad",
    "refuted (better than claimed)": "bad",
    "ill-posed": "open",
    "by citation": "open",
    "undecided": "open",
}
ANSWERS = {"reproduced": "Yes.", "refuted": "No:", "refuted (better than claimed)": "No, greedy is far better:"}


def pretty(text):
    """A claim's plain text with the signs that a terminal does without."""
    text = str(escape(text))
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
    return Markup(re.sub(r"\^(-?[\w.]*\w)", r"<sup>\1</sup>", text))


def question(results):
    """The answer to the question that most readers come with."""
    claims = results.claims.set_index("claim")
    claim, worst_case = claims.loc[QUESTION_CLAIM], claims.loc[WORST_CASE_CLAIM]
    return {
        "answer": ANSWERS.get(claim["verdict"], "Undecided:"),
        "verdict": claim["verdict"],
        "colour": COLOURS[claim["verdict"]],
        "measured": claim["measured"],
        "worst_case": worst_case["measured"],
    }


def details_of(results, claim):
    """The table of figures behind a claim, None if it has none."""
    path = results.folder / "claim_details" / f"{claim}.csv"
    if not path.is_file():
        return None
    table = pd.read_csv(path, dtype=str).fillna("")
    columns, converted = [], {}
    for title in table.columns:
        values = pd.to_numeric(table[title].replace("", float("nan")), errors="coerce")
        is_number = values.notna().sum() == (table[title] != "").sum() and (values.abs() < 2**53).all()
        columns.append(
            {"title": title, "number": bool(is_number), "filter": 1 < table[title].nunique() <= 30 and not is_number}
        )
        converted[title] = list(table[title])  # numbers as they were written, with all their digits
    return data_table(f"details-{claim}", f"details of {claim}", columns, zip(*converted.values()))


def claims(results, claim_rows):
    """Every claim with its verdict and the number of runs that it was judged by."""
    run_counts = claim_rows["claim"].value_counts() if len(claim_rows) else {}
    texts = ("verdict", "statement", "section", "measured", "rule", "evidence")
    return [
        {text: claim[text] for text in texts}
        | {
            "name": claim["claim"],
            "colour": COLOURS[claim["verdict"]],
            "run_count": int(run_counts.get(claim["claim"], 0)),
            "command": claim["command"].replace("mwt ", "build/release/mwt ").replace(" && ", "\n"),
            "details": details_of(results, claim["claim"]),
        }
        for _, claim in results.claims.iterrows()
    ]


def verdict_counts(results):
    return results.claims["verdict"].value_counts().to_dict()
