#!/usr/bin/env python3
"""Draws a prism as convex pieces and as a formula of its sides' half-planes on Pixel-planes 4.

    tests/bench/prism_formula.py build/release/csgsim

The formula is that of D. Dobkin, L. Guibas, J. Hershberger and J. Snoeyink, "An efficient algorithm for finding the CSG
representation of a simple polygon" (SIGGRAPH 1988): each side's half-plane once. A chain of sides, with the first and
last extended to rays, is divided at a corner of its convex hull; the two halves are intersected at a convex corner and
united at a reflex one. Here a half-plane is a box whose other sides are outside the picture.
"""
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile

HEIGHT = 3
FAR = 200  # half the side of a half-plane's box


def area(outline):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(outline, outline[1:] + outline[:1])) / 2


def letter(character, folder):
    """The outlines of OpenSCAD's text(), the outer one first and counter-clockwise, holes clockwise."""
    (folder / "letter.scad").write_text(f'text("{character}", size = 20);')
    subprocess.run(["openscad", "-q", "-o", folder / "letter.svg", folder / "letter.scad"], check=True)
    path = re.search(r' d="([^"]*)"', (folder / "letter.svg").read_text(), re.S).group(1)
    outlines = []
    for part in path.split("z"):
        numbers = [float(one) for one in re.findall(r"-?[\d.]+(?:e-?\d+)?", part)]
        corners = [[x, -y] for x, y in zip(numbers[::2], numbers[1::2])]
        corners = [corner for i, corner in enumerate(corners) if corner != corners[i - 1]]
        if len(corners) > 2:
            outlines.append(corners)
    outlines.sort(key=lambda one: -abs(area(one)))
    return [one if (area(one) > 0) == (i == 0) else one[::-1] for i, one in enumerate(outlines)]


def ring(radii_and_turns):
    return [[[round(r * math.cos(a), 4), round(r * math.sin(a), 4)] for r, a in radii_and_turns]]


def gear(teeth):
    profile = ((16, -0.32), (20, -0.15), (20, 0.15), (16, 0.32))
    return ring([(r, 2 * math.pi * (i + turn) / teeth) for i in range(teeth) for r, turn in profile])


def star(points):
    return ring([(9 if i % 2 else 20, math.pi * i / points) for i in range(2 * points)])


def direction(a, b):
    length = math.dist(a, b)
    return (b[0] - a[0]) / length, (b[1] - a[1]) / length


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def cross(a, b, c):
    return (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])


def chain(corners, first, last):
    """The formula of sides first .. last; side i runs from corner i to the next."""
    def at(i):
        return corners[i % len(corners)]

    if first == last:
        return "side", at(first), at(first + 1)
    start = direction(at(first + 1), at(first))  # directions of the rays
    end = direction(at(last), at(last + 1))
    towards = [(-start[0] - end[0], -start[1] - end[1])]
    for ray in (start, end):
        towards += [(-ray[1], ray[0]), (ray[1], -ray[0])]
    best = None
    for other in towards[1:]:
        for share in range(9):
            look = tuple(o * share / 8 + t * (1 - share / 8) for o, t in zip(other, towards[0]))
            if math.hypot(*look) < 1e-9 or dot(look, start) > 1e-12 or dot(look, end) > 1e-12:
                continue
            corner = max(range(first + 1, last + 1), key=lambda i: dot(look, at(i)))
            balance = abs(2 * corner - first - last - 1)
            if best is None or balance < best[0]:
                best = balance, corner
    corner = best[1]
    kind = "intersection" if cross(at(corner - 1), at(corner), at(corner + 1)) > 0 else "union"
    return kind, chain(corners, first, corner - 1), chain(corners, corner, last)


def negated(formula):
    if formula[0] == "side":
        return "side", formula[2], formula[1]
    return ("union" if formula[0] == "intersection" else "intersection", *map(negated, formula[1:]))


def formula_of(outline):
    is_hole = area(outline) < 0
    corners = outline[::-1] if is_hole else outline
    start = corners.index(min(corners))
    corners = corners[start:] + corners[:start]
    middle = corners.index(max(corners))
    whole = "intersection", chain(corners, 0, middle - 1), chain(corners, middle, len(corners) - 1)
    return negated(whole) if is_hole else whole


def flattened(formula):
    """Merges nested operators of one kind."""
    if formula[0] == "side":
        return formula
    children = []
    for child in map(flattened, formula[1:]):
        children += child[1:] if child[0] == formula[0] else [child]
    return (formula[0], *children)


