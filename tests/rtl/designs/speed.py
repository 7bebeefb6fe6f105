#!/usr/bin/env python3
"""How fast a frame is simulated: the design in Icarus and in Verilator, and csgsim's clocked level with trees worked out
and with trees stepped adder by adder, each alone on a processor, in one run. Prints a table of seconds a clock.

  speed.py CSGSIM [SIZE...]"""

import argparse
import json
import pathlib
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
MODEL = ROOT / "tests/models/thesis_fig_2_3.csg"
FRAMES = {"icarus": 2, "verilator": 40}
ROUNDS = 3
MOST_OF_ICARUS = 256  # pixels, beyond which a frame takes minutes


def run(command, folder=None):
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"speed.py: {' '.join(map(str, command))}:\n{done.stdout}{done.stderr}")


def fastest(command, folder):
    """Seconds of the processor, start and end of the program included."""
    found = []
    for _ in range(ROUNDS):
        begin = resource.getrusage(resource.RUSAGE_CHILDREN)
        run(command, folder)
        end = resource.getrusage(resource.RUSAGE_CHILDREN)
        found.append(end.ru_utime + end.ru_stime - begin.ru_utime - begin.ru_stime)
    return min(found)


def clocked(csgsim, size, evaluator, folder):
    """Seconds of a frame at the clocked level, and its clocks."""
    found = []
    for _ in range(4 * ROUNDS):  # each is short
        run([csgsim, "render", MODEL, "--size", size, "--level", "cycle", "--evaluator", evaluator, "-o", "clocked.png", "--stats",
             "clocked.json", "--quiet"], folder)
        stats = json.loads((folder / "clocked.json").read_text())
        found.append(stats["wall_seconds"])
    return min(found), stats["interval_clocks"], stats["shown_clocks"]


def row(csgsim, size):
    width, height = map(int, size.split("x"))
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        run([csgsim, "rtl", "pixel-planes-4", MODEL, "--size", size, "-o", folder, "--quiet"])
        seconds = {}
        seconds["worked"], interval, shown = clocked(csgsim, size, "worked-out", folder)
        seconds["stepped"], _, _ = clocked(csgsim, size, "stepped", folder)
        run(["make", "-s", "-C", folder, "verilated/testbench"])
        seconds["verilator"] = fastest([folder / "verilated/testbench", "+picture=x.ppm", f"+frames={FRAMES['verilator']}"], folder) / (FRAMES["verilator"] * interval)
        if width * height <= MOST_OF_ICARUS:
            run(["make", "-s", "-C", folder, "icarus.vvp"])
            seconds["icarus"] = fastest(["vvp", "-n", folder / "icarus.vvp", "+picture=x.ppm", f"+frames={FRAMES['icarus']}"], folder) / (FRAMES["icarus"] * interval)
        for name in ("worked", "stepped"):
            seconds[name] /= shown
    cells = [f"{width} × {height}"]
    for name in ("icarus", "verilator", "stepped", "worked"):
        cells.append(f"{seconds[name] * 1e6:.3g}" if name in seconds else "")
    cells.append(f"{seconds['verilator'] * 1e9 / (width * height):.3g}")
    cells.append(f"{seconds['worked'] * 1e9 / (width * height):.3g}")
    return "| " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("csgsim", type=lambda path: pathlib.Path(path).resolve(strict=True))
    parser.add_argument("sizes", nargs="*", default=["8x8", "16x16"])
    options = parser.parse_args()
    print("| pixels | Icarus, µs a clock | Verilator | csgsim, trees stepped | csgsim | Verilator, ns a pixel and clock | csgsim |")
    print("|--:|--:|--:|--:|--:|--:|--:|")
    for size in options.sizes:
        print(row(options.csgsim, size), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
