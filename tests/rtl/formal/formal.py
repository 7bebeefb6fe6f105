#!/usr/bin/env python3
"""Proofs about modules of hw/rtl with Yosys' sat: from reset, and by induction for all times. Each proof must hold, and
must fail for each fault planted in the module: a proof that cannot fail proves nothing.

  formal.py [NAME...]   the proofs of these names, or all
"""

import argparse
import functools
import pathlib
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
RTL = ROOT / "hw/rtl"
INSTRUCTIONS = ROOT / "docs/instruction-set.md"


@dataclass(frozen=True)
class Proof:
    module: str                                 # module of hw/rtl; NAME.v in this folder states its properties
    name: str
    parameters: list = field(default_factory=lambda: [{}])
    faults: list = field(default_factory=list)  # (text, its replacement)
    beside: list = field(default_factory=list)  # other modules of hw/rtl that it needs
    steps: int = 1                              # steps of the induction


PROOFS = [
    Proof("fifo", "fifo", [{"DEPTH": 1}, {"DEPTH": 2}, {"DEPTH": 3}, {"DEPTH": 4}],
          [("take & ~push", "take"), ("count != FULL", "count != END"), ("first <= last;", "first <= first;"),
           ("words[last] <= in;", "words[last] <= in | 1'b1;"), ("push ? one : 0", "0")]),
    Proof("receiver", "receiver", [{"LINK": 75}],
          [("width + (width << 1)", "width"), ("(~whole | take)", "~whole"), ("take & ~here", "1'b0"), ("count == BELOW[8:0]", "1'b1")]),
    Proof("pixel_processor", "alu", [{"ALU_BITS": 1}, {"ALU_BITS": 3}, {"ALU_BITS": 1, "MEMORY_READS": 2}],
          [("| (q & carry_here)", ""), ("present & result", "result"), ("enable & carry", "carry"), ("negative <= ~result", "negative <= result")], steps=2),
    Proof("sequencer", "sequencer", [{"ALU_BITS": 1}, {"ALU_BITS": 4}, {"ALU_BITS": 1, "MEMORY_READS": 2}],
          [("at_7 + ALU[6:0]", "at_7"), ("latching ? at", "latching ? 6'd0"), ("turn + 6'd1 : turn", "turn : turn")]),
    Proof("controller", "controller", [{"BUFFERS": 1}, {"BUFFERS": 2}, {"BUFFERS": 1, "MEMORY_READS": 2}],
          [("free && whole", "free && whole && !refresh_waits"), ("drained <= drained_here + 1", "drained <= drained_here"),
           ("at <= step_next_at", "at <= 0"), ("state <= clear_last ? READY : CLEARING", "state <= CLEARING")],
          ["receiver", "sequencer", "clearer"]),
]


def command_bits():
    """Verilog functions generated from the table of instructions and commands: the number of bits of a command."""
    rows = re.findall(r"^\| (\d+) \|.*?\| (\d+)(?: \+ (3w|n))? \| [^|]*\|$", INSTRUCTIONS.read_text(), re.M)
    if len(rows) != 40:
        sys.exit(f"formal.py: {INSTRUCTIONS} lists {len(rows)} commands with bits on a link, expected 40")
    cases, numbers = [], []
    for number, bits, more in rows:
        width_at = 6 if int(bits) < 36 else 24  # after the number, or after the number and a field
        more_bits = {"3w": f" + 3 * command[{width_at} +: 6]", "n": " + command[18 +: 6]", "": ""}[more]
        cases.append(f"    6'd{number}: command_bits = 9'd{bits}{more_bits};")
        numbers.append(f"number == 6'd{number}")
    return ("function [8:0] command_bits(input [COMMAND_BITS-1:0] command);\n  case (command[5:0])\n" + "\n".join(cases) +
            "\n    default: command_bits = 9'd6;\n  endcase\nendfunction\n" +
            "function is_command(input [5:0] number);\n  is_command = " + " ||\n    ".join(numbers) + ";\nendfunction\n")


@functools.cache
def lowering():
    """Yosys commands that convert assertions into the cells that `sat` accepts. Newer versions represent an assertion
    as a $check cell, which `chformal -lower` converts once `async2sync` has removed its clock; older ones have
    neither."""
    known = subprocess.run(["yosys", "-p", "help chformal"], capture_output=True, text=True).stdout
    return "async2sync; chformal -lower; " if "-lower" in known else ""


def proved(proof, parameters, source, folder):
    """Whether Yosys proves it for that source."""
    text = folder / f"{proof.module}.v"
    text.write_text(source)
    top = f"{proof.name}_check"
    files = " ".join([str(text), *(str(RTL / f"{name}.v") for name in proof.beside), str(HERE / f"{proof.name}.v")])
    values = " ".join(f"-chparam {name} {value}" for name, value in parameters.items())
    script = (f"read_verilog -formal -sv -I{RTL} -I{HERE} -I{folder} {files}; hierarchy -top {top} {values}; proc; {lowering()}memory -nordff; memory_map; flatten; "
              f"opt -full; sat -verify -prove-asserts -set-assumes -seq 1 -tempinduct -maxsteps {proof.steps} {top}")
    done = subprocess.run(["yosys", "-q", "-p", script], capture_output=True, text=True)
    if done.returncode != 0 and "proof did fail" not in done.stdout + done.stderr:
        sys.exit(f"formal.py: Yosys rejects {proof.name}:\n{done.stdout}{done.stderr}")
    return done.returncode == 0


def check(proof, folder):
    source = (RTL / f"{proof.module}.v").read_text()
    wrong = []
    for parameters in proof.parameters:
        if not proved(proof, parameters, source, folder):
            wrong.append(f"{proof.name} does not hold with {parameters}")
    for old, new in proof.faults:
        if source.count(old) == 0:
            wrong.append(f"{proof.name}: {proof.module}.v does not have the text of the planted fault, {old}")
        elif all(proved(proof, parameters, source.replace(old, new), folder) for parameters in proof.parameters):
            wrong.append(f"{proof.name}: {new} in place of {old} is not detected")
    for line in wrong:
        print("formal.py: " + line)
    print(f"{proof.name}: {len(proof.parameters)} sets of parameters, {len(proof.faults)} planted faults")
    return not wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", help="names of proofs")
    names = parser.parse_args().names
    unknown = set(names) - {proof.name for proof in PROOFS}
    if unknown:
        parser.error(f"unknown proof {', '.join(sorted(unknown))}; the proofs are {', '.join(proof.name for proof in PROOFS)}")
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "command_bits.vh").write_text(command_bits())
        results = [check(proof, folder) for proof in PROOFS if not names or proof.name in names]
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
