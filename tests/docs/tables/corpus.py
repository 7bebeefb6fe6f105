"""OpenSCAD's own examples on the machines, in docs/performance.md."""

import collections
import re

from figures import ruled

FOLDER = "/usr/share/openscad/examples"
COMMAND = f"csgsim corpus {FOLDER} --progress none -o $OUT || [ $? = 1 ]"
PURPOSES = ("render", "classify", "merge", "shade")
TITLES = {"pixel-planes-4": "Pixel-planes 4", "scan-line": "scan-line", "pixel-square": "pixel-square",
          "pixel-planes-5": "Pixel-planes 5", "pixel-powers": "Pixel-Powers", "multi-processor": "multi-processor"}
SUPERSCRIPTS = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")


class Corpus:
    """The results of csgsim corpus."""

    def __init__(self, run):
        table = run.json("corpus.json")
        self.distributions = table.distributions
        self.drawn = [point for point in table.points if not point.reason]
        self.points = table.points
        self.folder = run.folder

    def of(self, machine):
        return [point for point in self.drawn if point.machine == machine]

    def bounds(self, machine):
        """The number of models limited by each part, the most frequent first; similar parts count as one."""
        return collections.Counter(re.sub(r" [\d,]+$", "", point.bound_by) for point in self.of(machine)).most_common()

    def share(self, machine, *purposes):
        """The share of these purposes in all clocks, in per cent."""
        of_machine = self.distributions[machine]
        return 100 * sum(of_machine[purpose].total for purpose in purposes) / of_machine.clocks.total


def of_examples(figures):
    return Corpus(figures.runs.run(COMMAND))


def folder(figures):
    return of_examples(figures).folder


def power(value):
    """The value with three digits, times a power of ten."""
    digits, exponent = f"{value:.2e}".split("e")
    return f"{digits} · 10{str(int(exponent)).translate(SUPERSCRIPTS)}"


def machines(figures):
    corpus = of_examples(figures)
    rows = []
    for name in TITLES:
        of_machine = corpus.distributions[name]
        clocks = [of_machine.clocks[key] for key in ("minimum", "first_quartile", "median", "third_quartile", "maximum")]
        bounds = ", ".join(f"{part} {count}" for part, count in corpus.bounds(name))
        rows.append((f"`{name}`", of_machine.clocks.count, f"{of_machine.halfspaces.median:,.0f}", *(f"{each:,.0f}" for each in clocks),
                     f"{of_machine.frames_per_second.median:.4g}", bounds))
    head = ("machine", "drawn", "half-spaces: median", "clocks: minimum", "quartile", "median", "quartile", "maximum",
            "frames a second: median", "bound by")
    return ruled(head, rows)


def purposes(figures):
    distributions = of_examples(figures).distributions
    rows = [(f"`{name}`", *(f"{distributions[name][purpose].total:,.0f}" for purpose in PURPOSES),
             power(distributions[name].pixel_operations.total)) for name in TITLES]
    return ruled(("machine", *PURPOSES, "pixel operations"), rows)


def models(figures):
    """A row for each model: frames per second on each machine that draws it."""
    corpus = of_examples(figures)
    found = {}
    for point in corpus.drawn:
        found.setdefault(point.model.removeprefix(FOLDER + "/").rsplit(".", 1)[0], {})[point.machine] = point
    rows = []
    for model, of_model in found.items():
        one = next(iter(of_model.values()))
        frames = [f"{of_model[name].frames_per_second:.4g}" if name in of_model else "–" for name in TITLES]
        rows.append((model, one.primitives, f"{one.pieces:,}", f"{one.halfspaces:,}", *frames))
    return ruled(("model", "primitives", "pieces", "half-spaces", *TITLES.values()), rows)
