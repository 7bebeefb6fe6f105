"""Stories on pages of --report, and the page of two runs, in a headless Chromium, with the pointer and with keys.
explain_test.py compares the texts with those of `csgsim explain`.

Usage: story_test.py CSGSIM SOURCE_FOLDER. Exit code 77 without Chromium."""

import json
import os
import subprocess
import sys
import tempfile
import time

import browser
import pages_test

THESIS = ["tests/models/thesis_fig_2_3.csg", "--size", "64x48"]

# The visible text of the first drawing's story, normalized to the words of `csgsim explain`.
SHOWN = """(() => {
  const story = document.querySelector('.why .story');
  return [...story.querySelectorAll('strong, .facts li, .events li')].map(item => {
    const parts = item.children.length > 1 ? [...item.querySelectorAll('button, small[title], .what'), ...item.lastElementChild.childNodes] : [item];
    return parts.map(part => part.textContent).join(' ');
  }).join(' ').replace(/⇒/g, '=>').replace(/\\s+/g, ' ');
})()"""

# The text of a story in the page's data, normalized in the same way.
HELD = """csgsimDrawings[0].why.stories[%d].parts.map(part => typeof part === 'string' ? part : part[0]).join('').replace(/\\n +clocks\\n/g, ' ').replace(/\\s+/g, ' ').trim()"""

# In the gallery of two runs: number of coloured pixels in the third picture, and of pixels that differ between the
# first two.
MARKED = """(async () => {
  const [a, b, difference] = await Promise.all([...document.querySelectorAll('.gallery img')].map(async image => {
    await image.decode();
    const canvas = document.createElement('canvas');
    Object.assign(canvas, {width: image.naturalWidth, height: image.naturalHeight});
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    return context.getImageData(0, 0, canvas.width, canvas.height).data;
  }));
  const pixels = [...Array(a.length / 4).keys()].map(i => 4 * i);
  return [pixels.filter(i => difference[i] !== difference[i + 1]).length, pixels.filter(i => [0, 1, 2].some(k => a[i + k] !== b[i + k])).length];
})()"""


def until(page, expression, seconds=60):
    end = time.monotonic() + seconds
    while not page.evaluate(expression):
        if time.monotonic() > end:
            raise RuntimeError(f"timeout waiting for: {expression}; {page.problems}")
        time.sleep(0.02)


def spoken(page):
    return page.evaluate("document.querySelector('#told').textContent")


def check_choices(page, failures):
    """Each story can be selected in the form and is shown completely; each event leads to its step."""
    for i in range(page.evaluate("csgsimDrawings[0].why.stories.length")):
        page.evaluate(f"(() => {{ const {{choice}} = csgsimDrawings[0].why; choice.value = {i}; choice.dispatchEvent(new Event('change')); }})()")
        shown, held = page.evaluate(SHOWN), page.evaluate(HELD % i)
        failures.check(shown == held, f"story {i} differs:\n{shown}\nfor\n{held}")
        failures.check(spoken(page).startswith("pixel "), "a screen reader does not read the story")
        wrong = page.evaluate("""[...document.querySelectorAll('.why .events')][0] && [...document.querySelector('.why .events').querySelectorAll('button')].filter(button => {
            button.click();
            const {steps, now} = csgsimDrawings[0];
            const last = Number(button.textContent.split('i').pop());
            return button.getAttribute('aria-current') !== 'step' || !(steps[now - 1][0] <= last && last < steps[now][0]);
        }).map(button => button.textContent)""")
        failures.check(wrong == [], f"events of story {i} lead to other steps: {wrong}")


def check_rows(page, failures):
    """A row of the table shows the story of its primitive."""
    primitive = page.evaluate("csgsimDrawings[0].why.stories.find(story => story.primitive !== null).primitive")
    page.evaluate(f"document.querySelector('tr[data-p=\"{primitive}\"] button').click()")
    x, y = page.evaluate(f"(({{x, y}}) => [x, y])(csgsimDrawings[0].why.stories.find(story => story.primitive === {primitive}))")
    failures.check(page.evaluate(SHOWN).startswith(f"pixel {x},{y} shows p{primitive} "), "a primitive's story is not shown")
    failures.check(f"Why pixel {x},{y} shows it" in page.evaluate("document.querySelector('.price').textContent"), "a primitive does not lead to its story")


def check_keys(page, failures):
    """With keys alone: moves the cursor, opens a story with Enter, and uses the form."""
    page.evaluate("document.activeElement.blur(); csgsimDrawings[0].moveTo(20, 20)")
    if not pages_test.tab_to(page, ".drawing canvas", failures):
        return
    for key in ("ArrowRight", "ArrowDown", "ArrowDown"):
        page.press(key)
    failures.check(spoken(page).startswith("21, 22: #"), f"the cursor's pixel is not announced: {spoken(page)!r}")
    x, y = page.evaluate("(({x, y}) => [x, y])(csgsimDrawings[0].why.stories[1])")
    page.evaluate(f"csgsimDrawings[0].moveTo({x}, {y - 2})")
    page.press("ArrowDown")
    page.press("Enter")
    failures.check(page.evaluate(SHOWN).startswith(f"pixel {x},{y} shows"), "Enter does not show the story of a pixel near the cursor")
    if pages_test.tab_to(page, ".ask input", failures):
        for text, told in ((f"{x} {y}", f"pixel {x},{y} shows"), ("3,4000", "there is no pixel 3,4000"), ("", "enter a pixel"), (f"{x}, {y - 1}", f"csgsim explain {' '.join(THESIS)} --pixel {x},{y - 1}")):
            page.evaluate(f"document.activeElement.value = {json.dumps(text)}")
            page.press("Enter")
            shown = page.evaluate("document.querySelector('.story').textContent")
            failures.check(told in shown, f"{text!r} shows {shown!r}")
    if pages_test.tab_to(page, ".story button", failures):
        page.press("Enter")
        failures.check(page.evaluate(SHOWN).startswith(f"pixel {x},{y} shows"), "the nearest story is not shown")
    page.evaluate("document.querySelector('.ask button').focus()")
    if pages_test.tab_to(page, ".events button", failures):
        page.press("Enter")
        failures.check(page.evaluate("document.activeElement.getAttribute('aria-current')") == "step", "an event does not link to its step")


