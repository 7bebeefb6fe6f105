#!/usr/bin/env python3
"""Simulates designs of `csgsim rtl` in Icarus and Verilator and compares them with csgsim's clocked level: the picture
byte for byte; the clocks of a frame by activity, and when its instructions begin; for a sequence of the same frame,
when each is drawn, shown and followed by the next; and when a frame without a successor has been shown. Neither
simulator may warn.

  simulate.py CSGSIM SIMULATOR NAME...   rows of that name, with icarus or verilator
  simulate.py CSGSIM SIMULATOR long      all rows; with icarus those of at most 256 pixels

The exit code is 77 if the simulator is not installed."""

import argparse
import json
import math
import pathlib
import re
import sys
import tempfile
from dataclasses import dataclass

from tools import MODELS, designed, existing, run, skip_without, stop

PROGRAMS = {"icarus": ["iverilog", "vvp"], "verilator": ["verilator"]}
PARTS = ["issuing", "clearing", "starved", "answering", "jumping", "draining"]
MOST_OF_ICARUS = 256  # pixels
OF_TWO_BUFFERS = ["refreshing", "holding", "copying"]


@dataclass(frozen=True)
class Row:
    model: str
    size: str
    machine: str = "pixel-planes-4"
    options: tuple = ()
    frames: int = 2


ROWS = {
    "small": Row("thesis_fig_2_3", "8x8"),
    # A scan-out wider than the array, and colour channels of 2, 3 and 2 bits.
    "corners": Row("thesis_fig_2_3", "8x6", options=("--set", "scan_out.pixels=16", "--colour-bits", "7")),
    "16": Row("thesis_fig_2_3", "16x16"),
    "odd": Row("thesis_fig_2_3", "13x10", options=("--set", "scan_out.pixels=3", "--colour-bits", "16", "--set", "link.width=10")),
    "buffers": Row("thesis_fig_2_3", "16x16", options=("--set", "scan_out.buffers=2", "--memory-bits", "96"), frames=4),
    "wide": Row("thesis_fig_2_3", "64x4", options=("--set", "scan_out.buffers=2", "--set", "scan_out.pixels=1", "--memory-bits", "96"), frames=4),
    "own port": Row("thesis_fig_2_3", "16x16", options=("--set", "scan_out.port=own", "--set", "memory.reads=2", "--set", "alu.bits=2")),
    "powers": Row("sphere", "16x16", "pixel-powers"),
    "32": Row("carburettor", "32x32"),
    "64": Row("carburettor", "64x64"),
}


def drawn(simulator, frames, folder):
    """Simulates the design; returns what the testbench prints, and all warnings."""
    program, command = {"icarus": ("icarus.vvp", ["vvp", "-n", "icarus.vvp"]), "verilator": ("verilated/testbench", ["verilated/testbench"])}[simulator]
    warned = run(["make", "-s", program, "OPTIMISE=-O0"], folder).stderr
    printed = run([*command, f"+picture={simulator}.ppm", f"+frames={frames}", "+trace=trace.txt"], folder)
    run(["make", "-s", f"{simulator}.png"], folder)
    return printed.stdout, warned + printed.stderr


def shown_alone(simulator, folder):
    """The clocks until a frame without a successor has been shown, from a testbench whose host has only one frame."""
    system = folder / "system.v"
    endless = ".FRAMES(0)"
    text = system.read_text()
    if endless not in text:
        stop(f"system.v has no {endless}")
    system.write_text(text.replace(endless, ".FRAMES(1)"))
    printed, _ = drawn(simulator, 1, folder)
    return of_frame(printed, 0, r"shown after (\d+) clocks")


def of_frame(printed, frame, pattern):
    """The number that the testbench prints for a frame, or None."""
    found = re.search(rf"^frame {frame}: .*?{pattern}", printed, re.M)
    return int(found[1]) if found else None


def times_of_sequence(csgsim, words, row, folder):
    """For each frame with a successor: the clocks until it is drawn, until it has been shown, and until the next
    begins."""
    run([csgsim, "render", *words, "--machine", row.machine, "--level", "cycle", "--frames", str(row.frames + 1), "-o",
         folder / "sequence.png", "--stats", folder / "sequence.json"])
    frames = json.loads((folder / "sequence.json").read_text())["frames"]
    if len(frames) != row.frames + 1:
        stop(f"expected {row.frames + 1} frames, not {len(frames)}")
    return [tuple(frame[key] for key in ("clocks", "shown_clocks", "interval_clocks")) for frame in frames[:-1]]