def holds(formula, point):
    if formula[0] == "side":
        return cross(formula[1], formula[2], point) > 0
    return (all if formula[0] == "intersection" else any)(holds(child, point) for child in formula[1:])


def is_inside(outlines, x, y):
    inside = False
    for outline in outlines:
        for a, b in zip(outline, outline[1:] + outline[:1]):
            if (a[1] > y) != (b[1] > y) and x < (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]) + a[0]:
                inside = not inside
    return inside


def check(formula, outlines, low, high):
    random.seed(1)
    for _ in range(5000):
        point = [random.uniform(low[i] - 2, high[i] + 2) for i in range(2)]
        if holds(formula, point) != is_inside(outlines, *point):
            sys.exit(f"the formula is wrong at {point}")


def text_of(formula):
    if formula[0] != "side":
        return formula[0] + "() {\n" + "".join(map(text_of, formula[1:])) + "}\n"
    a, b = formula[1:]
    x, y = direction(a, b)
    quad = [(a[0] - FAR * x, a[1] - FAR * y), (b[0] + FAR * x, b[1] + FAR * y)]
    quad += [(px - FAR * y, py + FAR * x) for px, py in reversed(quad)]
    points = [[px, py, z] for z in (-FAR, FAR) for px, py in quad]
    faces = [[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
    return f"polyhedron(points = {points}, faces = {faces}, convexity = 1);\n"


def box_text(low, size):
    shift = ", ".join(f"[{', '.join('1' if i == k else '0' for k in range(3))}, {low[i]}]" for i in range(3))
    return f"multmatrix([{shift}, [0, 0, 0, 1]]) {{ cube(size = {size}, center = false); }}\n"


def models(outlines):
    """The prism in both forms."""
    corners = sum(outlines, [])
    low = [min(corner[i] for corner in corners) for i in range(2)]
    high = [max(corner[i] for corner in corners) for i in range(2)]
    formula = flattened(("intersection", *map(formula_of, outlines)))
    check(formula, outlines, low, high)
    around = box_text([*low, 0], [high[0] - low[0], high[1] - low[1], HEIGHT])
    by_formula = "intersection() {\n" + around + "".join(map(text_of, formula[1:])) + "}\n"
    paths, start = [], 0
    for outline in outlines:
        paths.append(list(range(start, start + len(outline))))
        start += len(outline)
    pieces = (f"linear_extrude(height = {HEIGHT}, center = false, convexity = 1, scale = [1, 1], $fn = 0, $fa = 12, "
              f"$fs = 2) {{ polygon(points = {corners}, paths = {paths}, convexity = 1); }}\n")
    return pieces, by_formula


def drawn(csgsim, model, folder):
    """Clocks, memory bits and half-spaces, and the picture."""
    (folder / "model.csg").write_text(model)
    subprocess.run([csgsim, "render", folder / "model.csg", "--memory-bits", "160", "--strategy", "auto", "--camera",
                    "30,-60,70,5,5,0", "--view-all", "-o", folder / "model.ppm", "--stats", folder / "stats.json"],
                   check=True, stdout=subprocess.DEVNULL)
    stats = json.loads((folder / "stats.json").read_text())
    figures = stats["clocks"], stats["memory"]["used_bits"], stats["model"]["halfspaces"]
    return figures, (folder / "model.ppm").read_bytes()


def main():
    csgsim = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        shapes = {"L": [[[0, 0], [20, 0], [20, 6], [6, 6], [6, 20], [0, 20]]]}
        shapes |= {f"star of {n}": star(n) for n in (5, 12)} | {f"gear of {n}": gear(n) for n in (12, 32)}
        shapes |= {f"letter {one}": letter(one, folder) for one in "EWSGRB"}
        print("| shape | sides | clocks: pieces | formula | cut out: pieces | formula | half-spaces | bits |")
        print("|---|---|---|---|---|---|---|---|")
        for shape, outlines in shapes.items():
            figures = []
            for cut in (False, True):
                pictures = []
                for model in models(outlines):
                    plate = box_text([-25, -25, 1], [60, 60, 1.5])
                    used, picture = drawn(csgsim, f"difference() {{\n{plate}{model}}}\n" if cut else model, folder)
                    figures.append(used)
                    pictures.append(picture)
                if pictures[0] != pictures[1]:
                    sys.exit(f"the pictures of {shape} differ")
            clocks = " | ".join(f"{one[0]:,}" for one in figures)
            sides = sum(map(len, outlines))
            print(f"| {shape} | {sides} | {clocks} | {figures[0][2]}, {figures[1][2]} | "
                  f"{figures[0][1]}, {figures[3][1]} |")


main()
