"""Programs of all instructions, in text form, for 8 x 6 pixels: fields are narrow, so that values are equal often; some
are wide. Nothing overflows."""

import random

COLUMNS, ROWS = 8, 6
BITS = ("m", "n")  # single ones
NUMBERS = ("a", "b", "c")  # of two bits
WIDE = ("d", "w", "[40+:37]")
HEADER = f"""# csgsim program
.array width={COLUMNS} height={ROWS} memory_bits=96
.frame colour_base=0 colour_bits=0 background=0
.field a [0+:2] effect
.field b [4+:2] effect
.field c [8+:2] effect
.field m [12] effect
.field n [13] effect
.field w [20+:7] effect
.field d [28+:9] effect
.segment x=0 y=0 width={COLUMNS} height={ROWS}
"""


class Writer:
    def __init__(self, seed):
        self.rng = random.Random(seed)
        # What stands behind each name.
        self.forms = {
            "": ("enable_all", "enable_invert", "global_or"),
            "bit": ("enable_load", "enable_and", "enable_and_not", "enable_or", "enable_xor", "enable_store"),
            "linear": ("edge_not_negative", "edge_negative", "stripe"),
            "number linear": ("linear_ge", "linear_gt", "linear_le", "linear_lt", "linear_eq", "keep_max", "keep_min"),
            "any linear": ("load_linear", "linear_plus", "linear_minus"),
            "number constant": ("set_constant", "xor_constant"),
            "two": ("copy", "field_lt", "field_le", "field_eq", "add"),
            "number number": ("bit_not",),
            "number number number": ("bit_and", "bit_or", "bit_xor", "bit_and_not"),
            "wide": ("root",),
            "count": ("skip_if_none",),
            "squares": ("squares",)}
        self.kinds = {name: kinds for kinds, names in self.forms.items() for name in names}

    def sum(self, most, end):
        a, b, c = (self.rng.randint(-each, each) for each in (most, most, 7 * most))
        return f"{a}*x + {b}*y + {c} ({end})".replace("+ -", "- ")

    def linear(self):
        return self.sum(6, f"w10 >> {self.rng.choice((0, 1, 3))}")

    def any_linear(self):
        field = self.rng.choice((*NUMBERS, *WIDE))
        if field in NUMBERS:
            return f"{field}, {self.linear()}"
        return f"{field}, " + (self.sum(10**9, "w44") if field.startswith("[") else self.sum(6, "w10"))

    def squares(self):
        xx, xy, yy = (self.rng.randint(-1, 1) for _ in range(3))
        return f"{xx}*x*x + {xy}*x*y + {yy}*y*y (w10)".replace("+ -", "- ")

    def operands(self, kinds):
        rng = self.rng
        if kinds == "any linear":
            return self.any_linear()
        if kinds == "two":
            return ", ".join(rng.sample(NUMBERS, 2))
        one = {"bit": lambda: rng.choice(BITS), "number": lambda: rng.choice(NUMBERS), "linear": self.linear, "constant": lambda: str(rng.randrange(4)),
               "wide": lambda: rng.choice(WIDE), "count": lambda: str(rng.randint(1, 3)), "squares": self.squares}
        return ", ".join(one[kind]() for kind in kinds.split())

    def line(self, name):
        return f"{name} {self.operands(self.kinds[name])}".strip()

    def lines(self, count):
        names = sorted(self.kinds)
        for _ in range(count):
            name = self.rng.choice(names)
            yield self.line(name)
            if name == "squares":
                yield self.line("keep_max")
            yield "enable_store " + self.rng.choice(BITS)  # so that E is told
            if self.rng.random() < 0.7:
                yield "enable_all"
        for _ in range(4):  # that a skip may leave out
            yield "enable_all"


def text_of(seed, count=80):
    # Purposes take turns, so that each instruction is an event of its own.
    return HEADER + "".join(f"  {line}  ; {('setup', 'effect')[i % 2]}\n" for i, line in enumerate(Writer(seed).lines(count)))
