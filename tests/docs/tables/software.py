"""Tables of docs/software.md: tables 4.9 and 4.10 of the thesis, whose own numbers are in italics, and software
compared with machines."""

import math
import tomllib

from figures import PERSPECTIVE, THESIS_MODELS, point, row, ruled
from runs import ROOT

TRAVERSALS = ("standard", "early-out", "positional", "status", "bit-sequential", "bit-parallel", "bit-parallel-status")
COHERENCES = ("all-points", "first-point", "one-list", "list-structure", "joined-lists", "csg-buffer")
OF_THESIS = COHERENCES[:4]
WHOLE = ("interval-lists", "weave", "interval-arithmetic")
PROCESSORS = ("mc68000", "i486dx2")
MACHINES = ("pixel-planes-4", "scan-line", "pixel-square", "pixel-planes-5", "pixel-powers", "multi-processor")

# Evaluations in the order of OF_THESIS.
TABLE_4_9 = {
    "carburettor": {"met": 219_451, "sequences": 19_227, "different": 218, "evaluations": (383_150, 163_719, 17_685, 393)},
    "vehicle": {"met": 231_536, "sequences": 21_706, "different": 705, "evaluations": (316_579, 85_144, 19_385, 1_647)},
    "house": {"met": 261_904, "sequences": 11_579, "different": 107, "evaluations": (276_579, 14_325, 1_322, 141)},
}
# Seconds in the order of OF_THESIS; a question mark where the scan does not show to which cell a number belongs.
TABLE_4_10 = {
    "carburettor": {"standard": ("774", "325", "99", "86"), "early-out": ("722", "305", "96", "86"), "positional": ("348", "202", "54", "52"),
                    "status": ("349", "218", "56", "53"), "bit-parallel": ("311", "147", "47", "52"),
                    "bit-parallel-status": ("243", "104", "43", "51")},
    "vehicle": {"standard": ("2853", "1103", "294", "109"), "early-out": ("2654", "1030", "278", "108"),
                "positional": ("343", "146", "65", "64?"), "status": ("399", "122", "60", "64?"),
                "bit-parallel": ("1885", "501", "140", "75?"), "bit-parallel-status": ("352?", "43?", "70", "62?")},
    "house": {"standard": ("1383", "171", "60", "55"), "early-out": ("1292", "163", "59", "55"), "positional": ("241", "37", "24", "27"),
              "status": ("353", "40", "26", "28"), "bit-parallel": ("1256?", "79", "29", "28"),
              "bit-parallel-status": ("300?", "29", "24", "27")},
}
PRIMITIVES = {"carburettor": 22, "vehicle": 118, "house": 91}
OPERATORS = {"unions": {"carburettor": 11, "vehicle": 97, "house": 87}, "differences": {"carburettor": 10, "vehicle": 17, "house": 3},
             "intersections": {"carburettor": 0, "vehicle": 3, "house": 0}}


def of(points, method, coherence="none", **wanted):
    return point(points, method=method, coherence=coherence, **wanted)


def whole(number):
    return f"{number:,}"


def italic(text):
    return f"*{text}*"


def three_digits(value):
    """The value with three digits, or all digits before the point if more."""
    if value == 0:
        return "0"
    digits = max(0, 2 - math.floor(math.log10(value)))
    return f"{value:,.{digits}f}"


def near(model):
    return f"{model}, near"


def beside(figures, rows, seen=lambda model: model):
    """Ours and the thesis's values, model by model; a row is a name, a function of a model's points for ours, and one
    of the model for the thesis's. `seen` names the view."""
    head = [""]
    for model in THESIS_MODELS:
        head += [model, italic("thesis")]
    lines = []
    for name, ours, thesis in rows:
        cells = []
        for model in THESIS_MODELS:
            cells += [ours(figures.classify(seen(model))), italic(thesis(model)) if thesis else ""]
        lines.append((name, *cells))
    return ruled(head, lines)


def evaluations(coherence):
    place = OF_THESIS.index(coherence)
    return (lambda points: of(points, "standard", coherence).evaluations), (lambda model: TABLE_4_9[model]["evaluations"][place])


