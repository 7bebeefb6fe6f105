"""Tables of docs/accuracy.md."""

from figures import PERSPECTIVE, point, ruled

MODELS = ("vehicle", "carburettor", "house")
WIDTHS = (1, 2, 4, 8, 16)
PRUNINGS = (("all prunings", "all"), ("without `space`", "no-space"), ("without `picture`", "no-picture"),
            ("without `separation`", "no-separation"), ("without `halfspaces`", "no-halfspaces"),
            ("without `hidden`", "no-hidden"), ("without `sets`", "no-sets"), ("without `early-out`", "no-early-out"),
            ("without `near`", "no-near"), ("none", "none"))


CURVED_Z_BITS = (20, 18, 16, 14, 13, 12, 10, 8)


def curved(figures):
    """The carburettor without facets, by bits of depth and of colour."""
    rows = []
    for z_bits in CURVED_Z_BITS:
        wide, narrow = (figures.render("carburettor", f"--machine pixel-powers --z-bits {z_bits} --colour-bits {bits}") for bits in (24, 12))
        facets = figures.render("carburettor", f"--z-bits {z_bits}")
        width = {field.name: field.width for field in wide.memory.memory_map}
        root = width["root"]
        rows.append((z_bits, width["sum"], root, f"{root * root + 2 * root}", wide.memory.used_bits, f"{wide.clocks:,}",
                     narrow.memory.used_bits, f"{narrow.clocks:,}", facets.memory.used_bits, f"{facets.clocks:,}"))
    return ruled(("z bits", "sum", "root", "clocks of a root", "bits, colours of 24", "clocks", "bits, colours of 12", "clocks", "bits in facets",
                  "clocks"), rows)


def of_bits(points, bits):
    return point(points, strategy="bits", stack_bits=bits)


STACK_BITS = range(3, 10)


def table_6_1(figures):
    """The thesis's columns follow the order of its section 6.4; the column headings are illegible in the scan."""
    bits = f"{STACK_BITS[0]}..{STACK_BITS[-1]}"
    points = [of_bits(figures.sweep("vehicle", f"{PERSPECTIVE} --strategy bits --stack-bits {bits}"), m) for m in STACK_BITS]
    thesis = (("scan-conversions", ["118"] * 7), ("depth-buffer tests", ["151"] + ["118"] * 6),
              ("in active trees", ["236", "236", "140", "131", "123", "123", "123"]))
    rows = [("scan-conversions of primitives", *(each.rendered for each in points)),
            ("depth-buffer tests", *(each.depth_tests for each in points)),
            ("scan-conversions of primitives in active trees", *(each.classified for each in points)),
            ("bits used, mask included", *(each.classification_bits for each in points)),
            ("clocks", *(f"{each.clocks:,}" for each in points)),
            *((f"*thesis: {name}*", *(f"*{value}*" for value in values)) for name, values in thesis)]
    return ruled(("bits for the stack, m", *STACK_BITS), rows)


def strategies(figures):
    """`parallel` with 80 bits, since the vehicle needs more than the machine has."""
    rows = []
    for model in MODELS:
        points = figures.sweep(model, PERSPECTIVE)
        wide = figures.sweep(model, PERSPECTIVE + " --strategy parallel --memory-bits 80")
        row = [point(points, strategy="stack"), point(points, strategy="list"), *(of_bits(points, bits) for bits in (3, 4, 5)),
               point(points, strategy="products"), point(wide, strategy="parallel")]
        rows.append((f"{model}: clocks", *(f"{each.clocks:,}" for each in row)))
        rows.append((f"{model}: bits used", *(each.classification_bits for each in row)))
    return ruled(("", "stack", "list", "bits 3", "bits 4", "bits 5", "products", "parallel"), rows)


