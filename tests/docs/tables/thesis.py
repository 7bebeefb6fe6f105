"""Tables of docs/reproduction.md: tables 7.2 and 7.3 of the thesis, whose own numbers are in italics."""

from figures import ruled

SIZE = "--size 256x256"
TOLERANCES = "--subdivisions 6 --tolerances 0.11,0.06,0.0278"
HOST = "--machine pixel-square+divider.kind=host"
NODES = "--machine multi-processor"


def cursive(values):
    return [f"*{value}*" if value else "" for value in values]


def between(ours, thesis):
    """Alternates our values and the thesis's."""
    return [cell for pair in zip(ours, cursive(thesis or [""] * len(ours))) for cell in pair]


def ratios(values):
    return ", ".join(f"{value / values[0]:.2f}" for value in values[1:])


def levels(figures, machine, rows):
    points = figures.subdivide("carburettor", f"{SIZE} {machine}")
    return ruled(("levels", *between([each.subdivisions for each in points], ["thesis"] * 3)),
                 [(name, *between([format(get(each), spec) for each in points], thesis)) for name, get, spec, thesis in rows])


def table_7_2(figures):
    return levels(figures, HOST, (
        ("segments", lambda p: p.segments["count"], ",", ("16", "64", "256")),
        ("of these touched", lambda p: p.segments.touched, ",", None),
        ("subsegments", lambda p: p.subsegments["count"], ",", ("256", "1,024", "4,096")),
        ("of these touched", lambda p: p.subsegments.touched, ",", None),
        ("primitives in the model", lambda p: p.primitives, ",", ("22",) * 3),
        ("primitives that touch a segment", lambda p: p.segments.primitives_mean, ".1f", None),
        ("primitives drawn in a segment", lambda p: p.segments.kept_primitives_mean, ".1f", ("10.0", "6.3?", "5.4")),
        ("comparisons in a segment", lambda p: p.segments.comparisons_mean, ".1f", ("13.0", "8.1?", "7.1")),
        ("half-spaces in the model", lambda p: p.halfspaces, ",", ("2,042",) * 3),
        ("in a segment, after the first pruning", lambda p: p.segments.kept_halfspaces_mean, ".1f", ("314.8", "110.8", "46.9")),
        ("in a subsegment, after the second", lambda p: p.subsegments.kept_halfspaces_mean, ".1f", ("81.6", "39.0", "25.4")),
        ("clocks, squares as large as segments", lambda p: p.segments.clocks, ",", None),
        ("clocks, squares as large as subsegments", lambda p: p.subsegments.clocks, ",", None)))


def node_table_7_2(figures):
    return levels(figures, NODES, (
        ("primitives drawn in a segment", lambda p: p.segments.kept_primitives_mean, ".1f", ("10.0", "6.3?", "5.4")),
        ("comparisons in a segment", lambda p: p.segments.comparisons_mean, ".1f", ("13.0", "8.1?", "7.1")),
        ("half-spaces broadcast for a segment", lambda p: p.stages.broadcast_halfspaces_mean, ".1f", ("314.8", "110.8", "46.9")),
        ("in a subsegment, after the second pruning", lambda p: p.subsegments.kept_halfspaces_mean, ".1f", ("81.6", "39.0", "25.4"))))


def tolerances(figures, machine, rows):
    """Rows are name, value of a point, format, whether ratios are meaningful, the thesis's values and their ratios."""
    points = figures.subdivide("carburettor", f"{SIZE} {machine} {TOLERANCES}")
    head = ("half-spaces in the model", *(f"{each.halfspaces:,}" for each in points), "ratios",
            "*thesis: 1258*", "*2042*", "*3876*", "*ratios*")
    lines = []
    for name, get, spec, has_ratios, thesis in rows:
        values = [get(each) for each in points]
        lines.append((name, *(format(value, spec) for value in values), ratios(values) if has_ratios else "",
                      *cursive(thesis or [""] * 4)))
    return ruled(head, lines)


def table_7_3(figures):
    return tolerances(figures, HOST, (
        ("half-spaces", lambda p: p.halfspaces, ",", True, ("1258", "2042", "3876", "1.62, 3.08")),
        ("tolerance, model units", lambda p: p.tolerance, "g", False, None),
        ("mean in a segment", lambda p: p.segments.kept_halfspaces_mean, ".1f", True, ("74.0", "110.8", "191.4", "1.50, 2.59")),
        ("mean in a subsegment", lambda p: p.subsegments.kept_halfspaces_mean, ".1f", True, ("31.9", "39.0", "52.0", "1.22, 1.63")),
        ("renderer's clocks, squares as segments", lambda p: p.segments.instruction_clocks, ",", True, None),
        ("clocks of the frame, squares as segments", lambda p: p.segments.clocks, ",", True, None),
        ("renderer's clocks, squares as subsegments", lambda p: p.subsegments.instruction_clocks, ",", True,
         ("32.6 s", "34.5 s", "42.3 s", "1.06, 1.30")),
        ("clocks of the frame, squares as subsegments", lambda p: p.subsegments.clocks, ",", True,
         ("89.7 s", "102.5 s", "139.7 s", "1.14, 1.56"))))