def table_4_9(figures):
    first = lambda key: lambda points: whole(points[0][key])  # noqa: E731
    thesis = lambda key: lambda model: whole(TABLE_4_9[model][key])  # noqa: E731
    rows = [("primitives", first("primitives"), lambda model: PRIMITIVES[model]),
            ("rays", first("rays"), lambda model: "262,144"),
            ("rays with points", first("met_rays"), thesis("met")),
            ("rays that hit the solid", first("hit_rays"), None),
            ("sequences", first("sequences"), thesis("sequences")),
            ("different sequences", first("different_sequences"), None),
            ("combinations of primitives", first("combinations"), thesis("different"))]
    for coherence in OF_THESIS:
        ours, theirs = evaluations(coherence)
        rows.append((f"evaluations, {coherence}", lambda points, get=ours: whole(get(points)), lambda model, get=theirs: whole(get(model))))
    rows.append(("evaluations, joined-lists", lambda points: whole(of(points, "standard", "joined-lists").evaluations), None))
    head, rule, primitives, *others = beside(figures, rows).splitlines()
    return "\n".join([head, rule, primitives, *operators(figures), *others])


def operators(figures):
    """Lines of table 4.9 with operators: ours counted by the compiler."""
    for name, thesis in OPERATORS.items():
        cells = []
        for model in THESIS_MODELS:
            cells += [figures.render(model, PERSPECTIVE).model[name], italic(thesis[model])]
        yield row(name, *cells)


def share(part, all_of):
    return f"{part / all_of:.2f}" if part / all_of >= 0.1 else f"{part / all_of:.2g}"


def per_ray(figures, seen=lambda model: model):
    rows = [("sequences", lambda points: share(points[0].sequences, points[0].met_rays),
             lambda model: share(TABLE_4_9[model]["sequences"], TABLE_4_9[model]["met"]))]
    for coherence in OF_THESIS:
        ours, theirs = evaluations(coherence)
        rows.append((f"evaluations, {coherence}", lambda points, get=ours: share(get(points), points[0].met_rays),
                     lambda model, get=theirs: share(get(model), TABLE_4_9[model]["met"])))
    return beside(figures, rows, seen)


def per_ray_near(figures):
    """Table 4.9 from cameras whose rays hit the model as often as those of the thesis."""
    met = ("% of rays that have points", lambda points: f"{100 * points[0].met_rays / points[0].rays:.1f}",
           lambda model: f"{100 * TABLE_4_9[model]['met'] / 262_144:.1f}")
    head, rule, *others = per_ray(figures, near).splitlines()
    return "\n".join([head, rule, beside(figures, [met], near).splitlines()[2], *others])


def seconds_near(figures):
    """The thesis's cells of table 4.10, from those cameras."""
    lines = [row("mc68000, s", *(cell for coherence in OF_THESIS for cell in (coherence, italic("thesis")))), "|---" + "|--:" * 8 + "|"]
    for model in THESIS_MODELS:
        for method, theirs in TABLE_4_10[model].items():
            cells = []
            for coherence, thesis in zip(OF_THESIS, theirs):
                cells += [three_digits(of(figures.classify(near(model)), method, coherence).seconds.mc68000.classification), italic(thesis)]
            lines.append(row(f"{model}, {method}", *cells))
    return "\n".join(lines)


def early_out(figures):
    """The saving of early out, with the operands of unions in the given and in reverse order."""
    rows = []
    for shape in ("balanced", "reversed"):
        cells = []
        for model in THESIS_MODELS:
            points = figures.classify(model, "--methods standard,early-out --coherences all-points --shapes balanced,reversed", "mc68000")
            taken = [of(points, method, "all-points", shape=shape).seconds.mc68000.classification for method in ("early-out", "standard")]
            cells.append(f"{100 - 100 * taken[0] / taken[1]:.0f}")
        rows.append((f"saved, %: {shape}", *cells))
    thesis = [[float(TABLE_4_10[model][method][0]) for method in ("early-out", "standard")] for model in THESIS_MODELS]
    rows.append((italic("thesis"), *(italic(f"{100 - 100 * each[0] / each[1]:.0f}") for each in thesis)))
    return ruled(["", *THESIS_MODELS], rows)


