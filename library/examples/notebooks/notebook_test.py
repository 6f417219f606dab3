#!/usr/bin/python3
"""Executes the notebooks: notebook_test.py FOLDER, the folder that has the package mwt. Exit code 77 (skipped) without nbclient."""
import os
import pathlib
import sys

try:
    import nbformat
    from nbclient import NotebookClient
except ImportError:
    print("SKIPPED: python3-nbclient OR python3-ipykernel IS MISSING, THE NOTEBOOKS WERE NOT RUN. Install them: setup/packages_for_checks.txt")
    sys.exit(77)

os.environ["PYTHONPATH"] = sys.argv[1]
for file in sorted(pathlib.Path(__file__).parent.glob("*.ipynb")):
    notebook = nbformat.read(file, as_version=4)
    NotebookClient(notebook, timeout=600, kernel_name="python3").execute()
    printed = [output.get("text", "") for cell in notebook.cells for output in cell.get("outputs", [])]
    pictures = sum("image/png" in output.get("data", {}) for cell in notebook.cells for output in cell.get("outputs", []))
    print(file.name, *printed, f"{pictures} pictures", sep="\n")
    if not pictures:
        sys.exit(f"{file}: draws nothing")
