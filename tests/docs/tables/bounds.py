"""Tables of docs/machines/comparison.md, and the bottlenecks of the scan-line array."""

from figures import THESIS_MODELS, ruled


def clocks(figures, machine, *changes):
    """Points of facets, which all machines draw with the same instructions."""
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


def chains(figures, *counts):
    head = ("chains", *(cell for model in THESIS_MODELS for cell in (model, "late")))
    return ruled(head, [(count, *with_lates(figures, f"chains.count={count}")) for count in counts])


def scan_line(figures):
    varied = [("unchanged",), ("`link.width` 64", "link.width=64"), ("`link.width` 128", "link.width=128"),
              ("`link.width` ideal", "link.width=ideal"), ("`cells.ports` 2", "cells.ports=2"),
              ("`link.width` 128, `cells.ports` 2", "link.width=128", "cells.ports=2"),
              ("`link.width`, `cells.ports` ideal", "link.width=ideal", "cells.ports=ideal"),
              ("`cells.shift_bits` ideal", "cells.shift_bits=ideal"), ("`cells.shift_bits` 1", "cells.shift_bits=1"),
              ("`cells.alu_bits` 8", "cells.alu_bits=8"),
              ("`link.width`, `cells.shift_bits` ideal", "link.width=ideal", "cells.shift_bits=ideal"),
              ("`evaluator.network` trees", "evaluator.network=trees"),
              ("trees, `evaluator.bits` 8", "evaluator.network=trees", "evaluator.bits=8"),
              ("trees, `evaluator.bits` 1", "evaluator.network=trees", "evaluator.bits=1"),
              ("everything ideal", *(f"{key}=ideal" for key in (
                  "link.width", "cells.ports", "cells.alu_bits", "cells.shift_bits", "memory.clear_clocks", "link.fifo_depth", "link.latency", "host.bucket_clocks",
                  "host.active_clocks"))),
              ("`host.bucket_clocks` 400, `host.active_clocks` 160", "host.bucket_clocks=400", "host.active_clocks=160"),
              ("`link.fifo_depth` 1", "link.fifo_depth=1"), ("`link.fifo_depth` 256", "link.fifo_depth=256")]
    return ruled(("", *THESIS_MODELS), [(name, *thousands(clocks(figures, "scan-line", *changes))) for name, *changes in varied])


def varied(figures, machine, key, title, *values):
    """A row for each value of a parameter."""
    return ruled((title, *THESIS_MODELS),
                 [(name(value), *thousands(clocks(figures, machine, f"{key}={value}"))) for value in values])


def name(value):
    return value if value.isdigit() else f"`{value}`"


def sides(figures):
    return ruled(("side", *THESIS_MODELS),
                 [(side, *thousands(clocks(figures, "pixel-square", f"array.width={side}", f"array.height={side}")))
                  for side in (8, 16, 32, 64, 128)])


def dividing(figures):
    def row(title, machine, *changes):
        return (title, *thousands(clocks(figures, machine, *changes)))

    corners = "divider.kind=corners"
    return ruled(("`pixel-square`", *THESIS_MODELS), [
        row("`divider.levels` 1", "pixel-square", "divider.levels=1"),
        row("`divider.levels` 2 (unchanged)", "pixel-square"),
        row('`divider.kind` "host"', "pixel-square", "divider.kind=host"),
        row("**`pixel-planes-5`** unchanged: processors", "pixel-planes-5"),
        row('`divider.kind` "corners", `divider.levels` 1', "pixel-planes-5", corners),
        row('`divider.kind` "corners", `divider.levels` 2', "pixel-planes-5", corners, "divider.levels=2"),
        row('`divider.kind` "host"', "pixel-planes-5", "divider.kind=host"),
    ])


def beside(title, *groups):
    """The table head for the models of several machines side by side."""
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
                               + clocks(figures, "pixel-planes-5", "divider.kind=corners", f"divider.count={count}"))) for count in (1, 2, 4, 8)]
    return ruled(beside("dividers", "`pixel-square`", "`pixel-planes-5`"), rows)


def processors(figures):
    rows = [(count, *thousands(clocks(figures, "pixel-planes-5", f"processors.count={count}")
                               + clocks(figures, "pixel-planes-5", "renderers.count=16", f"processors.count={count}"))) for count in (1, 2, 8, 32)]
    return ruled(beside("processors", "4 renderers", "16 renderers"), rows)


def ring(figures):
    varied = [("unchanged",), ("`ring.channels` 1", "ring.channels=1"), ("`ring.channels` 2", "ring.channels=2"), ("`ring.channels` ideal", "ring.channels=ideal"),
              ("`ring.word_clocks` 1", "ring.word_clocks=1"), ("`ring.width` 64", "ring.width=64"), ("`ring.width` 128", "ring.width=128"),
              ("`frame_buffer.banks` 1", "frame_buffer.banks=1"), ("`frame_buffer.banks` 8", "frame_buffer.banks=8"),
              ("that, and 16 renderers, 32 processors", "frame_buffer.banks=8", "renderers.count=16", "processors.count=32")]
    return ruled(("`pixel-planes-5`", *THESIS_MODELS), [(title, *thousands(clocks(figures, "pixel-planes-5", *changes))) for title, *changes in varied])


def screens(figures):
    """The machines without a divider, which would limit the frame."""
    twice = {"pixel-square": "frame_buffer.banks=2", "pixel-planes-5": "frame_buffer.banks=4"}
    varied = [("nothing is shown", False, "refresh.rate=ideal"), ("unchanged", False), ("`refresh.bits` 256", False, "refresh.bits=256", "refresh.clocks=1"),
              ("that, and twice the banks", True, "refresh.bits=256", "refresh.clocks=1"),
              ("`refresh.bits` 64", False, "refresh.bits=64", "refresh.clocks=1"),
              ("that, and twice the banks", True, "refresh.bits=64", "refresh.clocks=1")]

    def drawn(machine, doubled, *changes):
        return clocks(figures, machine, *changes, *((twice[machine],) if doubled else ()))

    return ruled(beside("screen", "`pixel-square`", "`pixel-planes-5`"),
                 [(title, *thousands(drawn("pixel-square", doubled, "divider.kind=host", *changes) + drawn("pixel-planes-5", doubled, *changes)))
                  for title, doubled, *changes in varied])


def buffers(figures):
    varied = [(1, "renderers.buffers=1", "backing.bits=0"), (2, "renderers.buffers=2", "backing.bits=0"), ("backing store", "backing.bits=4096")]
    return ruled(beside("buffers", "`pixel-square`", "`pixel-planes-5`"),
                 [(title, *thousands(clocks(figures, "pixel-square", *changes) + clocks(figures, "pixel-planes-5", *changes))) for title, *changes in varied])


def depths(figures):
    rows = []
    for large, small in ((16, 16), (256, 64), (4096, 1024), (65536, 4096)):
        rows.append((large, *thousands(clocks(figures, "pixel-planes-5", f"link.fifo_depth={large}")),
                     small, *thousands(clocks(figures, "pixel-square", f"link.fifo_depth={small}"))))
    return ruled((*beside("words", "`pixel-planes-5`"), *beside("words", "`pixel-square`")), rows)
