#!/usr/bin/env python3
"""table.py CSGSIM: measures the Programs and models of docs/performance.md and prints its table."""

import json
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
LINEAR = ("edge_", "linear_", "load_linear", "keep_")
CLOCKS_A_SECOND = 1e7
POWERS = ["--machine", "pixel-powers", "--view-all"]
TWO_PORTS = ["--machine", "pixel-powers+memory.reads=2", "--view-all"]
SPHERE_CAMERA = ["--camera", "0,-1286.98,0,0,0,0"]


def stats(csgsim, command, path, *options):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "stats.json"
        subprocess.run([csgsim, command, path, *options, "--stats", out], check=True, stdout=subprocess.DEVNULL)
        return json.loads(out.read_text())


def most_expensive(report):
    return max(primitive["clocks"] for primitive in report["by_primitive"])


def an_expression(report):
    """Instruction clocks, without latency, divided by the number of instructions with a linear expression."""
    counts = report["instructions"]["by_name"]
    return sum(row["clocks"] for row in counts.values()) / sum(
        row["count"] for name, row in counts.items() if name.startswith(LINEAR)
    )


def row(name, published, ours, digits=0):
    print(f"| {name} | {published:,.{digits}f} | {ours:,.{digits}f} | {ours / published:.2f} |")


def main():
    csgsim = sys.argv[1]
    models = HERE.parent / "models"
    print("| | published | ours | ours / published |\n|---|--:|--:|--:|")
    row("triangle", CLOCKS_A_SECOND / 30_000, most_expensive(stats(csgsim, "run", HERE / "triangle.csgt")))
    row("triangle with shadow", CLOCKS_A_SECOND / 21_000, most_expensive(stats(csgsim, "run", HERE / "shadow.csgt")))
    row("sphere", CLOCKS_A_SECOND / 25_000, most_expensive(stats(csgsim, "run", HERE / "sphere.csgt")))
    other = stats(csgsim, "run", HERE / "sphere_radius.csgt")
    row("sphere of another radius", CLOCKS_A_SECOND / 25_000, most_expensive(other))
    for facets in (16, 32):
        report = stats(csgsim, "render", HERE / f"sphere_{facets}.csg", *SPHERE_CAMERA)
        row(f"sphere of {report['model']['halfspaces']} facets", CLOCKS_A_SECOND / 25_000, most_expensive(report))
    for name, options in (
        ("sphere without facets", POWERS),
        ("the same, two read ports", TWO_PORTS),
        ("the same, 14 bits of depth", [*TWO_PORTS, "--z-bits", "14"]),
    ):
        row(name, CLOCKS_A_SECOND / 25_000, most_expensive(stats(csgsim, "render", models / "sphere.csg", *options)))
    for name, camera in (
        ("carburettor", "220,-255,135,2,0,5"),
        ("terrain_vehicle", "560,-590,420,-5,0,68"),
        ("rietveld_house", "3430,-2900,1950,590,230,220"),
    ):
        report = stats(csgsim, "render", models / f"{name}.csg", "--camera", camera)
        row(f"an expression of {name}", 7.5e-3 * CLOCKS_A_SECOND / 1_900, an_expression(report), 1)
    rod = stats(csgsim, "render", models / "connecting_rod.csg", *POWERS, "--pruning", "all")
    row("connecting rod", 7.5e-3 * CLOCKS_A_SECOND, rod["clocks"])


if __name__ == "__main__":
    main()
