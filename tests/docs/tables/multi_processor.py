"""Tables of docs/machines/multi-processor.md."""

from figures import THESIS_MODELS, ruled

STAGES = (("reception of the model", "reception_clocks"), ("transformation", "transformation_clocks"), ("first pruning", "first_pruning_clocks"),
          ("broadcasting", "broadcasting_clocks"), ("second pruning", "second_pruning_clocks"), ("sharing of lists", "sharing_clocks"),
          ("rendering", "rendering_clocks"))


def stages(figures):
    stats = [figures.render(model, "--machine multi-processor") for model in THESIS_MODELS]
    rows = [("clocks", *(f"{each.clocks:,}" for each in stats)),
            ("seconds", *(f"{each.simulated_seconds:.2f}" for each in stats))]
    rows += [(name, *(f"{each.account[key]:,}" for each in stats)) for name, key in STAGES]
    rows += [(name, *(f"{100 * each.account[key]:.1f} %" for each in stats))
             for name, key in (("nodes at work, mean", "node_utilisation"), ("busiest node", "busiest_node_utilisation"))]
    return ruled(("", *THESIS_MODELS), rows)


# Changes to the machine's file.
PROGRAMS = (("", "unchanged"), ("+node.branches=none", "without branches"), ("+lists.kind=instructions", "whole instructions in lists"),
            ("+lists.kind=instructions+node.branches=none", "no branches, whole instructions"), ("+node.program=native", "a native program"),
            ("+rendering.order=scan-line", "scan-line order"), ("+rendering.order=scan-line+node.program=native", "and a native program"),
            ("+rendering.order=pixel", "pixel order"), ("+rendering.order=pixel+node.program=native", "and a native program"))


def programs(figures):
    rows = []
    for change, name in PROGRAMS:
        stats = [figures.render(model, f"--machine multi-processor{change}") for model in THESIS_MODELS]
        option = f" (`{change[1:].replace('+', '`, `')}`)" if change else ""
        rows.append((name + option, *(f"{each.clocks:,}" for each in stats), *(f"{each.account.rendering_clocks:,}" for each in stats)))
    return ruled(("", *THESIS_MODELS, *(f"rendering, {model}" for model in THESIS_MODELS)), rows)
