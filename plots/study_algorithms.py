#!/usr/bin/python3
"""The algorithms of a study with their variants, for plots/gallery.sh: plots/study_algorithms.py RESULTS_FOLDER N

Prints a line per variant that the study ran on N points or, if it has none so large, on its largest instances: the name that
figures use, the algorithm, its parameters, and of programs of one's own the study file that names their command; separated by tabs.
"""
import sys

import page_tables
from library.records import Results


def study_file(results):
    """That of the project, from which relative paths of commands go; of other studies the copy beside the results."""
    return page_tables.project_file(results) if page_tables.project_study(results) else results.folder / "study.toml"


def main():
    if len(sys.argv) != 3:
        sys.exit(f"usage: {sys.argv[0]} RESULTS_FOLDER N")
    results = Results(sys.argv[1])
    runs = results.runs[results.runs["status"] == "ok"]
    runs = runs[(runs["n"] >= min(int(sys.argv[2]), runs["n"].max())) & ~runs["params"].str.contains(".csv", regex=False)]
    own = page_tables.command_options(results)
    for label in results.labels:
        for variant in runs[runs["label"] == label].head(1).itertuples():
            commands = study_file(results).resolve() if variant.algorithm in own else ""
            print(label, variant.algorithm, variant.params or " ", commands, sep="\t")


if __name__ == "__main__":
    main()
