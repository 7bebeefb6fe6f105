"""Rounding of a plane, and the planes of a seam that opens, for docs/lessons.md."""

import re

import by_hand
from figures import ruled
from runs import Record

from .one_pixel import minus
from .one_pixel_story import Differs, story

MODEL = "tests/docs/models/two_passes.csg"
CAMERA = "--camera 30,-24,36,3.2,8.2,3"
VIEW = f"--size 16x16 {CAMERA}"
X, Y = 7, 7
FACE = ("N", by_hand.Face(1, True))  # the face Y = 8 in docs/lessons.md


def rounded(figures):
    """A plane of One pixel before rounding, from boxes and camera, and after."""
    hand = story(figures).hand
    plane, at = hand.planes[FACE], lambda x, y: hand.exact(*FACE, x, y) * 2**by_hand.FRACTION_BITS
    exact = (at(1, 0) - at(0, 0), at(0, 1) - at(0, 0), at(0, 0))
    rows = [(name, minus(f"{real:.3f}"), minus(whole), minus(f"{whole - real:+.3f}"))
            for name, real, whole in zip("ABC", exact, (plane.a, plane.b, plane.c))]
    rows += [(f"F at {x},{y}", f"{at(x, y):.3f}", plane.sum_at(x, y), minus(f"{plane.sum_at(x, y) - at(x, y):+.3f}")) for x, y in ((7, 5), (8, 8))]
    return ruled(("", "exact", "rounded", "error"), rows, numbers_from=1)


def shown(figures, options="", pixel=(X, Y), model=MODEL):
    """The primitive that a pixel shows, and its depth."""
    printed = figures.runs.run(f"csgsim explain {model} {VIEW} {options} --pixel {pixel[0]},{pixel[1]} 2>/dev/null").printed
    return re.search(r"shows (p\d)", printed)[1], int(re.search(r"depth +(\d+) steps", printed)[1])


def planes(figures, options):
    """The planes where the second pass ends and the first begins on the pixel's ray: the least back of p2, and the
    greatest front of p1."""
    listing = figures.runs.run(f"csgsim compile {MODEL} {VIEW} {options} -o $OUT/seam.csgt >&2; csgsim disasm $OUT/seam.csgt").printed
    found = {}
    for box, names in (("p1", "linear_lt"), ("p2", "keep_min|load_linear")):
        texts = re.findall(rf"^  ((?:{names}) .*?) +; render {box} ", listing, re.MULTILINE)
        found[box] = [by_hand.expression(text) for text in texts]
    return min(found["p2"], key=lambda plane: plane.at(X, Y)), max(found["p1"], key=lambda plane: plane.at(X, Y))


def gap(figures):
    ends, begins = planes(figures, "")
    one, other = planes(figures, "--snap")
    if one != other:
        raise Differs(f"with --snap the seam has two planes: {one}, {other}")
    if shown(figures) != ("p2", ends.at(X, Y)) or not ends.at(X, Y) < begins.at(X, Y):
        raise Differs(f"pixel {X},{Y} shows {shown(figures)}, and not the second pass's end at {ends.at(X, Y)}")
    rows = [(name, *(minus(f"{each:,}") for each in (plane.a, plane.b, plane.c, plane.sum_at(X, Y), plane.at(X, Y))))
            for name, plane in (("the second pass ends", ends), ("the first begins", begins), ("both, with `--snap`", one))]
    return ruled(("", "A", "B", "C", f"F = {X}A + {Y}B + C", "z"), rows, numbers_from=1)


def seam(figures):
    ends, begins = (plane.at(X, Y) for plane in planes(figures, ""))
    return Record(ends=ends, begins=begins, thick=begins - ends, x=X, y=Y)


SAME_VIEW = '"${VIEW[@]}"'  # the page's VIEW, in bash and in zsh
REACHING = "sed '/0, 0, 6/s/6/5/; s/4, 8/5, 8/' $MODEL > reach.csg; "


def explain(options):
    return f"csgsim explain $MODEL {SAME_VIEW}{options} --pixel {X},{Y} | head -2"


def answers(figures):
    """Each answer, with the command that shows it, which is run: its output must contain the answer."""
    floor = shown(figures, "--snap")[1]
    rows = [(f"{floor - seam(figures).ends:,} steps: the floor is at {floor:,}", explain(" --snap"), f"depth     {floor} steps"),
            (f"No: {seam(figures).thick} steps of a million are far less than one of 256, and both planes round to the same depth", explain(" --z-bits 8"), "shows p1"),
            ("No: the planes differ in the model, and more bits separate them better", explain(" --fraction-bits 16"), "shows p2"),
            ("No wall: where the passes overlap, it does not matter which plane is nearer",
             REACHING + explain("").replace("$MODEL", "reach.csg"), "shows p")]
    made = []
    for n, (words, command, wanted) in enumerate(rows, 1):
        printed = figures.runs.run(f"MODEL={MODEL}; VIEW=({VIEW}); R=$PWD; cd $OUT; ln -s $R/tests tests; {command} 2>/dev/null").printed
        if wanted not in printed:
            raise Differs(f"exercise {n}: '{wanted}' is not in what '{command}' prints:\n{printed}")
        if n == 4 and f"depth     {floor} steps" not in printed:
            raise Differs(f"exercise {n}: not the floor:\n{printed}")
        made.append(f"{n}. {words}: `{command}`")
    return "\n".join(made)
