"""Tables of docs/software.md: table 5.1 of the thesis, whose own numbers are in italics, other methods, and wrong
pixels."""

from figures import ruled
from tables.software import italic, three_digits, whole

CYLINDERS = "--size 256x256 --fragments 12,18,24,32"
FRAGMENTS = (12, 18, 24, 32)
METHODS = ("depth-lists", "list-priority", "list-priority/depth-buffer", "scan-line", "depth-peeling", "rays")
LIST_PRIORITY = ("list-priority", "list-priority/depth-buffer")
OBJECTS = ("cylinders", "carburettor", "vehicle", "house")
PROCESSORS = ("mc68000", "i486dx2")

# Columns are in the order of the tolerances.
THESIS = {
    "tolerance": ("2", "1", "0.5", "0.25"),
    "polygons": (96, 144, 192, 256),
    "clipped_polygons": (457, 769, 1_164, 1_753),
    "preprocessing": (20.15, 34.45, 55.45, 80.48),
    "transformation": (2.48, 4.40, 6.58, 9.98),
    "sorting": (0.82, 1.35, 2.08, 3.33),
    "scan_conversion": (5.58, 7.10, 8.82, 11.20),
    "depth_test": (4.59, 5.67, 6.98, 8.64),
    "initialisation": (3.61, 3.68, 3.74, 3.78),  # additional part of its total
    "total": (17.08, 22.20, 28.20, 36.93),
}
SECONDS = {"preprocessing": "preprocessing, s", "transformation": "transformation, s", "sorting": "retrieval and sort, s",
           "scan_conversion": "scan conversion and CSG test, s", "depth_test": "depth test, s", "initialisation": "initialisation of buffers, s",
           "total": "total without preprocessing, s"}


def cylinders(figures):
    return figures.display("cylinders", CYLINDERS)


def of(points, method, **wanted):
    found = [each for each in points if each.method == method and all(each[key] == value for key, value in wanted.items())]
    if len(found) != 1:
        raise ValueError(f"{len(found)} points of {method} have {wanted}")
    return found[0]


def table_5_1(figures):
    points = [of(cylinders(figures), "list-priority/depth-buffer", fragments=n) for n in FRAGMENTS]
    head = [""]
    for n in FRAGMENTS:
        head += [f"$fn = {n}", italic("thesis")]
    lines = [("segments; *tolerance*", *(cell for n, tolerance in zip(FRAGMENTS, THESIS["tolerance"]) for cell in (n, italic(tolerance))))]
    for key, name in (("polygons", "polygons"), ("clipped_polygons", "after clipping")):
        lines.append((name, *(cell for each, thesis in zip(points, THESIS[key]) for cell in (whole(each[key]), italic(whole(thesis))))))
    for key, name in SECONDS.items():
        lines.append((name, *(cell for each, thesis in zip(points, THESIS[key])
                              for cell in (three_digits(each.seconds.mc68000[key]), italic(f"{thesis:.2f}")))))
    return ruled(head, lines)


def a_polygon(figures):
    """Milliseconds of a phase against the number of polygons after clipping."""
    points = [of(cylinders(figures), "list-priority/depth-buffer", fragments=n) for n in FRAGMENTS]
    lines = []
    for key in ("preprocessing", "transformation", "sorting"):
        ours = [1e3 * each.seconds.mc68000[key] / each.clipped_polygons for each in points]
        thesis = [1e3 * seconds / polygons for seconds, polygons in zip(THESIS[key], THESIS["clipped_polygons"])]
        lines.append((SECONDS[key].replace(", s", ", ms a clipped polygon"), f"{min(ours):.1f} to {max(ours):.1f}",
                      italic(f"{min(thesis):.1f} to {max(thesis):.1f}")))
    return ruled(["", "mc68000", italic("thesis")], lines)


def rivals(figures):
    head = ["seconds"]
    for name in OBJECTS:
        head += [f"{name}, mc68000", "i486dx2"]
    lines = []
    for method in METHODS:
        cells = []
        for name in OBJECTS:
            point = shown(figures, name, method)
            cells += [three_digits(point.seconds[processor].total) for processor in PROCESSORS]
        lines.append((method, *cells))
    return ruled(head, lines)


