"""One instruction of One pixel, signal by signal, computed by hand and compared with a wave, for docs/lessons.md."""

import re

import by_hand
from figures import ruled
from runs import Record

from . import one_pixel_pictures as art
from .one_pixel import minus
from .one_pixel_exercises import debug, issued
from .one_pixel_story import LATENCY, Differs, X, Y, compiled, last_keep, story
from .tasks import Wave

NUMBER = 24  # the instruction that removes the pixel from A's classification
LEVELS = [f"{axis}_{depth}" for axis in "xy" for depth in range(4)]
PROBES = " ".join(f"--probe tree.{level.replace('_', ':')}" for level in LEVELS)
OPCODE, LINK = 11, 32  # linear_gt; bits of a link word


class Wires:
    """The instruction, and the signals in each of its clocks."""

    def __init__(self, figures):
        self.text = story(figures).stream[NUMBER].text
        self.plane = by_hand.expression(self.text)
        self.width = int(re.search(r"\(w(\d+)", self.text)[1])
        run = figures.runs.run(f"{compiled(8)}; csgsim wave $OUT/step.csgt --probe {X},{Y} {PROBES} --window i{NUMBER} --padding 2 -o $OUT/wires.vcd >&2")
        self.wave = Wave(run.folder / "wires.vcd")
        self.clocks = {self.number(sample, "clock_number"): sample for sample in self.wave.samples[1:]}
        self.first = next(clock for clock, sample in self.clocks.items() if self.number(sample, "controller.instruction") == NUMBER)

    def value(self, sample, name):
        return sample[self.wave.names[name]]

    def number(self, sample, name):
        text = self.value(sample, name)
        return int(text, 2) if set(text) <= {"0", "1"} else None

    def times(self, level):
        """The multiples of A and B at the input of a level: the highest bits of the column, then of the row."""
        depth = int(level[-1])
        upper = lambda place: place & (16 - (16 >> depth))
        return (upper(X), 0) if level[0] == "x" else (X, upper(Y))

    def sum_at(self, level):
        a, b = self.times(level)
        return a * self.plane.a + b * self.plane.b + self.plane.c

    def bits(self, level):
        """The bits that enter a level, and their clocks; they must equal those of the sum."""
        begin = self.first + LEVELS.index(level)
        found = []
        for n in range(self.width):
            sample = self.clocks[begin + n]
            bit = int(self.value(sample, f"pixel_{X}_{Y}.tree_{level}"))
            if self.number(sample, f"pixel_{X}_{Y}.tree_{level}_bit") != n or bit != self.sum_at(level) >> n & 1:
                raise Differs(f"bit {n} of tree_{level} is not that of {self.sum_at(level)}")
            found.append(bit)
        return found


