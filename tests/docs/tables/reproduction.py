"""Results stated only in the thesis's text, next to its tables and ours, for docs/reproduction.md."""

from figures import PERSPECTIVE, THESIS_MODELS, per_cent, point, ruled
from tables import display, memory_bits, software, sweeps, thesis, tracing

MORE_POLYGONS = "--size 256x256 --tolerances 0.009 --methods list-priority/depth-buffer"


def listed(values, spec):
    return ", ".join(format(value, spec) for value in values)


def span(values, spec):
    return f"{min(values):{spec}} to {max(values):{spec}}"


def most_by_least(values):
    return f"{max(values) / min(values):.2f}"


def thesis_seconds(model, method, coherence):
    return float(software.TABLE_4_10[model][method][software.OF_THESIS.index(coherence)].rstrip("?"))


def our_seconds(figures, model, method, coherence):
    return software.of(figures.classify(model), method, coherence).seconds.mc68000.classification


def quotients(seconds, over, under):
    """By model: the time of one (method, coherence) divided by that of another."""
    return [seconds(model, *over) / seconds(model, *under) for model in THESIS_MODELS]


def list_processing(seconds, evaluations):
    """By model: the share of time outside evaluations, in %, for the standard traversal with the list structure."""
    shares = []
    for model in THESIS_MODELS:
        an_evaluation = seconds(model, "standard", "all-points") / evaluations(model, "all-points")
        shares.append(100 - per_cent(evaluations(model, "list-structure") * an_evaluation, seconds(model, "standard", "list-structure")))
    return listed(shares, ".0f")


def of_classification(figures):
    """Results of sections 4.1, 4.4 and 4.6."""
    ours = lambda model, method, coherence: our_seconds(figures, model, method, coherence)  # noqa: E731
    both = (thesis_seconds, ours)
    standard, all_points, kept = "standard", "all-points", "list-structure"
    saved = [[100 * (1 - value) for value in quotients(seconds, (standard, "one-list"), (standard, all_points))] for seconds in both]
    parts = [[per_cent(each.seconds.mc68000.classification, each.seconds.mc68000.all)
              for each in (software.of(figures.classify(model), method, coherence) for model in THESIS_MODELS)]
             for method, coherence in (("status", kept), (standard, all_points))]
    spread = [[max(taken) / min(taken) for taken in ([seconds(model, method, kept) for method in software.TABLE_4_10[model]] for model in THESIS_MODELS)]
              for seconds in both]
    evaluations = [[software.TABLE_4_9[model]["evaluations"][:2] for model in THESIS_MODELS],
                   [[software.of(figures.classify(model), standard, coherence).evaluations for coherence in (all_points, "first-point")]
                    for model in THESIS_MODELS]]
    first_points = [[100 * (1 - later / every) for every, later in each] for each in evaluations]
    lists = [[every / software.TABLE_4_9[model]["met"] for (every, _), model in zip(evaluations[0], THESIS_MODELS)],
             [every / figures.classify(model)[0].met_rays for (every, _), model in zip(evaluations[1], THESIS_MODELS)]]
    evaluated = (lambda model, coherence: software.TABLE_4_9[model]["evaluations"][software.OF_THESIS.index(coherence)],
                 lambda model, coherence: software.of(figures.classify(model), standard, coherence).evaluations)
    stacks = [point(figures.sweep(model, PERSPECTIVE), strategy="stack") for model in THESIS_MODELS]
    whole_bits = [figures.clocks("vehicle", f"{PERSPECTIVE} --strategy {strategy} --memory-bits 80") for strategy in ("parallel", "stack")]
    times = lambda over, under: [listed(quotients(seconds, (over, all_points), (under, all_points)), ".2g") for seconds in both]  # noqa: E731
    return [("4, p. 37; 4.1, p. 39", "classifying takes a small part of a picture's time", "",
             f"{listed(parts[0], '.0f')} % by `status`, `list-structure`; {listed(parts[1], '.0f')} % by `standard`, `all-points`"),
            ("4.4.1, p. 47; 6.1, p. 74", "a tree of n levels needs n bits of stack: n, and the bits of `stack`, mask included", "",
             "; ".join(f"{each.tree_depth - 1}, {each.classification_bits}" for each in stacks)),
            ("4.5.1, p. 50", "most evaluations are for first points: their share of all, %", *(listed(each, ".0f") for each in first_points)),
            ("4.6.1, p. 55", "unions keep the lists short: points of a ray, to the first in the solid", *(listed(each, ".1f") for each in lists)),
            ("4.6.1, p. 56", "with the list structure, lists take most of the time: %, by `standard`", *(list_processing(*each) for each in zip(both, evaluated))),
            ("4.6.1, p. 56", "bit-parallel is slightly faster than standard: times as fast", *times(standard, "bit-parallel")),
            ("4.6.1, p. 56", "bit-parallel with status is faster than the status tree: times as fast", *times("status", "bit-parallel-status")),
            ("4.6.1, p. 56", "with the list structure the method hardly matters: slowest ÷ fastest", *(listed(each, ".2f") for each in spread)),
            ("4.6.2, p. 56", "positional codes are efficient: times as fast as standard", *times(standard, "positional")),
            ("4.6.2, p. 56", "the status tree is efficient too: times as fast as standard", *times(standard, "status")),
            ("4.6.2, p. 56", "first point and one list save 90 %: of standard, %", *(listed(each, ".0f") for each in saved)),
            ("4.6.2, p. 56", "bit-parallel is the most efficient where pixels are processed in parallel", "",
             "the vehicle on `pixel-planes-4`: {:,} clocks, by `stack` {:,}".format(*whole_bits))]


