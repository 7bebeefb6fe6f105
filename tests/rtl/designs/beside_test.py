#!/usr/bin/env python3
"""`make beside` of a design: waves of csgsim and of the Verilog are equal, and planted faults of hw/rtl/faults.vh are told with
the signal that shows them.

  beside_test.py CSGSIM

The exit code is 77 where Icarus is not there."""

import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
MODEL = ROOT / "tests/models/thesis_fig_2_3.csg"
SKIPPED = 77
FAULTS = {"FAULT_CARRY": "carry", "FAULT_TREE_ADDER": "tree_bit", "FAULT_ENABLE": "enable"}


def run(*words, expected=0):
    done = subprocess.run(words, capture_output=True, text=True)
    if (done.returncode == 0) != (expected == 0):
        sys.exit(f"beside_test.py: {' '.join(map(str, words))} ends with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


def plant(folder, fault):
    """In the design's own copy of the modules."""
    path = folder / "rtl/faults.vh"
    text = (ROOT / "hw/rtl/faults.vh").read_text()
    none = "FAULT(NUMBER) 1'b0"
    if none not in text:
        sys.exit(f"beside_test.py: faults.vh has no {none}")
    path.write_text(text.replace(none, f"FAULT(NUMBER) (NUMBER == `{fault})"))


def check(csgsim, folder):
    run(csgsim, "rtl", "pixel-planes-4", MODEL, "--size", "8x8", "-o", folder, "--quiet")
    run(csgsim, "wave", MODEL, "--machine", "pixel-planes-4", "--size", "8x8", "--pixel", "3,4", "--pixel", "0,7", "--window", "0:900", "-o",
        folder / "csgsim.vcd", "--quiet")
    told = run("make", "-s", "-C", folder, "beside")
    if "clocks 0 to 899: 17 signals are the same" not in told:
        sys.exit(f"beside_test.py: {told}")
    wave, view = (folder / "beside.vcd").read_text(), (folder / "beside.gtkw").read_text()
    for scope in ("frame_buffer", "testbench", "verilog"):
        if f"$scope module {scope} $end" not in wave:
            sys.exit(f"beside_test.py: beside.vcd has no {scope}")
    if "verilog.pixel_0_7.enable" not in view:
        sys.exit("beside_test.py: beside.gtkw does not show the Verilog's pixel")
    for fault, signal in FAULTS.items():
        plant(folder, fault)
        told = run("make", "-s", "-C", folder, "beside", expected=1)
        if f".{signal} is " not in told:
            sys.exit(f"beside_test.py: {fault} does not show in {signal}:\n{told}")


def main():
    missing = [program for program in ("make", "iverilog", "vvp") if not shutil.which(program)]
    if missing:
        print(f"there is no {missing[0]}; ./setup.sh test installs it")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        check(pathlib.Path(sys.argv[1]).resolve(strict=True), pathlib.Path(folder))
    return 0


if __name__ == "__main__":
    sys.exit(main())
