"""The sphere without facets in docs/performance.md."""

from figures import ruled

SPHERE = "tests/models/sphere.csg --view-all"
MACHINES = ("pixel-powers", "pixel-powers+memory.reads=2")
WIDTHS = ((20, 24), (14, 24), (14, 12), (12, 12))


def drawn(figures, z_bits=20, colour_bits=24):
    """The stats with one read port, and with two."""
    return [figures.render(SPHERE, f"--machine {machine} --curves exact --z-bits {z_bits} --colour-bits {colour_bits}") for machine in MACHINES]


def own(stats):
    return stats.by_primitive[0].clocks


def parts(figures):
    both = drawn(figures)

    def line(name, of):
        return (name, *(of(stats) for stats in both))

    def root(stats):
        return stats.instructions.by_name["root"].clocks

    def waiting(stats):
        return stats.account.parts.controller.starved

    return ruled(("", "one read port", "two"), [
        line("the root of 19 bits", root),
        line("the rest of its surface", lambda stats: stats.by_purpose.render.clocks - root(stats)),
        line("depth test and copy", lambda stats: stats.by_purpose.merge.clocks),
        line("light", lambda stats: stats.by_purpose.shade.clocks),
        line("**the sphere**", lambda stats: f"**{own(stats)}**"),
        line("clear memory", lambda stats: stats.account.parts.controller.clearing),
        line("set depth and colour", lambda stats: stats.by_purpose.setup.clocks),
        line("wait for the link", waiting),
        line("latency", lambda stats: stats.by_purpose.latency.clocks),
        line("**the picture**", lambda stats: f"**{stats.clocks}**"),
    ])


def widths(figures):
    rows = []
    for z_bits, colour_bits in WIDTHS:
        rows.append((f"{z_bits} bits of depth, {colour_bits} of colour", *(own(stats) for stats in drawn(figures, z_bits, colour_bits))))
    return ruled(("", "one read port", "two"), rows)


def planes_5(figures):
    """Numbers from the abstract of Pixel-planes 5, and those computed from our renderers' clocks and parameters."""
    clock, renderers = 40e6, 16
    triangle = max(each.clocks for each in figures.render("tests/budgets/triangle.csgt", "", "run").by_primitive)
    ball = own(figures.render(SPHERE, "--machine pixel-powers"))
    house = figures.render("house", "--machine pixel-planes-5+frame_buffer.banks=8+renderers.count=16+processors.count=32")
    return ruled(("", "published", "ours"), [
        ("triangles per second, one renderer", "", f"{clock / triangle:,.0f}"),
        ("triangles per second, 16 renderers", "1,000,000", f"{renderers * clock / triangle:,.0f}"),
        ("renderer clocks per triangle, with 16 renderers", f"{renderers * clock / 1e6:,.0f}", f"{triangle}"),
        ("spheres per second, one renderer", "", f"{clock / ball:,.0f}"),
        ("spheres per second, 16 renderers", "", f"{renderers * clock / ball:,.0f}"),
        ("pixels per second to the frame buffer, one renderer", "", f"{20e6 * 32 / 24:,.0f}"),
        ("the same for the house, 16 renderers, 8 banks", "", f"{512 * 512 / house.simulated_seconds:,.0f}"),
        ("ring, bits a second", "5 · 10⁹", f"{8 * 32 * 20e6 / 1e9:.2f} · 10⁹"),
    ])
