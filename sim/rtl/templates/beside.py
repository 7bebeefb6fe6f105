#!/usr/bin/env python3
"""Combines waveforms of csgsim and of the Verilog in one file and compares them.

  beside.py WAVE [-o beside.vcd]

WAVE is a recording by `csgsim wave` of the same Program over one window of clocks, with --pixel; its save file lies beside it.
Icarus draws the frame and records all wires over the same clocks. beside.vcd contains both, each clock at csgsim's time, and the
bits of each probed pixel from the vectors; beside.gtkw shows corresponding signals below each other, the Verilog in yellow.
Differences are printed by clock, with exit code 1."""

import argparse
import pathlib
import subprocess
import sys
from dataclasses import dataclass, field

WIDTH = @WIDTH@  # pixels of a row
MACHINE = "testbench.dut.machine."
YELLOW = 3

# Signals of csgsim and the corresponding wires of the machine, compared where csgsim has a value.
WIRES = {
    "root.a": "a",
    "root.b": "b",
    "root.c": "c",
    "root.xx": "xx",
    "root.xy": "xy",
    "root.yy": "yy",
    "link.fill": "link.count",
    "answer.any_enabled": "answer",
}
# Signals of a pixel, and the corresponding vectors of its chip with a bit for every pixel. Between streams csgsim shows
# the last bit of F; of the memory outputs it shows the ALU inputs in use.
OF_PIXEL = {
    "tree_bit": "tree",
    "enable": "enable",
    "carry": "processor.carry",
    "flag": "processor.roots.negative",
    "latch": "processor.latch",
    "mem_read_x": "read_x",
    "mem_read_y": "read_y",
}


@dataclass
class Signal:
    width: int
    changes: list = field(default_factory=list)  # (time, value), all bits of it

    def at(self, times):
        """Returns the values at increasing times; None before the first."""
        found, place = [], 0
        for time in times:
            while place < len(self.changes) and self.changes[place][0] <= time:
                place += 1
            found.append(self.changes[place - 1][1] if place else None)
        return found

    def of_bits(self, at):
        """Returns a signal of the given bits, highest first; bit 0 is the lowest."""
        return Signal(len(at), [(time, "".join(value[-1 - bit] for bit in at)) for time, value in self.changes])


class Wave:
    """A VCD: its declarations, and its signals by name. Several names may share a signal."""

    def __init__(self, path):
        self.header, self.names, self.of_id = [], {}, {}
        with open(path) as lines:
            self._declare(lines)
            self._change(lines)

    def _declare(self, lines):
        scope = []
        for line in lines:
            words = line.split()
            if words[:1] == ["$enddefinitions"]:
                return
            if words[:1] == ["$scope"]:
                scope.append(words[2])
            elif words[:1] == ["$upscope"]:
                scope.pop()
            elif words[:1] == ["$var"]:
                self.names[".".join([*scope, words[4]])] = self.of_id.setdefault(words[3], Signal(int(words[2])))
            else:
                continue
            self.header.append(words)

    def _change(self, lines):
        time = 0
        for line in lines:
            if line[0] == "#":
                time = int(line[1:])
            elif line[0] in "bBsS":
                value, name = line.split()
                signal = self.of_id[name]
                signal.changes.append((time, value if line[0] in "sS" else whole(value[1:].lower(), signal.width)))
            elif line[0] in "01xzXZ":
                self.of_id[line[1:].strip()].changes.append((time, line[0].lower()))


def whole(value, width):
    return value.rjust(width, value[0] if value[0] in "xz" else "0")


def numbers(signal):
    """Returns the times at which the signal becomes a number, with the number."""
    return [(time, int(value, 2)) for time, value in signal.changes if set(value) <= {"0", "1"}]


