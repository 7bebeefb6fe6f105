"""Tables of docs/machines/bit-serial-memory.md: Pixel-planes compared with current memories. All rows of a model come
from a single call of `csgsim compare`, so that every machine draws the same facets, and a differing picture is an
error."""

from figures import THESIS_MODELS, row, ruled

DIGITAL = "digital-bit-serial-ddr4"
TREES = "+logic.expressions=trees"
LATCH = "+logic.enable=1"
LINE = "+global_or.present=1"
OLD = ("pixel-planes-4", "pixel-planes-5")
MACHINES = (*OLD, DIGITAL, DIGITAL + TREES, "simdram-ddr4", "ambit-ddr4")
CORPUS = (*(f"models/{name}" for name in ("thesis_fig_2_3", "old_example002", "old_example003", "old_example011", "molecule", "crossing_cylinders", "sphere")),
          "corpus/assembly", "corpus/engraved_box", "corpus/gear")
LACKING = (("unchanged", ""), ("the expression trees", TREES), ("a latch that enables writes", LATCH), ("the global OR", LINE),
           ("trees and latch", TREES + LATCH), ("all three", TREES + LATCH + LINE))
WAYS = (("rows of x and y", ""), ("planes of the host", "+logic.expressions=planes"), ("trees", TREES))
LIMITS = (("unchanged", ""), ("one chip", "+chips.count=1"), ("without tFAW", "+timing.window=ideal"),
          ("without refresh", "+timing.refresh_interval=ideal"))
CHANGED = tuple(dict.fromkeys(DIGITAL + change for choices in (LACKING, WAYS, LIMITS) for _, change in choices))
EXACT = ("models/old_example011", "models/thesis_fig_2_3")


def compared(figures, model, machines=tuple(dict.fromkeys((*MACHINES, *CHANGED))), options=""):
    """Points of each machine for the same picture of the model."""
    points = figures.compare(model, f"{options}--machines {','.join(machines)} --fragments none --sides none")
    return dict(zip(machines, points, strict=True))


def milliseconds(seconds):
    """Milliseconds with three digits, without an exponent."""
    digits = f"{seconds * 1e3:.3g}"
    return f"{float(digits):,.0f}" if "e" in digits else digits


def times(figures):
    """Seconds of a frame, by model and machine."""
    return {(model, machine): point.simulated_seconds for model in THESIS_MODELS for machine, point in compared(figures, model).items()}


def joules(machine, point):
    """Joules of a frame, in italics if they come from the model of a process instead of parameters of the machine."""
    return f"*{point.frame_joules:.3g}*" if machine in OLD else f"{point.frame_joules:.3g}"


def models(figures):
    lines = [row("", "clocks", "ms", "frames/s", "J a frame"), "|---" + "|--:" * 4 + "|"]
    for model in THESIS_MODELS:
        lines.append(row(f"**{model}**", *[""] * 4))
        points = compared(figures, model)
        for machine in MACHINES:
            point = points[machine]
            lines.append(row(f"`{machine}`", f"{point.clocks:,}", milliseconds(point.simulated_seconds), f"{point.frames_per_second:.3g}", joules(machine, point)))
    return "\n".join(lines)


def corpus(figures):
    rows = []
    for model in CORPUS:
        points = compared(figures, f"tests/{model}.csg", MACHINES, "--view-all ")
        energies = (DIGITAL, "simdram-ddr4", "ambit-ddr4")
        rows.append((model.split("/")[1], *(milliseconds(points[machine].simulated_seconds) for machine in MACHINES),
                     *(joules(machine, points[machine]) for machine in energies)))
    return ruled(("model", *(f"`{machine}`" for machine in MACHINES), "J, digital", "J, SIMDRAM", "J, Ambit"), rows)


def worth(figures, choices):
    of_models = [compared(figures, model) for model in THESIS_MODELS]
    rows = []
    for name, change in choices:
        points = [points[DIGITAL + change] for points in of_models]
        rows.append((name, *(milliseconds(point.simulated_seconds) for point in points), *(joules(DIGITAL, point) for point in points)))
    return ruled(("", *(f"{model}, ms" for model in THESIS_MODELS), *(f"{model}, J" for model in THESIS_MODELS)), rows)


def lacking(figures):
    return worth(figures, LACKING)


def ways(figures):
    return worth(figures, WAYS)


def limits(figures):
    return worth(figures, LIMITS)


def exact(figures):
    """Exact numbers, for models that take little time."""
    machines = (*CHANGED, "simdram-ddr4", "simdram-ddr4" + TREES, "ambit-ddr4")
    of_models = [compared(figures, f"tests/{model}.csg", machines, "--view-all ") for model in EXACT]
    rows = []
    for machine in machines:
        cells = [cell for points in of_models for cell in (f"{points[machine].clocks:,}", f"{points[machine].frame_joules * 1e9:,.3f}")]
        rows.append((f"`{machine}`", *cells))
    return ruled(("", *(head for model in EXACT for head in (f"{model.split('/')[1]}, clocks", "nJ"))), rows)
