#!/usr/bin/env python3
"""Solves the three tasks of docs/view.md in the page of csgsim view, in a headless Chromium, and compares the results
with the JSON of the commands in docs/view.md.

Usage: tasks_test.py CSGSIM SOURCE_FOLDER. Exit code 77 without Chromium."""

import json
import pathlib
import re
import sys
import tempfile

SOURCE = pathlib.Path(sys.argv[2]).resolve()
sys.path.insert(0, str(SOURCE / "tests/report"))

import browser  # noqa: E402
from server import Server  # noqa: E402
from viewed import viewed  # noqa: E402

BRACKET = "tests/corpus/parts/bracket.csg"
CARBURETTOR = ("tests/models/carburettor.csg", "--camera", "220,-255,135,2,0,5")
TREES = ("tests/models/thesis_fig_2_3.csg", "--size", "8x8", "--z-bits", "8", "--fraction-bits", "0")


def points_of(seen, study, *words):
    """The points written by a study."""
    with tempfile.TemporaryDirectory() as folder:
        seen.run(study, *words, "-o", folder)
        return json.loads((pathlib.Path(folder) / f"{study}.json").read_text())["points"]


def check_counts(seen, point, what):
    rows = seen.counts()
    for name, key in (("clocks until drawn", "clocks"), ("clocks from one frame to the next", "interval_clocks"), ("pixel operations", "pixel_operations")):
        if key in point:
            seen.check(rows[name] == f"{point[key]:,}", f"{what}: {name} {rows[name]}, {point[key]:,} from the command")


def what_would_a_machine_have_made_of_this_part(seen):
    stats = json.loads(seen.run("render", BRACKET, "--advice", "--stats", "-", "--progress", "none"))
    check_counts(seen, stats | {"pixel_operations": stats["pixel_operations"]["total"]}, "the bracket")
    seen.check(seen.text("bound") == stats["bound_by"]["sentence"], "bottleneck: " + seen.text("bound"))
    seen.click("#advise")
    seen.settled()
    advice = seen.evaluate("[...document.querySelectorAll('#advice strong')].map(each => each.textContent)")
    seen.check(advice == [knob["option"] for knob in stats["knobs"]] and advice, f"advice: {advice}")
    for knob, told in zip(stats["knobs"], seen.evaluate("[...document.querySelectorAll('#advice li')].map(each => each.textContent)")):
        seen.check(told == f"{knob['option']}: {knob['worth']}", f"stated saving: {told}")
    dearest = max(stats["by_primitive"], key=lambda each: each["clocks"])
    seen.check(dearest["name"].split("@")[0] in seen.evaluate("document.getElementById('tree').textContent"), "the most expensive primitive is in the tree")
    seen.set("curves", "facets")  # like compare
    for point in points_of(seen, "compare", BRACKET, "--fragments", "none", "--sides", "none"):
        seen.set("machine", point["machine"])
        seen.settled()
        check_counts(seen, point, point["machine"])
        for name, key in (("frames per second", "frames_per_second"), ("frames per second with the host", "hosted_frames_per_second")):
            rate = float(seen.counts()[name])
            seen.check(abs(rate / point[key] - 1) < 1e-3, f"{point['machine']}: {rate} {name}, {point[key]} from the command")


def streams_of(seen, lanes, width):
    """Reads the numbers of `width` bits that lanes carry, lowest bit first, clock by clock: of each lane, the first
    that begins in the window."""
    seen.evaluate("document.getElementById('lanes').focus()")
    begin, end = (int(each.replace(",", "")) for each in re.search(r"of ([\d,]+) to ([\d,]+):", seen.text("lanes-told")).groups())
    while not seen.text("lanes-told").startswith(f"Clock {begin:,} "):
        seen.page.press("ArrowLeft")
    bits = {lane: [] for lane in lanes}
    for _ in range(begin, end):
        told = dict(re.findall(r"pixel_5_3 (tree_\w+) (\w+)", seen.text("lanes-told")))
        for lane in lanes:
            # The previous number may still be in progress.
            if lane in told and (bits[lane] or told[lane + "_bit"] == "0") and len(bits[lane]) < width:
                seen.check(int(told[lane + "_bit"]) == len(bits[lane]), f"{lane}: bits arrive in order")
                bits[lane].append(int(told[lane]))
        seen.page.press("ArrowRight")
    return {lane: sum(bit << place for place, bit in enumerate(each)) - (each[-1] << width) for lane, each in bits.items()}


