#!/usr/bin/python3
"""Tests that counts find 1% more instructions overnight: more_instructions_test.py BUILD_DIR

Builds mwt a second time with a few instructions more in one kernel of the algorithm `patch` (its other parts are those of BUILD_DIR), runs a study
with counts = "callgrind" with both programs, and looks at what `mwt compare` and `mwt history` make of it. Exit code 77 (skipped) without valgrind, or
where the build is no unity build.
"""
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

BUILD = pathlib.Path(sys.argv[1]).resolve()
KERNEL = "PatchPolygon::find_best_apex"
BEGIN = "void PatchPolygon::find_best_apex(std::size_t i, std::size_t j) {\n"
MORE = '  asm volatile("nop\\n\\tnop\\n\\tnop\\n\\tnop\\n\\tnop\\n\\tnop\\n\\tnop\\n\\tnop");\n'  # 1.4% more of the algorithm at n = 300
STUDY = """
name = "night"
summary = "a small night"
families = ["uniform", "clustered"]
sizes = [300]
seeds = [1, 2]
algorithms = ["delaunay", "greedy", "patch"]
repetitions = 2
min_time_s = 0.0001
counts = "callgrind"
[optimum]
seek = false
"""


def skip(why):
    print("skipped:", why)
    sys.exit(77)


def run(*command, code=0):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if done.returncode != code:
        sys.exit(f"{command}: exit code {done.returncode} instead of {code}\n{done.stdout}{done.stderr}")
    return done.stdout


def require(condition, text):
    if not condition:
        sys.exit(f"FAILED: {text}")


def program_with_more_instructions(folder):
    """The unity source of algorithms/patch with the kernel changed, compiled and linked in front of the library that has the usual one."""
    units = [one for one in json.loads((BUILD / "compile_commands.json").read_text()) if one["file"].endswith("unity_algorithms_patch_cxx.cxx")]
    if not units:
        skip("this is no unity build")
    unit = units[0]
    kernel = next(pathlib.Path(file) for file in re.findall(r'#include "(.*)"', pathlib.Path(unit["file"]).read_text()) if file.endswith("/patch_polygon.cpp"))
    text = kernel.read_text()
    require(BEGIN in text, f"{kernel} has no function {KERNEL} any more: choose another kernel")
    changed = folder / "patch_polygon.cpp"
    changed.write_text(text.replace(BEGIN, BEGIN + MORE))
    source = folder / "unity.cxx"
    source.write_text(pathlib.Path(unit["file"]).read_text().replace(str(kernel), str(changed)))
    words = shlex.split(unit["command"])
    output = words[words.index("-o") + 1]
    compile_command = [str(source) if word == unit["file"] else str(folder / "unity.o") if word == output else word for word in words]
    subprocess.run(compile_command, cwd=unit["directory"], check=True)
    link = run("ninja", "-C", BUILD, "-t", "commands", "mwt").strip().splitlines()[-1]
    link = re.sub(r" -o mwt ", f" {shlex.quote(str(folder / 'unity.o'))} -o {shlex.quote(str(folder / 'mwt'))} ", link)
    subprocess.run(link, shell=True, cwd=BUILD, check=True)
    return folder / "mwt"


def night(program, folder, number):
    """The results of a night, as if of a commit of its own."""
    results = folder / f"night{number}"
    run(program, "run", folder / "study.toml", "--out", results, "--no-cache")
    runs = results / "runs.csv"
    commit = runs.read_text().splitlines()[1].split(",")[5]
    runs.write_text(runs.read_text().replace(commit, f"{number:040d}"))
    return results


def counts_found(base, now, code):
    found = json.loads(run(BUILD / "mwt", "compare", base, now, "--json", code=code))["findings"]
    return [finding for finding in found if finding["aspect"] == "counts"]


def main():
    if not shutil.which("valgrind"):
        skip("there is no valgrind")
    with tempfile.TemporaryDirectory(prefix="mwt_more_instructions_") as name:
        folder = pathlib.Path(name)
        (folder / "study.toml").write_text(STUDY)
        slower = program_with_more_instructions(folder)
        nights = [night(BUILD / "mwt", folder, number) for number in range(3)]
        require(not counts_found(nights[0], nights[2], 0), "counts of equal code differ by 1%")
        last = night(slower, folder, 3)
        found = counts_found(nights[2], last, 1)
        for finding in found:
            print(finding["algorithm"], "on", finding["instance"] + ":", finding["text"])
        require(len(found) == 4 and all(one["algorithm"].startswith("patch") for one in found), "patch on its four instances, and nothing else")
        for one in found:
            factor = float(re.search(r"\(x([\d.]+)\)", one["text"])[1])
            require(1.01 < factor < 1.03, f"the change is artificial: 1% to 3%, not x{factor}")
            require(f"most in {KERNEL} +" in one["text"], f"the function is named: {one['text']}")
            require(one["confirmed"], "two runs of either side")
        history = folder / "history.sqlite"
        run(BUILD / "mwt", "track", *nights, "--history", history)
        require("no lasting change" in run(BUILD / "mwt", "history", "changes", "--history", history), "three nights of equal code have no change")
        run(BUILD / "mwt", "track", last, "--history", history)
        changes = run(BUILD / "mwt", "history", "changes", "--history", history)
        print(changes, end="")
        pattern = r"regression patch[^:]*: counts x1\.0[12]\d\d on clustered .*n=300, uniform n=300, most in " + re.escape(KERNEL) + r" \+"
        require(re.search(pattern, changes), changes)


if __name__ == "__main__":
    main()
