#!/usr/bin/env python3
"""Finds which designs fit on which iCE40: designs of `csgsim rtl`, synthesised, placed and routed as by `make ice40`.
The table is copied into docs/hardware.md and the README of every design. Takes minutes per row.

  place.py CSGSIM"""

import argparse
import json
import pathlib
import re
import sys
import tempfile

from tools import MODELS, ROOT, attempt, existing, run, stop

PAGE = ROOT / "docs/hardware.md"
README = ROOT / "sim/rtl/templates/fits.md"
MODEL = MODELS / "thesis_fig_2_3.csg"
BEGIN, END = "<!-- placed -->\n", "<!-- end -->"

PARTS = {"hx8k": "HX8K", "up5k": "UP5K"}
FULL, FED = "`pixel-planes-4`", "`pixel-planes-4`, fed over a serial line"
WORDS = {FULL: [MODEL], FED: []}
# For each part, the most pixels that fit, and one row or column more, which does not fit.
ROWS = [(FULL, "hx8k", "8x8"), (FULL, "hx8k", "16x8"), (FULL, "hx8k", "16x9"), (FULL, "up5k", "9x8"), (FULL, "up5k", "10x8"), (FED, "hx8k", "8x8")]


def placed(csgsim, words, part, size):
    """Cells of a table row: logic cells, RAMs, MHz; or the resource that is exceeded."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        run([csgsim, "rtl", "pixel-planes-4", *words, "--size", size, "-o", folder, "--quiet"])
        done = attempt(["make", "-s", "-C", folder, "ice40", f"PART={part}"])
        log = (folder / f"{part}.txt").read_text() if (folder / f"{part}.txt").exists() else ""
        used = {kind: (int(got), int(there)) for kind, got, there in re.findall(r"(ICESTORM_LC|ICESTORM_RAM):\s+(\d+)/\s*(\d+)", log)}
        if not used:
            stop(f"{size} on {part}:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
        logic, rams = used["ICESTORM_LC"], used["ICESTORM_RAM"]
        if done.returncode != 0:
            print(f"place.py: {size} on {part} could not be placed: {re.findall('ERROR.*', log + done.stderr)[:1]}",
            file=sys.stderr)
            return [f"{logic[0]:,} of {logic[1]:,}", f"{rams[0]} of {rams[1]}", "does not fit"]
        clocks = json.loads((folder / f"{part}.report.json").read_text())["fmax"]
        return [f"{logic[0]:,} of {logic[1]:,}", f"{rams[0]} of {rams[1]}", f"{min(one['achieved'] for one in clocks.values()):.1f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("csgsim", type=existing)
    csgsim = parser.parse_args().csgsim
    lines = ["| machine | part | pixels | logic cells | RAMs | MHz |", "|---|---|--:|--:|--:|--:|"]
    for name, part, size in ROWS:
        cells = [name, PARTS[part], size.replace("x", " × "), *placed(csgsim, WORDS[name], part, size)]
        lines.append("| " + " | ".join(cells) + " |")
        print(lines[-1], flush=True)
    write("\n".join(lines) + "\n")
    return 0


def write(table):
    README.write_text(table)
    page = PAGE.read_text()
    PAGE.write_text(re.sub(f"({re.escape(BEGIN)}).*?({re.escape(END)})", lambda found: found[1] + table + found[2], page, flags=re.S))


if __name__ == "__main__":
    sys.exit(main())
