#!/usr/bin/env python3
"""Writes references/: depth pictures of OpenSCAD's meshes of the benchmark's cases, as tests/corpus/references.py does
for the corpus, but one picture per case, with the case's camera and size. Needs openscad and numpy.

    references.py [CASE ...]      the named cases, or all of them; the others stay unchanged"""
import sys
import tempfile
import tomllib
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "tests/corpus"))

import mesh_depth  # noqa: E402
import meshes  # noqa: E402
import references  # noqa: E402

FOLDER = Path(__file__).resolve().parent / "references"


def main():
    suite = tomllib.loads((TOP / "traces/benchmark/suite.toml").read_text(encoding="utf-8"))
    FOLDER.mkdir(exist_ok=True)
    views = FOLDER / "views.txt"
    lines = {line.split()[0]: line for line in views.read_text(encoding="utf-8").splitlines()} if views.exists() else {}
    for case in suite["case"]:
        if sys.argv[1:] and case["name"] not in sys.argv[1:]:
            continue
        triangles = meshes.mesh(TOP / case["model"], Path(tempfile.gettempdir()) / "csgsim-benchmark")
        camera = [float(number) for number in case["camera"].split(",")]
        values, view = references.reference(triangles, case["projection"], camera, int(case["size"].split("x")[0]))
        references.write_png(FOLDER / f"{case['name']}.png", values)
        lines[case["name"]] = f"{case['name']} {view}"
    views.write_text("".join(lines[case["name"]] + "\n" for case in suite["case"] if case["name"] in lines), encoding="utf-8")


if __name__ == "__main__":
    main()