CLOSED = " --methods standard,positional,status --coherences all-points --processors mc68000 --shapes balanced,written --no-plots --progress none -o closed"


def closed(figures):
    """The vehicle unchanged, and closed, in a low tree and in the original tree: ms per ray for all points. The last
    row divides ours by the thesis's."""
    methods = ("standard", "positional", "status")
    commands = figures.shown("docs/reproduction.md", "sed -E").replace("classify closed.csg", "classify $MODEL")
    rows = []
    for name, file in (("open", "tests/models/terrain_vehicle.csg"), ("closed", "closed.csg")):
        points = figures.runs.run(f"ln -s $PWD/tests $OUT/tests; cd $OUT; MODEL={file}; {commands}{CLOSED}").json("closed/classify.json").points
        for shape in ("balanced", "written"):
            own = [of(points, method, "all-points", shape=shape) for method in methods]
            rows.append((f"{name}, {shape}", own[0].tree_levels, f"{own[0].evaluations / own[0].met_rays:.2f}",
                         *(three_digits(each.seconds.mc68000.classification / each.met_rays * 1e3) for each in own)))
    met = TABLE_4_9["vehicle"]["met"]
    thesis = [TABLE_4_9["vehicle"]["evaluations"][0] / met, *(float(TABLE_4_10["vehicle"][method][0]) / met * 1e3 for method in methods)]
    rows.append((italic("thesis"), "", *(italic(f"{each:.2f}") for each in thesis)))
    ours = [own[0].evaluations / own[0].met_rays, *(each.seconds.mc68000.classification / each.met_rays * 1e3 for each in own)]
    rows.append(("closed, written: times the thesis's", "", *(f"{mine / theirs:.2f}" for mine, theirs in zip(ours, thesis))))
    return ruled(["ms a ray with points", "levels", "evaluations a ray", *methods], rows)


def table_4_10(figures):
    head = ["mc68000, s"]
    for coherence in COHERENCES:
        head += [coherence] + ([italic("thesis")] if coherence in OF_THESIS else [])
    lines = [row(*head), "|---" + "|--:" * (len(head) - 1) + "|"]
    for model in THESIS_MODELS:
        points = figures.classify(model)
        lines.append(row(f"**{model}**", *[""] * (len(head) - 1)))
        for method in (*TRAVERSALS, *WHOLE):
            cells = []
            for coherence in COHERENCES:
                if method in WHOLE:
                    one = of(points, method) if coherence == "all-points" else None
                else:
                    one = of(points, method, coherence)
                cells.append("–" if one and one.reason else three_digits(one.seconds.mc68000.classification) if one else "")
                if coherence in OF_THESIS:
                    thesis = TABLE_4_10[model].get(method)
                    cells.append(italic(thesis[OF_THESIS.index(coherence)]) if thesis else "")
            lines.append(row(method, *cells))
    return "\n".join(lines)


def visits(figures):
    """Time of an evaluation and of a node of the tree, for the standard traversal."""
    rows = []
    for model in THESIS_MODELS:
        standard = of(figures.classify(model), "standard", "all-points")
        nodes = 2 * PRIMITIVES[model] - 1
        thesis = TABLE_4_9[model]["evaluations"]
        seconds = [float(each) for each in TABLE_4_10[model]["standard"]]
        all_points, first_point = seconds[0] / thesis[0], seconds[1] / thesis[1]
        rows.append((model, nodes, f"{standard.seconds.mc68000.classification / standard.evaluations * 1e3:.2f}",
                     italic(f"{all_points * 1e3:.2f}"), italic(f"{first_point * 1e3:.2f}"),
                     f"{standard.seconds.mc68000.classification / standard.node_visits * 1e6:.1f}",
                     italic(f"{all_points / nodes * 1e6:.1f}"), italic(f"{first_point / nodes * 1e6:.1f}")))
    return ruled(("", "nodes", "ms an evaluation", "*thesis, all points*", "*first point*", "µs a node", "*thesis, all points*",
                  "*first point*"), rows)


