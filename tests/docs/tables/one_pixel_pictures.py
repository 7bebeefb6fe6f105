"""The pictures of docs/lessons.md as SVG: grids of pixels with their numbers, the tree, a ray."""

import html

import by_hand

CELL, EDGE = 26, 24  # size of a pixel, and of the margin with the numbers of rows and columns
SIDE = by_hand.SIDE
INK, PALE, PAPER, OUTLINE = "#1a1a1a", "#9a9a9a", "#ffffff", "#d0006f"
BOX_INK = {"A": "#1f5fae", "B": "#8a5a00", "N": "#b3261e"}
TINTS = {"A": "#cfe2f8", "B": "#fbe6b0", "N": "#f9cdc8", "none": "#ffffff", "out": "#e4e4e4", "x": "#d9c8f0", "y": "#c9e9cf", "z": "#fbe6b0"}


def text(x, y, words, size=12, fill=INK, anchor="middle", weight="normal"):
    return (f'<text x="{x:g}" y="{y:g}" font-size="{size}" fill="{fill}" text-anchor="{anchor}" font-weight="{weight}">'
            f"{html.escape(str(words))}</text>")


def box(x, y, width, height, fill, stroke="#c4c4c4", line=1):
    return f'<rect x="{x:g}" y="{y:g}" width="{width:g}" height="{height:g}" fill="{fill}" stroke="{stroke}" stroke-width="{line:g}"/>'


def line(x0, y0, x1, y1, stroke=INK, width=1.5, dashes=""):
    dashed = f' stroke-dasharray="{dashes}"' if dashes else ""
    return f'<path d="M{x0:.6g} {y0:.6g}L{x1:.6g} {y1:.6g}" stroke="{stroke}" stroke-width="{width:g}" fill="none"{dashed}/>'


def picture(width, height, title, parts):
    return "\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
        'font-family="DejaVu Sans, Verdana, sans-serif" role="img">',
        f"<title>{html.escape(title)}</title>", box(0.5, 0.5, width - 1, height - 1, PAPER), *parts, "</svg>", ""])


def grid(title, cell, legend, followed, over=()):
    """A grid: cell(x, y) returns the number of a pixel, or "", and its background; legend is a list of (colour,
    words)."""
    parts = [text(EDGE + CELL * (n + 0.5), EDGE - 7, n, 10, PALE) for n in range(SIDE)]
    parts += [text(EDGE - 7, EDGE + CELL * (n + 0.5) + 4, n, 10, PALE, "end") for n in range(SIDE)]
    for y in range(SIDE):
        for x in range(SIDE):
            number, fill = cell(x, y)
            parts.append(box(EDGE + CELL * x, EDGE + CELL * y, CELL, CELL, fill))
            if number != "":
                parts.append(text(EDGE + CELL * (x + 0.5), EDGE + CELL * (y + 0.5) + 4, number, 11.5))
    parts += over
    parts += [box(EDGE + CELL * followed[0], EDGE + CELL * followed[1], CELL, CELL, "none", stroke, width)
              for stroke, width in ((PAPER, 6), (OUTLINE, 3))]
    below = EDGE + CELL * SIDE + 8
    for n, (fill, words) in enumerate(legend):
        parts += [box(EDGE, below + 20 * n, 16, 14, fill, "#808080"), text(EDGE + 24, below + 20 * n + 12, words, 12.5, INK, "start")]
    return picture(EDGE + CELL * SIDE + 10, below + 20 * len(legend) + 6, title, parts)


def edges():
    """The boxes' edges as seen by the camera, those of the subtracted box dashed."""
    found = []
    for name in by_hand.BOXES:
        at = [[EDGE + CELL * each for each in by_hand.seen(corner)[:2]] for corner in by_hand.corners(name)]
        for n in range(8):
            found += [line(*at[n], *at[n | 1 << axis], BOX_INK[name], 1.5, "5 3" if name == "N" else "")
                      for axis in range(3) if not n >> axis & 1]
    return found


def final(story, followed):
    after = story.steps[-1].after
    return grid("The picture that is drawn, with the edges of the three boxes", lambda x, y: ("", f"#{after[x, y].colour:06x}"),
                [(TINTS["A"], "A, the slab (blue)"), (TINTS["B"], "B, the wall (yellow)"),
                 (TINTS["N"], "N, the notch, taken away (red, dashed)")], followed, edges())


