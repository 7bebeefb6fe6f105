"""The stream of a small model, the state of one pixel after each part of it, and its cost, for docs/lessons.md."""

import re

import by_hand
from figures import ruled
from runs import Record

from . import one_pixel_pictures as art
from .one_pixel_story import BOXES, LATENCY, MODEL, OR_LEVELS, VIEW, X, Y, Differs, is_in, last_keep, story


def pictures(figures):
    """A folder with the pictures of the page."""
    told_by, place = story(figures), (X, Y)
    drawn = {
        "tree": art.tree(), "picture": art.final(told_by, place), "facets": art.facets(told_by, place),
        "ray": art.ray(told_by, place),
        "first": art.kept(told_by, "A shade", place),
        "wall": art.classified(told_by, "B", place, ("out of N: kept", "in N: taken away")),
        "notch_in_a": art.classified(told_by, "N in A", place, ("in A: kept", "not in A")),
        "notch_in_b": art.classified(told_by, "N in B", place, ("in B: kept", "not in B")),
        "depth": art.kept(told_by, "N in B shade", place),
        "enabled": art.enabled(told_by, place), "stream": art.stream(told_by),
    }
    folder = figures.runs.run("true # the pictures of docs/lessons.md").folder
    for name, drawing in drawn.items():
        (folder / f"{name}.svg").write_text(drawing, encoding="utf-8")
    return folder


def minus(number):
    return str(number).replace("-", "−")


def planes(figures):
    """The planes of all faces, each evaluated at the pixel."""
    hand, faces = story(figures).hand, {}
    for (box, face), plane in sorted(hand.planes.items(), key=lambda each: (each[0][1].axis, each[0][1].place(each[0][0]))):
        faces.setdefault((is_in(box, face), plane), []).append((box, face))
    rows = []
    for (name, plane), of in faces.items():
        fronts, backs = (", ".join(box for box, face in of if face.is_forward() == is_front) for is_front in (True, False))
        parts = [each for each in (plane.a * X, plane.b * Y, plane.c) if each]
        worked = minus(" + ".join(map(str, parts)) + f" = {plane.sum_at(X, Y)}").replace("+ −", "− ")
        rows.append((name, plane.a, plane.b, plane.c, worked, 2**plane.shift, minus(plane.at(X, Y)), fronts, backs))
    return ruled(("plane", "A", "B", "C", f"A · {X} + B · {Y} + C", "divisor", "z", "front of", "back of"),
                 [tuple(map(minus, row)) for row in rows])


def extents(figures):
    """Front and back of each box at the pixel."""
    hand = story(figures).hand
    rows = []
    for box in BOXES:
        fronts, backs = ([hand.depth(box, face, X, Y) for face in faces] for faces in (by_hand.FRONTS, by_hand.BACKS))
        rows.append((box, minus(", ".join(map(str, fronts))), max(fronts), ", ".join(map(str, backs)), min(backs)))
    return ruled(("box", "front planes", "front (maximum)", "back planes", "back (minimum)"), rows)


HOLDS = {"Z2": "depth of the nearest surface drawn before", "Z1": "depth of the surface being processed",
         "colour": "colour of that surface: 8 bits each of red, green, blue",
         "mask": "1 while the surface in Z1 may be visible here"}


def memory(figures):
    fields = re.findall(r"^\.field (\w+) \[(\d+)(?:\+:(\d+))?\]", story(figures).listing, re.MULTILINE)
    rows = [(name, f"{first} to {int(first) + int(bits) - 1}" if bits else first, bits or 1, HOLDS[name]) for name, first, bits in fields]
    return ruled(("field", "bits of memory", "width", "content"), rows, numbers_from=9)


WHAT = {
    "setup": "Z2 := 255 (nothing), colour := background",
    "render": "edge tests; maximum of the front planes into Z1; are the back planes behind it?",
    "N render": "edge tests; minimum of the back planes into Z1; Z1 := 255 where a front plane is not before it",
    "test": "Z1 < Z2? The mask stores the result", "N in B test": "enable all pixels; Z1 < Z2? The mask stores the result",
    "skip": "if no pixel is enabled, skip the rest of {box}", "classify": "is Z1 in {other}? E holds the result",
    "mask": "where it is in N, mask := 0; E := mask", "N mask": "mask := E", "merge": "Z2 := Z1",
    "shade": "for each visible plane: where F = Z1, write its colour",
}


