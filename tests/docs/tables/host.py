"""docs/host.md."""

import math

from figures import THESIS_MODELS, row, ruled
from tables.comparison import MACHINES

PROCESSORS = ("mc68000", "i486dx2", "i860")


def milliseconds(clocks, each):
    """Of so many clocks of the point's machine."""
    return 1e3 * clocks * each.simulated_seconds / each.clocks


def four_digits(value):
    return f"{value:,.0f}" if value >= 1000 else f"{value:.4g}"


def on_one(figures, model, processor):
    """The points on machines whose host is one such processor, by machine."""
    hosts = {machine: f"{machine}+host.processor={processor}+host.count=1" for machine in MACHINES}
    # What a machine has already is not named as a change of it.
    points = figures.compare(model, f"--machines {','.join(hosts.values())}")
    whole = [each for each in points if each.width == 512 and each.fragments == 0]
    return dict(zip(MACHINES, whole, strict=True))


def hosts(figures):
    head = ("", "machine, ms", *(f"`{name}`, ms | to keep up" for name in PROCESSORS))
    lines = [row(*head), "|---" + "|--:" * (1 + 2 * len(PROCESSORS)) + "|"]
    for model in THESIS_MODELS:
        each = [on_one(figures, model, processor) for processor in PROCESSORS]
        lines.append(row(f"**{model}**", *[""] * (1 + 2 * len(PROCESSORS))))
        for machine in MACHINES:
            own = each[0][machine]
            cells = [four_digits(milliseconds(own.interval_clocks, own))]
            for points in each:
                one = points[machine]
                cells += [four_digits(milliseconds(one.host_clocks, one)), f"{math.ceil(one.host_clocks / one.interval_clocks):,}"]
            lines.append(row(f"`{machine}`", *cells))
    return "\n".join(lines)


PRUNINGS = ("all", "no-space", "no-separation", "no-halfspaces", "no-hidden", "no-sets", "none")


def prunings(figures):
    """What each pruning takes the host, and is worth to the machine."""
    rows = []
    for machine in ("pixel-planes-4", "scan-line"):
        for pruning in PRUNINGS:
            cells = []
            for model in THESIS_MODELS:
                stats = figures.render(model, f"--machine {machine} --pruning {pruning}")
                cells += [f"{stats.clocks:,}", four_digits(1e3 * stats.host_clocks / stats.machine.clock_hz)]
            rows.append((f"`{machine}`", f"`{pruning}`", *cells))
    head = ("machine", "`--pruning`", *(cell for model in THESIS_MODELS for cell in (f"{model}: clocks", "host, ms")))
    return ruled(head, rows, numbers_from=2)