def check_pointer(page, failures):
    # The pointer is located in the last drawn frame: two frames after scrolling, that frame is current.
    page.evaluate("""(() => {
      document.querySelector('.drawing canvas').scrollIntoView({block: 'center', behavior: 'instant'});
      window.isScrolled = false;
      requestAnimationFrame(() => requestAnimationFrame(() => { window.isScrolled = true; }));
    })()""")
    until(page, "window.isScrolled")
    pixel = page.evaluate("(({x, y}) => [x, y])(csgsimDrawings[0].why.stories[1])")
    x, y = page.evaluate(f"""(() => {{
      const box = document.querySelector('.drawing canvas').getBoundingClientRect();
      return [box.left + box.width * ({pixel[0]} + 0.5) / csgsimDrawings[0].width, box.top + box.height * ({pixel[1]} + 1.5) / csgsimDrawings[0].height];
    }})()""")
    page.point(x, y, click=True)
    failures.check(page.evaluate(SHOWN).startswith(f"pixel {pixel[0]},{pixel[1]} shows"), "a click does not show the story of the nearest pixel")
    failures.check(page.evaluate("document.querySelector('.tip').textContent").startswith(f"{pixel[0]}, {pixel[1] + 1}: #"), "the tooltip does not name the pixel under the pointer")


def check_looks(page, failures):
    pages_test.check_names(page, failures)
    pages_test.check_windows(page, failures)
    pages_test.check_colours(page, failures)
    unnamed = page.evaluate("""[...document.querySelectorAll('button, input, select, canvas[tabindex]')].filter(element =>
        !element.textContent.trim() && !element.getAttribute('aria-label') && !element.closest('label')).map(element => element.outerHTML.slice(0, 120))""")
    failures.check(unnamed == [], f"elements without an accessible name: {unnamed}")
    page.window(pages_test.WIDE, 900)


def check_two(page, csgsim, path, failures):
    """The page of two machines: the counts equal those of each alone, and one click explains both."""
    failures.where = "two"
    done = subprocess.run([csgsim, "diff", *THESIS, "--machine-b", "pixel-planes-5", "--no-stories", "--report", path], text=True, capture_output=True)
    failures.check(done.returncode == 1 and os.path.exists(path), f"no page for two runs: {done.stderr}")
    data = {side: json.loads(subprocess.run([csgsim, "render", *THESIS, *machine, "--stats", "-"], check=True, text=True, capture_output=True).stdout)
            for side, machine in (("a", []), ("b", ["--machine", "pixel-planes-5"]))}
    page.open(path)
    pages_test.check_numbers(page, data, 30, failures)
    texts = page.evaluate("[...document.querySelectorAll('p')].map(element => element.textContent)")
    first, pictures = (next(line for line in done.stdout.split("\n") if part in line) for part in ("first instruction that differs", "the pictures differ"))
    failures.check(any(text.startswith(f"The first instruction that differs is {first.split()[0]}:") for text in texts), f"the first differing instruction is not shown: {texts[:6]}")
    differ = int(pictures.split(" differ at ")[1].split()[0].replace(",", ""))
    failures.check(any(f" differ at {differ:,} pixels" in text for text in texts), f"the number of differing pixels is not shown: {texts[:6]}")
    marked, others = page.evaluate(MARKED)
    found = page.evaluate("JSON.parse(document.querySelector('#data').textContent).difference.pixels")
    failures.check(0 < others <= found <= differ and marked == found, f"{others} pixels differ in colour, the page states {found} and marks {marked}, and {differ} differ in any way")
    pixel = pictures.split("first ")[1].strip(":")
    page.evaluate(f"document.dispatchEvent(new CustomEvent('pixel', {{detail: {{pixel: [{pixel}]}}}}))")
    shown = page.evaluate("[...document.querySelectorAll('.shows')].map(element => element.textContent)")
    failures.check(len(shown) == 2 and all(text.startswith(f"pixel {pixel} shows") for text in shown), f"not both runs are explained: {shown}")
    check_looks(page, failures)


def main():
    csgsim = os.path.abspath(sys.argv[1])
    chromium = browser.find()
    if chromium is None:
        print("skipped: Chromium is not installed; run ./setup.sh report-test")
        return 77
    failures = pages_test.Failures()
    failures.where = "story"
    os.chdir(sys.argv[2])
    page = browser.Browser(chromium)
    with tempfile.TemporaryDirectory() as folder:
        try:
            path = os.path.join(folder, "page.html")
            subprocess.run([csgsim, "render", *THESIS, "--report", path], check=True, stdout=subprocess.DEVNULL)
            page.window(pages_test.WIDE, 900)
            page.open(path)
            check_choices(page, failures)
            check_rows(page, failures)
            check_keys(page, failures)
            check_pointer(page, failures)
            check_looks(page, failures)
            check_two(page, csgsim, path, failures)
            pages_test.check_quiet(page, failures, harmless=["willReadFrequently"])  # caused by the test's reads
        finally:
            page.close()
    print(f"2 pages, {failures.count} failures")
    return 1 if failures.count else 0


if __name__ == "__main__":
    sys.exit(main())
