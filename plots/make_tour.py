#!/usr/bin/python3
"""Writes a page that plays recorded steps of algorithms without the program: plots/make_tour.py MWT OUT.html

The steps are those that `mwt explore` sends its page, and the player is that page's own. plots/gallery.sh writes it to
RESULTS_FOLDER/gallery/tour.html, from where the report's page embeds it.
"""
import argparse
import base64
import json
import pathlib
import re
import struct
import subprocess
import urllib.request

from markupsafe import Markup

from library import html_page

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE.parent / "harness" / "explore" / "page"
MODULES = ("frames.js", "program.js", "picture.js", "play.js")

FLAT = {"greedy_corridor"}  # families that are drawn as high as wide

# (title, text, family, n, algorithm, parameters)
EXAMPLES = [
    (
        "Greedy, the source report’s worked example",
        "The shortest edge that crosses none taken before, again and again. The result weighs 70.9586, and that is the optimum.",
        "report_example", 10, "greedy_naive", {},
    ),
    (
        "Hull and insertion, the source report’s worked example",
        "An optimal triangulation of the hull, into which the other points are inserted by splitting triangles.",
        "report_example", 10, "hull_insertion", {},
    ),
    (
        "Local search",
        "The points of the source report’s run of local search, from the sweep’s triangulation. Each flip states what it gains.",
        "local_search_figure", 10, "flip_naive", {"start": "sweep"},
    ),
    (
        "Points against greedy",
        "On greedy_corridor the first short edges force long ones later: greedy’s weight grows beyond every multiple of the optimum’s.",
        "greedy_corridor", 40, "greedy", {},
    ),
    (
        "Insertion’s trap",
        "On insertion_trap every inserted point is joined to far corners, and nothing is ever repaired.",
        "insertion_trap", 40, "hull_insertion", {},
    ),
    (
        "Patches",
        "From the Delaunay triangulation, patches of a few triangles are replaced by the lightest triangulation of their polygon, as long as"
        " one improves.",
        "uniform", 60, "patch", {"start": "delaunay"},
    ),
    (
        "The quadtree",
        "A square is divided in four until its cells hold at most four points. Each leaf gets its lightest triangulation; what joins the"
        " leaves is the constrained Delaunay triangulation that keeps their edges.",
        "uniform", 40, "quadtree", {},
    ),
    (
        "Annealing",
        "Random flips: shorter edges always, longer ones the more seldom the longer they are and the later it is. In the end, flips that"
        " shorten.",
        "uniform", 25, "annealing", {"proposals": "3000"},
    ),
    (
        "How an optimum is proved",
        "Candidates pass the diamond test, the LMT-skeleton deletes most of them, certain edges divide the rest into faces, and"
        " a program for each face finishes. Point at an edge to see why it left or stayed.",
        "uniform", 80, "exact", {},
    ),
]  # fmt: skip


class Explorer:
    """A running `mwt explore`, asked as its page asks it."""

    def __init__(self, program):
        self._process = subprocess.Popen([str(program), "explore"], stdout=subprocess.PIPE, text=True)
        self._address = self._process.stdout.readline().strip()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._process.terminate()
        self._process.stdout.close()
        self._process.wait()

    def ask(self, request, data=b""):
        """The frames of the answer by type: (JSON object, bytes)."""
        text = json.dumps(request).encode()
        text += b" " * (-len(text) % 8)
        body = struct.pack("<II", len(text), len(data)) + text + data
        headers = {"Content-Type": "application/octet-stream"}
        answer = urllib.request.urlopen(urllib.request.Request(self._address + "job", body, headers)).read()
        frames, position = {}, 0
        while position < len(answer):
            json_size, size = struct.unpack_from("<II", answer, position)
            begin = position + 8 + json_size
            parsed = json.loads(answer[position + 8 : begin])
            frames[parsed["type"]] = (parsed, answer[begin : begin + size])
            position = begin + size
        if "error" in frames:
            raise SystemExit(f"make_tour: {request}: {frames['error'][0]['message']}")
        return frames


def recorded(explorer, example):
    """What the page needs to play an example."""
    title, text, family, n, algorithm, parameters = example
    _, points = explorer.ask({"job": "generate", "family": family, "n": n, "seed": "1"})["points"]
    chosen = {"name": algorithm, "parameters": parameters}
    steps, data = explorer.ask({"job": "play", "algorithm": chosen, "seed": "1"}, points)["trace"]
    options = "".join(f" --param {name}={value}" for name, value in parameters.items())
    command = f"mwt generate {family} --n {n} --seed 1 -o points.csv; mwt solve points.csv --algorithm {algorithm}{options}"
    return {
        "title": title,
        "text": text,
        "command": command,
        "is_flat": family in FLAT,
        "points": base64.b64encode(points).decode(),
        "steps": steps,
        "bytes": base64.b64encode(data).decode(),
    }


def in_one_script(names):
    """The modules as one script: each a function that returns what it exports, in an order in which each needs only those before."""
    parts = ["const modules = {};"]
    for name in names:
        code = (PAGE / name).read_text(encoding="utf-8")
        exported = re.findall(r"^export (?:async )?(?:class|function|const) (\w+)", code, re.MULTILINE)
        code = re.sub(r'^import (\{[^}]*\}) from "\./([^"]+)";', r'const \1 = modules["\2"];', code, flags=re.MULTILINE)
        code = re.sub(r"^export ", "", code, flags=re.MULTILINE)
        parts.append(f'modules["{name}"] = (() => {{\n{code}\nreturn {{ {", ".join(exported)} }};\n}})();')
    return "\n".join(parts)


def player_markup():
    """The player of the explorer's page."""
    page = (PAGE / "index.html").read_text(encoding="utf-8")
    return re.search(r'<div id="player".*?\n</div>', page, re.DOTALL)[0].replace(" hidden>", ">", 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mwt", type=pathlib.Path)
    parser.add_argument("output", type=pathlib.Path)
    arguments = parser.parse_args()
    with Explorer(arguments.mwt) as explorer:
        examples = [recorded(explorer, example) for example in EXAMPLES]
    values = {
        "title": "Triangulation algorithms, step by step",
        "style": Markup((PAGE / "explorer.css").read_text(encoding="utf-8")),
        "modules": Markup(in_one_script(MODULES)),
        "player": Markup(player_markup()),
        "examples": html_page.json_script(examples),
    }
    text = html_page.render("tour.html", values)
    arguments.output.parent.mkdir(parents=True, exist_ok=True)
    arguments.output.write_text(text, encoding="utf-8")
    print(f"{arguments.output}: {len(examples)} recorded examples, {len(text):,} bytes")


if __name__ == "__main__":
    main()