def facets(story, followed):
    """Z1 of A, and its greatest front plane at each pixel."""
    after, hand = story.step("A render").after, story.hand
    words = {"x": "X = 12, the right side", "y": "Y = 0, the left side", "z": "Z = 4, the top"}

    def cell(x, y):
        now = after[x, y]
        return (now.z1, TINTS["xyz"[hand.facet("A", by_hand.FRONTS, now.z1, x, y).axis]]) if now.enabled else ("", TINTS["none"])

    return grid("Z1 after A has been rendered", cell, [(TINTS[axis], f"greatest: {words[axis]}") for axis in "zyx"], followed)


def classified(story, name, followed, words):
    """Z1 where the surface is nearer than Z2, by the result of classification."""
    tested, masked = story.step(f"{name} test").after, story.step(f"{name} mask").after
    kept = TINTS[name[0]]

    def cell(x, y):
        if masked[x, y].mask:
            return tested[x, y].z1, kept
        return (tested[x, y].z1, TINTS["out"]) if tested[x, y].mask else ("", TINTS["none"])

    return grid(f"Z1 of {name[0]} where it is nearer than Z2", cell, [(kept, words[0]), (TINTS["out"], words[1])], followed)


def kept(story, name, followed):
    """Z2 after a step, by owner."""
    owners = dict.fromkeys(story.step("setup").after, "none")
    for step in story.steps[: story.steps.index(story.step(name)) + 1]:
        if step.name.endswith("mask"):
            owners.update({place: step.name[0] for place, now in step.after.items() if now.mask})
    after = story.step(name).after
    of = sorted(set(owners.values()) - {"none"})
    return grid("Z2, and whose surface it is", lambda x, y: (after[x, y].z2 if owners[x, y] != "none" else "", TINTS[owners[x, y]]),
                [(TINTS[owner], f"{owner}'s surface") for owner in of] + [(TINTS["none"], f"nothing: {story.hand.nothing}")], followed)


def node(x, y, words, fill=PAPER, width=46):
    return [box(x - width / 2, y - 16, width, 32, fill, INK, 1.2), text(x, y + 5, words, 14, weight="bold")]


def tree():
    """The model's tree, next to its positive form."""
    parts = []
    for middle, top, last, words in ((105, "−", "N", "as it is written"), (325, "∩", "¬N", "positive form")):
        places = {"top": (middle, 60), "union": (middle - 40, 120), "last": (middle + 48, 120), "a": (middle - 76, 180), "b": (middle - 4, 180)}
        joins = (("top", "union"), ("top", "last"), ("union", "a"), ("union", "b"))
        parts += [line(*places[above], *places[under]) for above, under in joins]
        parts += [text(middle, 26, words, 13)]
        leaves = (("last", last, TINTS["N"]), ("a", "A", TINTS["A"]), ("b", "B", TINTS["B"]))
        for place, name, fill in (("top", top, PAPER), ("union", "∪", PAPER), *leaves):
            parts += node(*places[place], name, fill)
    return picture(430, 214, "The tree of the model, and its positive form: a difference is an intersection with a complement", parts)


def ray(story, followed):
    """The tracked pixel's ray: intervals between the boxes' fronts and backs, and the remaining solid."""
    hand, (x, y) = story.hand, followed
    left, scale = 60, 350 / 255
    spans = {name: (hand.front(name, x, y), hand.back(name, x, y)) for name in by_hand.BOXES}
    at = left + spans["N"][1] * scale
    parts = [text(left, 22, "eye", 11, PALE), text(left + 255 * scale, 22, hand.nothing, 11, PALE), line(at, 16, at, 208, OUTLINE, 2, "4 3")]
    rows = [*spans.items(), ("left", (spans["N"][1], max(spans["A"][1], spans["B"][1])))]
    for n, (name, (front, back)) in enumerate(rows):
        top = 34 + 44 * n
        words = name if name in spans else "left"
        parts += [text(left - 10, top + 18, words, 14, anchor="end", weight="bold"), line(left, top + 13, left + 255 * scale, top + 13, "#c4c4c4", 1),
                  box(left + front * scale, top, (back - front) * scale, 26, TINTS.get(name, "#c9e9cf"), INK),
                  text(left + front * scale - 4, top + 9, front, 12, anchor="end"), text(left + back * scale + 4, top + 9, back, 12, anchor="start")]
    return picture(430, 216, f"The ray of pixel {x},{y}: depths of the boxes, and what is left of them", parts)