def said(figures):
    wires = Wires(figures)
    return Record(first=wires.first, last=wires.first + wires.width - 1, at=wires.first + LATENCY, end=wires.first + LATENCY + wires.width - 1,
                  bits=36 + 3 * wires.width, words=-(-(36 + 3 * wires.width) // LINK), width=wires.width, latency=LATENCY,
                  fraction=wires.plane.shift, f=wires.plane.sum_at(X, Y), z=wires.plane.at(X, Y), c=wires.plane.c, z1=story(figures).hand.front("A", X, Y))


def link(figures):
    """The operands in the words of the link."""
    wires = Wires(figures)
    z1 = re.search(r"^\.field Z1 \[(\d+)\+:(\d+)\]", story(figures).listing, re.MULTILINE)
    rows, used = [], 0
    for name, value, bits in (("opcode of `linear_gt`", OPCODE, 6), ("first bit of Z1", int(z1[1]), 12), ("bits of Z1", int(z1[2]), 6),
                              ("width", wires.width, 6), ("fraction bits to drop", wires.plane.shift, 6),
                              *((name, value, wires.width) for name, value in zip("ABC", (wires.plane.a, wires.plane.b, wires.plane.c)))):
        rows.append((name, minus(value), f"`{value % 2**bits:0{bits}b}`", bits, f"{used} to {used + bits - 1}"))
        used += bits
    if used != said(figures).bits:
        raise Differs(f"{used} bits, not {said(figures).bits}")
    return ruled(("operand", "value", "binary", "width", "bit positions"), rows, numbers_from=9)


def levels(figures):
    wires, rows = Wires(figures), []
    for level in LEVELS:
        wires.bits(level)
        a, b = wires.times(level)
        terms = [f"{times if times > 1 else ''}{name}" for times, name in ((a, "A"), (b, "B")) if times]
        bit = 8 >> int(level[-1])
        place, name = (X, "column") if level[0] == "x" else (Y, "row")
        share = f"{bit if bit > 1 else ''}{'A' if level[0] == 'x' else 'B'}" if place & bit else "nothing"
        rows.append((f"{level[0].upper()}, level {level[-1]}", " + ".join([*terms, "C"]), minus(f"{wires.sum_at(level):,}"),
                     f"{name} has a {1 if place & bit else 0} at {bit}: {share}"))
    rows.append(("pixel", f"{X}A + {Y}B + C", f"{wires.plane.sum_at(X, Y):,}", ""))
    return ruled(("input of", "sum", "value", "the level adds"), rows, numbers_from=9)


MEANING = {"-": "fraction bit, not compared", "compare_from_0": "K := maj(F, ¬Z1, 0)", "compare": "K := maj(F, ¬Z1, K)",
           "compare_with_0": "K := maj(F, 1, K): beyond Z1", "sign_enable": "K := maj(¬F, 0, K); E := E and K: F's sign"}


def pixel(figures):
    """Clock by clock, the bits that meet at the pixel, and K and E afterwards."""
    wires, rows = Wires(figures), []
    carry = enabled = None
    for n in range(wires.width):
        clock = wires.first + LATENCY + n
        now, then = wires.clocks[clock], wires.clocks[clock + 1]
        of = lambda name, sample: wires.value(sample, f"pixel_{X}_{Y}.{name}")  # pylint: disable=cell-var-from-loop
        f, z1 = int(of("tree_bit", now)), of("mem_read_y", now)
        if f != wires.plane.sum_at(X, Y) >> n & 1:
            raise Differs(f"bit {n} of F is {f} in the wave")
        function = wires.value(now, "pixels.function")
        carry, enabled = after(function, f, None if z1 == "z" else int(z1), carry, int(of("enable", now)))
        if function != "-" and (carry, enabled) != (int(of("carry", then)), int(of("enable", then))):
            raise Differs(f"clock {clock}: K and E are {carry}, {enabled} by hand, and not in the wave")
        rows.append((clock, f, "" if z1 == "z" else z1, MEANING[function], "" if carry is None else carry, enabled))
    return ruled(("clock", "F", "Z1", "ALU", "K after", "E after"), rows, numbers_from=9)


def after(function, f, z1, carry, enabled):
    """K and E after a step, by its definition."""
    majority = lambda a, b, c: int(a + b + c >= 2)
    if function == "compare_from_0":
        carry = majority(f, 1 - z1, 0)
    elif function == "compare":
        carry = majority(f, 1 - z1, carry)
    elif function == "compare_with_0":
        carry = majority(f, 1, carry)
    elif function == "sign_enable":
        carry = majority(1 - f, 0, carry)
        enabled = enabled & carry
    return carry, enabled


CELL, LEFT, TOP = 24, 118, 34
FRACTION, FIELD, BEYOND = "#e4e4e4", "#cfe2f8", "#f9cdc8"


def pictures(figures):
    """The bits of the sum on their way down the trees, one level per clock."""
    wires = Wires(figures)
    rows = [*((f"{level[0].upper()} level {level[-1]}", wires.bits(level)) for level in LEVELS),
            (f"pixel {X},{Y}", [wires.plane.sum_at(X, Y) >> n & 1 for n in range(wires.width)])]
    columns = wires.width + len(rows) - 1
    parts = [art.text(LEFT + CELL * (n + 0.5), TOP - 10, wires.first + n, 9, art.PALE) for n in range(columns)]
    for row, (name, bits) in enumerate(rows):
        parts.append(art.text(LEFT - 8, TOP + CELL * (row + 0.5) + 4, name, 12, anchor="end", weight="bold"))
        for n, bit in enumerate(bits):
            fill = FRACTION if n < wires.plane.shift else FIELD if n < wires.plane.shift + 8 else BEYOND
            parts += [art.box(LEFT + CELL * (row + n), TOP + CELL * row, CELL, CELL, fill, "#808080", 0.8),
                      art.text(LEFT + CELL * (row + n + 0.5), TOP + CELL * (row + 0.5) + 4, bit, 12)]
    below = TOP + CELL * len(rows) + 12
    for n, (fill, words) in enumerate(((FRACTION, "fraction"), (FIELD, "meets a bit of Z1"), (BEYOND, "beyond Z1, and the sign"))):
        parts += [art.box(LEFT + 170 * n, below, 16, 14, fill, "#808080"), art.text(LEFT + 170 * n + 24, below + 12, words, 12, anchor="start")]
    folder = figures.runs.run("true # the picture of docs/lessons.md").folder
    drawing = art.picture(LEFT + CELL * columns + 12, below + 26, "Bits of the linear expression by clock and level of the trees", parts)
    (folder / "trees.svg").write_text(drawing, encoding="utf-8")
    return folder


def answers(figures):
    """The answers by hand, with the commands that show them, which are run."""
    wires, hand = Wires(figures), story(figures).hand
    runs, x, y = figures.runs, 9, 8
    asked = debug(f"until i{NUMBER + 1}", f"print E[{x},{y}]")
    setup = f"{compiled(8)}; cd $OUT; "
    is_greater = wires.plane.at(x, y) > hand.front("A", x, y)
    if f"= {int(is_greater)}" not in runs.run(setup + asked).printed:
        raise Differs(f"E at {x},{y} after i{NUMBER} is not {is_greater}")
    keep = last_keep(story(figures))
    taken = [issued(runs.run(setup + debug(f"until i{n}", "where")).printed) for n in (keep, NUMBER)]
    if taken != [story(figures).stream[keep].clocks, wires.width]:
        raise Differs(f"i{keep} and i{NUMBER} take {taken} clocks")
    column = wires.plane.a * 8 + wires.plane.c
    streams = wires_at(figures, 8, Y)
    if streams != column:
        raise Differs(f"Y level 0 at column 8 streams {streams}, not {column}")
    return "\n".join([
        f"1. {minus(column)}, which is 8A + C: `csgsim wave step.csgt --probe 8,5 --probe tree.y:0 --window i{NUMBER} -o column.vcd`",
        f"2. {'1' if is_greater else '0'}: F >> 4 is {wires.plane.at(x, y)}, and Z1 is {hand.front('A', x, y)}: `{asked}`",
        f"3. i{keep}: {taken[0]} clocks instead of {taken[1]}, because F is streamed twice, to compare and to write: `{debug(f'until i{keep}', 'where')}`",
    ])


def wires_at(figures, column, row):
    """The bits that enter level 0 of the Y tree of a column."""
    run = figures.runs.run(f"{compiled(8)}; csgsim wave $OUT/step.csgt --probe {column},{row} --probe tree.y:0 --window i{NUMBER} -o $OUT/column.vcd >&2")
    clocks = {}
    wave = Wave(run.folder / "column.vcd")
    for sample in wave.samples[1:]:
        clocks[sample[wave.names["clock_number"]]] = sample
    wave.samples = [None, *clocks.values()]
    return wave.streamed(f"pixel_{column}_{row}.tree_y_0", Wires(figures).width)