def begins_of_instructions(csgsim, words, row, folder):
    """The clock in which the controller sends the first step of each instruction, from csgsim."""
    run([csgsim, "wave", *words, "--machine", row.machine, "-o", folder / "parts.json", "--quiet"])
    events = json.loads((folder / "parts.json").read_text())["traceEvents"]
    lane = next(event["tid"] for event in events if event["ph"] == "M" and event["name"] == "thread_name" and
                event["pid"] == 2 and event["args"]["name"] == "text")
    return sorted(event["args"]["clock"] for event in events if event["ph"] == "X" and event["tid"] == lane)


def alone(simulator, printed, controller, folder):
    """The clocks until a frame without a successor is shown. With one buffer the next frame begins when the last row
    has been latched, so it does not matter; with two the refresh words wait for the next frame's instructions."""
    return shown_alone(simulator, folder) if "copying" in controller else of_frame(printed, 0, r"shown after (\d+) clocks")


def compare(csgsim, simulator, name, folder):
    """Differences from csgsim, one per line."""
    row = ROWS[name]
    model = MODELS / f"{row.model}.csg"
    words = [str(model), "--size", row.size, *row.options]
    stats = designed(csgsim, row.machine, words, folder)
    printed, warned = drawn(simulator, row.frames, folder)
    wrong = []

    def expect(what, ours, theirs):
        if ours != theirs:
            wrong.append(f"{name}, {simulator}: {what}: {theirs} in Verilog, {ours} by csgsim")

    controller = stats["account"]["parts"]["controller"]
    expect("warnings", "", warned)
    expect("clocks", stats["clocks"], of_frame(printed, 0, r"drawn after (\d+) clocks"))
    for frame, times in enumerate(times_of_sequence(csgsim, words, row, folder)):
        for what, clocks in zip(("drawn", "shown", "next"), times):
            expect(f"frame {frame}, {what}", clocks, of_frame(printed, frame, rf"{what} after (\d+) clocks"))
    expect("interval_clocks", stats["interval_clocks"], of_frame(printed, row.frames - 1, r"next after (\d+) clocks"))
    expect("clocks in which instructions begin", begins_of_instructions(csgsim, words, row, folder),
           [int(line) for line in (folder / "trace.txt").read_text().split()])
    shared = "scan_out.port=own" not in row.options
    bits = int(re.search(r"VIDEO_BITS = (\d+)", (folder / "testbench.v").read_text())[1])
    expect("refresh words", int(row.size.split("x")[1]) * bits if shared else 0, of_frame(printed, 0, r"with (\d+) refresh words"))
    for part in PARTS + [part for part in OF_TWO_BUFFERS if part in controller]:
        expect(part, controller[part], of_frame(printed, 0, rf"\b{part} (\d+)"))
    expect("the picture's bytes", hash((folder / "csgsim.ppm").read_bytes()), hash((folder / f"{simulator}.ppm").read_bytes()))
    expect("shown_clocks", stats["shown_clocks"], alone(simulator, printed, controller, folder))
    if not wrong:
        print(f"{name}, {simulator}: {stats['clocks']} clocks, the next frame after {stats['interval_clocks']}, and an equal picture")
    return wrong


def fitting(simulator):
    """Names of the rows that do not take hours."""
    return [name for name, row in ROWS.items() if simulator != "icarus" or math.prod(map(int, row.size.split("x"))) <= MOST_OF_ICARUS]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("csgsim", type=existing)
    parser.add_argument("simulator", choices=PROGRAMS)
    parser.add_argument("names", nargs="+", choices=[*ROWS, "long"])
    options = parser.parse_args()
    skip_without(["make", *PROGRAMS[options.simulator]])
    names = fitting(options.simulator) if "long" in options.names else options.names
    wrong = []
    for name in names:
        with tempfile.TemporaryDirectory() as folder:
            wrong += compare(options.csgsim, options.simulator, name, pathlib.Path(folder))
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