SMALL, SPACE = 7, 22  # size of a pixel of a small grid, and space between grids


def enabled(story, followed):
    """E of all pixels at some instants; 1 is dark."""
    def after(name):
        return {place: now.enabled for place, now in story.step(name).after.items()}

    first, last = {name: story.step(name).first for name in ("A render", "B render")}, {each.name: each.last for each in story.steps}
    fenced = {(x, y): story.hand.covers("A", x, y) for x in range(SIDE) for y in range(SIDE)}
    shown = [(f"i{first['A render'] + 4}", "in A's rectangle", fenced, "A"), (f"i{last['A render']}", "A has a front", after("A render"), "A"),
             (f"i{last['A classify']}", "Z1 is in N", after("A classify"), "A"), (f"i{last['A mask']}", "A's front is left", after("A mask"), "A"),
             (f"i{last['B test']}", "B is nearer", after("B test"), "B"), (f"i{last['B mask']}", "B's front is left", after("B mask"), "B"),
             (f"i{last['N in A classify']}", "N's back is in A", after("N in A classify"), "N"),
             (f"i{last['N in B classify']}", "N's back is in B", after("N in B classify"), "N")]
    parts, pitch = [], SMALL * SIDE + SPACE
    for n, (instruction, words, pixels, owner) in enumerate(shown):
        left, top = SPACE + pitch * (n % 4), 24 + (pitch + 28) * (n // 4)
        parts += [box(left + SMALL * x, top + SMALL * y, SMALL, SMALL, BOX_INK[owner] if on else PAPER, "#dcdcdc", 0.6)
                  for (x, y), on in sorted(pixels.items())]
        parts += [box(left + SMALL * followed[0], top + SMALL * followed[1], SMALL, SMALL, "none", OUTLINE, 2),
                  text(left, top - 8, f"after {instruction}", 12, anchor="start", weight="bold"),
                  text(left, top + SMALL * SIDE + 16, f"{words}: {sum(pixels.values())}", 11.5, anchor="start")]
    return picture(SPACE + 4 * pitch, 2 * (pitch + 28), "Enabled pixels at eight instants", parts)


PURPOSES = {"setup": "#9a9a9a", "render": "#5b8fd0", "classify": "#e0a030", "stack": "#444444", "merge": "#4aa564", "shade": "#a678c8"}


def stream(story):
    """The instructions in order, one clock per step to the right, one row per surface."""
    rows = [("", "setup", "setup"), ("A", "A render", "A shade"), ("B", "B render", "B shade"), ("N, in A", "N render", "N in A shade"),
            ("in B", "N in B test", "N in B shade")]
    left, scale, high, parts = 66, 620 / sum(each.clocks for each in story.stream), 34, []
    clock = 0
    for n, (name, begin, end) in enumerate(rows):
        top, first, last = 14 + high * n, story.step(begin).first, story.step(end).last
        parts += [text(left - 8, top + 16, name or "setup", 12.5, anchor="end", weight="bold")]
        for each in story.stream[first : last + 1]:
            parts.append(box(left + clock * scale, top, each.clocks * scale, 22, PURPOSES[each.purpose], PAPER, 0.6))
            clock += each.clocks
        parts.append(text(left + clock * scale + 4, top + 16, f"i{last}, clock {clock:,}", 11, anchor="start"))
    below = 24 + high * len(rows)
    for n, (purpose, fill) in enumerate(PURPOSES.items()):
        parts += [box(left + 112 * n, below, 16, 14, fill, "#808080"), text(left + 112 * n + 22, below + 12, purpose, 12, anchor="start")]
    return picture(left + 620 + 126, below + 26, "The stream of instructions, clock by clock: each box is one", parts)
