"""The stream of docs/lessons.md in steps, with the state of every pixel after each.

The state computed by tests/docs/by_hand.py is compared with csgsim debug for every pixel and step before it is
shown."""

import functools
import re
from dataclasses import dataclass

import by_hand

MODEL = "tests/docs/models/notched_step.csg"
VIEW = "--size 16x16 --fraction-bits 4 --camera 30,-24,36,6,6,4"
OPTIONS = f"{VIEW} --z-bits 8 --strategy bits"
X, Y = 7, 5
BOXES = "ABN"
LATENCY, OR_LEVELS = 8, 2  # for 16 x 16 pixels: a level per bit of x and y; two levels of OR gates
STEPS = ["setup", "A render", "A test", "A skip", "A classify", "A mask", "A merge", "A shade",
         "B render", "B test", "B skip", "B classify", "B mask", "B merge", "B shade", "N render",
         "N in A test", "N in A skip", "N in A classify", "N in A mask", "N in A merge", "N in A shade",
         "N in B test", "N in B skip", "N in B classify", "N in B mask", "N in B merge", "N in B shade"]


@dataclass
class Instruction:
    """A line of the disassembly: its text, purpose, boxes, and the clocks by the rules."""

    text: str
    purpose: str
    box: str
    clocks: int


@dataclass
class Step:
    """Instructions first to last, and the state of every pixel after them: {(x, y): by_hand.Pixel}."""

    name: str
    first: int
    last: int
    clocks: int
    after: dict


class Differs(ValueError):
    """Raised if csgsim and the computation by hand differ."""


def read(listing):
    """Instructions of a disassembly."""
    widths = {name: width for name, width in re.findall(r"^\.field (\w+) \[\d+\+:(\d+)\]", listing, re.MULTILINE)}
    widths.update({name: "1" for name in re.findall(r"^\.field (\w+) \[\d+\] ", listing, re.MULTILINE)})
    found = []
    for text, purpose, box in re.findall(r"^  (\S.*?) +; (\w+)(?: p(\d))?.*# i\d+$", listing, re.MULTILINE):
        target = re.match(r"\w+ (\w+)", text)
        measured = f"{text} <{widths[target[1]]}>" if target and target[1] in widths else text
        found.append(Instruction(text, purpose, BOXES[int(box)] if box else "", by_hand.clocks(measured, LATENCY, OR_LEVELS)))
    return found


def begins(stream):
    """The first instruction of each step, where the purpose or box changes, or an instruction that only begins a
    step."""
    found, was = [0], stream[0]
    for n, each in enumerate(stream[1:], 1):
        name, purpose = each.text.split()[0], each.purpose
        is_next = purpose == "render" and each.box != was.box  # the next surface
        is_next |= name == "enable_all" and was.purpose == "shade" or name == "field_lt" and n - 1 != found[-1]
        is_next |= name in ("skip_if_none", "copy") or was.text.startswith("skip_if_none")
        is_next |= purpose == "stack" and was.purpose == "classify" or purpose == "shade" != was.purpose
        if is_next:
            found.append(n)
        was = each
    return found


def printed_states(printed):
    """The output of csgsim debug for every pixel at each of its stops: [{(x, y): {field: value}}]."""
    stops, pixel = [], None
    for line in printed.splitlines():
        at = re.match(r"> print (\d+),(\d+)$", line)
        value = re.match(r"  (\w+) +(\d+)", line)
        if at:
            pixel = (int(at[1]), int(at[2]))
            if pixel == (0, 0):
                stops.append({})
            stops[-1][pixel] = {}
        elif line.startswith(">"):
            pixel = None
        elif value and pixel:
            stops[-1][pixel][value[1]] = int(value[2])
    return stops


def compare(step, place, hand, machine):
    fields = {"E": int(hand.enabled), "Z1": hand.z1, "Z2": hand.z2, "mask": int(hand.mask), "colour": hand.colour}
    for name, value in fields.items():
        if value is not None and value != machine[name]:
            raise Differs(f"{step} at {place}: {name} is {value} by hand, {machine[name]} by csgsim debug")


def compiled(z_bits):
    return f"csgsim compile {MODEL} {OPTIONS.replace('--z-bits 8', f'--z-bits {z_bits}')} -o $OUT/step.csgt >&2"


def stream_and_hand(runs, z_bits):
    """The disassembly for a number of bits of depth, its instructions, and the picture by hand."""
    listing = runs.run(f"{compiled(z_bits)}; csgsim disasm $OUT/step.csgt").printed
    stream = read(listing)
    return listing, stream, by_hand.ByHand([plane for each in stream if (plane := by_hand.expression(each.text))], z_bits)


class Story:
    """The stream in steps, each with the state of all pixels after it."""

    def __init__(self, runs):
        self.listing, self.stream, self.hand = stream_and_hand(runs, 8)
        first = begins(self.stream)
        if len(first) != len(STEPS):
            raise Differs(f"the stream has {len(first)} steps, not {len(STEPS)}")
        last = [n - 1 for n in first[1:]] + [len(self.stream) - 1]
        stops = "".join(f"{f'until i{n + 1}' if n + 1 < len(self.stream) else 'run'}\n{self.prints()}" for n in last)
        debugged = runs.run(f"{compiled(8)}; csgsim debug $OUT/step.csgt -x - <<'END'\n{stops}END")
        self.steps = self.checked(first, last, printed_states(debugged.printed))
        self.stats = runs.run(f"csgsim render {MODEL} {OPTIONS} --progress none --stats $OUT/stats.json").json("stats.json")
        self.check_clocks()

    def watched(self, runs, numbers):
        """The state of the tracked pixel after each of these instructions."""
        stops = "".join(f"until i{n + 1}\nprint 0,0\nprint {X},{Y}\n" for n in numbers)
        return printed_states(runs.run(f"{compiled(8)}; csgsim debug $OUT/step.csgt -x - <<'END'\n{stops}END").printed)

    def prints(self):
        return "".join(f"print {x},{y}\n" for y in range(by_hand.SIDE) for x in range(by_hand.SIDE))

    def checked(self, first, last, stops):
        places = [(x, y) for y in range(by_hand.SIDE) for x in range(by_hand.SIDE)]
        hand = {place: dict(self.hand.pixel(*place)) for place in places}
        steps = []
        for name, begin, end, machine in zip(STEPS, first, last, stops, strict=True):
            known = name.replace("skip", "test")
            for place in places:
                compare(name, place, hand[place][known], machine[place])
            after = {place: hand[place][known] for place in places}
            steps.append(Step(name, begin, end, sum(each.clocks for each in self.stream[begin : end + 1]), after))
        return steps

    def check_clocks(self):
        """Checks that the clocks by the rules equal those of the stats, by purpose."""
        for purpose, of in self.stats.by_purpose.items():
            by_rule = LATENCY if purpose == "latency" else self.clocks(purpose)
            if by_rule != of.clocks:
                raise Differs(f"{purpose} takes {by_rule} clocks by the rules, {of.clocks} by the stats")

    def clocks(self, purpose):
        return sum(each.clocks for each in self.stream if each.purpose == purpose)

    def step(self, name):
        return next(step for step in self.steps if step.name == name)


@functools.cache
def of_runs(runs):
    return Story(runs)


def story(figures):
    return of_runs(figures.runs)


def is_in(box, face):
    return f"{'XYZ'[face.axis]} = {face.place(box)}"


def last_keep(told_by):
    """The instruction that sets the pixel to A's depth."""
    step = told_by.step("A render")
    return next(n for n in range(step.last, step.first, -1) if told_by.stream[n].text.startswith("keep_max"))
