"""docs/machines/today.md and bit-serial-memory.md: Pixel-planes beside the memories of today."""

from figures import THESIS_MODELS, row, ruled

DIGITAL = "digital-bit-serial-ddr4"
TREES = f"{DIGITAL}+logic.expressions=trees"
OLD = ("pixel-planes-4", "pixel-planes-5")
MACHINES = (*OLD, DIGITAL, TREES, "simdram-ddr4", "ambit-ddr4")
CORPUS = (*(f"models/{name}" for name in ("thesis_fig_2_3", "old_example002", "old_example003", "old_example011", "molecule", "crossing_cylinders", "sphere")),
          "corpus/assembly", "corpus/engraved_box", "corpus/gear")
LACKING = (("as it is", ""),
           ("the expression trees", "+logic.expressions=trees"),
           ("a latch that enables writes", "+logic.enable=1"),
           ("the global OR", "+global_or.present=1"),
           ("trees and latch", "+logic.expressions=trees+logic.enable=1"),
           ("all three", "+logic.expressions=trees+logic.enable=1+global_or.present=1"))
WAYS = (("rows of x and y", ""), ("planes of the host", "+logic.expressions=planes"), ("trees", "+logic.expressions=trees"))
LIMITS = (("as it is", ""), ("one chip", "+chips.count=1"), ("without tFAW", "+timing.window=ideal"),
          ("without refresh", "+timing.refresh_interval=ideal"))


def joules(stats):
    return f"{stats.frame_joules:.3g}"


def modelled(figures, model):
    """What the model of a process gives for the old machines, set off from what figures of a machine give."""
    points = figures.compare(model, f"--machines {','.join(OLD)}")
    return {machine: f"*{next(point.frame_joules for point in points if point.machine == machine):.3g}*" for machine in OLD}


def frame(figures, model, machine):
    return figures.render(model, f"--machine {machine}")


def frame_row(name, stats, energy):
    return (name, f"{stats.clocks:,}", f"{stats.simulated_seconds * 1e3:,.3g}", f"{stats.frames_per_second:.3g}", energy)


def models(figures):
    lines = [row("", "clocks", "ms", "frames/s", "J a frame"), "|---" + "|--:" * 4 + "|"]
    for model in THESIS_MODELS:
        lines.append(row(f"**{model}**", *[""] * 4))
        energy = modelled(figures, model)
        for machine in MACHINES:
            stats = frame(figures, model, machine)
            lines.append(row(*frame_row(f"`{machine}`", stats, energy[machine] if machine in OLD else joules(stats))))
    return "\n".join(lines)


def corpus(figures):
    rows = []
    for model in CORPUS:
        stats = [figures.render(f"tests/{model}.csg", f"--view-all --machine {machine}") for machine in MACHINES]
        rows.append((model.split("/")[1], *(f"{each.simulated_seconds * 1e3:,.3g}" for each in stats), joules(stats[2]), *(joules(each) for each in stats[4:])))
    return ruled(("model", *(f"`{machine}`" for machine in MACHINES), "J, digital", "J, SIMDRAM", "J, Ambit"), rows)


def worth(figures, kind, choices):
    rows = []
    for name, change in choices:
        stats = [frame(figures, model, kind + change) for model in THESIS_MODELS]
        rows.append((name, *(f"{each.simulated_seconds * 1e3:.3g}" for each in stats), *(joules(each) for each in stats)))
    return ruled(("", *(f"{model}, ms" for model in THESIS_MODELS), *("J" for _ in THESIS_MODELS)), rows)


def lacking(figures):
    return worth(figures, DIGITAL, LACKING)


def ways(figures):
    return worth(figures, DIGITAL, WAYS)


def limits(figures):
    return worth(figures, DIGITAL, LIMITS)
