#!/usr/bin/env python3
"""Measures simulation speed of a frame: the design in Icarus and in Verilator, and csgsim's clocked level with computed
trees and with trees stepped adder by adder. Prints a table of time per clock.

Time is processor time, user and system, of a whole program. The time of many frames is reduced by that of the same
program without them: a testbench with one frame, or csgsim at its functional level, which compiles and draws without
clocks.

  speed.py CSGSIM [SIZE...]"""

import argparse
import json
import pathlib
import resource
import sys
import tempfile

from tools import MODELS, existing, run

MODEL = MODELS / "thesis_fig_2_3.csg"
FRAMES = {"icarus": 3, "verilator": 60, "csgsim": 40}
ROUNDS = 3
MOST_OF_ICARUS = 256  # pixels; larger frames take minutes


def fastest(command, folder):
    """Processor seconds of the command, from start to end; the least of some runs."""
    found = []
    for _ in range(ROUNDS):
        begin = resource.getrusage(resource.RUSAGE_CHILDREN)
        run(command, folder)
        end = resource.getrusage(resource.RUSAGE_CHILDREN)
        found.append(end.ru_utime + end.ru_stime - begin.ru_utime - begin.ru_stime)
    return min(found)


def clocked(csgsim, size, evaluator, folder):
    """Seconds per clock at the clocked level, for a sequence of the same frame."""
    words = [csgsim, "render", MODEL, "--size", size, "--frames", str(FRAMES["csgsim"])]
    with_clocks = fastest([*words, "--level", "cycle", "--evaluator", evaluator], folder)
    return (with_clocks - fastest([*words, "--level", "functional"], folder)) / clocks_of_sequence(words, folder)


def clocks_of_sequence(words, folder):
    """Clocks until the last frame has been shown."""
    run([*words, "--level", "cycle", "--stats", "sequence.json"], folder)
    frames = json.loads((folder / "sequence.json").read_text())["frames"]
    return sum(frame["interval_clocks"] for frame in frames[:-1]) + frames[-1]["shown_clocks"]


def simulated(command, simulator, interval, folder):
    """Seconds per clock of the frames that a testbench draws after its first."""
    once, often = (fastest([*command, "+picture=x.ppm", f"+frames={frames}"], folder) for frames in (1, FRAMES[simulator]))
    return (often - once) / ((FRAMES[simulator] - 1) * interval)


def interval_of(csgsim, size, folder):
    run([csgsim, "render", MODEL, "--size", size, "--level", "cycle", "-o", "x.png", "--stats", "x.json", "--quiet"], folder)
    return json.loads((folder / "x.json").read_text())["interval_clocks"]


def row(csgsim, size):
    width, height = map(int, size.split("x"))
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        run([csgsim, "rtl", "pixel-planes-4", MODEL, "--size", size, "-o", folder, "--quiet"])
        interval = interval_of(csgsim, size, folder)
        seconds = {"worked": clocked(csgsim, size, "worked-out", folder), "stepped": clocked(csgsim, size, "stepped", folder)}
        run(["make", "-s", "-C", folder, "verilated/testbench"])
        seconds["verilator"] = simulated([folder / "verilated/testbench"], "verilator", interval, folder)
        if width * height <= MOST_OF_ICARUS:
            run(["make", "-s", "-C", folder, "icarus.vvp"])
            seconds["icarus"] = simulated(["vvp", "-n", folder / "icarus.vvp"], "icarus", interval, folder)
    cells = [f"{width} × {height}"]
    for name in ("icarus", "verilator", "stepped", "worked"):
        cells.append(f"{seconds[name] * 1e6:.3g}" if name in seconds else "")
    cells.append(f"{seconds['verilator'] * 1e9 / (width * height):.3g}")
    cells.append(f"{seconds['worked'] * 1e9 / (width * height):.3g}")
    return "| " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("csgsim", type=existing)
    parser.add_argument("sizes", nargs="*", default=["8x8", "16x16", "64x64"])
    options = parser.parse_args()
    print("| pixels | Icarus, µs per clock | Verilator | csgsim, trees stepped | csgsim | Verilator, ns per pixel and clock | csgsim |")
    print("|--:|--:|--:|--:|--:|--:|--:|")
    for size in options.sizes:
        print(row(options.csgsim, size), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
