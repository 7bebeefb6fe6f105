"""Tables of docs/host.md."""

import math

from figures import THESIS_MODELS, row, ruled
from tables.comparison import MACHINES

PROCESSORS = ("mc68000", "i486dx2", "i860")


def milliseconds(clocks, each):
    """Milliseconds of a number of clocks of the point's machine."""
    return 1e3 * clocks * each.simulated_seconds / each.clocks


def four_digits(value):
    return f"{value:,.0f}" if value >= 1000 else f"{value:.4g}"


def hosted(machine, processor):
    """The machine with one such processor as its host."""
    return f"{machine}+host.processor={processor}+host.count=1"


def on_hosts(figures, model, options=""):
    """The points of all machines with each host, by both: from a single call, so that all draw the same picture."""
    pairs = [(machine, processor) for machine in MACHINES for processor in PROCESSORS]
    points = figures.compare(model, f"{options}--machines {','.join(hosted(*pair) for pair in pairs)} --fragments none --sides none")
    return dict(zip(pairs, points, strict=True))


def hosts(figures):
    head = ("", "machine, ms", *(f"`{name}`: model, ms | frame, ms | needed" for name in PROCESSORS))
    lines = [row(*head), "|---" + "|--:" * (1 + 3 * len(PROCESSORS)) + "|"]
    for model in THESIS_MODELS:
        points = on_hosts(figures, model)
        lines.append(row(f"**{model}**", *[""] * (1 + 3 * len(PROCESSORS))))
        for machine in MACHINES:
            own = points[machine, PROCESSORS[0]]
            cells = [four_digits(milliseconds(own.interval_clocks, own))]
            for processor in PROCESSORS:
                one = points[machine, processor]
                cells += [four_digits(milliseconds(one.host_model_clocks, one)),
                          four_digits(milliseconds(one.host_clocks, one)), f"{math.ceil(one.host_clocks / one.interval_clocks):,}"]
            lines.append(row(f"`{machine}`", *cells))
    return "\n".join(lines)


EXACT = ("old_example011", "thesis_fig_2_3")


def exact(figures):
    """Exact numbers: clocks of each machine with each host, for models that take little time."""
    of_models = [on_hosts(figures, f"tests/models/{model}.csg", "--view-all ") for model in EXACT]
    rows = [(f"`{machine}`", f"`{processor}`", *(f"{points[machine, processor].host_clocks:,}" for points in of_models))
            for machine in MACHINES for processor in PROCESSORS]
    return ruled(("machine", "host", *EXACT), rows, numbers_from=2)


PRUNINGS = ("auto", "all", "no-space", "no-separation", "no-halfspaces", "no-hidden", "no-sets", "none")


def prunings(figures):
    """The host time of each pruning, and its saving on the machine."""
    rows = []
    for machine in ("pixel-planes-4", "scan-line"):
        for pruning in PRUNINGS:
            cells = []
            for model in THESIS_MODELS:
                stats = figures.render(model, f"--machine {machine} --curves facets --pruning {pruning}")
                cells += [f"{stats.clocks:,}"]
                cells += [four_digits(1e3 * clocks / stats.machine.clock_hz) for clocks in (stats.host_model_clocks, stats.host_clocks)]
            rows.append((f"`{machine}`", f"`{pruning}`", *cells))
    head = ("machine", "`--pruning`", *(cell for model in THESIS_MODELS for cell in (f"{model}: clocks", "model, ms", "frame, ms")))
    return ruled(head, rows, numbers_from=2)


# Models that every machine can draw; bolt_and_nut exceeds the memory of pixel-square's dividers.
CORPUS = ("bracket", "gear_pair", "knob", "connecting_rod", "crossing_cylinders", "molecule", "basics_csg",
          "old_example002", "old_example011", "mug")