def of_list_priority(figures):
    """Results of section 5.2."""
    points = [display.of(display.cylinders(figures), "list-priority/depth-buffer", fragments=n) for n in display.FRAGMENTS]
    polygons, seconds = [each.clipped_polygons for each in points], [each.seconds.mc68000.total for each in points]
    theirs = display.THESIS
    many = figures.display("carburettor", MORE_POLYGONS)[0]
    scan_line = [display.shown(figures, name, "scan-line").seconds.mc68000.total / display.shown(figures, name, "list-priority/depth-buffer").seconds.mc68000.total
                 for name in display.OBJECTS]
    grown = "{:.2f} times the clipped polygons, {:.2f} times the seconds"
    clipped = lambda one: one.clipped_polygons / one.polygons  # noqa: E731
    words = [display.shown(figures, name, "list-priority").words / display.shown(figures, name, "scan-line").words for name in display.OBJECTS]
    sorting = [[1e3 * taken / after for taken, after in each] for each in (
        zip(theirs["sorting"], theirs["clipped_polygons"]), ((each.seconds.mc68000.sorting, each.clipped_polygons) for each in points))]
    return [("5.2, p. 62", "clipping strongly increases the number of polygons: times",
             span([after / before for after, before in zip(theirs["clipped_polygons"], theirs["polygons"])], ".1f"),
             f"cylinders {span([clipped(each) for each in points], '.1f')}; {listed([clipped(display.shown(figures, name, 'list-priority')) for name in THESIS_MODELS], '.1f')}"),
            ("5.2.1, p. 62", "memory is excessive: words ÷ words of scan lines", "", f"cylinders {words[0]:.1f}; {listed(words[1:], '.1f')}"),
            ("5.2.1, p. 63", "sorting is linear: ms a clipped polygon", *(span(each, ".1f") for each in sorting)),
            ("5.2.1, p. 63", "time grows with the polygons: last column ÷ first",
             grown.format(theirs["clipped_polygons"][-1] / theirs["clipped_polygons"][0], theirs["total"][-1] / theirs["total"][0]),
             grown.format(polygons[-1] / polygons[0], seconds[-1] / seconds[0])),
            ("5.2.1, p. 63", "more than 10,000 polygons take 50 to 100 times table 5.1", "",
             f"{many.polygons:,} of the carburettor: {many.seconds.mc68000.total:.0f} s, {many.seconds.mc68000.total / seconds[-1]:.0f} to "
             f"{many.seconds.mc68000.total / seconds[0]:.0f} times"),
            ("5.2.1, p. 63", "no improvement on scan lines: time of scan lines ÷ time of list priority", "", span(scan_line, ".2f"))]


