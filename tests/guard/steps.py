#!/usr/bin/env python3
"""Checks the cost of a step of work (hw/base/work.h) against a band, for one kind of input.

    steps.py CSGSIM_STEPS KIND     KIND "all" prints the costs of all kinds

The default limit of 8,000 million steps should take about 20 s for every kind of input: 8 instructions per step at
3,200 million instructions per second. The band is a factor of 10 wide. Instructions are counted by callgrind, minus
those of an empty model, so the results do not depend on a clock. Exit code 77 if valgrind is not installed.
"""
import math
import os
import random
import shutil
import subprocess
import sys
import tempfile

LEAST, MOST = 2.5, 25.0  # instructions per step

FACETS = "$fn=0,$fa=12,$fs=2"
DRAWING = "linear_extrude(height=1){import(file=\"drawing.%s\",$fn=0,$fa=12,$fs=2);}"


def points(count, size, seed):
    draw = random.Random(seed)
    return [(draw.randrange(size), draw.randrange(size)) for _ in range(count)]


def vector(rows):
    return "[" + ",".join("[" + ",".join(map(str, row)) + "]" for row in rows) + "]"


def svg(paths):
    lines = "".join('<path d="M%sz"/>' % " ".join(f"{x} {y}" for x, y in path) for path in paths)
    return f'<svg xmlns="http://www.w3.org/2000/svg">{lines}</svg>'


def dxf(circles):
    groups = ["0", "SECTION", "2", "ENTITIES"]
    for x, y, radius in circles:
        groups += ["0", "CIRCLE", "8", "0", "10", str(x), "20", str(y), "40", str(radius)]
    return "\n".join(groups + ["0", "ENDSEC", "0", "EOF"]) + "\n"


def moved(x, y, z, what):
    return f"multmatrix([[1,0,0,{x}],[0,1,0,{y}],[0,0,1,{z}],[0,0,0,1]]){{{what}}}"


def spheres(count, seed):
    draw = random.Random(seed)
    return "".join(moved(draw.random() * 20, draw.random() * 20, draw.random() * 20, f"sphere($fn=12,$fa=12,$fs=2,r=3);")
                   for _ in range(count))


def circles(count, spread, seed):
    draw = random.Random(seed)
    return "".join(moved(draw.random() * spread, draw.random() * spread, 0, f"circle($fn=24,$fa=12,$fs=2,r=3);")
                   for _ in range(count))


def surface(size, seed):
    draw = random.Random(seed)
    return "\n".join(" ".join(f"{draw.random() * 9:.3f}" for _ in range(size)) for _ in range(size)) + "\n"


JUG = """tolerance {tolerance}
circle = curve closed degree 3 points (8 0) (5.66 5.66) (0 8) (-5.66 5.66) (-8 0) (-5.66 -5.66) (0 -8) (5.66 -5.66)
up = curve degree 3 points (0 0 0) (0 0 10) (5 5 20) (0 0 30)
turn = curve points (0) ({turn})
Jug = sweep contour circle trajectory up rotation turn
Object = Jug
"""

