#!/usr/bin/env python3
"""Measures the size of a cell of the scan-line array without the bits of its memory, as synthesised by Yosys.

  area.py            write the table of docs/hardware.md between its marks
  area.py --check    compare; exit code 1 if it has changed
"""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
RTL = ROOT / "hw" / "rtl" / "scan_line"
SCRIPT = ROOT / "tests" / "rtl" / "map_for_area.abc"
PAGE = ROOT / "docs" / "hardware.md"
ROWS = {"cell": "ROOTS=0", "cell that takes roots": "ROOTS=1", "cell that takes roots, of degree 2": "ROOTS=1 DEGREE=2",
        "cell, ALU of 8, shifter of 8": "ROOTS=0 ALU_BITS=8 SHIFT_BITS=8"}
# The page's numbers by versions of Yosys other than 0.23, which wrote them: gates, flip-flops and transistors, per row.
ROWS_BY_VERSION = {"0.52": [(11568, 577, 61048), (13202, 610, 68916), (13528, 643, 70610), (7560, 571, 43872)]}
MARKED = re.compile(r"(<!-- cell -->\n).*?(<!-- end -->)", re.S)


def synthesised(parameters):
    """Gates, flip-flops and transistors of a cell."""
    values = " ".join(f"-chparam {item.replace('=', ' ')}" for item in parameters.split())
    script = "; ".join([f"read_verilog -I{RTL} {RTL}/*.v", f"hierarchy -top scan_line_cell {values}", "blackbox *cell_memory*",
                        "synth -flatten -top scan_line_cell", "dfflegalize -cell $_DFF_P_ 01",
                        f"abc -g cmos4 -script {SCRIPT}", "opt_clean", "stat -tech cmos"])
    run = subprocess.run(["yosys", "-p", script], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit("area.py: yosys failed:\n" + run.stdout[-2000:] + run.stderr)
    text = run.stdout.rsplit("Printing statistics.", 1)[1]
    counts = {cell: int(count) for cell, count in re.findall(r"(\$_\w+_) +(\d+)", text)}
    flip_flops = counts.pop("$_DFF_P_")
    # The memory's module prevents stat from adding up: a flip-flop has 16 transistors, a gate of n inputs 2 n.
    inputs = {"$_NOT_": 1, "$_NAND_": 2, "$_NOR_": 2, "$_AOI3_": 3, "$_OAI3_": 3, "$_AOI4_": 4, "$_OAI4_": 4}
    transistors = 16 * flip_flops + sum(2 * inputs[gate] * count for gate, count in counts.items())
    return sum(counts.values()), flip_flops, transistors


def yosys_version():
    return re.match(r"Yosys (\S+)", subprocess.run(["yosys", "-V"], capture_output=True, text=True).stdout)[1]


def main():
    cells = [synthesised(parameters) for parameters in ROWS.values()]
    other = ROWS_BY_VERSION.get(yosys_version())
    if sys.argv[1:] == ["--check"] and other:
        for name, cell, expected in zip(ROWS, cells, other):
            if cell != expected:
                print(f"area.py: {name}: synthesised {cell}, but ROWS_BY_VERSION has {expected}")
        return int(cells != other)
    rows = "".join(f"| {name} | {gates:,} | {flip_flops:,} | {transistors:,} |\n"
                   for name, (gates, flip_flops, transistors) in zip(ROWS, cells))
    table = "| with the parameters of `scan-line` | gates | flip-flops | transistors |\n|---|--:|--:|--:|\n" + rows
    page = PAGE.read_text()
    told = MARKED.sub(lambda match: match[1] + table + match[2], page)
    if sys.argv[1:] == ["--check"]:
        if told != page:
            print("area.py: the size of a cell differs from docs/hardware.md; run tests/rtl/scan_line/area.py")
        return int(told != page)
    PAGE.write_text(told)
    return 0


if __name__ == "__main__":
    sys.exit(main())
