"""docs/machines/bounds.md, and what bounds the scan-line array."""

from figures import THESIS_MODELS, ruled


def clocks(figures, machine, *changes):
    """Of facets, which all machines draw: of the same instructions."""
    changed = "".join(f"+{change}" for change in changes)
    return [figures.clocks(model, f"--curves facets --machine {machine}{changed}") for model in THESIS_MODELS]


def thousands(values):
    return [f"{value:,}" for value in values]


def with_lates(figures, change):
    cells = []
    for model in THESIS_MODELS:
        stats = figures.render(model, f"--machine scan-line+{change}")
        cells += [f"{stats.simulated_seconds * 1e3:.2f}", stats.account.late_lines]
    return cells


def lines(figures, key, *values):
    head = [key.split(".")[1], *(cell for model in THESIS_MODELS for cell in (model, "late"))]
    head[0] = {"count": "chains", "width": "bits"}[head[0]]
    return ruled(head, [(value, *with_lates(figures, f"{key}={value}")) for value in values])


def scan_line(figures):
    varied = [("its own figures",), ("`link.width` 64", "link.width=64"), ("`link.width` 128", "link.width=128"),
              ("`link.width` ideal", "link.width=ideal"), ("`cells.ports` 2", "cells.ports=2"),
              ("`link.width` 128, `cells.ports` 2", "link.width=128", "cells.ports=2"),
              ("`link.width`, `cells.ports` ideal", "link.width=ideal", "cells.ports=ideal"),
              ("`cells.shift_bits` ideal", "cells.shift_bits=ideal"), ("`cells.shift_bits` 1", "cells.shift_bits=1"),
              ("`cells.alu_bits` 8", "cells.alu_bits=8"),
              ("`link.width`, `cells.shift_bits` ideal", "link.width=ideal", "cells.shift_bits=ideal"),
              ("`evaluator.network` trees", "evaluator.network=trees"),
              ("trees, `evaluator.tree_bits` 8", "evaluator.network=trees", "evaluator.tree_bits=8"),
              ("trees, `evaluator.tree_bits` 1", "evaluator.network=trees", "evaluator.tree_bits=1"),
              ("all that may be ideal", *(f"{key}=ideal" for key in (
                  "link.width", "cells.ports", "cells.alu_bits", "cells.shift_bits", "memory.clear_clocks", "link.fifo_depth", "link.latency", "host.bucket_clocks",
                  "host.active_clocks"))),
              ("`host.bucket_clocks` 400, `host.active_clocks` 160", "host.bucket_clocks=400", "host.active_clocks=160"),
              ("`link.fifo_depth` 1", "link.fifo_depth=1"), ("`link.fifo_depth` 256", "link.fifo_depth=256"),
              ("`chains.count` 4", "chains.count=4"), ("`chains.count` 16", "chains.count=16")]
    return ruled(("", *THESIS_MODELS), [(name, *thousands(clocks(figures, "scan-line", *changes))) for name, *changes in varied])


def varied(figures, machine, key, title, *values):
    """A row for each value of a figure."""
    return ruled((title, *THESIS_MODELS),
                 [(name(value), *thousands(clocks(figures, machine, f"{key}={value}"))) for value in values])


def name(value):
    return value if value.isdigit() else f"`{value}`"


def sides(figures):
    return ruled(("side", *THESIS_MODELS),
                 [(side, *thousands(clocks(figures, "pixel-square", f"array.width={side}", f"array.height={side}")))
                  for side in (8, 16, 32, 64, 128)])


def dividing(figures):
    rows = []
    for machine, levels in (("pixel-square", (1, 2)), ("pixel-planes-5", (1, 2))):
        for level in levels:
            title = {("pixel-square", 2): "`divider.levels` 2 (as it is)",
                     ("pixel-planes-5", 1): "**`pixel-planes-5`** as it is, `divider.levels` 1"}.get((machine, level), f"`divider.levels` {level}")
            rows.append((title, *thousands(clocks(figures, machine, f"divider.levels={level}"))))
        rows.append(('`divider.kind` "host"', *thousands(clocks(figures, machine, "divider.kind=host"))))
    return ruled(("`pixel-square`", *THESIS_MODELS), rows)


def beside(title, *groups):
    """The head of a table with the models of several machines side by side."""
    return (title, *(f"{group}: {model}" if group and n == 0 else model
                     for group in groups for n, model in enumerate(THESIS_MODELS)))


def renderers(figures):
    rows = []
    for count in (1, 2, 4, 8):
        own = f"renderers.count={count}"
        rows.append((count, *thousands(clocks(figures, "pixel-square", own) + clocks(figures, "pixel-square", own, "divider.kind=host")
                                       + clocks(figures, "pixel-planes-5", own))))
    return ruled(beside("renderers", "`pixel-square`", "host divides", "`pixel-planes-5`"), rows)


def dividers(figures):
    rows = [(count, *thousands(clocks(figures, "pixel-square", f"divider.count={count}")
                               + clocks(figures, "pixel-planes-5", f"divider.count={count}"))) for count in (1, 2, 4, 8)]
    return ruled(beside("dividers", "`pixel-square`", "`pixel-planes-5`"), rows)


def screens(figures):
    """Without a divider, which would bound the frame."""
    varied = [("nothing is shown", "refresh.rate=ideal"), ("as it is",), ("`refresh.bits` 256", "refresh.bits=256", "refresh.clocks=1"),
              ("that, and two banks", "refresh.bits=256", "refresh.clocks=1", "frame_buffer.banks=2"),
              ("`refresh.bits` 64", "refresh.bits=64", "refresh.clocks=1"),
              ("that, and two banks", "refresh.bits=64", "refresh.clocks=1", "frame_buffer.banks=2")]
    return ruled(beside("screen", "`pixel-square`", "`pixel-planes-5`"),
                 [(title, *thousands(clocks(figures, "pixel-square", "divider.kind=host", *changes)
                                     + clocks(figures, "pixel-planes-5", "divider.kind=host", *changes))) for title, *changes in varied])


def buffers(figures):
    rows = [(count, *thousands(clocks(figures, "pixel-square", f"renderers.buffers={count}")
                               + clocks(figures, "pixel-planes-5", f"renderers.buffers={count}"))) for count in (1, 2)]
    return ruled(beside("buffers", "`pixel-square`", "`pixel-planes-5`"), rows)


def depths(figures):
    rows = []
    for large, small in ((16, 16), (256, 64), (4096, 1024), (65536, 4096)):
        rows.append((large, *thousands(clocks(figures, "pixel-planes-5", f"link.fifo_depth={large}")),
                     small, *thousands(clocks(figures, "pixel-square", f"link.fifo_depth={small}"))))
    return ruled((*beside("words", "`pixel-planes-5`"), *beside("words", "`pixel-square`")), rows)
