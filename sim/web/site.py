#!/usr/bin/env python3
"""Combines the page and csgsim.wasm for a static server: site.py WASM FOLDER.

The page is that of csgsim view, except answers.js, which sends requests to csgsim.wasm instead of a server.
"""
import json
import shutil
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
TOP = HERE.parents[1]


def main():
    wasm, folder = (Path(argument) for argument in sys.argv[1:3])
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(TOP / "sim/viewer/page", folder)
    (folder / "page.html").rename(folder / "index.html")
    shutil.copytree(HERE / "page", folder, dirs_exist_ok=True)
    shutil.copy(TOP / "sim/report/page.css", folder)
    shutil.copy(wasm, folder / "csgsim.wasm")
    (folder / "models").mkdir()
    shutil.copy(HERE / "models.json", folder / "models")
    for row in json.loads((HERE / "models.json").read_text()):
        shutil.copy(TOP / "tests/models" / row["name"], folder / "models")


if __name__ == "__main__":
    main()