class Clocks:
    """The clocks of the window and their times in both files."""

    def __init__(self, ours):
        name = next(name for name in ours.names if name.endswith(".clock_number"))
        self.top = name.removesuffix("clock_number")
        self.starts = [(number, time) for time, number in numbers(ours.names[name])]
        self.first, self.last = self.starts[0][0], self.starts[-1][0]
        if len(self.starts) != self.last - self.first + 1:
            sys.exit("beside.py: the wave has several windows; record one")
        self.period = self.starts[0][1] // (self.first + 1)

    def align(self, theirs):
        """Aligns with the Verilog's times: `now` counts its edges, and the first frame began at edge `began`."""
        began = next(number for _, number in numbers(theirs.names["testbench.began"]) if number)
        (before, _), (edge, count) = numbers(theirs.names["testbench.now"])[-2:]
        self.edge, self.edge_number, self.edge_period = edge, count - began, edge - before

    def ours(self, time):
        """Converts a time of the Verilog to csgsim's, at earliest the clock before the window."""
        moved = (self.edge_number + 1) * self.period + (time - self.edge) * self.period // self.edge_period
        return max(moved, self.first * self.period)


def masked(signal, by):
    """Returns the bitwise AND with another signal."""
    times = sorted({time for one in (signal, by) for time, _ in one.changes})
    both = zip(times, signal.at(times), by.at(times))
    return Signal(signal.width, [(time, "".join(bit if where == "1" else "0" for bit, where in zip(value, places)))
                                 for time, value, places in both if value and places])


def held(signal, by):
    """Samples a bit while another is 1, and holds it in between."""
    times = sorted({time for one in (signal, by) for time, _ in one.changes})
    changes = [(time, bit) for time, bit, where in zip(times, signal.at(times), by.at(times)) if where == "1"]
    return Signal(1, changes)