def what(name):
    box, *_, kind = name.split() if name != "setup" else ("", "setup")
    words = WHAT.get(name) or WHAT.get(f"{box} {kind}") or WHAT[kind]
    return words.format(box=box, other=name.split()[2] if " in " in name else "N")


def stream(figures, *names):
    """The steps with that prefix, and the state of the pixel after each."""
    rows = []
    for step in story(figures).steps:
        if step.name.startswith(" ".join(names)) and not (len(names) == 1 and " in " in step.name):
            now = step.after[X, Y]
            rows.append((f"i{step.first} to i{step.last}" if step.first < step.last else f"i{step.first}", what(step.name), step.clocks,
                         int(now.enabled), now.z1, now.z2, int(now.mask), f"`#{now.colour:06x}`"))
    return ruled(("instructions", "action", "clocks", "E", "Z1", "Z2", "mask", "colour"), rows, numbers_from=2)


HOLD = {"le": ("F ≤ Z1", lambda value, z1: value <= z1), "gt": ("F > Z1", lambda value, z1: value > z1)}


def edge(text):
    """The condition of an edge test, and its value at the pixel."""
    of = re.fullmatch(r"edge_not_negative ((-?)([xy])(?: ([+-]) (\d+))?) \(w\d+\)", text)
    value = (-1 if of[2] else 1) * {"x": X, "y": Y}[of[3]] + int((of[4] or "+") + (of[5] or "0"))
    return f"{of[1]} ≥ 0", value


def answers_to(stream_part, names, z1):
    """For each instruction: its condition or effect, F, and whether the condition holds; then Z1 and E."""
    enabled = True
    for each in stream_part:
        name, plane = each.text.split()[0], by_hand.expression(each.text)
        asked, value, holds = "", "", True
        if name == "edge_not_negative":
            asked, value = edge(each.text)
            holds = value >= 0
        elif name == "enable_all":
            asked = "enable all pixels"
        elif name == "set_constant":
            asked, z1 = "Z1 := 0", 0
        elif name == "keep_max":
            value = plane.at(X, Y)
            asked, holds = f"{names[plane]}: F > Z1?", value > z1
            z1 = max(z1, value)
        else:
            value = plane.at(X, Y)
            words, test = HOLD[name.removeprefix("linear_")]
            asked, holds = f"{names[plane]}: {words}?", test(value, z1)
        enabled = enabled and (holds or name == "keep_max")
        yield asked, value, holds, z1, int(enabled)


def one_by_one(figures, *named):
    """The instructions of a step, each with the pixel's result; csgsim debug must agree after each."""
    told_by = story(figures)
    step, before = told_by.step(" ".join(named)), told_by.steps[told_by.steps.index(told_by.step(" ".join(named))) - 1]
    names = {plane: is_in(box, face) for (box, face), plane in told_by.hand.planes.items()}
    part = told_by.stream[step.first : step.last + 1]
    stops = told_by.watched(figures.runs, range(step.first, step.last + 1))
    rows = []
    numbers, answered = range(step.first, step.last + 1), answers_to(part, names, before.after[X, Y].z1)
    for n, each, answer, machine in zip(numbers, part, answered, stops, strict=True):
        asked, value, holds, z1, enabled = answer
        if (z1, enabled) != (machine[X, Y]["Z1"], machine[X, Y]["E"]):
            raise Differs(f"i{n}: Z1 and E are {z1}, {enabled} by hand, {machine[X, Y]} by csgsim debug")
        rows.append((f"i{n}", minus(asked), minus(value), ("yes" if holds else "no") if value != "" else "", each.clocks, z1, enabled))
    return ruled(("", "test or action", "F", "result", "clocks", "Z1 after", "E after"), rows, numbers_from=4)


def serial(figures):
    """Comparison of a plane with Z1 bit by bit, starting with the lowest."""
    told_by = story(figures)
    text = told_by.stream[last_keep(told_by)].text
    plane, width = by_hand.expression(text), int(re.search(r"\(w(\d+)", text)[1])
    bits = [plane.sum_at(X, Y) >> n & 1 for n in range(width)]
    meets = ["–"] * plane.shift + ["Z1"] * 8 + ["sign"] * (width - plane.shift - 8)
    rows = [("bit of F", *bits), ("compared with", *meets)]
    return ruled(("clock", *range(1, width + 1)), rows)