def small(figures):
    """All methods for a picture that the suite draws: exact counts, and seconds by phase."""
    points = figures.display("fig_2_3", "--size 64x48")
    rows = []
    for method in METHODS:
        one = of(points, method)
        seconds = one.seconds.mc68000
        rows.append((f"`{method}`", whole(one.pixel_events), whole(one.points), whole(one.evaluations), whole(one.words), whole(one.wrong),
                     *(f"{seconds[key]:.4f}" for key in SECONDS)))
    return ruled(["", "events at pixels", "points", "evaluations", "words", "wrong", *(f"mc68000: {name}" for name in SECONDS.values())], rows)


def shown(figures, name, method):
    wanted = {"fragments": 32} if name == "cylinders" else {}
    points = cylinders(figures) if name == "cylinders" else figures.display(name, "--size 256x256")
    return of(points, method, **wanted)


def work(figures):
    head = ["", "method", *OBJECTS]
    rows = (("events at pixels", "depth-lists", "pixel_events"), ("passes", "depth-peeling", "passes"), ("spans", "scan-line", "spans"),
            ("spans split", "scan-line", "splits"), ("events at their ends", "scan-line", "pixel_events"), ("polygons", "list-priority", "polygons"),
            ("after clipping", "list-priority", "clipped_polygons"), ("in several cells", "list-priority", "shared_polygons"),
            ("cut by cells", "list-priority", "references"), ("tests of polygon and polygon", "list-priority", "crossing_tests"),
            ("tests of polygon and cell", "list-priority", "overlap_tests"), ("cells", "list-priority", "cells"),
            ("cells and halves visited", "list-priority", "cell_visits"),
            ("cells overfull", "list-priority", "overfull_cells"), ("evaluations", "scan-line", "evaluations"),
            ("words", "depth-lists", "words"), ("words", "list-priority", "words"), ("words", "scan-line", "words"), ("words", "rays", "words"))
    return ruled(head, [(name, f"`{method}`", *(whole(shown(figures, each, method)[key]) for each in OBJECTS)) for name, method, key in rows], 2)


CAUSES = (("wrong pixels", "wrong"), ("bits of depth", "wrong_depth_bits"), ("two surfaces coincide", "wrong_coincident"),
          ("a third is near", "wrong_three_way"), ("order", "wrong_order"))


def wrong(figures):
    head = ["", "method", *OBJECTS]
    return ruled(head, [(name, f"`{method}`", *(whole(shown(figures, each, method)[key]) for each in OBJECTS))
                        for method in LIST_PRIORITY for name, key in (*CAUSES, ("conflicts of order", "conflicts"))], 2)


def few_bits(figures):
    """Wrong pixels of list priority by cause, for decreasing numbers of bits."""
    lines = []
    for method in LIST_PRIORITY:
        for bits in (16, 12, 8):
            points = [of(figures.display(name, f"--size 256x256 --methods {method} --z-bits {bits} --fraction-bits 4"), method) for name in OBJECTS[1:]]
            lines.append((f"`{method}`", bits, *(" + ".join(whole(point[key]) for _, key in CAUSES[1:]) for point in points)))
    return ruled(["bits of depth + coincide + three + order", "bits", *OBJECTS[1:]], lines)


def directories(figures):
    lines = []
    for name in OBJECTS[1:]:
        for directory in ("excell", "octree", "kd-tree"):
            point = of(figures.display(name, "--size 256x256 --methods list-priority --directories excell,octree,kd-tree"), "list-priority", directory=directory)
            seconds = point.seconds.mc68000
            lines.append((f"{name}, `{directory}`", *(whole(point[key]) for key in ("cells", "overfull_cells", "references", "conflicts", "wrong_order")),
                          *(three_digits(seconds[key]) for key in ("preprocessing", "sorting", "total"))))
    return ruled(["list priority", "cells", "overfull", "cut by cells", "conflicts", "order", "mc68000, s: preprocessing", "sorting", "total"], lines)
