#!/usr/bin/env python3
"""Designs of `csgsim rtl`, drawn by Icarus and Verilator, held against csgsim's clocked level: the picture byte for byte, the
clocks of a frame, where they go, when it has been shown, and those from one frame to the next. Neither simulator warns.

  simulate.py CSGSIM SIMULATOR NAME...   rows of that name, with icarus or verilator
  simulate.py CSGSIM SIMULATOR long      all of them

The exit code is 77 where the simulator is not there."""

import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAMS = {"icarus": ["iverilog", "vvp"], "verilator": ["verilator"]}
SKIPPED = 77
PARTS = ["issuing", "clearing", "starved", "answering", "jumping", "draining"]
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
    "16": Row("thesis_fig_2_3", "16x16"),
    "odd": Row("thesis_fig_2_3", "13x10", options=("--set", "scan_out.pixels=3", "--colour-bits", "16", "--set", "link.width=10")),
    "buffers": Row("thesis_fig_2_3", "16x16", options=("--set", "scan_out.buffers=2", "--memory-bits", "96"), frames=4),
    "own port": Row("thesis_fig_2_3", "16x16", options=("--set", "scan_out.port=own", "--set", "memory.reads=2", "--set", "alu.bits=2")),
    "powers": Row("sphere", "16x16", "pixel-powers"),
    "32": Row("carburettor", "32x32"),
    "64": Row("carburettor", "64x64"),
}


def run(command, folder=None):
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"simulate.py: {' '.join(map(str, command))}:\n{done.stdout}{done.stderr}")
    return done.stdout, done.stderr


def drawn(simulator, frames, folder):
    """What the testbench tells, and what was warned of."""
    program, command = {"icarus": ("icarus.vvp", ["vvp", "-n", "icarus.vvp"]), "verilator": ("verilated/testbench", ["verilated/testbench"])}[simulator]
    _, warned = run(["make", "-s", program, "OPTIMISE=-O0"], folder)
    told, more = run([*command, f"+picture={simulator}.ppm", f"+frames={frames}", "+trace=trace.txt"], folder)
    run(["make", "-s", f"{simulator}.png"], folder)
    return told, warned + more


def begins_of_instructions(csgsim, words, row, folder):
    """The clock in which the controller sends the first step of each instruction, by csgsim."""
    run([csgsim, "wave", *words, "--machine", row.machine, "-o", folder / "parts.json", "--quiet"])
    events = json.loads((folder / "parts.json").read_text())["traceEvents"]
    lane = next(event["tid"] for event in events if event["ph"] == "M" and event["name"] == "thread_name" and
                event["pid"] == 2 and event["args"]["name"] == "text")
    return sorted(event["args"]["clock"] for event in events if event["ph"] == "X" and event["tid"] == lane)


def compare(csgsim, simulator, name, folder):
    """What is not as csgsim has it, a line each."""
    row = ROWS[name]
    model = ROOT / "tests/models" / f"{row.model}.csg"
    words = [str(model), "--size", row.size, *row.options]
    run([csgsim, "rtl", row.machine, *words, "-o", folder, "--quiet"])
    run([csgsim, "render", *words, "--machine", row.machine, "--level", "cycle", "-o", folder / "csgsim.ppm",
         "--stats", folder / "csgsim.json", "--quiet"])
    stats = json.loads((folder / "csgsim.json").read_text())
    told, warned = drawn(simulator, row.frames, folder)
    wrong = []

    def expect(what, ours, theirs):
        if ours != theirs:
            wrong.append(f"{name}, {simulator}: {what}: {theirs} in Verilog, {ours} by csgsim")

    def of_frame(frame, pattern):
        found = re.search(rf"^frame {frame}: .*?{pattern}", told, re.M)
        return int(found[1]) if found else None

    last = row.frames - 1
    controller = stats["account"]["parts"]["controller"]
    expect("warnings", "", warned)
    expect("clocks", stats["clocks"], of_frame(0, r"drawn after (\d+) clocks"))
    if "holding" not in controller:  # else the next frame, which csgsim leaves out here, makes refresh words wait
        expect("shown_clocks", stats["shown_clocks"], of_frame(0, r"shown after (\d+) clocks"))
    expect("interval_clocks", stats["interval_clocks"], of_frame(last - 1, r"next after (\d+) clocks"))
    expect("clocks in which instructions begin", begins_of_instructions(csgsim, words, row, folder),
           [int(line) for line in (folder / "trace.txt").read_text().split()])
    shared = "scan_out.port=own" not in row.options
    bits = int(re.search(r"VIDEO_BITS = (\d+)", (folder / "testbench.v").read_text())[1])
    expect("refresh words", int(row.size.split("x")[1]) * bits if shared else 0, of_frame(0, r"with (\d+) refresh words"))
    for part in PARTS + [part for part in OF_TWO_BUFFERS if part in controller]:
        expect(part, controller[part], of_frame(0, rf"\b{part} (\d+)"))
    expect("the picture's bytes", hash((folder / "csgsim.ppm").read_bytes()), hash((folder / f"{simulator}.ppm").read_bytes()))
    if not wrong:
        print(f"{name}, {simulator}: {stats['clocks']} clocks, the next frame after {stats['interval_clocks']}, and every byte of the picture")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("csgsim", type=lambda path: pathlib.Path(path).resolve(strict=True))
    parser.add_argument("simulator", choices=PROGRAMS)
    parser.add_argument("names", nargs="+", choices=[*ROWS, "long"])
    options = parser.parse_args()
    missing = [program for program in ["make", *PROGRAMS[options.simulator]] if not shutil.which(program)]
    if missing:
        print(f"there is no {missing[0]}; ./setup.sh test installs it")
        return SKIPPED
    names = list(ROWS) if "long" in options.names else options.names
    wrong = []
    for name in names:
        with tempfile.TemporaryDirectory() as folder:
            wrong += compare(options.csgsim, options.simulator, name, pathlib.Path(folder))
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
