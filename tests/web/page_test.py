#!/usr/bin/env python3
"""The page without a server program in a headless Chromium, behind a static server: page_test.py CSGSIM SOURCE SITE
[PICTURE].

With PICTURE, takes a screenshot for docs/view.md. Exit code 77 without SITE or Chromium."""

import base64
import contextlib
import pathlib
import subprocess
import sys
import tempfile
import time

CSGSIM, SOURCE, SITE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
sys.path[:0] = [str(SOURCE / "tests/report"), str(SOURCE / "tests/view")]

import browser  # noqa: E402
from viewed import viewed  # noqa: E402
from web_page import StaticServer  # noqa: E402

PIXELS = """(() => { const image = document.getElementById('picture'), canvas = document.createElement('canvas');
  canvas.width = image.naturalWidth; canvas.height = image.naturalHeight;
  const pen = canvas.getContext('2d'); pen.drawImage(image, 0, 0);
  const data = pen.getImageData(0, 0, canvas.width, canvas.height).data.filter((_, i) => i % 4 < 3);
  let text = ''; for (let i = 0; i < data.length; i += 32768) text += String.fromCharCode(...data.subarray(i, i + 32768));
  return btoa(text); })()"""


def pixels_of_command(seen):
    """The picture of csgsim render for the command that the page shows."""
    with tempfile.TemporaryDirectory() as folder:
        words = seen.text("command").replace("csgsim", str(CSGSIM), 1) + f" --progress none -o {folder}/picture.ppm"
        subprocess.run(["bash", "-c", words], cwd=seen.folder, check=True, capture_output=True)
        return (pathlib.Path(folder) / "picture.ppm").read_bytes().split(b"\n", 3)[3]


def check_same(seen, what):
    """Compares counts and picture."""
    seen.check_same(what)
    seen.check(base64.b64decode(seen.evaluate(PIXELS)) == pixels_of_command(seen), what + ": the picture")


def until_new(seen, expression):
    """Waits on the next page: requests of the page being left may be lost."""
    end = time.monotonic() + 60
    while time.monotonic() < end:
        with contextlib.suppress(RuntimeError):
            if seen.evaluate(f"!window.old && {expression}"):
                return
        time.sleep(0.05)
    raise RuntimeError(f"timeout waiting for: {expression}; {seen.page.problems}")


def opened(seen, address):
    seen.evaluate("window.drawnPictures = 0")
    seen.page.send("Page.navigate", url=address)
    seen.until("window.drawnPictures > 0 && document.getElementById('picture').naturalWidth > 0")
    seen.settled()


def turns_the_camera_by_pointer(seen):
    left, top = seen.evaluate("(() => { const b = document.getElementById('picture').getBoundingClientRect(); return [b.left, b.top]; })()")
    first = seen.text("command")
    count = seen.evaluate("window.drawnPictures")
    mouse = {"x": left + 100, "y": top + 200, "button": "left", "clickCount": 1}
    seen.page.send("Input.dispatchMouseEvent", type="mousePressed", buttons=1, **mouse)
    end = time.monotonic() + 60
    while seen.evaluate("window.drawnPictures") < count + 20 and time.monotonic() < end:
        mouse["x"] += 5
        seen.page.send("Input.dispatchMouseEvent", type="mouseMoved", buttons=1, **mouse)
        time.sleep(0.02)
    seen.page.send("Input.dispatchMouseEvent", type="mouseReleased", **mouse)
    seen.settled()
    seen.check(seen.evaluate("window.drawnPictures") >= count + 20, "a moving pointer draws twenty pictures")
    seen.check(seen.text("command") != first, "the camera has been turned")
    check_same(seen, "turned")


def changes_options(seen):
    seen.set("machine", "pixel-planes-5")
    seen.settled()
    check_same(seen, "on another machine")
    seen.set("machine", "")
    seen.set("set", "effects.depth_cue.on=true")
    seen.settled()
    check_same(seen, "with an effect")
    seen.set("set", "")
    seen.settled()


def edits_the_source(seen):
    seen.edit_the_source()


def explains_a_pixel(seen):
    seen.set("pixel", "256,256")
    seen.after("drawnPictures", lambda: seen.set("size", "512x512"))
    seen.click("#why button")
    seen.until("document.getElementById('story').textContent.length > 100")
    told = seen.run(*seen.text("command").replace("csgsim render", "explain").split(), "--pixel", "256,256")
    seen.check(seen.text("story").strip() == told.strip(), "the story equals that of csgsim explain")