def how_do_the_trees_form_it(seen):
    number = 8
    seen.set("instant", str(number))
    seen.settled()
    text = seen.evaluate("document.querySelector('#listing [aria-current=true]').textContent")
    a, b, c = (int(each.replace(" ", "")) for each in re.search(r"(-?\d+)\*x ([+-] \d+)\*y ([+-] \d+)", text).groups())
    lanes = {"tree_x_0": c, "tree_x_1": 4 * a + c, "tree_x_2": 4 * a + c, "tree_x_3": 5 * a + c, "tree_y_3": 5 * a + 3 * b + c}
    seen.set("wires-pixel", "5,3")
    seen.set("window", f"i{number}:i{number + 1}")
    seen.set("probes", " ".join("tree." + lane[5:].replace("_", ":") for lane in lanes))
    seen.after("shownLanes", lambda: seen.click("#probing button[type=submit]"))
    read = streams_of(seen, lanes, int(re.search(r"\(w(\d+)", text).group(1)))
    seen.check(read == lanes, f"each level streams its partial sum: {read}, {lanes} by A, B and C of {text}")
    seen.after("savedWaves", lambda: seen.click("#save-wave"))
    probes = [word for lane in lanes for word in ("--probe", "tree." + lane[5:].replace("_", ":"))]
    seen.check(seen.evaluate("window.savedWave") == seen.run("wave", *TREES, "--window", "i8:i9", "--pixel", "5,3", *probes, "-o", "-"), "the wave equals that of the command")


def what_do_width_and_memory_change(seen):
    widths = [f"pixel-planes-4+alu.bits={bits}" for bits in (2, 4, 8)]
    for point in points_of(seen, "compare", *CARBURETTOR, "--fragments", "none", "--sides", "none", "--machines", ",".join(widths)):
        seen.set("machine", point["machine"])
        seen.settled()
        check_counts(seen, point, point["machine"])
    seen.set("machine", "")
    for point in points_of(seen, "sweep", *CARBURETTOR):
        if point["reason"] or point["strategy"] == "auto" or point["z_bits"] != 20:
            continue
        seen.set("strategy", "" if point["strategy"] == "stack" else point["strategy"], "input")
        seen.set("stack-bits", str(point["stack_bits"]) if point["stack_bits"] else "")
        seen.settled()
        check_counts(seen, point, f"{point['strategy']} {point['stack_bits']}")
        seen.check(seen.counts()["memory bits per pixel"].startswith(f"{point['used_bits']} of "), f"{point['strategy']}: memory bits")


def which_instruction_made_this_pixel_wrong(seen):
    seen.set("z-bits", "8")
    seen.settled()
    seen.set("pixel", "344,389")
    seen.set("why-not", "p2")
    seen.click("#why button")
    seen.until("!document.getElementById('story').hidden && document.getElementById('story').textContent.includes('why not')")
    words = (BRACKET, "--z-bits", "8", "--pixel", "344,389", "--why-not", "p2")
    seen.check(seen.text("story") == seen.run("explain", *words), "the story equals that of the command")
    told = json.loads(seen.run("explain", *words, "--json", "-"))
    seen.check(len(told["events"]) == seen.evaluate("document.querySelectorAll('#events button').length"), "each event is shown")
    number = int(re.search(r"behind p0 [^:]*:\d+: i(\d+)", seen.text("story")).group(1))
    seen.set("instant", str(number))
    seen.settled()
    seen.check(f"before i{number} of" in seen.text("at"), "the depth test is found: " + seen.text("at"))
    seen.after("shownLanes", lambda: seen.click("#clocks"))
    seen.check(f"controller text {seen.text('at').split(': ')[1].split(', for')[0]}" in seen.text("lanes-told"), "its clocks are shown: " + seen.text("lanes-told"))
    for bits in (8, 20):
        seen.set("z-bits", str(bits))
        seen.settled()
        seen.click("#judge")
        seen.settled()
        stats = json.loads(seen.run("render", BRACKET, "--z-bits", str(bits), "--check", "--stats", "-", "--progress", "none"))
        seen.check(seen.evaluate("document.getElementById('verdict').dataset.wrong") == str(stats["accuracy"]["wrong"]), f"{bits} bits: " + seen.text("verdict"))
        seen.check(stats["accuracy"]["wrong"] > 0 if bits == 8 else stats["accuracy"]["wrong"] == 0, "8 bits are too few, 20 enough")


TASKS = (((BRACKET,), what_would_a_machine_have_made_of_this_part), (TREES, how_do_the_trees_form_it), (CARBURETTOR, what_do_width_and_memory_change),
         ((BRACKET,), which_instruction_made_this_pixel_wrong))


def main():
    if not (chromium := browser.find()):
        print("Chromium is not installed; run ./setup.sh report-test")
        return 77
    csgsim = pathlib.Path(sys.argv[1]).resolve()
    failures = 0
    for words, do in TASKS:
        server = Server(csgsim, *words, cwd=SOURCE)
        with viewed(chromium, server, csgsim, SOURCE) as seen:
            seen.open(server)
            do(seen)
            seen.check(seen.page.problems == [], f"{seen.page.problems}")
            failures += seen.failures
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