def stored(figures):
    """Memory and clocks of stored depths, with facets and without, with all prunings and with none."""
    rows = []
    for model in MODELS:
        for how, options in ((model, ""), (f"{model}, without prunings", " --pruning none"),
                             (f"{model} on `pixel-powers`, without facets", " --machine pixel-powers")):
            stack, kept = (figures.render(model, f"{PERSPECTIVE}{options} --memory-bits 4096 --strategy {strategy}")
                           for strategy in ("stack", "stored"))
            rows.append((how, kept.memory.classification_bits, kept.memory.used_bits, kept.scan_conversions.rendered,
                         stack.scan_conversions.rendered + stack.scan_conversions.classified, f"{kept.clocks:,}", f"{stack.clocks:,}",
                         f"{100 * (kept.clocks / stack.clocks - 1):+.1f} %".replace("-", "−")))
    return ruled(("", "bits used", "bits in all", "scan-conversions", "of `stack`", "clocks", "of `stack`", ""), rows)


def polygons(figures):
    """Memory and clocks of drawing face by face. The last model is an imported mesh."""
    rows = []
    for name, model in (*((model, model) for model in MODELS), ("molecule", "tests/models/molecule.csg"), ("sphere", "tests/models/sphere.csg"),
                        ("an imported torus", "tests/corpus/import_stl_binary.csg")):
        options = PERSPECTIVE if model in MODELS else ""
        stack, faces = (figures.render(model, f"{options} --strategy {strategy}") for strategy in ("stack", "polygons"))
        rows.append((name, f"{faces.model.halfspaces:,}", f"{stack.clocks:,}", f"{faces.clocks:,}", f"{faces.clocks / stack.clocks:.2f} ×"))
    return ruled(("", "half-spaces", "clocks of `stack`", "of `polygons`", ""), rows)


def widths(figures):
    rows = []
    for model in ("vehicle", "carburettor"):
        for strategy in ("stack", "parallel"):
            stats = [figures.render(model, f"{PERSPECTIVE} --strategy {strategy} --memory-bits 80"
                                           f" --machine pixel-planes-4+alu.bits={width}") for width in WIDTHS]
            rows.append((f"{model}, `{strategy}`", *(f"{each.clocks:,}" for each in stats)))
            rows.append((f"{model}, combining, `{strategy}`", *(each.by_purpose.stack.clocks for each in stats)))
    return ruled(("`alu.bits`", *WIDTHS), rows)


def prunings(figures):
    """Savings in active trees and clocks; `bits` 3 of the house equals its `stack`."""
    names = ",".join(pruning for _, pruning in PRUNINGS)
    points = {model: figures.sweep(model, f"{PERSPECTIVE} --strategy stack,bits --stack-bits 3 --pruning {names}")
              for model in MODELS}
    rows = []
    for title, pruning in PRUNINGS:
        cells = []
        for model in MODELS:
            stack = point(points[model], strategy="stack", pruning=pruning)
            bits = point(points[model], strategy="bits", pruning=pruning)
            cells += [stack.classified, f"{stack.clocks:,}"] + ([f"{bits.clocks:,}"] if model != "house" else [])
        rows.append((title, *cells))
    return ruled(("", "vehicle: in trees", "`stack`", "`bits` 3", "carburettor: in trees", "`stack`", "`bits` 3",
                  "house: in trees", "`stack`"), rows)


def early_out(figures):
    """The saving of early out, in both projections."""
    varied = [(model, "") for model in ("vehicle", "carburettor", "house")]
    varied += [(model, " --strategy bits --stack-bits 3") for model in ("vehicle", "carburettor")]
    varied += [(model, " --colouring field --memory-bits 110") for model in ("vehicle", "carburettor", "house")]
    rows = []
    for model, options in varied:
        cells = []
        for projection in (PERSPECTIVE, " --projection ortho"):
            without = figures.clocks(model, f"{projection}{options} --pruning no-early-out")
            with_it = figures.clocks(model, f"{projection}{options}")
            cells += [f"{without:,}", f"{with_it:,}", f"{100 * (with_it / without - 1):+.1f} %".replace("-", "−")]
        name = {"": "", " --strategy bits --stack-bits 3": ", `bits` 3"}.get(options, ", `--colouring field`")
        rows.append((model + name, *cells))
    return ruled(("clocks", "without, perspective", "with", "", "without, ortho", "with", ""), rows)
