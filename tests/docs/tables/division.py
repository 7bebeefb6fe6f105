"""Tables of docs/machines/pixel-square.md, from the output of bench_division."""

import re

from figures import ruled

PRUNINGS = (("the divider's prunings", None), ("with `space`", "with space"), ("with `separation`", "with separation"),
            ("with `hidden`", "with hidden"), ("with `near`", "with near"),
            ("without cells: leaders of the rectangle alone", "without cells"), ("the host's prunings", "the host's prunings"),
            ("the host's prunings, and cells", "the host's prunings and cells"))


class Report:
    """A model's part of the output of bench_division."""

    def __init__(self, text):
        self.text = text
        self.halfspaces = self.numbers(r"(\d+) half-spaces, picture")[0]

    def numbers(self, pattern):
        found = re.search(pattern, self.text)
        if not found:
            raise ValueError(f"bench_division prints nothing like '{pattern}'")
        return [int(each) for each in found.groups()]

    def counted(self, name):
        """Boxes, half-spaces, cells, nodes and instructions of a row."""
        return self.numbers(rf"{name} +(\d+) +(\d+) +(\d+) +(\d+) +(\d+)")

    def pruned(self, name):
        return self.numbers(rf"  {name} +\d+ instructions +(\d+) clocks")[0]


def reports(figures):
    """Reports of three models in squares of 16, of the same in squares of 128, and of three tolerances in squares of
    8."""
    parts = figures.runs.run("bench_division").printed.strip().split("\n\n")
    parts = [Report(part) for part in parts]
    return parts[0:3], parts[3:6], parts[6:]


def with_commas(values):
    return [f"{value:,}" for value in values]


def divider(figures):
    models, _, _ = reports(figures)
    rows = []

    def add(name, pattern, count=1):
        cells = [with_commas(each.numbers(pattern)) for each in models]
        rows.append((name, *(", ".join(cell[:count]) for cell in cells)))

    def add_counts(title, name, what):
        for each, row in what:
            rows.append((f"{title}{each}", *with_commas(report.counted(name)[row] for report in models)))
            title = ""

    rows.append(("half-spaces in the model", *with_commas(each.halfspaces for each in models)))
    add("bits of the model", r"model: (\d+) bits")
    add("words of 32", r"(\d+) words of 32")
    add("of one plane, primitive, half-space (bits without colours)", r"planes of (\d+), primitives of (\d+), half-spaces of (\d+)", 3)
    add_counts("**one level**: ", "one level", (("boxes", 0), ("half-spaces", 1), ("cells", 2)))
    add_counts("**two levels**: ", "two: groups", (("boxes of groups", 0), ("half-spaces of groups", 1), ("cells of groups", 2)))
    add_counts("", "two: squares", (("boxes of squares", 0), ("half-spaces of squares", 1), ("cells of squares", 2)))
    add("entries of a group's list: median, maximum", r"list: (\d+) entries in the middle, (\d+) at most", 2)
    add_counts("", "two: squares", (("nodes", 3), ("instructions", 4)))
    add("tests, one level, clocks", r"tests: (\d+) clocks at one")
    add("tests, two levels, clocks", r"one level, (\d+) at two")
    add("the same in groups of 4 × 4", r"groups of 4: (\d+)")
    rows.append(("half-spaces of the current surface, maximum: one level, two levels",
                 *(", ".join(with_commas(each.numbers(r"at hand: (\d+) half-spaces and \d+ nodes at one level, (\d+)"))) for each in models)))
    add("nodes of the current surface", r"half-spaces and (\d+) nodes")
    add("words of a square's commands, at most", r"; (\d+) words of commands")
    return ruled(("", "carburettor", "vehicle", "house"), rows)


def prunings(figures):
    models, _, _ = reports(figures)
    own = [each.pruned("the divider's prunings") for each in models]
    rows = [(title, *(with_commas(own) if name is None else
                      [f"{each.pruned(name) / base:.3f}" for each, base in zip(models, own)])) for title, name in PRUNINGS]
    return ruled(("", "carburettor", "vehicle", "house"), rows)


def ratios(values):
    return ", ".join(f"{value / values[0]:.2f}" for value in values[1:])


def table_7_3(figures):
    """Our ratios next to those of the thesis."""
    _, _, points = reports(figures)
    groups, squares = ([each.counted(name) for each in points] for name in ("two: groups", "two: squares"))
    together = [a[1] + b[1] for a, b in zip(groups, squares)]
    cells = [a[2] + b[2] for a, b in zip(groups, squares)]
    measured = (("one level: half-space tests", [each.counted("one level")[1] for each in points], ""),
                ("two levels: tests for groups", [each[1] for each in groups], "*1.59, 2.97*"),
                ("tests for subsegments", [each[1] for each in squares], "*1.42, 2.25*"),
                ("together", together, "*1.56, 2.86*"), ("cells", cells, ""),
                ("all tests, clocks", [each.numbers(r"one level, (\d+) at two")[0] for each in points], ""),
                ("the same with segments of 4 × 4 for groups", [each.numbers(r"groups of 4: (\d+)")[0] for each in points], ""),
                ("entries of a group's list, at most", [each.numbers(r"middle, (\d+) at most")[0] for each in points], ""),
                ("renderers' clocks, instructions alone", [each.pruned("the divider's prunings") for each in points], "*1.06, 1.30*"),
                ("the same without cells", [each.pruned("without cells") for each in points], ""))
    halfspaces = [each.halfspaces for each in points]
    rows = [("", "", "", "", ratios(halfspaces), "*1.62, 3.08*")]
    rows += [(name, *with_commas(values), ratios(values), thesis) for name, values, thesis in measured]
    rows.insert(9, ("half-spaces of the current surface, maximum: one level, two levels",
                    *(", ".join(with_commas(each.numbers(r"at hand: (\d+) half-spaces and \d+ nodes at one level, (\d+)"))) for each in points), "", ""))
    return ruled(("half-spaces in the model", *with_commas(halfspaces), "ratios", "*thesis: ratios*"), rows)