def shows_instants(seen):
    seen.settled()
    count = int(seen.evaluate("document.getElementById('instant').max"))
    seen.set("instant", str(count))
    seen.evaluate("(() => { const t = document.getElementById('tinted'); t.checked = false; t.dispatchEvent(new Event('input', {bubbles: true})); t.dispatchEvent(new Event('change', {bubbles: true})); })()")
    seen.settled()
    seen.check(seen.evaluate("document.getElementById('then').src === document.getElementById('picture').src"), "the last instant is the picture")
    seen.set("instant", str(count // 3))
    seen.settled()
    # A skipped instruction leads to the next executed one.
    number = int(seen.evaluate("document.getElementById('instant').value"))
    seen.check(count // 3 <= number < count and f"before i{number} of" in seen.text("at"), "the place of the instant is shown: " + seen.text("at"))


def checks_and_compares_drawings(seen):
    seen.click("#judge")
    seen.until("document.getElementById('verdict').textContent.includes('pixels')")
    seen.after("comparedTwo", lambda: seen.click("#keep"))
    seen.check("pictures are equal" in seen.text("differs"), "A equals itself")
    seen.after("comparedTwo", lambda: seen.set("z-bits", "8"))
    seen.check("pixels differ" in seen.text("differs"), "the differences are shown: " + seen.text("differs"))
    seen.set("z-bits", "")
    seen.settled()


def rejects_lanes(seen):
    seen.click("#frame")
    seen.until("document.getElementById('wires-told').textContent.includes('csgsim view')")


def opens_a_file(seen, address):
    """Drops a file onto the page."""
    drop = """(() => { const data = new DataTransfer(); data.items.add(new File([%r], %r));
      document.body.dispatchEvent(new DragEvent('drop', {dataTransfer: data, bubbles: true, cancelable: true})); window.drawnPictures = 0; window.old = true; })()"""
    seen.evaluate(drop % ("cube(size=[3,4,5],center=false);", "own.csg"))
    until_new(seen, "window.drawnPictures > 0")
    seen.settled()
    seen.check(seen.text("title") == "own.csg" and seen.counts()["primitives, half-spaces"] == "1, 6", "a dropped file is drawn")
    seen.evaluate(drop % ("cube(3);", "own.scad"))
    until_new(seen, "document.getElementById('error') && !document.getElementById('error').hidden")
    seen.check("export the model as .csg" in seen.text("error"), "OpenSCAD source is rejected: " + seen.text("error"))
    seen.page.send("Page.navigate", url=address + "?model=nothing.csg")
    until_new(seen, "document.getElementById('error') && document.getElementById('error').textContent.includes('choose one of')")


def use(seen, address):
    opened(seen, address)
    seen.check("camera 220,-255,135,2,0,5" in seen.text("command"), "the first model has its default camera: " + seen.text("command"))
    check_same(seen, "as it begins")
    if len(sys.argv) > 4:
        seen.page.window(1280, 1000)
        seen.page.screenshot(sys.argv[4], full=False)
    for width in (390, 1280):
        seen.page.window(width, 900)
        seen.check(seen.too_wide() == [], f"{width} pixels: {seen.too_wide()}")
    for part in (turns_the_camera_by_pointer, changes_options, edits_the_source, explains_a_pixel, shows_instants, checks_and_compares_drawings, rejects_lanes):
        part(seen)
    opened(seen, address + "?model=terrain_vehicle.csg&machine=pixel-planes-5&size=256x256")
    seen.check("--machine pixel-planes-5" in seen.text("command"), "the address sets options: " + seen.text("command"))
    check_same(seen, "a model by its address")
    opens_a_file(seen, address)
    own = [url for url in seen.page.requests if not url.startswith((address, "data:", "blob:"))]
    seen.check(own == [], f"requests to other servers: {own}")
    problems = [each for each in seen.page.problems if "nothing.csg" not in each]
    seen.check(problems == [], f"{problems}")


def main():
    if not (SITE / "csgsim.wasm").exists() or not (chromium := browser.find()):
        print("the page or Chromium is missing; run ./setup.sh web")
        return 77
    server = StaticServer(SITE)
    with viewed(chromium, server, CSGSIM, SOURCE / "tests/models") as seen:
        use(seen, server.address)
    return 1 if seen.failures else 0


if __name__ == "__main__":
    sys.exit(main())
