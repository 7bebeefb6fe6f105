"""Pages of --report contain the text of `csgsim explain` for selected pixels, and the command that explains any other
pixel.

Usage: explain_test.py CSGSIM SOURCE_FOLDER"""

import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

CARBURETTOR = ["tests/models/carburettor.csg", "--camera", "220,-255,135,2,0,5", "--size", "48x48"]
THESIS = ["tests/models/thesis_fig_2_3.csg", "--size", "48x40"]
RUNS = [CARBURETTOR,
        [*CARBURETTOR, "--machine", "pixel-square", "--check"],
        [*THESIS, "--machine", "pixel-planes-5", "--colour-bits", "13", "--projection", "perspective", "--level", "cycle"],
        [*THESIS, "--max-wrong-pixels", "40", "--stats", "-"]]


def drawings_of(csgsim, words, page):
    """The data of the drawings on the page that the command writes, and the command's output."""
    done = subprocess.run([csgsim, *words, "--report", page], check=words[0] != "diff", text=True, capture_output=True)
    html = pathlib.Path(page).read_text(encoding="utf-8")
    found = re.findall(r'<script type="application/json" id="drawing-\d">(.*?)</script>', html)
    return [json.loads(one) for one in found], done.stdout


def text_of(story):
    return "".join(part if isinstance(part, str) else part[0] for part in story["parts"])


def explained(csgsim, drawing, x, y):
    """The explanation of a pixel by the page's command."""
    program, *words = shlex.split(drawing["explain"])
    assert program == "csgsim", drawing["explain"]
    return subprocess.run([csgsim, *words, "--pixel", f"{x},{y}"], check=True, text=True, capture_output=True).stdout


def check_run(csgsim, words, page):
    (drawing,), _ = drawings_of(csgsim, ["render", *words], page)
    assert len({story["primitive"] for story in drawing["stories"]}) == len(drawing["stories"]) > 2
    for story in drawing["stories"]:
        text = explained(csgsim, drawing, story["x"], story["y"])
        assert text_of(story) == text, f"{words}: {text_of(story)}\nfor {text}"
    assert explained(csgsim, drawing, 1, 2).startswith("pixel 1,2 shows")


def check_two(csgsim, words, page):
    (a, b), told = drawings_of(csgsim, ["diff", *words], page)
    assert told.endswith("\nA  " + text_of(a["stories"][0]) + "\nB  " + text_of(b["stories"][0])), told
    assert a["explain"] != b["explain"]
    for drawing in (a, b):
        for story in drawing["stories"][:4]:
            shown = text_of(story).split("\n")
            assert shown[:3] == explained(csgsim, drawing, story["x"], story["y"]).split("\n")[:3], shown


def main():
    csgsim = os.path.abspath(sys.argv[1])
    os.chdir(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        page = os.path.join(folder, "page.html")
        for words in RUNS:
            check_run(csgsim, words, page)
        check_two(csgsim, [*THESIS, "--machine-b", "pixel-planes-5", "--strategy-b", "list", "--set", "ambient.intensity=0.5"], page)
        program = os.path.join(folder, "a.csgt")
        subprocess.run([csgsim, "compile", *THESIS, "--camera", "20,-30,25,0,0,0", "-o", program], check=True, stdout=subprocess.DEVNULL)
        check_two(csgsim, [program, *THESIS, "--pruning-b", "none", "--machine", "pixel-planes-4"], page)


if __name__ == "__main__":
    main()