def joined(figures):
    rows = []
    for name, key in (("evaluations", "evaluations"), ("elements made", "list_elements"), ("elements or links looked at", "list_steps"),
                      ("words", "words")):
        cells = []
        for model in THESIS_MODELS:
            points = figures.classify(model)
            cells += [whole(of(points, "status", coherence)[key]) for coherence in ("list-structure", "joined-lists")]
        rows.append((name, *cells))
    head = [""]
    for model in THESIS_MODELS:
        head += [f"{model}, list-structure", "joined-lists"]
    return ruled(head, rows)


SHAPES = ("written", "left-deep", "balanced")
SHAPED = ("standard", "positional", "status", "bit-parallel", "bit-parallel-status")


def shapes(figures):
    rows = []
    for model in THESIS_MODELS:
        points = figures.classify(model, f"--methods {','.join(SHAPED)} --coherences all-points --shapes {','.join(SHAPES)}", "mc68000")
        for shape in SHAPES:
            own = [of(points, method, "all-points", shape=shape) for method in SHAPED]
            rows.append((f"{model}, {shape}", own[0].tree_levels,
                         *("refused" if each.reason else three_digits(each.seconds.mc68000.classification) for each in own),
                         "refused" if own[3].reason else whole(own[3].words)))
    return ruled(("mc68000, s", "levels", *SHAPED, "words, bit-parallel"), rows)


def prunings(figures):
    rows = []
    for model in THESIS_MODELS:
        points = figures.classify(model, "--methods standard,status --coherences all-points,list-structure --reduced none,cells,inside",
                                  "mc68000")
        for reduced in ("none", "cells", "inside"):
            cells = []
            for method in ("standard", "status"):
                one = of(points, method, "all-points", reduced=reduced)
                cells += [whole(one.node_visits), whole(one.pruned_nodes), three_digits(one.seconds.mc68000.classification)]
            kept = of(points, "status", "list-structure", reduced=reduced)
            rows.append((f"{model}, {reduced}", *cells, three_digits(kept.seconds.mc68000.classification)))
    return ruled(("", "standard, all points: visits", "pruned nodes", "s", "status, all points: visits", "pruned nodes", "s",
                  "status, list-structure: s"), rows)


def file_of(processor):
    return tomllib.loads((ROOT / "hw/processors" / f"{processor}.toml").read_text(encoding="utf-8"))


def priced(processor, operations, program="factor"):
    """Seconds of operations, by the processor's file; a program has a compiler factor."""
    file = file_of(processor)
    clocks = sum(count * file["price"][name]["value"] for name, count in operations.items())
    return clocks * file["compiler"][program]["value"] / 1000 / file["clock"]["frequency"]["value"]


def classifying(processor, one, program):
    """Seconds of classification; its traversal has a separate compiler factor."""
    traversal = priced(processor, one.traversal_operations)
    return priced(processor, one.operations) - traversal + priced(processor, one.traversal_operations, program)


def parts(figures):
    """Seconds of a picture by phase, for status/list-structure."""
    rows = []
    for processor in PROCESSORS:
        for model in THESIS_MODELS:
            one = of(figures.classify(model), "status", "list-structure")
            seconds = [*(priced(processor, one[key]) for key in ("ray_operations", "sort_operations")), classifying(processor, one, "status")]
            rows.append((f"{processor}, {model}", three_digits(sum(seconds)), *(f"{100 * each / sum(seconds):.0f} %" for each in seconds)))
    return ruled(("", "picture, s", "ray intersection", "sorting", "classification"), rows)


def best(points, processor):
    """The fastest method for the whole picture."""
    return min((each for each in points if not each.reason), key=lambda each: each.seconds[processor].all)


def name_of(one):
    return one.method if one.coherence == "none" else f"{one.method}/{one.coherence}"


WITH = " --with " + ",".join(f"{processor}:status/list-structure" for processor in PROCESSORS)


def compared(figures, model):
    return figures.compare(model, PERSPECTIVE + WITH)


