"""The three tasks of docs/view.md, and the values in the multiplier trees shown by their wave."""

import re

from .steps import Steps

STEPS = Steps("docs/view.md", links=["hw", "tests", "traces"], not_run=["gtkwave"], section="Three tasks")
lines = STEPS.lines
folder = STEPS.folder

LEVELS = ("x_0", "x_1", "x_2", "x_3", "y_3")
SIZE = 8


class Wave:
    """The samples of a VCD: the values of all signals at each time."""

    def __init__(self, path):
        self.names = {}
        self.samples = []
        scope, held = [], {}
        for line in path.read_text(encoding="utf-8").splitlines():
            words = line.split()
            if line.startswith("$scope"):
                scope.append(words[2])
            elif line.startswith("$upscope"):
                scope.pop()
            elif line.startswith("$var"):
                self.names[".".join([*scope[1:], words[4]])] = words[3]
            elif line.startswith("#"):
                self.samples.append(dict(held))
            elif len(words) == 2 and line[0] in "bs":
                held[words[1]] = words[0][1:]
            elif len(words) == 1 and line[0] in "01xz":
                held[line[1:]] = line[0]
        self.samples.append(held)

    def streamed(self, signal, width):
        """The first complete number of `width` bits on a wire, one bit per clock from the lowest on. Their indices are
        on a second wire; a number that began before the window lacks its lowest bit."""
        bits = []
        for sample in self.samples[1:]:
            index, bit = int(sample[self.names[signal + "_bit"]], 2), int(sample[self.names[signal]])
            if index == 0:
                bits = [bit]
            elif bits and index == len(bits):
                bits.append(bit)
            if len(bits) == width:
                return sum(each << i for i, each in enumerate(bits)) - (bits[-1] << width)
        raise ValueError(f"no number of {width} bits is on {signal}")


    def instruction(self):
        """The first instruction of the controller."""
        name = self.names["controller.text"]
        text = next(sample[name] for sample in self.samples if sample.get(name, "-") != "-")
        return text.replace("\\x20", " ")


def expression(text):
    """A, B, C and the width of `A*x + B*y + C (wN`, as written by csgsim disasm."""
    form = re.search(r"(-?\d+)\*x ([+-] \d+)\*y ([+-] \d+) \(w(\d+)", text)
    return tuple(int(part.replace(" ", "")) for part in form.groups())


def trees(figures, column, row):
    """The partial sum of each level of the trees on the path to a pixel: streamed in the wave, and computed."""
    column, row = int(column), int(row)
    wave = Wave(folder(figures) / "trees.vcd")
    text = wave.instruction()
    a, b, c, width = expression(text)
    table = [f"The instruction is `{text}`.", "", "| wire | value | expression |", "|---|---:|---|"]
    for level in LEVELS:
        axis, depth = level[0], int(level[2])
        upper = lambda place: place & (SIZE - (SIZE >> depth))  # its highest bits, one per level above
        times_a, times_b = (upper(column), 0) if axis == "x" else (column, upper(row))
        streamed = wave.streamed(f"pixel_{column}_{row}.tree_{level}", width)
        if streamed != times_a * a + times_b * b + c:
            raise ValueError(f"tree.{axis}:{depth} streams {streamed}, not {times_a}A + {times_b}B + C")
        terms = [f"{times}{name}" for times, name in ((times_a, "A"), (times_b, "B")) if times]
        table.append(f"| `tree.{axis}:{depth}` | {streamed:,} | {' + '.join([*terms, 'C'])} |")
    return "\n".join(table)
