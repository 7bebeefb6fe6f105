"""Tables of docs/software.md: table 5.2 and figures 5.7 to 5.9 of the thesis, whose own numbers are in italics, and
rivals of EXCELL."""

from figures import PERSPECTIVE, THESIS_MODELS, point, ruled
from tables.software import italic, three_digits, whole

CAST = ("primary", "shadow", "mirror")
NAMES = {"primary": "primary rays", "shadow": "plus shadow rays", "mirror": "plus mirror rays"}
DIRECTORIES = ("excell", "excell-recursive", "boxes", "octree", "grid", "kd-tree", "bvh")
BUCKETS = (1, 2, 4, 6, 8, 12, 16, 20, 24)
TOLERANCES = "2,0.5,0.1,0.02,0.005"
# Without and with item buffer: facets tested per ray, facets hit per ray, minutes.
TABLE_5_2 = {"primary": (("15.70", "0.32"), ("0.59", "0.32"), ("81.88", "18.12")),
             "shadow": (("22.36", "6.95"), ("1.23", "0.96"), ("109.06", "46.18")),
             "mirror": (("29.58", "14.20"), ("1.83", "1.55"), ("140.35", "76.55"))}


def excell(figures, model):
    """Points of EXCELL, all rays, with and without item buffer."""
    return figures.trace(model, "--directories excell --item-buffer without,list-priority,depth-lists --facet-test space,projected")


def minutes(one):
    return one.seconds.mc68000.all / 60


def a_ray(one, key):
    return f"{one[key] / one.rays:.2f}"


def table_5_2(figures):
    rows = []
    for cast in CAST:
        measures = (("facets tested a ray", lambda one: a_ray(one, "facet_tests")), ("facets met a ray", lambda one: a_ray(one, "facets_met")),
                    ("mc68000, minutes", lambda one: three_digits(minutes(one))))
        for (name, get), theirs in zip(measures, TABLE_5_2[cast]):
            cells = [italic(each) for each in theirs]
            for model in THESIS_MODELS:
                cells += [get(point(excell(figures, model), cast=cast, facet_test="space", item_buffer=buffer)) for buffer in ("without", "list-priority")]
            rows.append((f"{NAMES[cast]}: {name}", *cells))
    head = ["without, with item buffer", "*thesis*", ""]
    for model in THESIS_MODELS:
        head += [model, ""]
    return ruled(head, rows)


def passes(figures):
    """Primary rays by the test of facets and by the method of the item buffer."""
    rows = []
    for test in ("space", "projected"):
        for buffer in ("without", "list-priority", "depth-lists"):
            own = [point(excell(figures, model), cast="primary", facet_test=test, item_buffer=buffer) for model in THESIS_MODELS]
            rows.append((f"`{test}`, `{buffer}`", *(three_digits(each) for one in own for each in (one.seconds.mc68000.projection / 60, minutes(one)))))
    return ruled(("mc68000, minutes", *(cell for model in THESIS_MODELS for cell in (f"{model}: projection", "all"))), rows)


def fitted(tested, seconds, rays=65_536):
    """Least-squares fit of seconds = rays (a + b tested): a and b in ms."""
    n, values = len(tested), [1e3 * each / rays for each in seconds]
    mean, middle = sum(tested) / n, sum(values) / n
    slope = sum((x - mean) * (y - middle) for x, y in zip(tested, values)) / sum((x - mean) ** 2 for x in tested)
    return middle - slope * mean, slope


def fit(figures):
    """Time of a ray without tests, and time of a test."""
    thesis = [(float(tested[i]), 60 * float(taken[i])) for tested, _, taken in TABLE_5_2.values() for i in (0, 1)]
    rows = [(italic("thesis, six cells"), *(italic(f"{each:.{digits}f}") for each, digits in zip(fitted(*zip(*thesis)), (1, 2))), "")]
    for model in THESIS_MODELS:
        own = [point(excell(figures, model), cast=cast, facet_test="space", item_buffer="without") for cast in CAST]
        constant, slope = fitted([one.facet_tests / one.rays for one in own], [one.seconds.mc68000.all for one in own])
        shading = own[0].seconds.mc68000.classification + own[0].seconds.mc68000.shading
        rows.append((f"{model}, without item buffer", f"{constant:.2f}", f"{slope:.2f}", f"{1e3 * shading / own[0].rays:.2f}"))
    return ruled(("ms", "a ray", "a facet tested", "classification and shading of a primary ray"), rows)