def of_projection(figures):
    """Results of sections 2.4 and 7.4.1: time of primary rays divided by that of projective methods."""
    rays = [point(tracing.primary(figures, model), directory="excell").seconds.mc68000.all for model in THESIS_MODELS]
    shares = {method: [taken / display.shown(figures, model, method).seconds.mc68000.total for taken, model in zip(rays, THESIS_MODELS)]
              for method in ("list-priority/depth-buffer", "scan-line")}
    return [("2.4, p. 19; 7.4.1, p. 90", "projective methods are an order of magnitude faster than ray tracing", "",
             f"list priority {span(shares['list-priority/depth-buffer'], '.1f')} times as fast, scan lines {span(shares['scan-line'], '.1f')} times")]


def of_rays(figures):
    """Results of sections 5.1.3 and 5.3."""
    by_steps, by_halves = ([point(tracing.primary(figures, model), directory=name) for model in THESIS_MODELS] for name in ("excell", "excell-recursive"))
    grown = {each.polygons: each for each in tracing.growing(figures) if each.directory == "excell"}
    few, many = sorted(grown)[2:4]
    least, most = min(grown), max(grown)
    boxes = {each.polygons: each for each in tracing.growing(figures) if each.directory == "boxes"}
    slower = lambda points: f"{points[most].seconds.mc68000.all / points[least].seconds.mc68000.all:.1f}"  # noqa: E731
    descent = [point(tracing.primary(figures, model), directory="octree") for model in THESIS_MODELS]
    a_cell = lambda one: one.seconds.mc68000.traversal / one.cell_visits  # noqa: E731
    return [("5.1.3, p. 60", "cells take constant time, boxes logarithmic", "",
             f"from {least:,} to {most:,} polygons: EXCELL {slower(grown)} times the seconds, boxes {slower(boxes)}"),
            ("5.3, p. 64", "an address is better than descending an octree (Glassner 1984): clocks per cell, octree ÷ EXCELL", "",
             listed([a_cell(b) / a_cell(a) for a, b in zip(by_steps, descent)], ".2f")),
            ("5.3, p. 66", "more than two or three cells a ray", "", listed([each.cell_visits / each.rays for each in by_steps], ".2f")),
            ("5.3, p. 66", "no clear difference between stepping through cells and halving: halving, % of stepping", "",
             listed([per_cent(b.seconds.mc68000.traversal, a.seconds.mc68000.traversal) for a, b in zip(by_steps, by_halves)], ".0f")),
            ("5.3, p. 67", "testing polygons against rays takes most of the time: %", "",
             listed([per_cent(each.seconds.mc68000.intersection, each.seconds.mc68000.all) for each in by_steps], ".0f")),
            ("5.3, p. 67; 8.1, p. 97", "the constant time is very high: ms a primary ray", f"{float(tracing.TABLE_5_2['primary'][2][0]) * 60e3 / 65_536:.0f}",
             listed([1e3 * each.seconds.mc68000.all / each.rays for each in by_steps], ".0f")),
            ("5.3, p. 67", "time does not depend on the number of polygons", "",
             f"from {few:,} to {many:,}: {grown[many].seconds.mc68000.all / grown[few].seconds.mc68000.all:.2f} times the seconds, "
             f"{grown[many].facet_tests / grown[few].facet_tests:.2f} times the facets tested")]


def of_trees(figures):
    """Results of sections 6.1, 6.3 and 6.4."""
    swept = lambda options: figures.sweep("vehicle", f"{PERSPECTIVE} --strategy bits --stack-bits 3..9{options}")  # noqa: E731
    compared = [[memory_bits.of_bits(points, bits).classified for bits in memory_bits.STACK_BITS] for points in (swept(""), swept(" --pruning none"))]
    saved = [100 * (1 - each[-1] / each[0]) for each in ([236, 236, 140, 131, 123, 123, 123], *compared)]
    enough = memory_bits.STACK_BITS[compared[0].index(compared[0][-1])]
    pairs = figures.runs.run("cd $OUT; " + figures.shown("docs/reproduction.md", "awk")).json("pairs.json").scan_conversions.rendered
    bits = [[figures.render(model, f"{PERSPECTIVE} --memory-bits 4096 --strategy {strategy}").memory.used_bits for strategy in ("stored", "stack")]
            for model in THESIS_MODELS]
    least = [memory_bits.of_bits(figures.sweep(model, PERSPECTIVE), 3).classification_bits for model in THESIS_MODELS]
    return [("6.1, p. 74", "keeping all depths takes enormous memory: bits a pixel, and those of `stack`", "",
             "; ".join("{}, {}".format(*each) for each in bits)),
            ("6.3.1, p. 78", "2ⁿ primitives, joined in pairs that are then intersected, have 2^2ⁿ⁻¹ products: n = 3", "16",
             f"{pairs} scan-conversions, four a product: {pairs // 4}"),
            ("6.4, p. 80", "three bits are the least: bits that `bits` 3 uses", "3", f"{listed(least, '')}: only the mask"),
            ("6.4, p. 82", "enough bits save 50 % of the active trees, against m = 3", f"{saved[0]:.0f} %",
             f"{saved[1]:.0f} %; without prunings {saved[2]:.0f} %"),
            ("6.4, p. 82", "few bits are enough: smallest m beyond which nothing more is saved", "7?", f"{enough}")]


