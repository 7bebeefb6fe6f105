#!/usr/bin/env python3
"""The page of csgsim view in a headless Chromium: used with a pointer, with keys, on a phone and in dark mode.

Usage: page_test.py CSGSIM SOURCE_FOLDER [PICTURE]. With PICTURE, takes a screenshot for docs/view.md. Exit code 77
without Chromium."""

import os
import pathlib
import sys
import tempfile
import time

SOURCE = pathlib.Path(sys.argv[2]).resolve()
sys.path.insert(0, str(SOURCE / "tests/report"))

import browser  # noqa: E402
from server import Server  # noqa: E402
from viewed import viewed  # noqa: E402


def photograph(seen, name, selector):
    """Takes a screenshot for docs/view.md, if requested."""
    if len(sys.argv) < 4:
        return
    seen.evaluate(f"document.querySelector('{selector}').scrollIntoView({{behavior: 'instant'}})")
    seen.page.screenshot(sys.argv[3].replace(".png", f"_{name}.png"), full=False)
    seen.evaluate("window.scrollTo({top: 0, behavior: 'instant'})")


def drag(page, x, y, dx, dy, steps):
    page.send("Input.dispatchMouseEvent", type="mousePressed", x=x, y=y, button="left", buttons=1, clickCount=1)
    for step in range(1, steps + 1):
        page.send("Input.dispatchMouseEvent", type="mouseMoved", x=x + dx * step / steps, y=y + dy * step / steps, button="left", buttons=1)
        time.sleep(0.1)
    page.send("Input.dispatchMouseEvent", type="mouseReleased", x=x + dx, y=y + dy, button="left", clickCount=1)


def box_of_picture(seen):
    return seen.evaluate("(() => { const b = document.getElementById('picture').getBoundingClientRect(); return [b.left, b.top, b.width]; })()")


def turns_the_camera_by_pointer(seen):
    """Draws twenty pictures at any rate, as sanitized builds are slow; speed.py measures the rate."""
    first = seen.text("command")
    left, top, _ = box_of_picture(seen)
    count = seen.evaluate("window.drawnPictures")
    begin = time.monotonic()
    turn = 0
    while seen.evaluate("window.drawnPictures") < count + 20 and time.monotonic() < begin + 60:
        drag(seen.page, left + 100, top + 200, 80 if turn % 2 else 40, 20, 6)
        turn += 1
    rate = (seen.evaluate("window.drawnPictures") - count) / (time.monotonic() - begin)
    seen.check(seen.evaluate("window.drawnPictures") >= count + 20, "a moving pointer draws twenty pictures")
    print(f"{rate:.1f} pictures per second with a pointer that moves ten times per second")
    seen.settled()
    seen.check(seen.text("command") != first, "the camera has been turned")
    seen.check_same("turned")


def turns_the_camera_by_keys(seen):
    seen.evaluate("document.getElementById('stage').focus()")
    for key in ("ArrowLeft", "ArrowUp"):
        seen.page.press(key)
    seen.page.send("Input.dispatchKeyEvent", type="char", text="+")
    seen.settled()
    seen.check_same("turned by keys")
    seen.page.send("Input.dispatchKeyEvent", type="keyDown", key="0", code="Digit0", windowsVirtualKeyCode=48)
    seen.settled()


def changes_the_machine(seen):
    seen.set("machine", "pixel-planes-5")
    seen.settled()
    seen.check("--machine pixel-planes-5" in seen.text("command"), "the machine has changed")
    seen.check_same("on another machine")
    seen.set("machine", "pixel-planes-6")
    seen.until("!document.getElementById('error').hidden")
    seen.check("pixel-planes-" in seen.text("error"), "an unknown machine is reported")
    seen.set("machine", "")
    seen.until("document.getElementById('error').hidden")


def enables_an_effect(seen):
    on = "[data-key=\"effects.depth_cue.on\"]"
    seen.evaluate(f"(() => {{ const e = document.querySelector('{on}'); e.value = 'true'; e.dispatchEvent(new Event('change')); }})()")
    seen.settled()
    seen.check("--set effects.depth_cue.on=true" in seen.text("command"), "the form writes a valid option: " + seen.text("command"))
    seen.check_same("with an effect")
    seen.set("set", "effects.depth_cue.on=false")
    seen.settled()
    seen.check(seen.evaluate(f"document.querySelector('{on}').value") == "false", "the form shows the written option")
    seen.set("set", "")
    seen.settled()


def explains_a_pixel(seen):
    left, top, width = box_of_picture(seen)
    seen.page.point(left + width / 2, top + width / 2, click=True)
    seen.until("document.getElementById('story').textContent.length > 100")
    story = seen.text("story")
    seen.check("pixel" in story, "the pixel's story is shown")
    off = seen.evaluate("(() => { const m = document.getElementById('mark').getBoundingClientRect(); return [m.left + m.width / 2, m.top + m.height / 2]; })()")
    seen.check(abs(off[0] - left - width / 2) < 3 and abs(off[1] - top - width / 2) < 3, f"the mark is where the click was: {off}")
    seen.set("why-not", "p1")
    seen.click("#why button")
    seen.until(f"document.getElementById('story').textContent.length > {len(story)}")


