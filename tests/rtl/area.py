#!/usr/bin/env python3
"""Synthesises the Verilog with Yosys and writes what it costs.

  area.py [--liberty FILE]   write hw/machines/area_table.h, and the tables of docs/area.md between their marks
  area.py --check            synthesise the narrowest ALUs again and compare; exit code 1 if a figure has changed

Transistors are those of static CMOS that `stat -tech cmos` counts, mapped for area to NAND, NOR, AOI and OAI gates.
FILE is a liberty library, such as osu05_stdcells.lib of Debian's qflow-tech-osu050; without it the columns of areas stay
as they are.
"""

import argparse
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
TABLE = ROOT / "hw" / "machines" / "area_table.h"
PAGE = ROOT / "docs" / "area.md"

ALU_BITS = (1, 2, 4, 8, 16, 32)
PAGE_ALU_BITS = (1, 2, 4, 8)
READS = (1, 2)
MEMORY_BITS = (64, 72, 96, 128, 208, 256)
CELL = {1: 3, 2: 5}  # transistors of a memory bit, by read ports: as hw/machines/area.h has it
STATIC_CELL = {1: 6, 2: 8}
SOURCES = "pixel.v multiplier_tree.v receiver.v controller.v frame_buffer.v area.v"
SCRIPT = "+strash;dch;map,-a"


