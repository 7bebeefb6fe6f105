#!/usr/bin/env python3
"""The page of csgsim view in a headless Chromium, as somebody uses it: with a pointer, with keys, on a phone, in the dark.

Usage: page_test.py CSGSIM SOURCE_FOLDER [PICTURE]. With PICTURE the page is photographed for docs/view.md. Exit code 77 where there is no Chromium."""

import json
import pathlib
import subprocess
import sys
import time

SOURCE = pathlib.Path(sys.argv[2]).resolve()
sys.path.insert(0, str(SOURCE / "tests/report"))

import browser  # noqa: E402
from server import Server  # noqa: E402

TOO_WIDE = """[...document.body.querySelectorAll('*')].filter(element => {
  const box = element.getBoundingClientRect();
  return box.width > 0 && box.right > innerWidth + 1 && !element.closest('.scroll, .told');
}).map(element => element.outerHTML.slice(0, 120))"""
failures = 0


def check(holds, what):
    global failures
    if not holds:
        failures += 1
        print("FAILED:", what)


def until(page, expression, seconds=30):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if page.evaluate(expression):
            return
        time.sleep(0.02)
    raise RuntimeError(f"never came: {expression}; {page.problems}")


def settled(page):
    """Waits until all that was wished is shown."""
    until(page, "window.isAtRest()")


def stats_of(csgsim, command):
    words = command.replace("csgsim", str(csgsim), 1) + " --stats - --progress none"
    return json.loads(subprocess.run(["bash", "-c", words], cwd=SOURCE, check=True, text=True, capture_output=True).stdout)


def check_same(page, csgsim, what):
    stats = stats_of(csgsim, page.evaluate("document.getElementById('command').textContent"))
    rows = dict(page.evaluate("[...document.querySelectorAll('#counts tr')].map(row => [row.cells[0].textContent, row.cells[1].textContent])"))
    check(rows["clocks until it is drawn"] == f"{stats['clocks']:,}", f"{what}: clocks {rows} {stats['clocks']}")
    check(rows["instructions"] == f"{stats['instructions']['total']:,}", f"{what}: instructions")
    for name, clocks in page.evaluate("[...document.querySelectorAll('#bill tr')].map(row => [row.cells[0].textContent, row.cells[1].textContent])"):
        check(clocks == f"{stats['by_purpose'][name.replace(' ', '_')]['clocks']:,}", f"{what}: {name}")


def drag(page, x, y, dx, dy, steps):
    page.send("Input.dispatchMouseEvent", type="mousePressed", x=x, y=y, button="left", buttons=1, clickCount=1)
    for step in range(1, steps + 1):
        page.send("Input.dispatchMouseEvent", type="mouseMoved", x=x + dx * step / steps, y=y + dy * step / steps, button="left", buttons=1)
        time.sleep(0.1)
    page.send("Input.dispatchMouseEvent", type="mouseReleased", x=x + dx, y=y + dy, button="left", clickCount=1)


def set_value(page, name, value, event="input"):
    page.evaluate(f"(() => {{ const e = document.getElementById({name!r}); e.value = {json.dumps(value)}; e.dispatchEvent(new Event({event!r}, {{bubbles: true}})); }})()")


def move(page, number):
    """To an instant."""
    page.evaluate("document.getElementById('tinted').checked = false")
    set_value(page, "instant", str(number))
    settled(page)


