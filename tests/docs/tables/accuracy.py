"""docs/accuracy.md."""

from figures import ruled

STEPS = ("10/2", "12/2", "12/4", "12/6", "14/4", "16/4", "16/6", "18/6", "20/6", "20/8")
FACETS = (("as modelled", "facets as modelled"), ("`$fn` = 16", "fragments 16"), ("`$fn` = 64", "fragments 64"), ("tolerance 0.565", "tolerance 0.565"),
          ("tolerance 0.0565", "tolerance 0.0565"), ("tolerance 0.0188", "tolerance 0.0188"))


def by_name(points):
    return {f"{each.knob} {each.value}": each for each in points}


def steps(figures):
    points = by_name(figures.accuracy("carburettor"))
    rows = []
    for before, after in zip(STEPS, STEPS[1:]):
        one, other = points[f"both {before}"], points[f"both {after}"]
        rows.append((before, after, f"{one.wrong:,} → {other.wrong:,}", f"{100 * (other.clocks / one.clocks - 1):.1f} %"))
    return ruled(("from", "to", "wrong pixels", "more clocks"), rows, numbers_from=9)
