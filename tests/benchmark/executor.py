"""Executes Programs in text form, pixel by pixel, in plain Python: written from docs/instruction-set.md alone, without
squares and roots, which the benchmark's Programs do not use.

Counts are those of Pixel-planes 4: ALU and trees process one bit a clock, memory is read once a clock, and a gate of the
global OR joins 64 lines (docs/machines/pixel-planes.md)."""
import math
import re
from collections import Counter
from dataclasses import dataclass, field

TERM = re.compile(r"([+-]?)(?:(\d+)\*)?([xy]|\d+)")


@dataclass
class Field:
    base: int
    width: int
    role: str = ""


@dataclass
class Linear:
    terms: dict  # A, B and C, by `x`, `y` and `1`
    width: int
    shift: int


@dataclass
class Segment:
    x: int
    y: int
    width: int
    height: int
    instructions: list = field(default_factory=list)


@dataclass
class Program:
    width: int = 0
    height: int = 0
    fields: dict = field(default_factory=dict)
    colour: Field = None
    background: int = 0
    depth: dict = None
    segments: list = field(default_factory=list)


@dataclass
class Result:
    colours: list
    depths: list
    counts: Counter = field(default_factory=Counter)  # by instruction
    skipped: int = 0
    pixel_operations: int = 0
    enabled_operations: int = 0
    used: set = field(default_factory=set)  # bits of pixel memory


def parse_linear(text):
    total, _, ending = text.rpartition("(")
    width, _, shift = ending.rstrip(")").partition(">>")
    terms = {"x": 0, "y": 0, "1": 0}
    for sign, factor, what in TERM.findall(total.replace(" ", "")):
        is_constant = what.isdigit()
        number = int(what) if is_constant else int(factor or 1)
        terms["1" if is_constant else what] += -number if sign == "-" else number
    return Linear(terms, int(width.strip()[1:]), int(shift or 0))


def parse_operand(text, fields):
    text = text.strip()
    if text.endswith(")"):
        return parse_linear(text)
    if text in fields:
        return fields[text]
    if match := re.fullmatch(r"\[(\d+)(?:\+:(\d+))?\]", text):
        return Field(int(match[1]), int(match[2] or 1))
    return int(text, 0)


def parse(text):
    program = Program()
    for line in text.splitlines():
        line = re.split("[#;]", line)[0].strip()
        name, _, rest = line.partition(" ")
        if name == ".array":
            values = dict(word.split("=") for word in rest.split())
            program.width, program.height = int(values["width"]), int(values["height"])
        elif name == ".frame":
            values = dict(word.split("=") for word in rest.split())
            program.colour = Field(int(values["colour_base"]), int(values["colour_bits"]))
            program.background = int(values.get("background", 0))
        elif name == ".depth":
            program.depth = dict(word.split("=") for word in rest.split())
        elif name == ".field":
            called, place, role = rest.split()
            program.fields[called] = parse_operand(place, {})
            program.fields[called].role = role
        elif name == ".segment":
            values = dict(word.split("=") for word in rest.split())
            program.segments.append(Segment(*(int(values[key]) for key in ("x", "y", "width", "height"))))
        elif name and not name.startswith("."):
            operands = [parse_operand(one, program.fields) for one in rest.split(",")] if rest else []
            program.segments[-1].instructions.append((name, operands))
    return program


def steps_of(name, operands, segment):
    """Clocks of an instruction."""
    if name in ("global_or", "skip_if_none"):
        trees = sum(math.ceil(math.log2(side)) for side in (segment.width, segment.height))
        return 1 + trees + next(n for n in range(9) if 64**n >= segment.width * segment.height)
    for one in operands:
        if isinstance(one, Linear):
            return one.width * (2 if name in ("keep_max", "keep_min") else 1)
    widths = [one.width for one in operands if isinstance(one, Field)]
    if name in ("set_constant", "copy", "bit_not", "xor_constant"):
        return widths[0]
    if name in ("field_lt", "field_le", "field_eq", "bit_and", "bit_or", "bit_xor", "bit_and_not", "add"):
        return 2 * max(widths)
    return 1


COMPARISONS = {"ge": lambda f, s: f >= s, "gt": lambda f, s: f > s, "le": lambda f, s: f <= s, "lt": lambda f, s: f < s,
               "eq": lambda f, s: f == s}
OF_BITS = {"bit_and": lambda s, r: s & r, "bit_or": lambda s, r: s | r, "bit_xor": lambda s, r: s ^ r,
           "bit_and_not": lambda s, r: s & ~r}
OF_ENABLE = {"enable_load": lambda e, s: s, "enable_and": lambda e, s: e and s, "enable_and_not": lambda e, s: e and not s,
             "enable_or": lambda e, s: e or s, "enable_xor": lambda e, s: e != s}