def use(page, csgsim, server):
    page.window(1280, 900)
    page.send("Page.navigate", url=server.address)
    until(page, "window.drawnPictures > 0 && document.getElementById('picture').naturalWidth > 0")
    check(page.evaluate("document.getElementById('picture').naturalWidth") == 512, "the picture is 512 wide")
    check_same(page, csgsim, "as it begins")
    first = page.evaluate("document.getElementById('command').textContent")

    # Twenty pictures under the pointer, however slow a build beside sanitizers is: speed.py measures the rate.
    box = page.evaluate("(() => { const b = document.getElementById('picture').getBoundingClientRect(); return [b.left, b.top, b.width]; })()")
    count = page.evaluate("window.drawnPictures")
    begin = time.monotonic()
    turn = 0
    while page.evaluate("window.drawnPictures") < count + 20 and time.monotonic() < begin + 60:
        drag(page, box[0] + 100, box[1] + 200, 80 if turn % 2 else 40, 20, 6)
        turn += 1
    rate = (page.evaluate("window.drawnPictures") - count) / (time.monotonic() - begin)
    check(page.evaluate("window.drawnPictures") >= count + 20, "twenty pictures are drawn under the pointer")
    print(f"{rate:.1f} pictures a second under a pointer that moves ten times a second")
    settled(page)
    check(page.evaluate("document.getElementById('command').textContent") != first, "the camera has been turned")
    check_same(page, csgsim, "turned")

    # By keys.
    page.evaluate("document.getElementById('stage').focus()")
    for key in ("ArrowLeft", "ArrowUp"):
        page.press(key)
    page.send("Input.dispatchKeyEvent", type="char", text="+")
    settled(page)
    check_same(page, csgsim, "turned by keys")
    page.send("Input.dispatchKeyEvent", type="keyDown", key="0", code="Digit0", windowsVirtualKeyCode=48)
    settled(page)

    # Knobs.
    set_value(page, "machine", "pixel-planes-5")
    settled(page)
    check("--machine pixel-planes-5" in page.evaluate("document.getElementById('command').textContent"), "the machine is another")
    check_same(page, csgsim, "on another machine")
    set_value(page, "machine", "pixel-planes-6")
    until(page, "!document.getElementById('error').hidden")
    check("pixel-planes-" in page.evaluate("document.getElementById('error').textContent"), "a wrong machine is told")
    set_value(page, "machine", "")
    until(page, "document.getElementById('error').hidden")

    # Why.
    page.point(box[0] + box[2] / 2, box[1] + box[2] / 2, click=True)
    until(page, "document.getElementById('story').textContent.length > 100")
    story = page.evaluate("document.getElementById('story').textContent")
    check("pixel" in story, "the pixel's story is told")
    off = page.evaluate("(() => { const m = document.getElementById('mark').getBoundingClientRect(); return [m.left + m.width / 2, m.top + m.height / 2]; })()")
    check(abs(off[0] - box[0] - box[2] / 2) < 3 and abs(off[1] - box[1] - box[2] / 2) < 3, f"the mark is where the click was: {off} {box}")
    set_value(page, "why-not", "p1")
    page.evaluate("document.querySelector('#why button').click()")
    until(page, f"document.getElementById('story').textContent.length > {len(story)}")

    # Time: the slider, a field, an event of the story, an instruction of the listing, a line of the source.
    settled(page)
    count = int(page.evaluate("document.getElementById('instant').max"))
    move(page, count)
    check(page.evaluate("document.getElementById('then').src === document.getElementById('picture').src"), "the last instant is the picture")
    set_value(page, "field", "Z1", "change")
    move(page, count // 3)
    number = int(page.evaluate("document.getElementById('instant').value"))
    check(f"before i{number} of" in page.evaluate("document.getElementById('at').textContent"), "it tells where it is: " + page.evaluate("document.getElementById('at').textContent"))
    check("white" in page.evaluate("document.getElementById('scale').textContent"), "the scale of Z1 is told")
    shown = page.evaluate("window.shownInstants")
    page.evaluate("document.querySelectorAll('#events button')[1].click()")
    until(page, f"window.shownInstants > {shown}")
    event = page.evaluate("document.querySelectorAll('#events button')[1].textContent")
    last = int(event.split()[0].split("i")[-1])
    check(int(page.evaluate("document.getElementById('instant').value")) == last + 1, f"an event leads behind its last instruction: {event}")
    shown = page.evaluate("window.shownInstants")
    page.evaluate("document.querySelector('#listing button').click()")
    until(page, f"window.shownInstants > {shown}")
    check(page.evaluate("document.querySelector('#listing [aria-current=true]').textContent.startsWith('i' + document.getElementById('instant').value + ' ')"),
          "the listing shows where it is")
    lines = page.evaluate("document.getElementById('source').value").split("\n")
    line = next(number for number, text in enumerate(lines) if "cylinder" in text)
    shown = page.evaluate("window.shownInstants")
    at = len("\n".join(lines[:line])) + 2
    page.evaluate(f"(() => {{ const s = document.getElementById('source'); s.setSelectionRange({at}, {at}); s.click(); }})()")
    until(page, f"window.shownInstants > {shown}")
    check(f"@{line + 1}:" in page.evaluate("document.getElementById('at').textContent"), "a line of the source leads to its primitive")
    if len(sys.argv) > 3:
        page.evaluate("document.getElementById('tinted').checked = true")
        set_value(page, "instant", str(count // 5))
        settled(page)
        page.evaluate("document.querySelector('.time').scrollIntoView({behavior: 'instant'})")
        page.screenshot(sys.argv[3].replace(".png", "_time.png"), full=False)
        page.evaluate("window.scrollTo({top: 0, behavior: 'instant'})")

    # Two at once.
    page.evaluate("document.getElementById('keep').click()")
    until(page, "window.comparedTwo > 0")
    check("pictures are equal" in page.evaluate("document.getElementById('differs').textContent"), "A is itself")
    compared = page.evaluate("window.comparedTwo")
    set_value(page, "z-bits", "8")
    until(page, f"window.comparedTwo > {compared}")
    told = page.evaluate("document.getElementById('differs').textContent")
    check("pixels differ" in told and "other instruction is i" in told, f"what differs is told: {told}")
    check(page.evaluate("document.querySelectorAll('#counts tr:first-child td').length") == 2, "counts stand side by side")
    if len(sys.argv) > 3:
        page.evaluate("document.getElementById('keep').scrollIntoView({behavior: 'instant'})")
        page.screenshot(sys.argv[3].replace(".png", "_two.png"), full=False)
        page.evaluate("window.scrollTo({top: 0, behavior: 'instant'})")
    set_value(page, "z-bits", "")
    settled(page)

    # Source.
    source = page.evaluate("document.getElementById('source').value")
    set_value(page, "source", "cube(size=[20,20,20],center=true);")
    settled(page)
    rows = dict(page.evaluate("[...document.querySelectorAll('#counts tr')].map(row => [row.cells[0].textContent, row.cells[1].textContent])"))
    check(rows["primitives, half-spaces"] == "1, 6", f"the edited source is drawn: {rows}")
    set_value(page, "source", "cube(size=[20,20,20],center=true);\nsphere(r=;")
    until(page, "!document.getElementById('error').hidden")
    check(page.evaluate("document.getElementById('source').selectionStart") > 35, "the line of the error is selected")
    set_value(page, "source", source)
    until(page, "document.getElementById('error').hidden")
    settled(page)
    check_same(page, csgsim, "with the source as it was")


def main():
    if not (chromium := browser.find()):
        print("there is no Chromium; ./setup.sh report-test installs one")
        return 77
    csgsim = pathlib.Path(sys.argv[1]).resolve()
    server = Server(csgsim, "tests/models/carburettor.csg", "--camera", "220,-255,135,2,0,5", "--size", "512x512", cwd=SOURCE)
    page = browser.Browser(chromium)
    try:
        use(page, csgsim, server)
        for width in (390, 1280):
            for dark in (False, True):
                page.window(width, 900, dark)
                check(page.evaluate(TOO_WIDE) == [], f"{width} pixels: {page.evaluate(TOO_WIDE)}")
        if len(sys.argv) > 3:
            page.window(1280, 1000)
            page.screenshot(sys.argv[3], full=False)
        # What Chromium says of answers that tell of an error is no fault of the page.
        problems = [each for each in page.problems if "422" not in each]
        check(problems == [], f"{problems}")
        own = [url for url in page.requests if not url.startswith((server.address, "data:"))]
        check(own == [], f"asked for elsewhere: {own}")
    finally:
        page.close()
        server.stop()
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