def of_pixel(theirs, number, wire):
    """Returns the pixel's bits of a vector of its chip, which has several planes with one bit per pixel; None if missing."""
    chips = MACHINE + "processors.chip"
    chip, here = divmod(number, theirs.names[f"{chips}[0].pixels.enable"].width)
    vector = theirs.names.get(f"{chips}[{chip}].pixels.{wire}")
    if vector is None:
        return None
    pixels = theirs.names[f"{chips}[{chip}].pixels.enable"].width
    found = vector.of_bits([here + place * pixels for place in reversed(range(vector.width // pixels))])
    if wire == "tree":
        return held(found, theirs.names[MACHINE + "stream"])
    return masked(found, theirs.names[MACHINE + "active"]) if wire in ("read_x", "read_y") else found


def pairs_of(ours, theirs, top):
    """Returns rows of csgsim's name, the Verilog's name and the Verilog's signal."""
    pairs = [(top + mine, MACHINE + wire, theirs.names[MACHINE + wire]) for mine, wire in WIRES.items()
             if top + mine in ours.names and MACHINE + wire in theirs.names]
    probed = sorted({name[len(top):].split(".")[0] for name in ours.names if name.startswith(top + "pixel_")})
    for scope in probed:
        x, y = map(int, scope.split("_")[1:])
        for mine, wire in OF_PIXEL.items():
            signal = of_pixel(theirs, y * WIDTH + x, wire) if f"{top}{scope}.{mine}" in ours.names else None
            if signal is not None:
                pairs.append((f"{top}{scope}.{mine}", f"verilog.{scope}.{mine}", signal))
    return pairs


def differences(ours, pairs, clocks):
    """Yields, for each signal, the first clock at which csgsim has a value and the Verilog another one."""
    middles = [time + clocks.period // 2 for _, time in clocks.starts]
    for mine, wire, signal in pairs:
        moved = Signal(signal.width, [(clocks.ours(time), value) for time, value in signal.changes])
        for (number, _), a, b in zip(clocks.starts, ours.names[mine].at(middles), moved.at(middles)):
            if a is None or b is None:
                continue
            width = max(len(a), len(b))
            if not set(a) & set("xz") and a.rjust(width, "0") != b.rjust(width, "0"):
                yield f"clock {number}: {mine} is {a}, {wire} is {b}"
                break


def value_line(value, name):
    return f"{value}{name}" if len(value) == 1 else f"{value} {name}" if value[0] in "sS" else f"b{value} {name}"


def write_both(path, ours, theirs, pairs, clocks):
    """Writes one VCD with the scopes of csgsim and of the Verilog, and `verilog` with the probed pixels of the latter."""
    changes = {}
    for prefix, wave, time_of in (("s", ours, lambda time: time), ("v", theirs, clocks.ours)):
        for name, signal in wave.of_id.items():
            for time, value in signal.changes:
                changes.setdefault(time_of(time), {})[prefix + name] = value
    pixels = {}
    for i, (_, wire, signal) in enumerate(pairs):
        if wire.startswith("verilog."):
            pixels.setdefault(wire.split(".")[1], []).append(f"$var wire {signal.width} p{i} {wire.split('.')[2]}"
                                                             + (f" [{signal.width - 1}:0]" if signal.width > 1 else "") + " $end")
            for time, value in signal.changes:
                changes.setdefault(clocks.ours(time), {})[f"p{i}"] = value
    lines = ["$timescale 1 ps $end"]
    for prefix, wave in (("s", ours), ("v", theirs)):
        lines += [" ".join([*words[:3], prefix + words[3], *words[4:]] if words[0] == "$var" else words) for words in wave.header]
    lines.append("$scope module verilog $end")
    for scope, variables in pixels.items():
        lines += [f"$scope module {scope} $end", *variables, "$upscope $end"]
    lines += ["$upscope $end", "$enddefinitions $end"]
    for time in sorted(changes):
        lines += [f"#{time}", *(value_line(value, name) for name, value in changes[time].items())]
    path.write_text("\n".join(lines) + "\n")


def write_view(path, base, dump, pairs):
    """Writes csgsim's save file with the Verilog's signal below each of its signals."""
    below = {}
    for mine, wire, signal in pairs:
        below[mine] = f"[color] {YELLOW}\n@{'28' if signal.width == 1 else '24'}\n{wire}" + (
            f"[{signal.width - 1}:0]" if signal.width > 1 else "")
    lines = []
    for line in base.read_text().splitlines():
        if line.startswith("[dumpfile]"):
            line = f'[dumpfile] "{dump}"'
        lines.append(line)
        if line.split("[")[0] in below:
            lines.append(below[line.split("[")[0]])
    path.write_text("\n".join(lines) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("wave", type=pathlib.Path)
    parser.add_argument("-o", dest="output", type=pathlib.Path, default=pathlib.Path("beside.vcd"))
    options = parser.parse_args()
    for path in (options.wave, options.wave.with_suffix(".gtkw")):
        if not path.exists():
            sys.exit(f"beside.py: {path} does not exist; write it with csgsim wave MODEL ... --pixel 5,5 --window 0:200 -o {options.wave}")
    ours = Wave(options.wave)
    clocks = Clocks(ours)
    wires = options.output.with_suffix(".wires.vcd")
    subprocess.run(["vvp", "-n", "icarus.vvp", "+picture=icarus.ppm", "+frames=1", f"+wave={wires}", f"+from={clocks.first}",
                    f"+until={clocks.last + 1}"], check=True, stdout=subprocess.DEVNULL)
    theirs = Wave(wires)
    wires.unlink()
    clocks.align(theirs)
    pairs = pairs_of(ours, theirs, clocks.top)
    write_both(options.output, ours, theirs, pairs, clocks)
    write_view(options.output.with_suffix(".gtkw"), options.wave.with_suffix(".gtkw"), options.output, pairs)
    wrong = list(differences(ours, pairs, clocks))
    print("\n".join(wrong) if wrong else f"clocks {clocks.first} to {clocks.last}: {len(pairs)} signals are equal")
    print(f"gtkwave {options.output.with_suffix('.gtkw')}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