def of_machines(figures):
    """Results of sections 7.2, 7.4 and 8.1."""
    runs = [figures.render(model, PERSPECTIVE) for model in THESIS_MODELS]
    shown, drawn = ([get(each) for each in runs] for get in (lambda run: run.frames_per_second, lambda run: 1 / run.simulated_seconds))
    planes = figures.machine_file("pixel-planes-4")
    bits = planes["array.width"] * planes["array.height"] * planes["clock.frequency"]
    account = figures.render("carburettor", "--machine multi-processor").account
    rendering = [part.rendering for name, part in account.parts.items() if name.startswith("node")]
    saved = 100 - per_cent(sum(rendering) / len(rendering), account.rendering_clocks)
    nodes = figures.subdivide("carburettor", f"{thesis.SIZE} {thesis.NODES} {thesis.TOLERANCES}")
    wholes = [figures.clocks("carburettor", f"{thesis.SIZE} --tolerance {each.tolerance}") for each in nodes]
    faces = [figures.clocks(model, f"{PERSPECTIVE} --strategy polygons") / figures.clocks(model, f"{PERSPECTIVE} --strategy stack") for model in THESIS_MODELS]
    return [("7.2, p. 83", "several billion pixel operations a second", "", f"`pixel-planes-4`: {bits / 1e9:,.0f} billion, of one bit"),
            ("7.4.1, p. 90; 7.4.2, p. 91", "interleaving shares the rendering equally", "",
             f"carburettor: shared perfectly, it would take {saved:.0f} % less"),
            ("7.4.4, p. 92", "time is linear in the half-spaces: for 1.62 and 3.08 times their number", "1.14, 1.56",
             f"`multi-processor` {thesis.ratios([each.stages.seconds.total for each in nodes])}; `pixel-planes-4` {thesis.ratios(wholes)}"),
            ("7.4.4, p. 92", "polygons may be more expensive than half-spaces: `polygons` by `stack`", "", f"{listed(faces, '.2f')} times the clocks"),
            ("8.1, p. 97", "logic-enhanced frame buffers draw nearly in real time", "", f"frames shown a second, `pixel-planes-4`: {listed(shown, '.0f')}; drawn: {listed(drawn, '.0f')}")]


def claims(figures):
    held = [[sweeps.held_by_root(*each) for each in zip(most, elements)] for most, elements in (
        (sweeps.TABLE_3_1["most_elements"], sweeps.TABLE_3_1["elements"]), sweeps.held_and_elements(figures))]
    patch = sweeps.patch(figures)
    an_element = ([float(taken.rstrip("?")) / elements for taken, elements in zip(sweeps.SECONDS, sweeps.TABLE_3_1["elements"])],
                  [patch["filter", tolerance].seconds.mc68000.repairing / patch["filter", tolerance].elements for tolerance in sweeps.TOLERANCES])
    rows = [("3.3.3, p. 35", "the filter holds O(√elements): peak elements held ÷ √elements", *(span(each, ".1f") for each in held)),
            ("3.3.3, p. 35", "the filter takes O(L) time: largest ÷ smallest ms per element",
             f"{most_by_least(an_element[0])}? ({most_by_least(an_element[0][1:])} without the first)", most_by_least(an_element[1])),
            *of_projection(figures), *of_classification(figures), *of_list_priority(figures), *of_rays(figures), *of_trees(figures), *of_machines(figures)]
    return ruled(("section", "the thesis's text says", "*its tables*", "ours"),
                 [(section, text, f"*{theirs}*" if theirs else "", ours) for section, text, theirs, ours in rows], 4)
