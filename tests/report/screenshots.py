"""Redraws the pictures of docs/view.md: pages in a headless Chromium.

Usage, from the source folder: python3 tests/report/screenshots.py build/release/csgsim docs/pictures/report"""

import os
import subprocess
import sys
import tempfile

import browser

CAMERA = ["--camera", "220,-255,135,2,0,5"]
MODEL = "tests/models/carburettor.csg"

CHOOSE = "document.querySelectorAll('tr[data-p] button')[2].click()"
STEP = """(() => {
  const slider = document.querySelector('input[type=range]');
  slider.value = 40;
  slider.dispatchEvent(new Event('input'));
})()"""

# The story of the pixel in the middle of a primitive, at its merge.
WHY = ["""(() => {
  document.querySelector('tr[data-p="1"] button').click();
  const item = [...document.querySelectorAll('.events li')].filter(one => one.querySelector('.what')?.textContent === 'merge').pop();
  item.querySelector('button').click();
  item.parentElement.scrollTop = item.offsetTop - item.parentElement.offsetTop - 180;
  csgsimDrawings[0].canvas.focus();
  csgsimDrawings[0].box.scrollIntoView({behavior: 'instant'});
})()"""]


def shot(csgsim, page, words, name, folder, width, height, dark, act=()):
    with tempfile.TemporaryDirectory() as scratch:
        path = os.path.join(scratch, "r.html")
        is_study = words[0] != "render"
        subprocess.run([csgsim, *words, *(["-o", scratch] if is_study else []), "--report", path], check=True,
                       stdout=subprocess.DEVNULL)
        page.window(width, height, dark)
        page.open(path)
        # Replaces the working folder in the command shown.
        shown = " ".join(["csgsim", *words, *(["-o", "out"] if is_study else []), "--report", "r.html"])
        page.evaluate(f"document.querySelector('#command').textContent = {shown!r}")
        for expression in act:
            page.evaluate(expression)
        page.screenshot(os.path.join(folder, name), full=False)


def main():
    csgsim, folder = sys.argv[1], sys.argv[2]
    os.makedirs(folder, exist_ok=True)
    page = browser.Browser(browser.find() or sys.exit("Chromium is not installed"))
    shot(csgsim, page, ["render", MODEL, *CAMERA], "render.png", folder, 1280, 1340, False, (CHOOSE, STEP, "document.activeElement.blur()"))
    shot(csgsim, page, ["render", MODEL, *CAMERA], "why.png", folder, 1280, 1000, False, WHY)
    shot(csgsim, page, ["accuracy", MODEL, *CAMERA, "--size", "128x128", "--views", "1", "--no-plots"], "accuracy.png", folder, 390, 1500, True)
    page.close()


if __name__ == "__main__":
    main()
