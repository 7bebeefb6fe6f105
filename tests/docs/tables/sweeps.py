"""Tables of docs/reproduction.md: table 3.1 of the thesis, whose own numbers are in italics."""

import math

from figures import point, ruled

TOLERANCES = (0.1, 0.05, 0.01, 0.001)
TABLE_3_1 = {
    "elements": (49, 103, 442, 4_093),
    "vertices": (78, 145, 549, 4_478),
    "most_elements": (16, 23, 50, 142),
    "most_vertices": (38, 51, 115, 327),
}
# Seconds of a PDP-11/44; the scan shows the first one without its point.
SECONDS = ("0.10?", "0.24", "1.02", "11.04")
NAMES = {
    "elements": "elements",
    "vertices": "vertices",
    "most_elements": "peak elements held",
    "most_vertices": "peak vertices held",
}


def held_by_root(held, elements):
    """The elements held divided by the root of all elements; the thesis expects a constant (3.3.3)."""
    return held / math.sqrt(elements)


def patch(figures):
    """Points by repair and tolerance."""
    points = figures.mesh("tests/models/thesis_fig_3_9.jan")
    return {(repair, tolerance): point(points, repair=repair, tolerance=tolerance) for repair in ("filter", "quadtree") for tolerance in TOLERANCES}


def held_and_elements(figures):
    """For the filter, by tolerance: the most elements held, and all elements."""
    return tuple([patch(figures)["filter", tolerance][key] for tolerance in TOLERANCES] for key in ("most_elements", "elements"))


def table_3_1(figures):
    of = patch(figures)
    head = ["tolerance"]
    for tolerance in TOLERANCES:
        head += [f"{tolerance:g}", "*thesis*"]
    rows = []
    for key, name in NAMES.items():
        cells = [name]
        for i, tolerance in enumerate(TOLERANCES):
            cells += [f"{of['filter', tolerance][key]:,}", f"*{TABLE_3_1[key][i]:,}*"]
        rows.append(cells)
    cells = ["peak elements held ÷ √elements"]
    for i, tolerance in enumerate(TOLERANCES):
        own = of["filter", tolerance]
        cells += [f"{held_by_root(own.most_elements, own.elements):.1f}",
                  f"*{held_by_root(TABLE_3_1['most_elements'][i], TABLE_3_1['elements'][i]):.1f}*"]
    rows.append(cells)
    for key, name in (("most_edges", "nodes of the quadtree"), ("most_vertices", "vertices it holds")):
        rows.append([name, *(cell for tolerance in TOLERANCES for cell in (f"{of['quadtree', tolerance][key]:,}", ""))])
    for what, repair, name in (("repairing", "filter", "the filter, s"), ("repairing", "quadtree", "the quadtree, s"), ("subdividing", "filter", "subdividing, s")):
        cells = [f"MC68000: {name}"]
        for i, tolerance in enumerate(TOLERANCES):
            cells += [f"{of[repair, tolerance].seconds.mc68000[what]:.3g}", f"*{SECONDS[i]}*" if name == "the filter, s" else ""]
        rows.append(cells)
    return ruled(head, rows)
