"""Tables of docs/accuracy.md."""

from figures import ruled
from runs import Record

STEPS = ("10/2", "12/2", "12/4", "12/6", "14/4", "16/4", "16/6", "18/6", "20/6", "20/8")
FACETS = (("as modelled", "size 512x512"), ("`$fn` = 16", "fn 16"), ("`$fn` = 64", "fn 64"), ("tolerance 0.565", "tolerance 0.565474"),
          ("tolerance 0.0565", "tolerance 0.0565474"), ("tolerance 0.0188", "tolerance 0.0188491"))


SPHERE = "tests/budgets/sphere_32.csg --camera 0,-1286.98,0,0,0,0"
MOLECULE = "tests/models/molecule.csg --camera 300,-400,250,0,0,0 --view-all"
CURVED = {"sphere": (SPHERE, "fn,tolerance,curves", "1,0.1,0.02,0.005,0.002,0.001"),
          "molecule": (MOLECULE, "tolerance,curves", "1,0.3,0.1"),
          "fig. 2.3": ("fig_2_3", "fn,tolerance,curves", "0.05,0.01,0.002,0.0004,0.0001"),
          "carburettor": ("carburettor", "fn,tolerance,curves", "0.11,0.06,0.0278,0.01,0.002,0.0005"),
          "vehicle": ("vehicle", "fn,tolerance,curves", "0.4,0.1,0.02,0.005,0.002,0.001")}


def curves_of(figures, name):
    """The points of facets and of curved surfaces without them, for four views."""
    model, knobs, tolerances = CURVED[name]
    return figures.accuracy(model, f"--machine pixel-powers --knobs {knobs} --tolerances {tolerances}")


def nearest(points, exact):
    """The cheapest facets with at most the wrong pixels of the curved surfaces; otherwise the most accurate ones."""
    facets = [each for each in points if each.knob in ("fn", "tolerance") or each.value == "facets"]
    return min(facets, key=lambda each: (max(each.facet_wrong, exact.facet_wrong), each.clocks))


def compared(figures, name):
    """The points without facets first, with the exact ones among them; the model's own facets, and those closest to
    exact."""
    points = curves_of(figures, name)
    own = {each.value: each for each in points if each.knob == "curves"}
    best = nearest(points, own["exact"])
    return Record(points=points, exact=own["exact"], fast=own.get("fast"), own=own["facets"], nearest=best, times=best.clocks / own["exact"].clocks,
                  drawn=[*(each for value, each in own.items() if value != "facets"), own["facets"], best])


def curved(figures):
    return {name: compared(figures, name) for name in CURVED}


def named(point):
    if point.knob == "curves":
        return "facets, as modelled" if point.value == "facets" else f"`--curves {point.value}`"
    return f"facets, `$fn` = {point.value}" if point.knob == "fn" else f"facets, tolerance {point.value}"


def curves(figures):
    """Drawing without facets, compared with the model's facets and with those of equal or nearest accuracy."""
    rows = []
    for name, of in curved(figures).items():
        for each in of.drawn:
            rows.append((name, named(each), f"{each.halfspaces:,}", f"{each.clocks:,}", f"{each.clocks / of.exact.clocks:.3g}",
                         f"{each.facet_wrong:,}", f"{each.facet_depth_p999:.2g}"))
            name = ""
    return ruled(("", "drawn as", "half-spaces", "clocks (4 views)", "times exact", "pixels off", "depth off"), rows, numbers_from=2)


def by_tolerance(figures):
    """The carburettor in facets of different tolerances, and without facets."""
    points = curves_of(figures, "carburettor")
    first = next(each for each in points if each.value == "0.11")
    rows = []
    for each in points:
        if each.knob == "fn" or each.value == "facets":
            continue
        tolerance = each.value if each.knob == "tolerance" else f"`--curves {each.value}`"
        rows.append((tolerance, f"{each.halfspaces:,}", f"{each.clocks:,}", f"{each.clocks / first.clocks:.2f}", f"{each.facet_wrong:,}"))
    return ruled(("tolerance", "half-spaces", "clocks (4 views)", "ratio", "pixels off"), rows, numbers_from=1)


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
    """Times measured on the computer that generated the page."""
    printed = figures.runs.run(f"csgsim levels {figures.model('fig_2_3')} --size 256x256").printed
    rows = []
    for line in printed.splitlines():
        cells = line.split()
        if cells and cells[0] in ("functional", "cycle", "reference"):
            rows.append((*cells[:4], "" if cells[0] == "functional" else cells[-1]))
    return ruled(("level", "clocks", "wall s", "wall / functional", "results"), rows)