def move(seen, number):
    """Goes to an instant."""
    seen.evaluate("document.getElementById('tinted').checked = false")
    seen.set("instant", str(number))
    seen.settled()


def shows_instants(seen):
    """Goes to instants by slider, field, event of the story, instruction of the listing, source line, and tree."""
    seen.settled()
    count = int(seen.evaluate("document.getElementById('instant').max"))
    move(seen, count)
    seen.check(seen.evaluate("document.getElementById('then').src === document.getElementById('picture').src"), "the last instant is the picture")
    seen.set("field", "Z1", "change")
    move(seen, count // 3)
    number = int(seen.evaluate("document.getElementById('instant').value"))
    seen.check(f"before i{number} of" in seen.text("at"), "the place of the instant is shown: " + seen.text("at"))
    seen.check("white" in seen.text("scale"), "the scale of Z1 is shown")
    seen.after("shownInstants", lambda: seen.evaluate("document.querySelectorAll('#events button')[1].click()"))
    event = seen.evaluate("document.querySelectorAll('#events button')[1].textContent")
    last = int(event.split()[0].split("i")[-1])
    seen.check(int(seen.evaluate("document.getElementById('instant').value")) == last + 1, f"an event leads to the instant after its last instruction: {event}")
    seen.after("shownInstants", lambda: seen.click("#listing button"))
    seen.check(seen.evaluate("document.querySelector('#listing [aria-current=true]').textContent.startsWith('i' + document.getElementById('instant').value + ' ')"),
               "the listing shows where it is")
    lines = seen.evaluate("document.getElementById('source').value").split("\n")
    line = next(number for number, text in enumerate(lines) if "cylinder" in text)
    at = len("\n".join(lines[:line])) + 2
    seen.after("shownInstants", lambda: seen.evaluate(f"(() => {{ const s = document.getElementById('source'); s.setSelectionRange({at}, {at}); s.click(); }})()"))
    seen.check(f"@{line + 1}:" in seen.text("at"), "a line of the source leads to its primitive")
    seen.check(f"@{line + 1}:" in seen.evaluate("document.querySelector('#tree [aria-current=true]').textContent"), "the tree marks the primitive")
    seen.after("shownInstants", lambda: seen.click("#tree [data-primitive='3'] button"))
    seen.check("render p3 " in seen.text("at"), "the tree leads to the primitive: " + seen.text("at"))
    seen.check("Active tree of p3 " in seen.text("active-of"), "the active tree is shown: " + seen.text("active-of"))
    seen.evaluate("document.getElementById('tinted').checked = true")
    seen.set("instant", str(count // 5))
    seen.settled()
    photograph(seen, "time", ".time")


def shows_lanes(seen):
    begin, end = seen.evaluate("document.getElementById('clocks').textContent").replace(",", "").split("clocks ")[1].split(":")[0].split(" to ")
    seen.after("shownLanes", lambda: seen.click("#clocks"))
    told = seen.text("lanes-told")
    seen.check(told.startswith(f"Clock {int(begin):,} of ") and "controller issuing" in told, f"the clock is shown: {told}")
    seen.check(seen.evaluate("document.querySelectorAll('#lane-names li').length") > 4, "parts have lanes")
    canvas = "const c = document.getElementById('lanes').getContext('2d').getImageData(2, 2, 400, 60).data; return new Set(c.filter((_, i) => i % 4 < 3)).size;"
    seen.check(seen.evaluate("(() => { " + canvas + " })()") > 5, "lanes are painted")
    photograph(seen, "wires", "#wires")
    number = seen.evaluate("document.getElementById('instant').value")
    seen.evaluate("document.getElementById('lanes').focus()")
    for _ in range(2):
        seen.page.send("Input.dispatchKeyEvent", type="char", text="+")
        seen.page.send("Input.dispatchKeyEvent", type="keyDown", key="-", text="-")
    for _ in range(40):
        seen.page.press("ArrowRight")
    seen.check(seen.text("lanes-told") != told, "the arrow keys point at other clocks")
    seen.after("shownInstants", lambda: seen.page.press("Enter"))
    seen.check(seen.evaluate("document.getElementById('instant').value") != number, "a clock leads to its instant")
    seen.after("shownLanes", lambda: seen.click("#frame"))
    seen.check(f"of 0 to {seen.stats_of_command()['shown_clocks']:,}:" in seen.text("lanes-told"), "the lanes cover the whole frame: " + seen.text("lanes-told"))
    seen.after("shownLanes", lambda: seen.click("#nearer"))


def compares_two_drawings(seen):
    seen.after("comparedTwo", lambda: seen.click("#keep"))
    seen.check("pictures are equal" in seen.text("differs"), "A equals itself")
    seen.after("comparedTwo", lambda: seen.set("z-bits", "8"))
    told = seen.text("differs")
    seen.check("pixels differ" in told and "instruction that differs is i" in told, f"the differences are shown: {told}")
    seen.check(seen.evaluate("document.querySelectorAll('#counts tr:first-child td').length") == 2, "counts stand side by side")
    seen.check(seen.evaluate("document.getElementById('timeline').hidden"), "lanes of the previous drawing are hidden")
    photograph(seen, "two", "#keep")
    seen.set("z-bits", "")
    seen.settled()


def edits_the_source(seen):
    seen.edit_the_source()
    seen.types_through_errors()
    seen.jumps_to_an_error_when_asked()
    seen.check_same("with the source as it was")


ENDLESS = """#!/bin/sh
# Stands in for OpenSCAD: the evaluation of an endless text never ends.
text=$(cat)
case "$text" in *endless*) sleep 1000;; *) printf '%s\\n' "$text";; esac
"""


def cancels_an_endless_evaluation(seen, server):
    """With a model of OpenSCAD: the progress of an evaluation, its cancel button, and its replacement by a new text."""
    seen.open(server)
    seen.set("source", "endless();")
    seen.until("!document.getElementById('working').hidden")
    seen.until("document.getElementById('doing').textContent.includes('evaluating the model')")
    seen.check("of at most 600 s" in seen.text("doing"), "the progress shows the limit: " + seen.text("doing"))
    left, top, width = box_of_picture(seen)
    seen.page.point(left + width / 2, top + width / 2, click=True)
    seen.until("document.getElementById('story').textContent.length > 100")
    seen.check(not seen.evaluate("document.getElementById('working').hidden"), "the previous picture can still be explained")
    seen.click("#cancel")
    seen.until("!document.getElementById('error').hidden")
    seen.check("cancelled" in seen.text("error"), "the evaluation is cancelled: " + seen.text("error"))
    seen.until("document.getElementById('working').hidden")
    seen.set("source", "endless();\n")
    seen.until("!document.getElementById('working').hidden")
    begin = time.monotonic()
    seen.set("source", "cube(size=[20,20,20],center=true);")
    seen.until("document.getElementById('error').hidden && document.getElementById('working').hidden")
    seen.settled()
    seen.check(time.monotonic() - begin < 20, "a new text does not wait for the old one")
    seen.check(seen.counts()["primitives, half-spaces"] == "1, 6", f"the new text is drawn: {seen.counts()}")


def use(seen, server):
    seen.open(server)
    seen.check(seen.evaluate("document.getElementById('picture').naturalWidth") == 512, "the picture is 512 wide")
    seen.check_same("as it begins")
    for part in (turns_the_camera_by_pointer, turns_the_camera_by_keys, changes_the_machine, enables_an_effect, explains_a_pixel, shows_instants, shows_lanes, compares_two_drawings,
                 edits_the_source):
        part(seen)
    for width in (390, 1280):
        for dark in (False, True):
            seen.page.window(width, 900, dark)
            seen.evaluate("document.querySelectorAll('details').forEach(each => { each.open = true; })")
            seen.check(seen.too_wide() == [], f"{width} pixels: {seen.too_wide()}")
    if len(sys.argv) > 3:
        seen.evaluate("document.querySelectorAll('details').forEach(each => { each.open = false; })")
        seen.page.window(1280, 1000)
        seen.page.screenshot(sys.argv[3], full=False)
    # Chromium reports error answers as problems; they are expected here.
    problems = [each for each in seen.page.problems if "422" not in each]
    seen.check(problems == [], f"{problems}")
    own = [url for url in seen.page.requests if not url.startswith((server.address, "data:"))]
    seen.check(own == [], f"requests to other servers: {own}")


def main():
    if not (chromium := browser.find()):
        print("Chromium is not installed; run ./setup.sh report-test")
        return 77
    csgsim = pathlib.Path(sys.argv[1]).resolve()
    server = Server(csgsim, "tests/models/carburettor.csg", "--camera", "220,-255,135,2,0,5", "--size", "512x512", cwd=SOURCE)
    with viewed(chromium, server, csgsim, SOURCE) as seen:
        use(seen, server)
        failures = seen.failures
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "openscad").write_text(ENDLESS)
        (folder / "openscad").chmod(0o755)
        (folder / "model.scad").write_text("cube(size=[9,9,9],center=true);\n")
        server = Server(csgsim, str(folder / "model.scad"), "--size", "64x64", "--evaluation-time", "600",
                        env=os.environ | {"PATH": f"{folder}:{os.environ['PATH']}"})
        with viewed(chromium, server, csgsim, folder) as seen:
            cancels_an_endless_evaluation(seen, server)
            failures += seen.failures
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