def hardware(figures):
    """Frames per second of the machines, and their ratio to the fastest picture of each processor."""
    rows = []
    software = {(model, processor): best(figures.classify(model), processor) for model in THESIS_MODELS for processor in PROCESSORS}
    for machine in MACHINES:
        cells = []
        for model in THESIS_MODELS:
            seconds = point(compared(figures, model), machine=machine, width=512, fragments=0.0).simulated_seconds
            cells += [three_digits(seconds * 1e3)]
            cells += [three_digits(software[model, processor].seconds[processor].all / seconds) for processor in PROCESSORS]
        rows.append((f"`{machine}`", *cells))
    for processor in PROCESSORS:
        cells = []
        for model in THESIS_MODELS:
            one = software[model, processor]
            cells += [three_digits(one.seconds[processor].all * 1e3), name_of(one), ""]
        rows.append((f"`{processor}`, best", *cells))
    head = [""]
    for model in THESIS_MODELS:
        head += [f"{model}, ms", *PROCESSORS]
    return ruled(head, rows)


def line(points, machine, across):
    """A machine's line in logarithms through its last two points: size and seconds of the last, the exponent between
    them."""
    own = [each for each in points if each.machine == machine]
    if across == "halfspaces":
        sizes = sorted((each.halfspaces, each.simulated_seconds) for each in own if each.width == 512 and each.fragments > 0)
    else:
        sizes = sorted((each.width * each.height, each.simulated_seconds) for each in own if each.fragments == 0)
    (size_before, before), (size, last) = sizes[-2:]
    return size, last, math.log(last / before) / math.log(size / size_before)


MOST_HALFSPACES, LEAST_PIXELS = 1e9, 64


def meeting(of_machine, of_software, across):
    """The size from which software is at least as fast, by the lines."""
    size, seconds, exponent = of_machine
    _, other, other_exponent = of_software
    if other < seconds:
        return "is faster"
    if (exponent > other_exponent) != (across == "halfspaces") or exponent == other_exponent:
        return "never"
    at = size * (other / seconds) ** (1 / (exponent - other_exponent))
    if across == "halfspaces":
        return f"{float(f'{at:.1e}'):,.0f}" if at < MOST_HALFSPACES else "never"
    return f"{math.sqrt(at):.0f}²" if at >= LEAST_PIXELS else "never"


def crossings(figures):
    """Exponents, and the size from which software is at least as fast."""
    rows = []
    for model in ("carburettor", "vehicle"):
        points = compared(figures, model)
        software = {(processor, across): line(points, f"{processor}:status/list-structure", across)
                    for processor in PROCESSORS for across in ("halfspaces", "pixels")}
        for processor in PROCESSORS:
            rows.append((f"{model}: `{processor}`", f"{software[processor, 'halfspaces'][2]:.2f}", "", "",
                         f"{software[processor, 'pixels'][2]:.2f}", "", ""))
        for machine in (name for name in MACHINES if name != "pixel-powers"):
            cells = []
            for across in ("halfspaces", "pixels"):
                own = line(points, machine, across)
                cells += [f"{own[2]:.2f}", *(meeting(own, software[processor, across], across) for processor in PROCESSORS)]
            rows.append((f"{model}: `{machine}`", *cells))
    return ruled(("", "half-spaces: exponent", "mc68000", "i486dx2", "pixels: exponent", "mc68000", "i486dx2"), rows)


WITH_FRAME_BUFFER = ("pixel-square", "pixel-planes-5")


def dollars(processor, bits):
    """Price of ordinary memory at that time, in dollars."""
    return f"{bits / 8 / 2**20 * file_of(processor)['memory']['price']['value']:,.0f}"


def memory(figures):
    """Bits, transistors and dollars for a picture of 512 x 512 of the vehicle."""
    points = compared(figures, "vehicle")
    rows = []
    for machine in MACHINES:
        one = point(points, machine=machine, width=512, fragments=0.0)
        beside = 24 * one.width * one.height if machine in WITH_FRAME_BUFFER else 0
        transistors = one.machine_transistors + beside if one.machine_transistors else 0
        rows.append((f"`{machine}`", whole(one.machine_memory_bits), whole(transistors) if transistors else "–",
                     dollars(PROCESSORS[0], transistors) if transistors else "–"))
    for processor in PROCESSORS:
        bits = point(points, machine=f"{processor}:status/list-structure", width=512, fragments=0.0).machine_memory_bits
        rows.append((f"`{processor}`, status/list-structure", whole(bits), whole(bits), dollars(processor, bits)))
    return ruled(("", "bits of memory", "transistors", "dollars"), rows)


