"""Tables of docs/machines/comparison.md."""

from figures import THESIS_MODELS, point, row, ruled

MACHINES = ("pixel-planes-4", "scan-line", "pixel-square", "pixel-planes-5", "pixel-powers", "multi-processor")
LEAST_SHARE = 0.001  # minimum share of an ideal parameter to get its own row


def four_digits(value):
    return f"{value / 1e9:.4g} · 10⁹"


def at_full_size(points, machine):
    return point(points, machine=machine, width=512, fragments=0.0)


def two_digits(value):
    digits = f"{value:.2g}"
    return f"{float(digits):.0f}" if "e+" in digits else digits


def machine_row(machine, each):
    pace = each.frames_per_second
    return row(f"`{machine}`", f"{each.clocks:,}", f"{each.simulated_seconds * 1e3:,.2f}", f"{pace:.{1 if pace >= 0.5 else 2}f}",
               two_digits(each.hosted_frames_per_second),
               four_digits(each.pixel_operations), f"{each.processors:,}", four_digits(each.processor_clocks),
               f"{each.machine_memory_bits:,}", f"{100 * each.utilisation:.1f} %")


def machines(figures):
    head = ("", "clocks", "ms", "frames/s", "with host", "pixel operations", "processors", "processor clocks", "memory bits", "used")
    lines = [row(*head), "|---" + "|--:" * 9 + "|"]
    for model in THESIS_MODELS:
        points = figures.compare(model)
        half_spaces = at_full_size(points, MACHINES[0]).halfspaces
        lines.append(row(f"**{model}**, {half_spaces:,} half-spaces", *[""] * 9))
        lines += [machine_row(machine, at_full_size(points, machine)) for machine in MACHINES]
    return "\n".join(lines)


def shares(points, machine):
    """The saving of each ideal parameter, as a share of the unchanged machine's clocks."""
    own = [each for each in points if each.machine == machine]
    as_it_is = next(each for each in own if not each.ideal).clocks
    return {each.ideal: (as_it_is - each.clocks) / as_it_is for each in own if each.ideal}


def ideals(figures):
    rows = []
    points = [figures.compare(model, "--ideal") for model in THESIS_MODELS]
    for machine in MACHINES:
        of_models = [shares(each, machine) for each in points]
        for ideal in of_models[0]:
            worth = [each[ideal] for each in of_models]
            if max(worth) > LEAST_SHARE or ideal == "all":
                name = "**all**" if ideal == "all" else f"`{ideal}`"
                rows.append((f"`{machine}`", name, *(f"{100 * each:.1f} %" for each in worth)))
    return ruled(("machine", "ideal", *THESIS_MODELS), rows, numbers_from=2)


def times(ratio):
    if ratio >= 10:
        return f"× {ratio:.1f}".replace(".0", "")
    return f"× {ratio:.2f}" if ratio < 1.2 else f"× {ratio:.1f}"


def growth(figures):
    rows = []
    for model in THESIS_MODELS:
        points = figures.compare(model)
        few, many = (point(points, machine=MACHINES[0], width=512, fragments=float(n)) for n in (8, 64))
        name = f"{model}, {few.halfspaces:,} → {many.halfspaces:,} half-spaces, × {many.halfspaces / few.halfspaces:.1f}"
        rows.append((name, *(times(point(points, machine=machine, width=512, fragments=64.0).clocks
                                   / point(points, machine=machine, width=512, fragments=8.0).clocks) for machine in MACHINES)))
    for model in THESIS_MODELS:
        points = figures.compare(model)
        rows.append((f"{model}, 128² → 512² pixels, × 16",
                     *(times(at_full_size(points, machine).clocks / point(points, machine=machine, width=128).clocks)
                       for machine in MACHINES)))
    return ruled(("from → to", *(f"`{machine}`" for machine in MACHINES)), rows)
