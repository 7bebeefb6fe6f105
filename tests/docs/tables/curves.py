"""Tables of docs/shapes.md."""

from figures import point, ruled

VIEWS = {
    "a sphere of radius 10": "tests/models/sphere.csg --view-all",
    "molecule, 26 spheres": "tests/models/molecule.csg --camera 300,-400,250,0,0,0 --view-all",
}
WAYS = {
    "facets": "--curves facets --memory-bits 128",
    "fast": "--curves fast --check --memory-bits 128",
    "fast, 18 bits of depth and of colour": "--curves fast --check --z-bits 18 --colour-bits 18",
    "exact, on `pixel-powers`": "--curves exact --check --machine pixel-powers",
}


SCENES = {
    "a sphere of radius 10": "sphere",
    "fig. 2.3": "thesis_fig_2_3",
    "carburettor": "carburettor",
    "vehicle": "terrain_vehicle",
    "connecting rod": "connecting_rod",
    "molecule": "molecule",
}


def models(figures):
    rows = []
    for name, model in SCENES.items():
        facets, exact = (figures.render(f"tests/models/{model}.csg --view-all --machine pixel-powers --curves {way}")
                         for way in ("facets", "exact"))
        rows.append((name, exact.model.primitives, f"{facets.clocks:,}", f"{exact.clocks:,}", f"{facets.clocks / exact.clocks:.1f}",
                     facets.memory.used_bits, exact.memory.used_bits))
    return ruled(("", "primitives", "facets: clocks", "exact: clocks", "facets / exact", "facets: bits", "exact: bits"), rows)


def wrong(figures, view, way, stats):
    """Pixels that show another surface than the true one."""
    if way != "facets":
        return stats.accuracy.wrong_silhouette + stats.accuracy.wrong_owner
    points = figures.accuracy(VIEWS[view], "--curves facets --views 1 --knobs size")
    return point(points, knob="size", value="512x512").facet_wrong


def fast(figures):
    rows = []
    for view, model in VIEWS.items():
        for way, options in WAYS.items():
            stats = figures.render(model, options)
            clocks = stats.by_purpose
            rows.append((f"{view}: {way}" if way == "facets" else way, f"{stats.clocks:,}", f"{clocks.render.clocks:,}",
                         f"{clocks.shade.clocks:,}", f"{clocks.setup.clocks:,}", stats.memory.used_bits,
                         f"{wrong(figures, view, way, stats):,}"))
    return ruled(("", "clocks", "surfaces", "light", "setup", "bits", "pixels of another surface"), rows)