WHY = {
    "setup": "one clock per bit written: 8 of Z2, 24 of the colour; 1 to enable all pixels",
    "render": "one clock per bit of F; front planes are streamed twice, to compare and to write",
    "classify": "one clock per bit of F; also the tests whether any pixel is enabled",
    "stack": "one clock per bit; 8 to set Z1 to 255",
    "merge": "two clocks per bit to compare Z1 with Z2, because one port reads both; one per bit to copy",
    "shade": "all visible planes except the last are streamed again; 24 bits for each colour",
    "latency": "8 tree levels, once, until the last bit has arrived",
}


def bill(figures):
    stats, rows = story(figures).stats, []
    for purpose, of in stats.by_purpose.items():
        rows.append((f"`{purpose}`", of.instructions or "", of.clocks, WHY[purpose]))
    added = sum(row[2] for row in rows)
    clearing = stats.account.parts.controller.clearing
    waited = "the first words travel over the link; some later words arrive late"
    rows += [("clear", "", clearing, "memory is cleared, one bit per clock"), ("waiting", "", stats.clocks - added - clearing, waited),
             ("**all**", len(story(figures).stream), f"{stats.clocks:,}", "")]
    return ruled(("purpose", "instructions", "clocks", "why"), rows, numbers_from=9)


MACHINES = {
    "pixel-planes-4": ("bits", "the machine above"),
    "pixel-powers": ("bits", "has trees for squares, which boxes do not need; more memory to clear"),
    "scan-line": ("bits", "line by line: a line receives the instructions that touch it, and words of F pass from cell to cell"),
    "pixel-square": ("stack", "divides the model itself into squares of 16 × 16; this picture is one square"),
    "pixel-planes-5": ("bits", "graphics processors divide the model and send squares of 128 × 128 over a ring to four renderers"),
    "multi-processor": ("stack", "16 processors of 16-bit words share the pixels, and each divides its part of the picture"),
}


PAGES = dict.fromkeys(("pixel-planes-4", "pixel-planes-5", "pixel-powers"), "pixel-planes")  # shared pages


def machines(figures):
    rows, drawn = [], set()
    for name, (strategy, words) in MACHINES.items():
        run = figures.runs.run(f"csgsim render {MODEL} {VIEW} --z-bits 8 --strategy {strategy} --machine {name} --curves facets --progress none "
                               "-o $OUT/step.png --stats $OUT/stats.json")
        stats = run.json("stats.json")
        drawn.add((run.folder / "step.png").read_bytes())
        rows.append((f"[`{name}`](machines/{PAGES.get(name, name)}.md)", f"`{strategy}`", f"{stats.clocks:,}",
                     f"{stats.clocks / stats.machine.clock_hz * 1e6:,.1f}", words))
    if len(drawn) != 1:
        raise Differs("machines draw different pictures")
    return ruled(("machine", "strategy", "clocks", "µs", "difference"), rows, numbers_from=9)


def followed(figures):
    """Numbers in the page's sentences about the pixel and the stream."""
    told_by = story(figures)
    hand, keep = told_by.hand, last_keep(told_by)
    top, lines = hand.planes["A", by_hand.Face(2, True)], hand.rectangles["A"]
    step = {each.name.replace(" ", "_"): each for each in told_by.steps}
    return Record(
        x=X, y=Y, side=by_hand.SIDE, nothing=hand.nothing, near=by_hand.NEAR, far=by_hand.FAR,
        front=Record({box: hand.front(box, X, Y) for box in BOXES}), back=Record({box: hand.back(box, X, Y) for box in BOXES}),
        top=hand.depth("A", by_hand.Face(2, True), X, Y), keep=keep, keep_clocks=told_by.stream[keep].clocks, skip=step["A_skip"].clocks,
        clocks=told_by.stats.clocks, shade=told_by.stats.by_purpose.shade.clocks, render=told_by.stats.by_purpose.render.clocks,
        owners=Record({box: sum(each.mask for each in step[f"{box}_mask"].after.values()) for box in "AB"}),
        rows=[top.sum_at(0, lines[3]), top.sum_at(0, lines[1])], width=told_by.stream[keep].clocks // 2,
        test=step["A_test"].clocks - 1, levels=LATENCY, or_levels=OR_LEVELS, farthest=2**hand.z_bits - 3,
        behind=hand.depth("N", by_hand.Face(1, True), X, Y),
        skipped=told_by.stats.instructions.skipped,
        met=sum(each.enabled for each in step["A_render"].after.values()))
