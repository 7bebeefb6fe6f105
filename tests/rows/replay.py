#!/usr/bin/env python3
"""Executes a row-command trace (docs/row-traces.md) and writes the picture that its SEND commands deliver.

It shares no code with csgsim: a row is a Python integer, with column c as bit c. Usage: replay.py TRACE PICTURE.ppm
"""
import sys


class Slot:
    """The rows and latches of one subarray of all chips."""

    def __init__(self, pixels):
        self.pixels = pixels  # numbers of the pixels in its columns
        self.all = (1 << len(pixels)) - 1
        self.rows = {}
        self.latches = dict.fromkeys(["SA", "R1", "R2", "R3", "R4", "R5", "T1", "T2", "T3", "T4"], 0)

    def column_bits(self, value_of):
        return sum(1 << column for column, pixel in enumerate(self.pixels) if value_of(pixel))

    def read(self, line):
        value = self.rows.get(int(line.lstrip("!")), 0)
        return value ^ self.all if line.startswith("!") else value

    def write(self, lines, mask=None):
        where = self.all if mask is None else self.latches[mask]
        for line in lines:
            value = self.latches["SA"] ^ (self.all if line.startswith("!") else 0)
            row = int(line.lstrip("!"))
            self.rows[row] = (value & where) | (self.rows.get(row, 0) & ~where)

    def open(self, lines):
        values = [self.read(line) for line in lines]
        if len(values) == 1:
            self.latches["SA"] = values[0]
            return
        a, b, c = values
        self.latches["SA"] = (a & b) | (b & c) | (a & c)
        self.write(lines)

    def table_value(self, table, operands):
        """A bit of the table for each column: the operands form its index, the first as the highest bit."""
        value = 0
        for index, bit in enumerate(table):
            match = self.all if bit == "1" else 0
            for place, name in enumerate(reversed(operands)):
                match &= self.latches[name] ^ (0 if index >> place & 1 else self.all)
            value |= match
        return value

    def logic(self, target, gate, operands):
        x, y, z = ([self.latches[name] for name in operands] + [0, 0, 0])[:3]
        self.latches[target] = {"SET0": 0, "SET1": self.all, "MOVE": x, "NOT": x ^ self.all, "AND": x & y, "OR": x | y,
                                "XOR": x ^ y, "XNOR": x ^ y ^ self.all, "SEL": (x & y) | (z & ~x)}[gate]


class Memory:
    def __init__(self):
        self.facts, self.slots, self.sent, self.expression, self.is_scan_out = {}, [], [], [0] * 7, False
        self.tables = {}  # of the declared gates

    def declare(self, words):
        self.facts[words[0]] = words[1:]
        if words[0] == "slots":
            width, height = map(int, self.facts["picture"][:2])
            count, columns, self.banks = map(int, words[1:])
            pixels = range(width * height)
            self.slots = [Slot(pixels[s * columns:(s + 1) * columns]) for s in range(count)]
        if words[0] == "rows" and words[1] in ("one", "x", "y"):
            width = int(self.facts["picture"][0])
            value_of = {"one": lambda p: 1, "x": lambda p: p % width, "y": lambda p: p // width}[words[1]]
            for slot in self.slots:
                for bit in range(int(words[3])):
                    slot.rows[int(words[2]) + bit] = slot.column_bits(lambda p, b=bit: value_of(p) >> b & 1)
        if words[0] == "gate":
            self.tables[words[1]] = words[2]
        if words[0] == "expression":
            self.expression = list(map(int, words[1:]))
        if words[0] == "scan_out":
            self.is_scan_out = True

    def expression_bit(self, slot, bit):
        _, a, b, c, xx, xy, yy = self.expression
        width = int(self.facts["picture"][0])

        def value(pixel):
            x, y = pixel % width, pixel // width
            return (a * x + b * y + c + xx * x * x + xy * x * y + yy * y * y) >> bit & 1
        return slot.column_bits(value)

    def execute(self, slot, words):
        words = words[:words.index("bus")] if "bus" in words else words
        mask = words[words.index("where") + 1] if "where" in words else None
        words = words[:words.index("where")] if "where" in words else words
        op = words[0]
        arrow = words.index("->") if "->" in words else len(words)
        if op in ("AAP", "AP", "LATCH", "READ", "SEND"):
            slot.open(words[1:arrow])
        if op == "LATCH":
            slot.latches["R4"] = slot.latches["SA"]
        if op in ("LEAF", "LEAFAP", "RECEIVE"):
            slot.latches["SA"] = self.expression_bit(slot, int(words[1]))
        if op in ("AAP", "LEAFAP", "RECEIVE"):
            slot.write(words[arrow + 1:], mask)
        if op == "WRITE":
            slot.write(words[1:], mask)
        if op == "LOGIC" and self.tables:
            slot.latches[words[1]] = slot.table_value(self.tables[words[3]], words[4:])
        elif op == "LOGIC":
            slot.logic(words[1], words[3], words[4:])
        if op == "SEND" and self.is_scan_out:
            self.sent.append((slot, slot.latches["SA"]))
        assert op in ("AAP", "AP", "LATCH", "READ", "SEND", "LEAF", "LEAFAP", "RECEIVE", "WRITE", "LOGIC", "OR",), op

    def line(self, text):
        words = text.split("#")[0].split()
        if not words:
            return
        if not words[0].isdigit():
            self.declare(words)
        elif words[5] != "REFRESH":
            bank = int(words[1])
            chosen = self.slots[bank::self.banks]
            for slot in chosen if words[2] == "*" else [chosen[int(words[2])]]:
                self.execute(slot, words[5:])

    def picture(self):
        width, height, background = map(int, self.facts["picture"])
        colours = [0 if self.sent else background] * (width * height)
        seen = {}
        for slot, row in self.sent:  # the rows of a slot arrive in the order of their bits
            bit = seen.setdefault(id(slot), 0)
            seen[id(slot)] += 1
            for column, pixel in enumerate(slot.pixels):
                colours[pixel] |= (row >> column & 1) << bit
        return width, height, colours


def main():
    memory = Memory()
    with open(sys.argv[1], encoding="ascii") as trace:
        for text in trace:
            memory.line(text)
    width, height, colours = memory.picture()
    with open(sys.argv[2], "wb") as picture:
        picture.write(b"P6\n%d %d\n255\n" % (width, height))
        picture.write(b"".join(colour.to_bytes(3, "big") for colour in colours))


if __name__ == "__main__":
    main()