def yosys(commands):
    """The last statistics that Yosys prints."""
    run = subprocess.run(["yosys", "-p", "; ".join(commands)], cwd=HERE, capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit("area.py: yosys failed:\n" + run.stdout[-2000:] + run.stderr)
    return run.stdout.rsplit("Printing statistics.", 1)[1]


def synthesised(top, parameters, liberty):
    """Gates, flip-flops, transistors, and the area in a cell library (None without one)."""
    values = " ".join(f"-chparam {name} {value}" for name, value in parameters.items())
    begin = [f"read_verilog -I. {SOURCES}", f"hierarchy -top {top} {values}", f"synth -flatten -top {top}"]
    text = yosys(begin + ["dfflegalize -cell $_DFF_P_ 01", f"abc -g cmos4 -script {SCRIPT}", "opt_clean",
                          "stat -tech cmos"])
    cells = int(re.search(r"Number of cells: +(\d+)", text)[1])
    flip_flops = sum(int(count) for count in re.findall(r"\$_DFF_P_ +(\d+)", text))
    transistors = int(re.search(r"Estimated number of transistors: +(\d+)", text)[1])
    area = None
    if liberty:
        text = yosys(begin + [f"dfflibmap -liberty {liberty}", f"abc -liberty {liberty} -script {SCRIPT}", "opt_clean",
                              f"stat -liberty {liberty}"])
        area = round(float(re.search(r"Chip area for module .*: ([\d.]+)", text)[1]))
    return {"gates": cells - flip_flops, "flip_flops": flip_flops, "transistors": transistors, "area": area}


def pixel(alu_bits, reads, liberty):
    return synthesised("area_pixel", {"ALU_BITS": alu_bits, "MEMORY_READS": reads}, liberty)


def shared(liberty):
    """What the pixels share, of a machine with the figures of pixel-planes-4, by name."""
    figures = {"MEMORY_BITS": 72, "ADDRESS": 7, "SIDE": 10}
    rows = {"controller, receiver and sequencer":
            synthesised("controller", figures | {"LATENCY": 18, "CLEAR_CLOCKS": 72, "LINK": 32}, liberty),
            "FIFO of the link, 16 words of 32 bits": synthesised("fifo", {"DEPTH": 16, "BITS": 32}, liberty),
            "delay of the control word, 18 clocks":
            synthesised("area_delay", {"ADDRESS": 7, "SIDE": 10, "LATENCY": 18}, liberty)}
    return rows


def grouped(number):
    return "" if number is None else f"{number:,}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "|".join(["---"] + ["--:"] * (len(head) - 1)) + "|"]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def figures(row):
    return [grouped(row["gates"]), grouped(row["flip_flops"]), grouped(row["transistors"]), grouped(row["area"])]


def tables(pixels, node, wired_or, rest):
    """The tables of the page, by mark."""
    head = ["", "gates", "flip-flops", "transistors", "area, µm²"]
    logic = [[f"pixel, ALU of {alu}, {reads} read{'s' if reads > 1 else ''} a clock"] + figures(pixels[alu, reads])
             for alu in PAGE_ALU_BITS for reads in READS]
    logic += [["node of the multiplier trees"] + figures(node), ["global OR, 64 inputs a gate, 1/4,096 of it"] + wired_or]

    def all_of(alu, reads, bits, cell):
        return pixels[alu, reads]["transistors"] + node["transistors"] + bits * cell[reads]

    depths = []
    for alu in PAGE_ALU_BITS:
        for reads in READS:
            depths.append([alu, reads, grouped(pixels[alu, reads]["transistors"] + node["transistors"])] +
                          [grouped(all_of(alu, reads, bits, CELL)) for bits in MEMORY_BITS])
    static = [[alu, reads, ""] + [grouped(all_of(alu, reads, bits, STATIC_CELL)) for bits in MEMORY_BITS]
              for alu, reads in ((1, 1), (1, 2))]
    depth_head = ["ALU, bits", "reads", "logic"] + [f"{bits} bits" for bits in MEMORY_BITS]
    return {"logic": table(head, logic), "depths": table(depth_head, depths), "static": table(depth_head, static),
            "shared": table(head, [[name] + figures(row) for name, row in rest.items()])}


def header(pixels, node):
    rows = "\n".join(f"    {{{alu}, {reads}, {row['transistors']}}}," for (alu, reads), row in pixels.items())
    return f"""#pragma once

#include <array>
#include <cstdint>

/// Written by tests/rtl/area.py from what Yosys makes of the Verilog in tests/rtl: transistors of static CMOS.
namespace csgsim::machines {{

/// A pixel processor with its registers and the turning of its memory ports, without its memory.
struct PixelLogic {{
  std::uint32_t alu_bits;
  std::uint32_t memory_reads;
  std::uint32_t transistors;
}};

// clang-format off
inline constexpr auto pixel_logic_table = std::to_array<PixelLogic>({{
{rows}
}});
// clang-format on

/// A node of the multiplier trees, of which there is one a pixel.
inline constexpr std::uint32_t tree_node_transistors = {node['transistors']};

}}  // namespace csgsim::machines
"""


def marked(name):
    return re.compile(rf"(<!-- {name} -->\n).*?(<!-- end -->)", re.S)


def check():
    text = TABLE.read_text()
    page = PAGE.read_text()
    wrong = []

    def expect(line, where, path, what):
        if line not in where:
            wrong.append(f"{what}, and {path.relative_to(ROOT)} says otherwise; run tests/rtl/area.py")

    # It takes the whole machine.
    yosys([f"read_verilog -I. {SOURCES}", "hierarchy -check -top frame_buffer", "proc", "check -assert", "stat"])
    node = synthesised("area_node", {}, None)["transistors"]
    expect(f"tree_node_transistors = {node};", text, TABLE, f"a tree node takes {node} transistors")
    for alu_bits, reads in ((1, 1), (1, 2), (2, 1)):
        now = pixel(alu_bits, reads, None)["transistors"]
        what = f"an ALU of {alu_bits} with {reads} reads takes {now} transistors"
        expect(f"{{{alu_bits}, {reads}, {now}}}", text, TABLE, what)
        cells = [alu_bits, reads, grouped(now + node)] + [grouped(now + node + n * CELL[reads]) for n in MEMORY_BITS]
        expect("| " + " | ".join(map(str, cells)) + " |", page, PAGE, what)
    for line in wrong:
        print("area.py: " + line)
    return 1 if wrong else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--liberty", type=lambda name: pathlib.Path(name).resolve(strict=True))
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if options.check:
        return check()
    pixels = {(alu, reads): pixel(alu, reads, options.liberty) for alu in ALU_BITS for reads in READS}
    node = synthesised("area_node", {}, options.liberty)
    whole_or = synthesised("global_or", {"LINES": 4096, "FAN_IN": 64}, options.liberty)
    wired_or = [f"{value / 4096:.2f}" if value is not None else "" for value in whole_or.values()]
    TABLE.write_text(header(pixels, node))
    page = PAGE.read_text()
    for name, rows in tables(pixels, node, wired_or, shared(options.liberty)).items():
        page = marked(name).sub(lambda match: match[1] + rows + "\n" + match[2], page)
    PAGE.write_text(page)
    return 0


if __name__ == "__main__":
    sys.exit(main())
