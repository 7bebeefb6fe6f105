#!/usr/bin/env python3
"""Synthesises the Verilog with Yosys and records its cost.

  area.py [--liberty FILE]   write hw/machines/area_table.h, and the tables of docs/hardware.md between their marks
  area.py --check            synthesise the narrowest ALUs again and compare; exit code 1 if a number has changed

Transistors are those of static CMOS counted by `stat -tech cmos`, mapped for area to NAND, NOR, AOI and OAI gates, and
those of nMOS, mapped to the cells of nmos.lib, whose areas are transistors. FILE is a liberty library, such as
osu05_stdcells.lib of Debian's qflow-tech-osu050; without it the columns of areas are kept. Tables and flip-flops of an
iCE40 are results of synth_ice40.
"""

import argparse
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
CONTROLLER = "controller, receiver and sequencer"
FIFO_DEPTH, FIFO_BITS = 16, 32
FIFO = f"FIFO of the link, {FIFO_DEPTH} words of {FIFO_BITS} bits"
TABLE = ROOT / "hw" / "machines" / "area_table.h"
PAGE = ROOT / "docs" / "hardware.md"

ALU_BITS = (1, 2, 4, 8, 16, 32)
PAGE_ALU_BITS = (1, 2, 4, 8)
NODE_BITS = ALU_BITS  # bits of a stream per clock
READS = (1, 2)
MEMORY_BITS = (64, 72, 96, 128, 208, 256)
CELL = {1: 3, 2: 5}  # transistors of a memory bit, by read ports: as in hw/machines/area.h
STATIC_CELL = {1: 6, 2: 8}
RTL = ROOT / "hw" / "rtl"
SOURCES = " ".join(str(path) for path in sorted(RTL.glob("*.v"))) + " area.v"
WIDE_SOURCES = "area_wide.v"  # a separate file, so that other syntheses do not depend on it
# Transistors of the controller by versions of Yosys other than 0.23, which wrote the table. All other checked numbers are
# equal in these versions.
CONTROLLER_BY_VERSION = {"0.52": 37762}
NMOS = "nmos.lib"
SCRIPT = "map_for_area.abc"  # in a file, because versions of Yosys differ in how they split a script in a command


