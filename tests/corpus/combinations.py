"""Compares machines and strategies with Pixel-planes 4 and its stack: depth, owner and colour of every pixel must be
equal."""
import re
import subprocess
import tomllib
from collections import defaultdict

from drawn import render

MACHINES = ("pixel-planes-4", "scan-line", "pixel-square", "pixel-planes-5", "multi-processor")
FIRST = (MACHINES[0], "stack")
# Parts of messages with which a machine may reject a model, with the options that make it draw the model.
HOST_DIVIDES, MORE_BITS = "+divider.kind=host", ("--memory-bits", "4096")
REFUSALS = (("divides the model itself", HOST_DIVIDES), ("memory bits a pixel", MORE_BITS), ("tree of this primitive expands", None), ("the divider keeps", None))


def usual_strategies(csgsim):
    """The machines and strategies that a sweep varies by default."""
    settings = subprocess.run([csgsim, "sweep", "model.csg", "--dump-config"], check=True, capture_output=True, text=True).stdout
    return tomllib.loads(settings)["sweep"]["strategy"].split(",")


def chosen(csgsim, machines, strategies, cross):
    """Pairs to compare with the first: machines with the stack and strategies on the first machine, or all
    combinations."""
    pairs = [(machine, strategy) for machine in (MACHINES if machines else MACHINES[:1])
             for strategy in (usual_strategies(csgsim) if strategies else FIRST[1:])]
    return [pair for pair in pairs if pair != FIRST and (cross or pair[0] == FIRST[0] or pair[1] == FIRST[1])]


def draw(csgsim, model, view, size, pair):
    """The final drawing, and the messages of earlier rejections."""
    machine, more, refused = pair[0], (), []
    while True:
        drawn = render(csgsim, model, view, size, ("--machine", machine, "--strategy", pair[1], *more))
        known = [(words, fix) for words, fix in REFUSALS if words in drawn.said]
        if drawn.code != 1 or not known:
            return drawn, refused
        refused.append(re.sub(r"^\S+:\d+:\d+: ", "", drawn.said))
        fix = known[0][1]
        if fix == HOST_DIVIDES and machine == pair[0] and machine != "multi-processor":  # its cells always divide
            machine += fix
        elif fix == MORE_BITS and not more:
            more = fix
        else:
            return drawn, refused


class Tally:
    """Results of each machine with each strategy, over all models and views."""

    def __init__(self):
        self.counts = defaultdict(lambda: defaultdict(int))
        self.refusals = defaultdict(set)

    def add(self, pair, model, drawn, refused):
        counts = self.counts[pair]
        counts["drawn" if drawn else "refused" if refused else "failed"] += 1
        for said in refused:
            self.refusals[pair, re.sub(r"\d+", "N", said)].add(model.stem)
        if drawn:
            counts["most bits"] = max(counts["most bits"], drawn.stats["memory"]["used_bits"])

    def compare(self, pair, first, other):
        """Differences between two drawings."""
        differs = {"depths": int((first.depth != other.depth).sum()), "owners": int((first.owner != other.owner).sum()),
                   "colours": int(first.picture != other.picture)}
        for what, count in differs.items():
            self.counts[pair][what] = max(self.counts[pair][what], count)
        return ", ".join(f"{count} {what} differ" for what, count in differs.items() if count)

    def print(self):
        columns = ("drawn", "refused", "failed", "depths", "owners", "colours", "most bits")
        print("\n%-16s %-9s" % ("machine", "strategy") + "%10s" * len(columns) % columns)
        for pair, counts in self.counts.items():
            print("%-16s %-9s" % pair + "%10d" * len(columns) % tuple(counts[name] for name in columns))
        for (pair, said), models in sorted(self.refusals.items()):
            print(f"{' '.join(pair)} rejected {len(models)} models: {said}\n    {' '.join(sorted(models))}")


def judge(csgsim, model, view, size, pairs, tally):
    """Compares the drawings of machines and strategies with that of the first pair."""
    first = render(csgsim, model, view, size, ("--machine", FIRST[0], "--strategy", FIRST[1]))
    if not first:
        return [first.said]
    faults = []
    for pair in pairs:
        drawn, refused = draw(csgsim, model, view, size, pair)
        tally.add(pair, model, drawn, refused)
        if drawn:
            fault = tally.compare(pair, first, drawn)
        else:
            fault = "" if refused else f"exit code {drawn.code}: {drawn.said}"
        if fault:
            faults.append(f"{' '.join(pair)}: {fault}")
    return faults
