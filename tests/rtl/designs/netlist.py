#!/usr/bin/env python3
"""Simulates the FPGA netlist in Icarus: a design of `csgsim rtl`, synthesised for an iCE40 as by `make ice40`, with
Yosys' models of the cells. The picture must equal that of csgsim's clocked level byte for byte, as must the clocks
after which a frame is drawn, shown and followed by the next. Then repeats it for netlists with planted faults: each
must be detected.

  netlist.py CSGSIM [FAULT...]

The exit code is 77 if Yosys or Icarus is not installed."""

import argparse
import pathlib
import re
import shutil
import sys
import tempfile

from tools import MODELS, designed, existing, plant, run, skip_without

MODEL = MODELS / "thesis_fig_2_3.csg"
FIGURES = ["--size", "4x4", "--colour-bits", "6", "--set", "scan_out.pixels=1", "--set", "link.fifo_depth=2"]
FAULTS = [1, 6]  # in hw/rtl/faults.vh: one in the ALU, one in an adder of the trees
TIMES = {"clocks": "drawn", "interval_clocks": "next", "shown_clocks": "shown"}


def cell_models():
    """Path of Yosys' models of an iCE40's cells."""
    return pathlib.Path(shutil.which("yosys")).resolve().parents[1] / "share/yosys/ice40/cells_sim.v"


def synthesise(folder):
    """Synthesises `system` into cells, in netlist.v."""
    run(["yosys", "-q", "-p", "read_verilog -defer -Irtl system.v rtl/*.v; synth_ice40 -abc9 -device hx -top system; "
         "write_verilog -noattr netlist.v"], folder)


def drawn(folder):
    """Simulates the netlist and returns what the testbench prints."""
    run(["iverilog", "-g2005", "-DPORTS_ALONE", "-DNO_ICE40_DEFAULT_ASSIGNMENTS", "-s", "testbench", "-o", "netlist.vvp", "testbench.v",
         "netlist.v", cell_models()], folder)
    return run(["vvp", "-n", "netlist.vvp", "+picture=netlist.ppm", "+frames=1"], folder).stdout


def differences(csgsim, fault, folder):
    """Differences from csgsim, one per line."""
    stats = designed(csgsim, "pixel-planes-4", [MODEL, *FIGURES], folder)
    if fault:
        plant(folder, fault)
    synthesise(folder)
    printed = drawn(folder)
    wrong = []
    for name, what in TIMES.items():
        found = re.search(rf"^frame 0: {what} after (\d+) clocks", printed, re.M)
        if not found or int(found[1]) != stats[name]:
            wrong.append(f"{name}: {found[1] if found else 'none'} of the netlist, {stats[name]} by csgsim")
    picture = folder / "netlist.ppm"
    if not picture.exists() or picture.read_bytes() != (folder / "csgsim.ppm").read_bytes():
        wrong.append("the picture differs")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("csgsim", type=existing)
    parser.add_argument("faults", nargs="*", type=int, default=FAULTS)
    options = parser.parse_args()
    skip_without(["yosys", "iverilog", "vvp"])
    failed = False
    for fault in [0, *options.faults]:
        with tempfile.TemporaryDirectory() as folder:
            wrong = differences(options.csgsim, fault, pathlib.Path(folder))
        print(f"{f'planted fault {fault}' if fault else 'the netlist'}: {'; '.join(wrong) or 'equal to csgsim'}", flush=True)
        failed = failed or bool(wrong) != bool(fault)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
