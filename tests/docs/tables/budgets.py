"""docs/budgets.md: a sphere without facets."""

from figures import ruled

SPHERE = "tests/models/sphere.csg --view-all"
MACHINES = ("pixel-powers", "pixel-powers+memory.reads=2")
WIDTHS = ((20, 24), (14, 24), (14, 12), (12, 12))


def drawn(figures, z_bits=20, colour_bits=24):
    """The stats with one read port, and with two."""
    return [figures.render(SPHERE, f"--machine {machine} --z-bits {z_bits} --colour-bits {colour_bits}") for machine in MACHINES]


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
