#!/usr/bin/env python3
"""Draws the models in parts/ and writes their pictures and table into docs/shapes.md, between its marks.

    parts.py [--csgsim build/release/csgsim]
"""
import argparse
import json
import subprocess
import tempfile
import time
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
ROOT = FOLDER.parents[1]
PAGE = ROOT / "docs/shapes.md"
PICTURES = ROOT / "docs/pictures/shapes"
BEGIN, END = "<!-- parts.py: begin -->\n", "<!-- parts.py: end -->\n"


def drawn(csgsim, model, folder):
    """The part's row of the table."""
    stats = folder / "stats.json"
    picture = PICTURES / (model.stem + ".png")
    program = folder / "part.csgt"
    begun = time.monotonic()
    subprocess.run([csgsim, "compile", model, "--view-all", "--size", "512x512", "-o", program], check=True, stdout=subprocess.DEVNULL)
    seconds = time.monotonic() - begun
    subprocess.run([csgsim, "run", program, "-o", picture, "--stats", stats], check=True, stdout=subprocess.DEVNULL)
    stats_file = json.loads(stats.read_text(encoding="utf-8"))
    of = stats_file["model"]
    return (f"| [{model.stem}](../tests/corpus/parts/{model.stem}.scad) | {of['primitives']} | {of['pieces']} | {of['halfspaces']} "
            f"| {stats_file['clocks']} | {stats_file['memory_bits']['used']} | {seconds:.1f} |\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--csgsim", default=ROOT / "build/release/csgsim")
    arguments = parser.parse_args()
    PICTURES.mkdir(parents=True, exist_ok=True)
    models = sorted((FOLDER / "parts").glob("*.csg"))
    with tempfile.TemporaryDirectory() as folder:
        rows = [drawn(arguments.csgsim, model, Path(folder)) for model in models]
    table = "".join(f'<img src="pictures/shapes/{model.stem}.png" width="19%"> ' for model in models) + "\n\n"
    table += "| Part | Primitives | Pieces | Half-spaces | Clocks | Bits per pixel | Compilation, s |\n|---|--:|--:|--:|--:|--:|--:|\n" + "".join(rows)
    before, rest = PAGE.read_text(encoding="utf-8").split(BEGIN)
    PAGE.write_text(before + BEGIN + table + END + rest.split(END)[1], encoding="utf-8")


if __name__ == "__main__":
    main()
