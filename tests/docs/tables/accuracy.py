"""docs/accuracy.md."""

from figures import ruled

STEPS = ("10/2", "12/2", "12/4", "12/6", "14/4", "16/4", "16/6", "18/6", "20/6", "20/8")
FACETS = (("as modelled", "size 512x512"), ("`$fn` = 16", "fn 16"), ("`$fn` = 64", "fn 64"), ("tolerance 0.565", "tolerance 0.565474"),
          ("tolerance 0.0565", "tolerance 0.0565474"), ("tolerance 0.0188", "tolerance 0.0188491"))


def by_name(points):
    """Points by knob and value, as in 'together 16/6'."""
    return {f"{each.knob} {each.value}": each for each in points}


def steps(figures):
    points = by_name(figures.accuracy("carburettor"))
    rows = []
    for before, after in zip(STEPS, STEPS[1:]):
        one, other = points[f"together {before}"], points[f"together {after}"]
        rows.append((before, after, f"{one.wrong:,} → {other.wrong:,}", f"{100 * (other.clocks / one.clocks - 1):.1f} %"))
    return ruled(("from", "to", "wrong pixels", "more clocks"), rows, numbers_from=9)


def facets(figures):
    points = by_name(figures.accuracy("carburettor"))
    rows = [(title, *(f"{value:,}" for value in (each.halfspaces, each.clocks, each.wrong, each.facet_wrong)))
            for title, each in ((title, points[name]) for title, name in FACETS)]
    return ruled(("carburettor", "half-spaces", "clocks (4 views)", "wrong pixels", "differ from curved surfaces"), rows)


def levels(figures):
    """Times are those of the machine that made the page."""
    printed = figures.runs.run(f"csgsim levels {figures.model('fig_2_3')} --size 256x256").printed
    rows = []
    for line in printed.splitlines():
        cells = line.split()
        if cells and cells[0] in ("functional", "cycle", "reference"):
            rows.append((*cells[:4], "" if cells[0] == "functional" else cells[-1]))
    return ruled(("level", "clocks", "wall s", "times functional", "results"), rows)
