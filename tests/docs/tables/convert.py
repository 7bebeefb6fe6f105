"""Durations of conversions in docs/convert.md, compared with OpenSCAD's."""

from math import prod

from figures import row
from runs import ROOT

MODELS = ("carburettor", "terrain_vehicle", "rietveld_house", "connecting_rod", "molecule", "old_example006", "basics_csg", "thesis_fig_2_3")
PARTS = ("thread", "knurl", "engraved_box", "lattice", "spheres_cut", "text_align", "text_fonts", "seams", "extrude_twist_full", "surface_dat")
FLAT = ("flat_top",)


def seconds(figures, command):
    """Processor time of the command and its child processes."""
    timed = f"export TIMEFORMAT='%U %S'; {{ time {command} > $OUT/out.txt 2> $OUT/err.txt; }} 2>&1"
    return sum(map(float, figures.runs.run(timed).printed.split()[-2:]))


def both(figures, path):
    ours = seconds(figures, f"csgsim convert {path} --imports-from tests -o $OUT/a.stl")
    theirs = seconds(figures, f"openscad -o $OUT/b.stl {path}")
    return ours, theirs


def triangles(figures, path):
    done = figures.runs.run(f"csgsim convert {path} --imports-from tests -o $OUT/a.stl --stats $OUT/s.json --quiet 2> $OUT/err.txt")
    return done.json("s.json").triangles


def line(name, count, ours, theirs):
    return row(name, f"{count:,}", f"{ours:.2f}", f"{theirs:.2f}", f"{theirs / ours:.3g}")


def times(figures):
    lines = [row("model", "triangles", "csgsim, s", "OpenSCAD, s", "speed-up"), "|---|--:|--:|--:|--:|"]
    for name in MODELS:
        path = f"tests/models/{name}.csg"
        lines.append(line(f"`{name}`", triangles(figures, path), *both(figures, path)))
    corpus = {path.stem: f"tests/corpus/{path.name}" for path in sorted((ROOT / "tests/corpus").glob("*.csg")) if path.stem not in FLAT}
    measured = {name: (triangles(figures, path), *both(figures, path)) for name, path in corpus.items()}
    for name in PARTS:
        lines.append(line(f"`{name}`", *measured[name]))
    sums = [sum(each) for each in zip(*measured.values())]
    lines.append(line(f"all {len(measured)} of tests/corpus", *sums))
    times_as_fast = [theirs / ours for _, ours, theirs in measured.values()]
    lines.append(row(f"geometric mean of the {len(measured)}", "", "", "", f"{prod(times_as_fast) ** (1 / len(times_as_fast)):.3g}"))
    return "\n".join(lines)