def shared_equally(figures, activity):
    """Seconds of that activity if the work of the 16 nodes were always equal, as table 7.3 assumes."""
    def get(point):
        frame = figures.render("carburettor", f"{SIZE} {NODES} --tolerance {point.tolerance}")
        parts = [part for name, part in frame.account.parts.items() if name.startswith("node")]
        return sum(part[activity] for part in parts) / len(parts) * frame.simulated_seconds / frame.clocks
    return get


def node_items(figures):
    """Seconds of a stage of rendering for each thing that it handles at a pixel, with about 2,040 half-spaces. The
    thesis's seconds are a sixteenth, and its means those of a subsegment and of a segment."""
    point = figures.subdivide("carburettor", f"{SIZE} {NODES} {TOLERANCES}")[1]
    parts = point.subsegments
    rows = []
    for name, stage, mean, theirs, seconds, doubt in (
            ("scan conversion: half-spaces", "scan_conversion", parts.kept_halfspaces_mean, 39.0, 34.5, ""),
            ("classification: comparisons", "classification", parts.comparisons_mean, 8.1, 27.6, "?"),
            ("depth sort: primitives", "depth_sort", parts.kept_primitives_mean, 6.3, 5.6, "?")):
        ours = mean * parts.touched / parts["count"]
        each = lambda all_seconds, items: all_seconds * 16 / 256**2 / items * 1e3  # noqa: E731
        rows.append((name, f"{ours:.2f}", f"*{theirs}{doubt}*", f"{each(point.stages.seconds[stage], ours):.2f}", f"*{each(seconds, theirs):.2f}{doubt}*"))
    return ruled(("2,036 half-spaces", "items at a pixel", "*thesis*", "ms an item", "*thesis*"), rows)


def node_table_7_3(figures):
    seconds = lambda key: lambda p: p.stages.seconds[key]  # noqa: E731
    return tolerances(figures, NODES, (
        ("transformation of half-spaces", seconds("transformation"), ".2f", True, ("6.4", "10.2", "19.0", "1.59, 2.97")),
        ("first pruning", seconds("first_pruning"), ".2f", True, ("12.8", "20.3", "38.0", "1.59, 2.97")),
        ("second pruning, perfect balance", shared_equally(figures, "pruning"), ".2f", True, ("2.4", "3.4", "5.4", "1.42, 2.25")),
        ("second pruning, slowest node", seconds("second_pruning"), ".2f", True, None),
        ("communication", seconds("communication"), ".2f", True, ("0.2", "0.3", "0.5", "1.50, 2.50")),
        ("tree pruning", lambda p: "", "", False, ("0.6", "0.6", "0.6", "1.00, 1.00")),
        ("rendering, perfect balance", shared_equally(figures, "rendering"), ".2f", True, ("67.3", "67.7", "76.2", "1.01, 1.13")),
        ("rendering, slowest node", seconds("rendering"), ".2f", True, None),
        ("rendering: scan conversion", seconds("scan_conversion"), ".2f", True, ("32.6", "34.5", "42.3", "1.06, 1.30")),
        ("rendering: CSG classification", seconds("classification"), ".2f", True, ("29.1", "27.6", "28.3", "0.95, 0.97")),
        ("rendering: depth sort", seconds("depth_sort"), ".2f", True, ("5.6", "5.6", "5.6", "1.00, 1.00")),
        ("total", seconds("total"), ".2f", True, ("89.7", "102.5", "139.7", "1.14, 1.56")),
        ("clocks", lambda p: p.subsegments.clocks, ",", False, None),
        ("half-spaces tested in the first pruning", lambda p: p.stages.first_halfspace_tests, ",", False, None),
        ("half-spaces broadcast for a segment", lambda p: p.stages.broadcast_halfspaces_mean, ".1f", True,
         ("74.0", "110.8", "191.4", "1.50, 2.59"))))


def node_levels(figures):
    points = figures.subdivide("carburettor", f"{SIZE} {NODES}")
    keys = ("first_pruning", "second_pruning", "communication", "rendering", "total")
    return ruled(("levels", *(each.subdivisions for each in points)),
                 [(f"{key.replace('_', ' ')}, s", *(f"{each.stages.seconds[key]:.2f}" for each in points)) for key in keys])


def node_figures(figures):
    varied = (("unchanged, 4 × 4 nodes", ""), ("4 × 3 nodes (`nodes.rows` 3)", "+nodes.rows=3"),
              ("3 × 3 nodes", "+nodes.rows=3+nodes.columns=3"), ("`display.divides_ahead` 1", "+display.divides_ahead=1"))
    rows = []
    for name, changes in varied:
        points = figures.subdivide("carburettor", f"{SIZE} {NODES}{changes} --subdivisions 6")
        rows.append((name, f"{points[0].stages.seconds.total:.2f}"))
    return ruled(("6 levels", "total, s"), rows)