TIMES = 5  # number of measurements; the least is reported


def wall(figures, model):
    """The least wall time of the functional engine, in seconds."""
    command = f"csgsim render {figures.model(model)}{PERSPECTIVE} --progress none --stats $OUT/$run.json -o $OUT/a.png"
    done = figures.runs.run(f"for run in {' '.join(str(n) for n in range(TIMES))}; do {command}; done")
    return min(done.json(f"{run}.json").wall_seconds for run in range(TIMES))


def least(runs, columns):
    """Seconds of intersecting rays, and of the classification of each column; the least over all runs that contain
    it."""
    rays = min(each.wall_seconds_rays for points in runs for each in points if each.wall_seconds_rays > 0)
    return [rays, *(min(each.wall_seconds_classification for points in runs for each in points
                        if (each.method, each.coherence) == column) for column in columns)]


def measured(figures):
    """Software on this computer and the functional engine, in ms."""
    rows = []
    for model in THESIS_MODELS:
        command = (f"csgsim classify {figures.model(model)}{PERSPECTIVE} --methods standard,status,weave,interval-arithmetic"
                   " --coherences all-points,list-structure --processors this-computer --no-plots --progress none -o $OUT")
        done = figures.runs.run("\n".join(f"{command}/{run}" for run in range(TIMES)))
        rays, *seconds = least([done.json(f"{run}/classify.json").points for run in range(TIMES)],
                               (("standard", "all-points"), ("status", "all-points"), ("status", "list-structure"), ("weave", "none"),
                                ("interval-arithmetic", "none")))
        rows.append((model, *(three_digits(each * 1e3) for each in (rays, *seconds, rays + seconds[2], wall(figures, model)))))
    return ruled(("ms", "intersection and sorting", "standard, all points", "status, all points", "status, list-structure", "weave",
                  "interval-arithmetic, total", "the picture by status, list-structure", "functional engine, `pixel-planes-4`"), rows)


GROWN = {"cubes": (17, 167, 1667, 16667), "drilled": (4, 42, 417, 4167)}


def grown(figures, name):
    """The points of runs for a grid's sizes, as the page shows them; slow ones run once."""
    shown = figures.shown("docs/software.md", "grid()").split("csgsim classify")
    rest = shown[1].split("cubes_17.csg")[1]
    command = rest + " --no-plots --progress none -o "
    commands = []
    for n in GROWN[name]:
        quick = command.replace("standard,status,interval-arithmetic", "status")
        commands += [f"csgsim classify {name}_{n}.csg{command if run == 0 else quick}{name}_{n}_{run}" for run in range(TIMES)]
    done = figures.runs.run("\n".join(["cd $OUT", shown[0], *commands]))
    return [[done.json(f"{name}_{n}_{run}/classify.json").points for run in range(TIMES)] for n in GROWN[name]]


def growth(figures):
    """Milliseconds against half-spaces, and the exponent from the smallest to the largest."""
    rows = []
    for name in GROWN:
        columns = []
        for runs in grown(figures, name):
            columns.append((runs[0][0].halfspaces, runs[0][0].primitives,
                            least(runs, (("standard", "all-points"), ("status", "all-points"), ("status", "list-structure"),
                                         ("interval-arithmetic", "none")))))
        for halfspaces, primitives, seconds in columns:
            rows.append((name, whole(halfspaces), whole(primitives), *(three_digits(each * 1e3) for each in seconds)))
        (before, _, first), (last, _, second) = columns[0], columns[-1]
        rows.append((f"{name}: exponent", "", "", *(f"{math.log(b / a) / math.log(last / before):.2f}" for a, b in zip(first, second))))
    return ruled(("ms", "half-spaces", "primitives", "intersection and sorting", "standard, all points", "status, all points",
                  "status, list-structure", "interval-arithmetic, total"), rows)