PLACES = {"mug": "tests/docs/models", **{name: "tests/corpus/parts" for name in CORPUS[:3]}}
MEMORIES = ("ambit-ddr4", "simdram-ddr4", "digital-bit-serial-ddr4")
RANKED = (*MACHINES, *MEMORIES)
OWN, IDEAL, SAME = "own host", "ideal host", "one `mc68000`"
# Changes of a machine's host: none, no host, and one processor that is the same for all machines. Memories have none.
HOSTS = {OWN: "", IDEAL: "+host.processor=ideal", SAME: "+host.processor=mc68000+host.count=1"}
PAIRS = [(machine, host) for machine in RANKED for host in HOSTS if machine in MACHINES or host != IDEAL]
SIDE = 256  # pixels; the memories take long to simulate


def ranked_points(figures, model, pairs, options=""):
    """The points of machines with each of HOSTS, by both: the three stand-ins and the corpus, each fitted to its picture."""
    path = model if model in THESIS_MODELS else f"{PLACES.get(model, 'tests/models')}/{model}.csg"
    options += "" if model in THESIS_MODELS else " --view-all"
    names = ",".join(machine + HOSTS[host] for machine, host in pairs)
    points = figures.compare(path, f"{options} --size {SIDE}x{SIDE} --machines {names} --fragments none --sides none")
    found = dict(zip(pairs, points, strict=True))
    found.update({(machine, IDEAL): found[machine, OWN] for machine in MEMORIES if (machine, OWN) in found})
    return found


def ranking(figures):
    """Frames per second of every machine, the geometric mean over thirteen models, and its rank, with each of HOSTS."""
    models = [ranked_points(figures, model, PAIRS) for model in (*THESIS_MODELS, *CORPUS)]
    rates = {pair: [points[pair].hosted_frames_per_second for points in models] for pair in models[0]}
    mean = {pair: math.exp(sum(map(math.log, each)) / len(each)) for pair, each in rates.items()}
    rows = []
    for machine in RANKED:
        cells = []
        for host in HOSTS:
            place = 1 + sum(mean[other, host] > mean[machine, host] for other in RANKED)
            limited = sum(points[machine, host].host_clocks > points[machine, host].interval_clocks for points in models)
            cells += [f"{mean[machine, host]:.3g}", str(place), *([] if host == IDEAL else [str(limited)])]
        rows.append((f"`{machine}`", *cells))
    head = ("machine", *(cell for host in HOSTS
                         for cell in (f"{host}: frames/s", "rank", *([] if host == IDEAL else ["host limits"]))))
    return ruled(head, rows)


def seconds(clocks, each):
    return f"{milliseconds(clocks, each) / 1e3:.3g}"


def work_of(each):
    """Seconds of the host for the model, and for each frame; bold if the host limits the frame rate."""
    frame = seconds(each.host_clocks, each)
    return f"{seconds(each.host_model_clocks, each)} + {f'**{frame}**' if each.host_clocks > each.interval_clocks else frame}"


def work(figures):
    """Host time of every machine that has a host, for each model."""
    rows = []
    for model in (*THESIS_MODELS, *CORPUS):
        points = ranked_points(figures, model, PAIRS)
        rows.append((model, *(work_of(points[machine, OWN]) for machine in MACHINES)))
    return ruled(("model", *(f"`{machine}`" for machine in MACHINES)), rows)


def pays(figures):
    """Host time with one `mc68000`: of `auto`, and of every pruning if all work is repeated for each frame."""
    machines = ("pixel-planes-4", "scan-line", "pixel-square")
    rows = []
    for model in (*THESIS_MODELS, *CORPUS):
        points = ranked_points(figures, model, PAIRS)
        every = ranked_points(figures, model, [(machine, SAME) for machine in machines], " --pruning all")
        cells = []
        for machine in machines:
            auto, full = points[machine, SAME], every[machine, SAME]
            cells += [work_of(auto), seconds(full.host_model_clocks + full.host_clocks, full),
                      f"{100 * (auto.clocks / full.clocks - 1):+.1f} %"]
        rows.append((model, *cells))
    return ruled(("model", *(cell for machine in machines for cell in (f"`{machine}`", "every pruning", "clocks"))), rows)
