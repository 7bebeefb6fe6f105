"""Tables of docs/host.md."""

import math

from figures import THESIS_MODELS, row, ruled
from tables.comparison import MACHINES

PROCESSORS = ("mc68000", "i486dx2", "i860")


def milliseconds(clocks, each):
    """Milliseconds of a number of clocks of the point's machine."""
    return 1e3 * clocks * each.simulated_seconds / each.clocks


def four_digits(value):
    return f"{value:,.0f}" if value >= 1000 else f"{value:.4g}"


def hosted(machine, processor):
    """The machine with one such processor as its host."""
    return f"{machine}+host.processor={processor}+host.count=1"


def on_hosts(figures, model, options=""):
    """The points of all machines with each host, by both: from a single call, so that all draw the same picture."""
    pairs = [(machine, processor) for machine in MACHINES for processor in PROCESSORS]
    points = figures.compare(model, f"{options}--machines {','.join(hosted(*pair) for pair in pairs)} --fragments none --sides none")
    return dict(zip(pairs, points, strict=True))


def hosts(figures):
    head = ("", "machine, ms", *(f"`{name}`: model, ms | frame, ms | needed" for name in PROCESSORS))
    lines = [row(*head), "|---" + "|--:" * (1 + 3 * len(PROCESSORS)) + "|"]
    for model in THESIS_MODELS:
        points = on_hosts(figures, model)
        lines.append(row(f"**{model}**", *[""] * (1 + 3 * len(PROCESSORS))))
        for machine in MACHINES:
            own = points[machine, PROCESSORS[0]]
            cells = [four_digits(milliseconds(own.interval_clocks, own))]
            for processor in PROCESSORS:
                one = points[machine, processor]
                cells += [four_digits(milliseconds(one.host_model_clocks, one)),
                          four_digits(milliseconds(one.host_clocks, one)), f"{math.ceil(one.host_clocks / one.interval_clocks):,}"]
            lines.append(row(f"`{machine}`", *cells))
    return "\n".join(lines)


EXACT = ("old_example011", "thesis_fig_2_3")


def exact(figures):
    """Exact numbers: clocks of each machine with each host, for models that take little time."""
    of_models = [on_hosts(figures, f"tests/models/{model}.csg", "--view-all ") for model in EXACT]
    rows = [(f"`{machine}`", f"`{processor}`", *(f"{points[machine, processor].host_clocks:,}" for points in of_models))
            for machine in MACHINES for processor in PROCESSORS]
    return ruled(("machine", "host", *EXACT), rows, numbers_from=2)


PRUNINGS = ("auto", "all", "no-space", "no-separation", "no-halfspaces", "no-hidden", "no-sets", "none")


def prunings(figures):
    """The host time of each pruning, and its saving on the machine."""
    rows = []
    for machine in ("pixel-planes-4", "scan-line"):
        for pruning in PRUNINGS:
            cells = []
            for model in THESIS_MODELS:
                stats = figures.render(model, f"--machine {machine} --curves facets --pruning {pruning}")
                cells += [f"{stats.clocks:,}"]
                cells += [four_digits(1e3 * clocks / stats.machine.clock_hz) for clocks in (stats.host_model_clocks, stats.host_clocks)]
            rows.append((f"`{machine}`", f"`{pruning}`", *cells))
    head = ("machine", "`--pruning`", *(cell for model in THESIS_MODELS for cell in (f"{model}: clocks", "model, ms", "frame, ms")))
    return ruled(head, rows, numbers_from=2)