class Array:
    """The pixels of a segment: a number with all memory bits per pixel, and the set of those with E = 1."""

    def __init__(self, segment):
        self.segment = segment
        self.all = range(segment.width * segment.height)
        self.memory = [0] * len(self.all)
        self.enabled = set()

    def read(self, pixel, place):
        return self.memory[pixel] >> place.base & (1 << place.width) - 1

    def write(self, pixel, place, value):
        mask = (1 << place.width) - 1
        self.memory[pixel] = self.memory[pixel] & ~(mask << place.base) | (value & mask) << place.base

    def sum_at(self, pixel, linear):
        y, x = divmod(pixel, self.segment.width)
        total = linear.terms["x"] * x + linear.terms["y"] * y + linear.terms["1"] & (1 << linear.width) - 1
        return total - (1 << linear.width) if total >> linear.width - 1 else total

    def value(self, pixel, linear):
        return self.sum_at(pixel, linear) >> linear.shift

    def keep(self, condition):
        self.enabled = {pixel for pixel in self.enabled if condition(pixel)}

    def store_value(self, target, linear, is_wanted, with_field=None):
        """Writes F where it is wanted; disables the pixels in whose field it does not fit."""
        for pixel in list(self.enabled):
            value, old = self.value(pixel, linear), self.read(pixel, target)
            if with_field:
                self.write(pixel, target, with_field(value, old))
            elif is_wanted(value, old):
                self.write(pixel, target, value)
                if not 0 <= value < 1 << target.width:
                    self.enabled.discard(pixel)

    def execute(self, name, operands):
        first, second, third = (operands + [None] * 3)[:3]
        if name == "enable_all":
            self.enabled = set(self.all)
        elif name == "enable_invert":
            self.enabled = set(self.all) - self.enabled
        elif name in OF_ENABLE:
            self.enabled = {p for p in self.all if OF_ENABLE[name](p in self.enabled, bool(self.read(p, first)))}
        elif name == "enable_store":
            for pixel in self.all:
                self.write(pixel, first, pixel in self.enabled)
        elif name == "edge_not_negative":
            self.keep(lambda p: self.value(p, first) >= 0)
        elif name == "edge_negative":
            self.keep(lambda p: self.value(p, first) < 0)
        elif name == "stripe":
            self.keep(lambda p: self.sum_at(p, first) < 0)
        elif name.startswith("linear_") and name[7:] in COMPARISONS:
            self.keep(lambda p: COMPARISONS[name[7:]](self.value(p, second), self.read(p, first)))
        elif name == "load_linear":
            self.store_value(first, second, lambda value, old: True)
        elif name == "keep_max":
            self.store_value(first, second, lambda value, old: value > old)
        elif name == "keep_min":
            self.store_value(first, second, lambda value, old: value < old)
        elif name == "linear_plus":
            self.store_value(first, second, None, lambda value, old: value + old)
        elif name == "linear_minus":
            self.store_value(first, second, None, lambda value, old: value - old)
        elif name.startswith("field_"):
            self.keep(lambda p: COMPARISONS[name[6:]](self.read(p, first), self.read(p, second)))
        elif name not in ("global_or", "skip_if_none"):
            for pixel in self.enabled:
                self.write(pixel, first, self.new_value(name, pixel, first, second, third))

    def new_value(self, name, pixel, target, second, third):
        if name == "set_constant":
            return second
        if name == "xor_constant":
            return self.read(pixel, target) ^ second
        if name == "copy":
            return self.read(pixel, second)
        if name == "bit_not":
            return ~self.read(pixel, second)
        if name == "add":
            return self.read(pixel, target) + self.read(pixel, second)
        if name in OF_BITS:
            return OF_BITS[name](self.read(pixel, second), self.read(pixel, third))
        raise ValueError(f"{name} is not executed here")


def run(program):
    """The picture, depths and counts of a Program."""
    depth = next((one for one in program.fields.values() if one.role == "depth"), None)
    result = Result([program.background] * (program.width * program.height), [None] * (program.width * program.height))
    result.used.update(range(program.colour.base, program.colour.base + program.colour.width))
    for segment in program.segments:
        array, at = Array(segment), 0
        for _, operands in segment.instructions:
            for one in operands:
                if isinstance(one, Field):
                    result.used.update(range(one.base, one.base + one.width))
        while at < len(segment.instructions):
            name, operands = segment.instructions[at]
            steps = steps_of(name, operands, segment)
            result.counts[name] += 1
            result.pixel_operations += steps * len(array.all)
            result.enabled_operations += steps * len(array.enabled)
            array.execute(name, operands)
            skip = operands[0] if name == "skip_if_none" and not array.enabled else 0
            result.skipped += skip
            at += 1 + skip
        for pixel in array.all if segment.instructions else ():
            y, x = divmod(pixel, segment.width)
            place = (segment.y + y) * program.width + segment.x + x
            result.colours[place] = array.read(pixel, program.colour)
            result.depths[place] = array.read(pixel, depth)
    return result
