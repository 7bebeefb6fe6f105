#!/usr/bin/env python3
"""`make beside` of a design: the waves of csgsim and of the Verilog are equal, and planted faults of hw/rtl/faults.vh
are reported with the signal that shows them.

  beside_test.py CSGSIM

The exit code is 77 if Icarus is not installed."""

import pathlib
import sys
import tempfile

from tools import MODELS, attempt, existing, plant, run, skip_without, stop

MODEL = MODELS / "thesis_fig_2_3.csg"
FAULTS = {"FAULT_CARRY": "carry", "FAULT_TREE_ADDER": "tree_bit", "FAULT_ENABLE": "enable"}


def check(csgsim, folder):
    run([csgsim, "rtl", "pixel-planes-4", MODEL, "--size", "8x8", "-o", folder, "--quiet"])
    run([csgsim, "wave", MODEL, "--machine", "pixel-planes-4", "--size", "8x8", "--pixel", "3,4", "--pixel", "0,7", "--window", "0:900",
         "-o", folder / "csgsim.vcd", "--quiet"])
    beside = ["make", "-s", "-C", folder, "beside"]
    printed = run(beside).stdout
    if "clocks 0 to 899: 17 signals are equal" not in printed:
        stop(printed)
    wave, view = (folder / "beside.vcd").read_text(), (folder / "beside.gtkw").read_text()
    for scope in ("frame_buffer", "testbench", "verilog"):
        if f"$scope module {scope} $end" not in wave:
            stop(f"beside.vcd has no {scope}")
    if "verilog.pixel_0_7.enable" not in view:
        stop("beside.gtkw does not show the Verilog's pixel")
    for fault, signal in FAULTS.items():
        plant(folder, f"`{fault}")
        done = attempt(beside)
        if done.returncode == 0 or f".{signal} is " not in done.stdout:
            stop(f"{fault} does not show in {signal}:\n{done.stdout}{done.stderr}")


def main():
    skip_without(["make", "iverilog", "vvp"])
    with tempfile.TemporaryDirectory() as folder:
        check(existing(sys.argv[1]), pathlib.Path(folder))
    return 0


if __name__ == "__main__":
    sys.exit(main())
