"""Cost of stepped trees, for docs/debugging.md."""

from figures import THESIS_MODELS, ruled

TIMES = 3


def seconds(figures, model, form):
    """Least wall time of several runs at the cycle level."""
    return min(figures.render(model, f"--level cycle --evaluator {form} -o $OUT/{form}-{run}.png").wall_seconds for run in range(TIMES))


def row(figures, model):
    worked_out, stepped = (seconds(figures, model, form) for form in ("worked-out", "stepped"))
    clocks = figures.clocks(model, "--level cycle")
    return (model, f"{clocks:,}", f"{worked_out * 1e3:.0f}", f"{stepped * 1e3:,.0f}", f"{stepped / worked_out:.0f}", f"{stepped / clocks * 1e6:.0f}")


def stepped(figures):
    return ruled(("", "clocks", "computed, ms", "stepped, ms", "ratio", "µs per clock"), [row(figures, model) for model in THESIS_MODELS])