# Models and other files by name, for each kind. Each takes at least about 1e7 instructions.
KINDS = {
    "a path that crosses itself": {"m.csg": DRAWING % "svg", "drawing.svg": svg([points(200, 1000, 1)])},
    "a path that runs along itself": {"m.csg": DRAWING % "svg", "drawing.svg": svg([points(9000, 1000, 2) * 2 + [(1, 2)]])},
    "a path of steps": {"m.csg": DRAWING % "svg",
                        "drawing.svg": svg([[(x, y) for i in range(400) for x, y in
                                             ((i % 11 * 7, i * 3), (i * 5 % 13 * 9, i * 3))]])},
    "many paths that overlap": {"m.csg": DRAWING % "svg", "drawing.svg": svg([points(12, 60, i) for i in range(60)])},
    "circles apart": {"m.csg": DRAWING % "dxf", "drawing.dxf": dxf([(i % 40 * 3, i // 40 * 3, 1) for i in range(800)])},
    "circles that overlap": {"m.csg": DRAWING % "dxf",
                             "drawing.dxf": dxf([(x / 10, y / 10, 2) for x, y in points(200, 300, 3)])},
    "circles in circles": {"m.csg": DRAWING % "dxf", "drawing.dxf": dxf([(0, 0, 1 + i / 50) for i in range(200)])},
    "a union of circles": {"m.csg": "linear_extrude(height=1){" + circles(300, 60, 4) + "}"},
    "a difference of circles": {"m.csg": "linear_extrude(height=1){difference(){square(60);" + circles(300, 60, 4) + "}}"},
    "the same circle many times": {"m.csg": "linear_extrude(height=1){" + circles(1, 1, 4) * 3000 + "}"},
    "circles along each other": {"m.csg": "linear_extrude(height=1){" + "".join(
        moved(i % 20, i // 20, 0, "square([3,3]);") for i in range(1000)) + "}"},
    "an offset": {"m.csg": f"linear_extrude(height=1){{offset(r=2,{FACETS}){{" + circles(200, 150, 5) + "}}"},
    "a flat sum": {"m.csg": "linear_extrude(height=1){minkowski(){" + circles(6, 20, 6) + "circle($fn=16,$fa=12,$fs=2,r=1);}}"},
    "a polygon": {"m.csg": "linear_extrude(height=1){polygon(points=" + vector(
        [(round(math.cos(i / 3000 * math.tau) * (50 + i % 2 * 9), 4), round(math.sin(i / 3000 * math.tau) * (50 + i % 2 * 9), 4))
         for i in range(3000)]) + ");}"},
    "a twisted star": {"m.csg": "linear_extrude(height=20,twist=90,slices=10,$fn=0,$fa=12,$fs=2){polygon(points=" + vector(
        [(round(math.cos(i / 60 * math.tau) * (5 + i % 2 * 4), 4), round(math.sin(i / 60 * math.tau) * (5 + i % 2 * 4), 4))
         for i in range(60)]) + ");}"},
    "a shadow": {"m.csg": "linear_extrude(height=1){projection(cut=false){" + spheres(200, 7) + "}}"},
    "a shadow of a difference": {"m.csg": "linear_extrude(height=1){projection(cut=false){difference(){cube([20,20,20]);" +
                                          spheres(6, 8) + "}}}"},
    "a cut": {"m.csg": "linear_extrude(height=1){projection(cut=true){" + moved(0, 0, -10, spheres(400, 9)) + "}}"},
    "a hull": {"m.csg": "hull(){sphere($fn=60,$fa=12,$fs=2,r=30);}"},
    "a sum": {"m.csg": "minkowski(){difference(){cube([20,20,20]);" + spheres(2, 11) + "}cube([1,1,1]);}"},
    "a surface": {"m.csg": 'surface(file="heights.dat",center=false,invert=false);', "heights.dat": surface(12, 12)},
    "a sweep": {"m.jan": JUG.format(tolerance=0.4, turn=0)},
    "a sweep that turns": {"m.jan": JUG.format(tolerance=1.5, turn=200)},
}


def instructions_and_steps(program, files, folder):
    for name, text in files.items():
        with open(os.path.join(folder, name), "w", encoding="ascii") as file:
            file.write(text)
    model = next(name for name in files if name.startswith("m."))
    calls = os.path.join(folder, "calls")
    done = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={calls}", program, model], cwd=folder,
                          capture_output=True, text=True)
    if done.returncode != 0:
        sys.stderr.write(done.stderr[-2000:])
        sys.exit(77 if "nrecognised instruction" in done.stderr or "unhandled instruction" in done.stderr else 1)
    with open(calls, encoding="ascii") as file:
        totals = next(line for line in file if line.startswith(("summary:", "totals:")))
    return int(totals.split()[1]), int(done.stdout)


def measure(program, kind):
    with tempfile.TemporaryDirectory() as folder:
        idle, _ = instructions_and_steps(program, {"m.csg": "cube(1);"}, folder)
    with tempfile.TemporaryDirectory() as folder:
        instructions, steps = instructions_and_steps(program, KINDS[kind], folder)
    ratio = (instructions - idle) / max(steps, 1)
    print(f"{kind}: {instructions - idle:,} instructions, {steps:,} steps, {ratio:.1f} per step", flush=True)
    return LEAST <= ratio <= MOST


def main():
    if not shutil.which("valgrind"):
        print("valgrind is not installed; run ./setup.sh test")
        sys.exit(77)
    program = os.path.realpath(sys.argv[1])
    kinds = list(KINDS) if sys.argv[2] == "all" else [sys.argv[2]]
    is_good = [measure(program, kind) for kind in kinds]
    if not all(is_good):
        print(f"a step should take {LEAST} to {MOST} instructions; charge more or fewer steps in the code that does the work")
        sys.exit(1)


main()
