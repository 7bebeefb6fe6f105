#!/usr/bin/env python3
"""Draws the machine's modules and the wires between them, as found by Yosys in hw/rtl: nested boxes for nested modules,
and an arrow from the driver of a wire to its reader. Laid out by Graphviz.

  hierarchy.py OUT.svg"""

import argparse
import collections
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
RTL = ROOT / "hw/rtl"
TOP = "pixel_planes"
FIGURES = {"WIDTH": 4, "HEIGHT": 4, "MEMORY_BITS": 16, "CHIP": 8, "FIFO_DEPTH": 2, "FAN_IN": 4, "COLOUR_BITS": 6, "CLEAR_CLOCKS": 3,
           "SCAN_SHARED": 1}
EVERYWHERE = {"clk", "reset"}
MANY = 3  # maximum number of names on an arrow


def elaborated():
    """The modules of the machine with these parameters, from Yosys."""
    values = " ".join(f"-chparam {name} {value}" for name, value in FIGURES.items())
    files = " ".join(str(path) for path in sorted(RTL.glob("*.v")))
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "machine.json"
        script = f"read_verilog -defer -I{RTL} {files}; hierarchy -top {TOP} {values}; proc; write_json {out}"
        done = subprocess.run(["yosys", "-q", "-p", script], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"hierarchy.py: {done.stderr}")
        return json.loads(out.read_text())["modules"]


def plain(name):
    """A module's name without its parameters."""
    return name.split("\\")[1] if name.startswith("$paramod") else name


class Drawing:
    def __init__(self, modules):
        self.modules = modules
        self.lines = []
        self.wires = collections.defaultdict(lambda: (set(), set()))  # by bit: drivers and readers
        self.labels = {}                               # by bit
        self.number = 0
        top = next(name for name, module in modules.items() if int(module["attributes"].get("top", "0"), 2))
        self.outside(top, self.place(top, 1, {}, ""))

    @staticmethod
    def nets(scope, bits, bit):
        """The machine-level wires of a bit of a module, for all instances that are drawn as one box."""
        if not isinstance(bit, int):
            return set()
        return bits.get(bit, {(scope, bit)})

    def place(self, name, count, bits, indent):
        """Draws a module; `bits` maps its port bits to the wires outside."""
        module = self.modules[name]
        self.number += 1
        scope = self.number
        box = f"box{scope}"
        groups = collections.defaultdict(list)
        for cell in module["cells"].values():
            if self.is_drawn(cell, name):
                groups[plain(cell["type"])].append(cell)
        title = plain(name) + (f" × {count}" if count > 1 else "")
        if groups:
            self.lines.append(f'{indent}subgraph cluster{scope} {{ label="{title}"; style="rounded,filled"; fillcolor="#00000008"; color="#7a7a7a";')
        own = "logic" if groups else title
        self.label(module, scope, bits)
        if self.connect(module, scope, box, bits, name):
            self.lines.append(f'{indent}  {box} [label="{own}"' + (', style="rounded,dashed"' if groups else "") + "];")
        for cells in groups.values():
            inner = collections.defaultdict(set)
            widest = max(cells, key=lambda cell: sum(map(len, cell["connections"].values())))["type"]
            for cell in cells:
                for port, outside in cell["connections"].items():
                    for own_bit, there in zip(self.modules[widest]["ports"][port]["bits"], outside):
                        inner[own_bit] |= self.nets(scope, bits, there)
            self.place(widest, len(cells), dict(inner), indent + "  ")
        if groups:
            self.lines.append(f"{indent}}}")
        return scope

    def is_drawn(self, cell, name):
        """Delays, and modules inside modules of the same name, are not drawn separately."""
        return cell["type"] in self.modules and plain(cell["type"]) not in ("delay", plain(name))

    def label(self, module, scope, bits):
        for label, net in module["netnames"].items():
            for bit in net["bits"]:
                for whole in self.nets(scope, bits, bit):
                    if not label.startswith("$") and not net.get("hide_name"):
                        self.labels.setdefault(whole, label)

    def connect(self, module, scope, box, bits, name):
        """Adds the module's own logic as driver and reader; a module without inner modules drives its outputs and reads
        its inputs. Returns whether it has any connection."""
        cells = [cell for cell in module["cells"].values() if not self.is_drawn(cell, name)]
        is_leaf = len(cells) == len(module["cells"])
        ends = [("output" if one["direction"] == "output" else "input", one["bits"])
                for port, one in module["ports"].items() if port not in EVERYWHERE] if is_leaf else [
                    (cell["port_directions"][port], outside) for cell in cells for port, outside in cell["connections"].items()]
        for direction, outside in ends:
            for bit in outside:
                for whole in self.nets(scope, bits, bit):
                    self.wires[whole][0 if direction == "output" else 1].add(box)
        return bool(ends)

    def outside(self, name, scope):
        for port, one in self.modules[name]["ports"].items():
            if port not in EVERYWHERE:
                for bit in one["bits"]:
                    self.wires[scope, bit][1 if one["direction"] == "output" else 0].add("outside")

    @staticmethod
    def words(names):
        """The text of an arrow: wires by name, with their number."""
        short = collections.Counter()
        for name, count in names.items():
            short[name.split(".")[-1]] += count
        shown = [name + (f" [{count}]" if count > 1 else "") for name, count in sorted(short.items()) if name]
        return "\\n".join(shown[:MANY] + (["…"] if len(shown) > MANY else []))

    def text(self):
        arrows = collections.defaultdict(lambda: collections.Counter())
        for bit, (drivers, readers) in self.wires.items():
            for driver in sorted(drivers):
                for reader in sorted(readers):
                    if driver != reader and self.labels.get(bit, "") not in EVERYWHERE:
                        arrows[driver, reader][self.labels.get(bit, "")] += 1
        lines = [f'digraph machine {{ rankdir=LR; compound=true; fontname="DejaVu Sans"; fontsize=12; nodesep=0.25; ranksep=0.6;',
                 '  node [shape=box, style="rounded,filled", fillcolor="white", color="#3465a4", fontname="DejaVu Sans", fontsize=11];',
                 '  edge [color="#555753", fontname="DejaVu Sans", fontsize=8, arrowsize=0.6];',
                 '  outside [label="host and screen", shape=plaintext, style=""];', *self.lines]
        for (driver, reader), names in sorted(arrows.items()):
            back = arrows.get((reader, driver))
            if back is None:
                lines.append(f'  {driver} -> {reader} [label="{self.words(names)}"];')
            elif driver < reader:
                lines.append(f'  {driver} -> {reader} [dir=both, label="▸ {self.words(names)}\\n◂ {self.words(back)}"];')
        return "\n".join(lines + ["}"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("svg", type=pathlib.Path)
    svg = parser.parse_args().svg
    text = Drawing(elaborated()).text()
    done = subprocess.run(["dot", "-Tsvg"], input=text, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"hierarchy.py: {done.stderr}")
    svg.write_text(done.stdout)
    return 0


if __name__ == "__main__":
    sys.exit(main())