def yosys(commands):
    """The last statistics that Yosys prints."""
    run = subprocess.run(["yosys", "-p", "; ".join(commands)], cwd=HERE, capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit("area.py: yosys failed:\n" + run.stdout[-2000:] + run.stderr)
    return run.stdout.rsplit("Printing statistics.", 1)[1]


def synthesised(top, parameters, liberty, sources=SOURCES):
    """Gates, flip-flops, transistors, and the area in a cell library (None without one)."""
    values = " ".join(f"-chparam {name} {value}" for name, value in parameters.items())
    begin = [f"read_verilog -I{RTL} {sources}", f"hierarchy -top {top} {values}", f"synth -flatten -top {top}"]
    text = yosys(begin + ["dfflegalize -cell $_DFF_P_ 01", f"abc -g cmos4 -script {SCRIPT}", "opt_clean",
                          "stat -tech cmos"])
    cells = int(re.search(r"Number of cells: +(\d+)", text)[1])
    flip_flops = sum(int(count) for count in re.findall(r"\$_DFF_P_ +(\d+)", text))
    transistors = int(re.search(r"Estimated number of transistors: +(\d+)", text)[1])
    area = mapped_area(begin, liberty) if liberty else None
    luts, registers = ice40(top, values, sources)
    return {"gates": cells - flip_flops, "flip_flops": flip_flops, "transistors": transistors,
            "nmos": mapped_area(begin, NMOS), "area": area, "luts": luts, "registers": registers}


def mapped_area(begin, liberty):
    """The area of the design mapped to the cells of a library."""
    text = yosys(begin + [f"dfflibmap -liberty {liberty}", f"abc -liberty {liberty} -script {SCRIPT}", "opt_clean",
                          f"stat -liberty {liberty}"])
    return round(float(re.search(r"Chip area for module .*: ([\d.]+)", text)[1]))


def ice40(top, values, sources):
    """Four-input tables and flip-flops of an iCE40."""
    text = yosys([f"read_verilog -I{RTL} {sources}", f"hierarchy -top {top} {values}", f"synth_ice40 -top {top}", "stat"])
    count = lambda cell: sum(int(number) for number in re.findall(rf"{cell}\w* +(\d+)", text))
    return count("SB_LUT4"), count("SB_DFF")


def yosys_version():
    return re.match(r"Yosys (\S+)", subprocess.run(["yosys", "-V"], capture_output=True, text=True).stdout)[1]


def pixel(alu_bits, reads, degree, liberty):
    """A pixel; with degree 2 it has the flag for roots."""
    return synthesised("area_pixel", {"ALU_BITS": alu_bits, "MEMORY_READS": reads, "ROOTS": degree - 1}, liberty)


def node(bits, degree, liberty):
    """A node; in degree 2 the mean of the nodes of a Y tree: half of them delay their slope by 0 bits, a quarter by 1,
    an eighth by 2."""
    wide = {"BITS": bits} if bits > 1 else {}
    top = ("area_wide_node" if wide else "area_node") + ("_2" if degree == 2 else "")
    sources = WIDE_SOURCES if wide else SOURCES
    if degree == 1:
        return synthesised(top, wide, liberty, sources=sources)
    none, two = (synthesised(top, wide | {"DELAY": delay}, liberty, sources=sources) for delay in (0, 2))
    return {key: None if none[key] is None else round((none[key] + two[key]) / 2) for key in none}


def controller(liberty):
    figures = {"MEMORY_BITS": 72, "ADDRESS": 7, "SIDE": 10, "LATENCY": 18, "CLEAR_CLOCKS": 72, "LINK": 32}
    return synthesised("controller", figures, liberty)


def fifo(liberty):
    return synthesised("fifo", {"DEPTH": FIFO_DEPTH, "BITS": FIFO_BITS}, liberty)


def shared(liberty):
    """The logic shared by all pixels of a machine with the parameters of pixel-planes-4, by name."""
    rows = {CONTROLLER: controller(liberty), FIFO: fifo(liberty),
            "delay of the control word, 18 clocks":
            synthesised("area_delay", {"ADDRESS": 7, "SIDE": 10, "LATENCY": 18}, liberty)}
    return rows


def shared_constants(rows):
    return f"""inline constexpr Transistors controller_transistors{{{counts(rows[CONTROLLER])}}};
inline constexpr Transistors fifo_transistors{{{counts(rows[FIFO])}}};
"""


def counts(row):
    return f"{row['transistors']}, {row['nmos']}"


def grouped(number):
    return "" if number is None else f"{number:,}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "|".join(["---"] + ["--:"] * (len(head) - 1)) + "|"]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def area_on_page(name):
    """The area stated on the page, for runs without a library."""
    row = re.search(rf"^\| {re.escape(name)} \|(.*)\|$", PAGE.read_text(), re.M)
    return row[1].split("|")[4].strip() if row else ""


def figures(name, row):
    area = area_on_page(name) if row["area"] is None else grouped(row["area"])
    return [name, grouped(row["gates"]), grouped(row["flip_flops"]), grouped(row["transistors"]), grouped(row["nmos"]), area,
            grouped(row["luts"]), grouped(row["registers"])]


def pixel_name(alu, reads, degree):
    flag = " and a flag for roots" if degree == 2 else ""
    return f"pixel, ALU of {alu}, {reads} read{'s' if reads > 1 else ''} a clock{flag}"


def node_name(bits, degree):
    return ("node of the multiplier trees" + (" of degree 2" if degree == 2 else "") +
            (f", {bits} bits a clock" if bits > 1 else ""))


def tables(pixels, nodes, wired_or, rest):
    """The tables of the page, by mark."""
    head = ["", "gates", "flip-flops", "transistors", "in nMOS", "area, µm²", "iCE40 tables", "iCE40 flip-flops"]
    shown = [(alu, reads, 1) for alu in PAGE_ALU_BITS for reads in READS] + [(1, reads, 2) for reads in READS]
    logic = [figures(pixel_name(*key), pixels[key]) for key in shown]
    logic += [figures(node_name(bits, degree), nodes[bits, degree]) for degree in (1, 2) for bits in PAGE_ALU_BITS]
    logic.append(["global OR, 64 inputs a gate, 1/4,096 of it"] + wired_or)

    def logic_of(key):
        return pixels[key]["transistors"] + nodes[1, key[2]]["transistors"]

    def row(key, cell):
        return [grouped(logic_of(key) + bits * cell[key[1]]) for bits in MEMORY_BITS]

    depths = [[key[0], key[1], key[2], grouped(logic_of(key))] + row(key, CELL) for key in shown]
    static = [[key[0], key[1], key[2], ""] + row(key, STATIC_CELL) for key in ((1, 1, 1), (1, 2, 1), (1, 1, 2), (1, 2, 2))]
    depth_head = ["ALU, bits", "reads", "degree", "logic"] + [f"{bits} bits" for bits in MEMORY_BITS]
    return {"logic": table(head, logic), "depths": table(depth_head, depths), "static": table(depth_head, static),
            "shared": table(head, [figures(name, row) for name, row in rest.items()])}


def header(pixels, nodes, rest):
    rows = "\n".join(f"    {{{alu}, {reads}, {degree}, {{{counts(row)}}}}},"
                     for (alu, reads, degree), row in pixels.items())
    of_nodes = "\n".join(f"    {{{bits}, {degree}, {{{counts(row)}}}}}," for (bits, degree), row in nodes.items())
    return f"""// Synthesized transistor counts.
// Used by area.cpp and hw/process.
#pragma once

#include <array>
#include <cstdint>

// Written by tests/rtl/area.py from Yosys's synthesis of the Verilog in hw/rtl.
namespace csgsim::machines {{

/// Transistors of a circuit in static CMOS, and in nMOS with depletion loads, dynamic latches and pass-transistor
/// selectors (tests/rtl/nmos.lib).
struct Transistors {{
  std::uint32_t cmos;
  std::uint32_t nmos;
}};

/// A pixel processor with its registers and the rotators of its memory ports, without its memory; in degree 2 with the
/// flag for roots.
struct PixelLogic {{
  std::uint32_t alu_bits;
  std::uint32_t memory_reads;
  std::uint32_t degree;
  Transistors transistors;
}};

// clang-format off
inline constexpr auto pixel_logic_table = std::to_array<PixelLogic>({{
{rows}
}});
// clang-format on

/// A node of the multiplier trees with that degree (1 or 2) and stream width; there is one per pixel.
struct NodeLogic {{
  std::uint32_t bits;
  std::uint32_t degree;
  Transistors transistors;
}};

// clang-format off
inline constexpr auto node_logic_table = std::to_array<NodeLogic>({{
{of_nodes}
}});
// clang-format on

/// The controller with its receiver, and the link's FIFO with fifo_bits bits, for the parameters of pixel-planes-4.
{shared_constants(rest)}inline constexpr std::uint32_t fifo_bits = {FIFO_DEPTH * FIFO_BITS};

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

    # Yosys accepts the whole machine.
    yosys([f"read_verilog -I{RTL} {SOURCES}", "hierarchy -check -top pixel_planes", "proc", "check -assert", "stat"])
    nodes = {(bits, degree): node(bits, degree, None) for degree in (1, 2) for bits in (1, 2)}
    for (bits, degree), now in nodes.items():
        expect(f"{{{bits}, {degree}, {{{counts(now)}}}}}", text, TABLE,
               f"a node of {bits} bits and degree {degree} takes {counts(now)} transistors (CMOS, nMOS)")
    for alu_bits, reads, degree in ((1, 1, 1), (1, 2, 1), (2, 1, 1), (1, 1, 2), (1, 2, 2)):
        now = pixel(alu_bits, reads, degree, None)
        what = f"an ALU of {alu_bits} with {reads} reads and degree {degree} takes {counts(now)} transistors (CMOS, nMOS)"
        expect(f"{{{alu_bits}, {reads}, {degree}, {{{counts(now)}}}}}", text, TABLE, what)
        logic = now["transistors"] + nodes[1, degree]["transistors"]
        cells = [alu_bits, reads, degree, grouped(logic)] + [grouped(logic + n * CELL[reads]) for n in MEMORY_BITS]
        expect("| " + " | ".join(map(str, cells)) + " |", page, PAGE, what)
    controller_now = controller(None)
    other = CONTROLLER_BY_VERSION.get(yosys_version())
    if other is not None:
        if controller_now["transistors"] != other:
            wrong.append(f"the controller takes {controller_now['transistors']} transistors, and CONTROLLER_BY_VERSION says {other}")
        controller_now["transistors"] = int(re.search(r"controller_transistors\{(\d+)", text)[1])
    for line in shared_constants({CONTROLLER: controller_now, FIFO: fifo(None)}).splitlines():
        expect(line, text, TABLE, line.removeprefix("inline constexpr ").removesuffix(";"))
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
    pixels = {(alu, reads, degree): pixel(alu, reads, degree, options.liberty)
              for degree in (1, 2) for alu in ALU_BITS for reads in READS}
    nodes = {(bits, degree): node(bits, degree, options.liberty) for degree in (1, 2) for bits in NODE_BITS}
    whole_or = synthesised("global_or", {"LINES": 4096, "FAN_IN": 64}, options.liberty)
    wired_or = [f"{value / 4096:.2f}" if value is not None else area_on_page("global OR, 64 inputs a gate, 1/4,096 of it")
                for value in whole_or.values()]
    rest = shared(options.liberty)
    TABLE.write_text(header(pixels, nodes, rest))
    page = PAGE.read_text()
    for name, rows in tables(pixels, nodes, wired_or, rest).items():
        page = marked(name).sub(lambda match: match[1] + rows + "\n" + match[2], page)
    PAGE.write_text(page)
    return 0


if __name__ == "__main__":
    sys.exit(main())
