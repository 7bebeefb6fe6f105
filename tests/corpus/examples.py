#!/usr/bin/env python3
"""Writes the table of OpenSCAD's own examples into docs/shapes.md, between its marks.

    examples.py [--csgsim build/release/csgsim] [--work FOLDER] [--limit SECONDS]

Each example installed by the Debian package of OpenSCAD is exported to .csg, whose nodes are listed. OpenSCAD itself
makes a mesh, or an area for flat models. With --csgsim, the source is compiled and drawn; seconds are those of
compiling, including OpenSCAD's evaluation."""
import argparse
import json
import re
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

EXAMPLES = Path("/usr/share/openscad/examples")
PAGE = Path(__file__).resolve().parents[2] / "docs/shapes.md"
BEGIN, END = "<!-- examples.py: begin -->\n", "<!-- examples.py: end -->\n"
STRING = re.compile(r'"(\\.|[^"\\])*"')
FIGURES = ["Half-spaces", "Pieces", "Clocks", "Bits", "Compilation, s"]
NODE = re.compile(r"([a-z_0-9]+)\(")


def run(command, limit):
    """Exit code (None after a time-out) and output."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=limit, check=False)
    except subprocess.TimeoutExpired:
        return None, ""
    return done.returncode, done.stderr


def nodes(csg):
    """Names of the nodes, without those that every file has."""
    names = set(NODE.findall(STRING.sub('""', csg.read_text(encoding="utf-8"))))
    return sorted(names - {"group", "multmatrix"})


def problem(said):
    """OpenSCAD's first complaint."""
    lines = [line for line in said.splitlines() if re.match(r"(ERROR|WARNING): (?!variable timestamp)", line)]
    return "; " + re.sub(r" in file .*", "", lines[0]) if lines else ""


def openscad_says(csg, limit):
    """OpenSCAD's result; kept in the folder, since it may take minutes."""
    kept = csg.with_suffix(".verdict")
    if kept.exists():
        return kept.read_text(encoding="utf-8")
    code, said = run(["openscad", "-o", str(csg.with_suffix(".mesh.stl")), str(csg)], limit)
    if code == 1 and "not a 3D object" in said:
        code, said = run(["openscad", "-o", str(csg.with_suffix(".area.svg")), str(csg)], limit)
        verdict = "an area" if code == 0 else "fails"
    elif code == 1 and "object is empty" in said:
        verdict = "nothing"
    else:
        verdict = {0: "a mesh", None: f"no mesh in {limit} s"}.get(code, "fails")
    verdict += problem(said)
    kept.write_text(verdict, encoding="utf-8")
    return verdict


def drawn(csgsim, scad, limit, more=()):
    """csgsim's drawing of the source with its costs, or its error message."""
    with tempfile.TemporaryDirectory() as folder:
        program, stats = folder + "/example.csgt", folder + "/stats.json"
        begun = time.monotonic()
        code, said = run([csgsim, "compile", str(scad), "--view-all", "-o", program, *more], limit)
        seconds = time.monotonic() - begun
        if code == 0:
            code, more_said = run([csgsim, "run", program, "--progress", "none", "-o", folder + "/picture.png", "--stats", stats], limit)
            said += more_said
        if code != 0:
            return None, f"not in {limit} s" if code is None else said.strip().splitlines()[-1]
        found = json.loads(Path(stats).read_text(encoding="utf-8"))
    of = found["model"]
    return [of["halfspaces"], of["pieces"], found["clocks"], found["memory"]["used_bits"], f"{seconds:.1f}"], said


def csgsim_says(csgsim, scad, limit):
    """Cells of the row. A rejected model is drawn with the option that the message suggests."""
    cells, said = drawn(csgsim, scad, limit)
    if cells:
        return ["drawn; transparent surfaces by screen-door" if "screen-door" in said else "drawn", *cells]
    reason = "refused: " + re.sub(r"^\S*:(\d+:\d+:)? ", "", said).partition(";")[0].partition(" (")[0]
    fix = re.search(r"--set (\S+?),? ", said)
    if fix:
        cells, _ = drawn(csgsim, scad, limit, ["--set", fix[1]])
        reason += f"; drawn with `--set {fix[1]}`"
    return [reason, *(cells or [""] * 5)]


def row(arguments, scad):
    name = scad.relative_to(arguments.work)
    csg = scad.with_suffix(".csg")
    code, said = run(["openscad", "-o", str(csg), str(scad)], arguments.limit)
    if code != 0:
        return [str(name), "", "fails" + problem(said)]
    cells = csgsim_says(arguments.csgsim, scad, arguments.limit) if arguments.csgsim else []
    return [str(name), ", ".join(f"`{node}`" for node in nodes(csg)), openscad_says(csg, arguments.limit) + problem(said), *map(str, cells)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--csgsim")
    parser.add_argument("--work", type=Path, default=Path(tempfile.gettempdir()) / "csgsim-examples", help="folder for .csg files and meshes")
    parser.add_argument("--limit", type=int, default=300, help="time limit of each run in seconds")
    arguments = parser.parse_args()
    shutil.copytree(EXAMPLES, arguments.work, dirs_exist_ok=True)  # .csg files name imports relative to the source
    heads = ["Example", "Nodes other than `group` and `multmatrix`", "OpenSCAD 2021.01"]
    if arguments.csgsim:
        heads += ["csgsim", *FIGURES]
    rows = [row(arguments, scad) for scad in sorted(arguments.work.rglob("*.scad"))]
    made = [cells[2].split(";")[0] for cells in rows]
    summary = f"Of {len(rows)} examples, OpenSCAD makes " + ", ".join(f"{kind} of {made.count(kind)}" for kind in sorted(set(made)))
    if arguments.csgsim:
        summary += f"; csgsim draws {[cells[3] for cells in rows].count('drawn')}, by `csgsim render FILE.scad --view-all -o picture.png`"
    lines = ["| " + " | ".join(cells) + " |\n" for cells in [heads, [("--:" if head in FIGURES else "---") for head in heads], *rows]]
    before, _, rest = PAGE.read_text(encoding="utf-8").partition(BEGIN)
    _, _, after = rest.partition(END)
    PAGE.write_text(before + BEGIN + f"{summary}.\n\n" + "".join(lines) + END + after, encoding="utf-8")


if __name__ == "__main__":
    main()