def primary(figures, model):
    """Points of all directories, primary rays without item buffer."""
    return figures.trace(model, f"--directories {','.join(DIRECTORIES)} --cast primary --item-buffer without")


def directories(figures):
    rows = []
    for model in THESIS_MODELS:
        for directory in DIRECTORIES:
            one = point(primary(figures, model), directory=directory)
            seconds = one.seconds.mc68000
            rows.append((f"{model}, `{directory}`", whole(one.cells), a_ray(one, "cell_visits"), a_ray(one, "facet_tests"),
                         *(three_digits(each) for each in (seconds.traversal, seconds.intersection, seconds.all, one.seconds.i486dx2.all)),
                         three_digits(seconds.build), whole(one.directory_words + one.bucket_words)))
    return ruled(("primary rays", "cells", "cells a ray", "facets tested a ray", "mc68000, s: cells", "facets", "all", "i486dx2, s",
                  "mc68000, s: building", "words"), rows)


def histogram(figures):
    """Rays by number of cells: shares of all, in EXCELL."""
    rows = []
    most = 16
    for model in THESIS_MODELS:
        one = point(primary(figures, model), directory="excell")
        counts = [int(each) for each in one.rays_by_cells.split()]
        shares = [100 * each / one.rays for each in counts]
        groups = [sum(shares[first:last]) for first, last in ((0, 1), (1, 3), (3, 5), (5, 9), (9, most + 1), (most + 1, len(shares)))]
        rows.append((model, a_ray(one, "cell_visits"), *(f"{each:.1f}" for each in groups)))
    return ruled(("EXCELL, % of rays", "cells a ray", "none", "1 to 2", "3 to 4", "5 to 8", "9 to 16", "more"), rows)


def buckets(figures):
    points = figures.trace("carburettor", f"--directories excell --cast primary --item-buffer without --bucket-sizes {','.join(map(str, BUCKETS))}",
                           "mc68000")
    rows = []
    for size in BUCKETS:
        one = point(points, bucket_size=size)
        seconds = one.seconds.mc68000
        rows.append((size, whole(one.cells), whole(one.directory_words + one.bucket_words), a_ray(one, "cell_visits"), a_ray(one, "facet_tests"),
                     *(three_digits(each) for each in (seconds.traversal, seconds.intersection, seconds.classification + seconds.shading, seconds.all,
                                                       seconds.build))))
    return ruled(("facets in a bucket", "cells", "words", "cells a ray", "facets tested a ray", "s: cells", "facets", "classification and shading",
                  "all", "building"), rows)


GROWING = ("excell", "boxes", "octree", "grid", "kd-tree", "bvh")


def growing(figures):
    """Points of the carburettor by tolerance."""
    return figures.trace("carburettor", f"--directories {','.join(GROWING)} --cast primary --item-buffer without --tolerances {TOLERANCES}", "mc68000")


def polygons(figures):
    rows = []
    points = growing(figures)
    for tolerance in (float(each) for each in TOLERANCES.split(",")):
        own = [point(points, directory=directory, tolerance=tolerance) for directory in GROWING]
        rows.append((whole(own[0].polygons), *(three_digits(each.seconds.mc68000.all) for each in own), a_ray(own[0], "facet_tests"),
                     a_ray(own[1], "facet_tests")))
    return ruled(("mc68000, s, by polygons", *GROWING, "facets tested, excell", "boxes"), rows, numbers_from=0)


NODES = 16


def nodes(figures):
    """Estimate of ray tracing on the multi-processor: all rays, with item buffer, evenly distributed."""
    rows = []
    for model in THESIS_MODELS:
        one = {cast: point(excell(figures, model), cast=cast, facet_test="space", item_buffer="depth-lists") for cast in CAST}
        drawn = figures.render(model, f"{PERSPECTIVE} --size 256x256 --machine multi-processor")
        words = one["mirror"].words + one["mirror"].directory_words + one["mirror"].bucket_words
        rows.append((model, *(three_digits(each.seconds.mc68000.all / NODES) for each in one.values()),
                     three_digits(drawn.simulated_seconds), whole(2 * words)))
    return ruled(("seconds of 16 nodes", "primary rays", "plus shadow rays", "plus mirror rays", "depth buffer, as simulated", "words of 16 bits a node"), rows)
