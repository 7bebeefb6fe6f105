"""What pages of --report tell of pixels and show of fields, held against `csgsim explain` and `csgsim view`; and the page
of two runs. In a headless Chromium, with the pointer and with keys.

Usage: story_test.py CSGSIM SOURCE_FOLDER. Exit code 77 where there is no Chromium."""

import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time

import browser
import pages_test
import random_program
import stories

SOURCE = pathlib.Path(sys.argv[2]).resolve()
sys.path.insert(0, str(SOURCE / "tests/view"))

from server import Server  # noqa: E402

CARBURETTOR = ["tests/models/carburettor.csg", "--camera", "220,-255,135,2,0,5"]
THESIS = ["tests/models/thesis_fig_2_3.csg"]
CASES = [[*CARBURETTOR, "--size", "48x48"],
         [*CARBURETTOR, "--size", "48x48", "--machine", "pixel-square"],
         [*THESIS, "--size", "64x48"],
         [*THESIS, "--size", "64x48", "--machine", "pixel-planes-5", "--projection", "perspective", "--colour-bits", "13"]]
PIXELS = 8  # of each kind and case: at random, and at edges

# Pixels whose left neighbour shows another colour, of the last step.
EDGES = """(() => {
  const {states, width} = csgsimDrawings[0];
  return [...states.keys()].filter(at => at % width > 0 && states[at] >> 1 !== states[at - 1] >> 1).map(at => [at % width, Math.floor(at / width)]);
})()"""

# How many pixels of the drawing's canvas differ from a picture.
DIFFERENT = """(async url => {
  const image = new Image();
  image.src = url;
  await image.decode();
  const {canvas, width, height} = csgsimDrawings[0];
  const other = document.createElement('canvas');
  Object.assign(other, {width, height});
  const context = other.getContext('2d');
  context.drawImage(image, 0, 0);
  const [a, b] = [canvas.getContext('2d'), context].map(each => new Uint32Array(each.getImageData(0, 0, width, height).data.buffer));
  return image.naturalWidth === width ? a.reduce((count, pixel, i) => count + (pixel === b[i] ? 0 : 1), 0) : -1;
})"""

# In the gallery of two runs: pixels of the third picture that are no grey, and those of other colours in the first two.
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
            raise RuntimeError(f"never came: {expression}; {page.problems}")
        time.sleep(0.02)


def plain(value):
    """Whole numbers that JavaScript writes as text are numbers, blanks do not matter."""
    if isinstance(value, dict):
        return {key: plain(one) for key, one in value.items()}
    if isinstance(value, list):
        return [plain(one) for one in value]
    if isinstance(value, str):
        return int(value) if value.lstrip("-").isdigit() else " ".join(value.split())
    return value


def first_difference(one, other):
    for a, b in zip(one, other):
        if a != b:
            return f"{a!r} for {b!r}"
    return f"{len(one)} lines for {len(other)}"


def check_story(page, csgsim, words, pixel, failures):
    told, lines = stories.explained(csgsim, words, pixel)
    expected = plain(stories.of_explain(told))
    found = plain(json.loads(page.evaluate(f"JSON.stringify({stories.STORY}({pixel[0]}, {pixel[1]}))")))
    for key, value in expected.items():
        failures.check(found[key] == value, f"{pixel}, {key}: {found[key]!r} for {value!r}"[:600])
    page.evaluate(f"document.dispatchEvent(new CustomEvent('pixel', {{detail: [{pixel[0]}, {pixel[1]}]}}))")
    shown = page.evaluate(stories.SHOWN)
    failures.check(shown == lines, f"{pixel} is shown otherwise: {first_difference(shown, lines)}")
    return told


def check_why_not(page, csgsim, words, pixel, primitive, failures):
    _, lines = stories.explained(csgsim, words, pixel, "--why-not", f"p{primitive}")
    page.evaluate(f"csgsimDrawings[0].why.whyNot.value = {primitive}; csgsimDrawings[0].ask({pixel[0]}, {pixel[1]})")
    shown = page.evaluate(stories.SHOWN)
    failures.check(shown == lines, f"why not p{primitive} at {pixel}: {first_difference(shown, lines)}")
    page.evaluate("csgsimDrawings[0].why.whyNot.value = ''")


def check_links(page, failures):
    """Each event leads to the first step that has carried it out."""
    for text, step in page.evaluate("""[...document.querySelectorAll('.events button')].map(button => {
        button.click();
        return [button.textContent, csgsimDrawings[0].now, button.getAttribute('aria-current')];
    }).map(([text, step, current]) => current === 'step' ? [text, step] : [text, -1])"""):
        last = int(text.split("i")[-1])
        failures.check(step > 0, f"{text} leads nowhere")
        before, after = page.evaluate(f"[csgsimDrawings[0].steps[{step} - 1][0], csgsimDrawings[0].steps[{step}][0]]")
        failures.check(before <= last < after, f"{text} leads to the step of {after} instructions, after that of {before}")


def check_fields(page, server, words, rng, failures):
    """At three steps each field is the picture that csgsim view has of it there, tinted by nobody."""
    knobs = {name.removeprefix("--"): value for name, value in zip(words[1::2], words[2::2])}
    count = page.evaluate("csgsimDrawings[0].steps.length")
    names = page.evaluate("csgsimDrawings[0].fields.map(field => field.name)")
    failures.check({"E", "Z1", "Z2", "mask"} <= set(names), f"the fields are {names}")
    for step in (count - 1, rng.randrange(1, count - 1), rng.randrange(1, count - 1)):
        page.evaluate(f"(() => {{ const d = csgsimDrawings[0]; d.tint.checked = false; d.goTo({step}); }})()")
        number = page.evaluate("csgsimDrawings[0].steps[csgsimDrawings[0].now][0]")
        for i, name in enumerate(names):
            page.evaluate(f"(() => {{ const d = csgsimDrawings[0]; d.field.value = {i}; d.field.dispatchEvent(new Event('change')); }})()")
            until(page, "!document.querySelector('.drawing').hasAttribute('aria-busy')")
            status, instant = server.post("instant", {"knobs": knobs, "number": number, "field": name})
            failures.check(status == 200 and instant["number"] == number, f"csgsim view has no instant {number}")
            differ = page.evaluate(f"{DIFFERENT}({json.dumps(instant['picture'])})")
            failures.check(differ == 0, f"{name} after {number} instructions differs at {differ} pixels")
            scale = page.evaluate("document.querySelector('.scale').textContent").replace(",", "").removeprefix(name + ": ")
            failures.check(scale == instant["scale"].replace(",", ""), f"{name}: {scale!r} for {instant['scale']!r}")
    page.evaluate("(() => { const d = csgsimDrawings[0]; d.field.value = ''; d.tint.checked = true; d.goTo(0); })()")


def check_keys(page, csgsim, words, failures):
    """By keys alone: the cursor moves, Enter asks, and the form does."""
    page.evaluate("document.activeElement.blur(); csgsimDrawings[0].moveTo(20, 20)")
    if not pages_test.tab_to(page, ".drawing canvas", failures):
        return
    for key in ("ArrowRight", "ArrowDown", "ArrowDown"):
        page.press(key)
    told = page.evaluate("document.querySelector('#told').textContent")
    failures.check(told.startswith("21, 22: #"), f"the cursor is not told: {told!r}")
    page.press("Enter")
    _, lines = stories.explained(csgsim, words, (21, 22))
    failures.check(page.evaluate(stories.SHOWN) == lines, "Enter does not ask for the pixel under the cursor")
    failures.check(lines[0] in page.evaluate("document.querySelector('#told').textContent"), "the story is not told to who does not see it")
    if pages_test.tab_to(page, ".ask input", failures):
        page.evaluate("document.activeElement.value = '3, 4'")
        page.press("Enter")
        failures.check(page.evaluate(stories.SHOWN)[0].startswith("pixel 3,4 shows"), "the form does not ask")
        page.evaluate("document.activeElement.value = '3,4000'")
        page.press("Enter")
        failures.check("there is no pixel 3,4000" in page.evaluate("document.querySelector('.story').textContent"), "a pixel that there is not is not refused")
    if pages_test.tab_to(page, ".ask button", failures):
        page.evaluate("csgsimDrawings[0].ask(21, 22)")
    if pages_test.tab_to(page, ".events button", failures):
        page.press("Enter")
        failures.check(page.evaluate("document.activeElement.getAttribute('aria-current')") == "step", "an event is no link to its step")


def check_pointer(page, failures):
    # What is under the pointer is looked up where the last drawn frame has it: two frames after scrolling it is drawn.
    page.evaluate("""(() => {
      document.querySelector('.drawing canvas').scrollIntoView({block: 'center', behavior: 'instant'});
      window.isScrolled = false;
      requestAnimationFrame(() => requestAnimationFrame(() => { window.isScrolled = true; }));
    })()""")
    until(page, "window.isScrolled")
    x, y = page.evaluate("""(() => {
      const box = document.querySelector('.drawing canvas').getBoundingClientRect();
      return [box.left + box.width * 30.5 / csgsimDrawings[0].width, box.top + box.height * 10.5 / csgsimDrawings[0].height];
    })()""")
    page.point(x, y, click=True)
    failures.check(page.evaluate(stories.SHOWN)[0].startswith("pixel 30,10 shows"), "a click does not ask for the pixel under it")
    failures.check(page.evaluate("document.querySelector('.tip').textContent").startswith("30, 10: #"), "the pixel under the pointer is not told")


def check_looks(page, failures):
    pages_test.check_names(page, failures)
    pages_test.check_windows(page, failures)
    pages_test.check_colours(page, failures)
    unnamed = page.evaluate("""[...document.querySelectorAll('button, input, select, canvas[tabindex]')].filter(element =>
        !element.textContent.trim() && !element.getAttribute('aria-label') && !element.closest('label')).map(element => element.outerHTML.slice(0, 120))""")
    failures.check(unnamed == [], f"without a name for who does not see them: {unnamed}")
    page.window(pages_test.WIDE, 900)


def check_run(page, csgsim, words, folder, failures):
    rng = random.Random(" ".join(words))
    path = os.path.join(folder, "run.html")
    subprocess.run([csgsim, "render", *words, "--report", path], cwd=SOURCE, check=True, stdout=subprocess.DEVNULL)
    page.window(pages_test.WIDE, 900)
    page.open(path)
    until(page, "document.querySelectorAll('.why').length === 1")
    width, height, primitives = page.evaluate("(({width, height, primitives}) => [width, height, primitives.length])(csgsimDrawings[0].program)")
    pixels = [(rng.randrange(width), rng.randrange(height)) for _ in range(PIXELS)] + rng.sample(page.evaluate(EDGES), PIXELS)
    fates = set()
    for pixel in pixels:
        told = check_story(page, csgsim, words, pixel, failures)
        fates |= {one["fate"] for one in told["surfaces"]}
    failures.check({"seen", "outside"} <= fates, f"no more fates than {fates}")
    for pixel in pixels[-3:]:
        check_why_not(page, csgsim, words, pixel, rng.randrange(primitives), failures)
    check_story(page, csgsim, words, pixels[-1], failures)
    check_links(page, failures)
    server = Server(csgsim, *words, cwd=SOURCE)
    try:
        check_fields(page, server, words, rng, failures)
    finally:
        server.stop()


def check_instructions(page, csgsim, folder, failures):
    """Programs of all instructions at random, which a page of two runs holds."""
    path, subject = os.path.join(folder, "two.html"), os.path.join(folder, "random.csgt")
    machine = ["--machine", "pixel-planes-4", "--set", "evaluator.degree=2", "--set", "array.memory_bits=96"]
    names = set()
    for seed in range(4):
        failures.where = f"instructions {seed}"
        pathlib.Path(subject).write_text(random_program.text_of(seed), encoding="utf-8")
        subprocess.run([csgsim, "diff", subject, subject, *machine, "--report", path], check=True, stdout=subprocess.DEVNULL)
        page.open(path)
        until(page, "document.querySelectorAll('.why').length === 2")
        for pixel in ((0, 0), (7, 5), (2, 3), (5, 1), (4, 4)):
            told = check_story(page, csgsim, [subject, *machine], pixel, failures)
            failures.check(len(told["events"]) > 20, "there are few events")
        names |= set(page.evaluate("csgsimDrawings[0].program.segments[0].instructions.map(instruction => instruction.opcode)"))
    failures.check(names == set(page.evaluate("Object.keys(csgsimDrawings[0].program.opcodes)")), f"instructions are missing, there are {names}")


def check_two(page, csgsim, folder, failures):
    """The page of two machines: the counts are those of each alone, and one click asks both."""
    failures.where = "two"
    path = os.path.join(folder, "two.html")
    size = ["--size", "48x40"]
    done = subprocess.run([csgsim, "diff", *THESIS, *size, "--machine-b", "pixel-planes-5", "--no-stories", "--report", path], cwd=SOURCE, text=True, capture_output=True)
    failures.check(done.returncode == 1 and os.path.exists(path), f"no page of two: {done.stderr}")
    data = {side: json.loads(subprocess.run([csgsim, "render", *THESIS, *size, *machine, "--stats", "-"], cwd=SOURCE, check=True, text=True, capture_output=True).stdout)
            for side, machine in (("a", []), ("b", ["--machine", "pixel-planes-5"]))}
    page.window(pages_test.WIDE, 900)
    page.open(path)
    until(page, "document.querySelectorAll('.why').length === 2")
    pages_test.check_numbers(page, data, 30, failures)
    texts = page.evaluate("[...document.querySelectorAll('p')].map(element => element.textContent)")
    first, pictures = (next(line for line in done.stdout.split("\n") if part in line) for part in ("another instruction", "the pictures differ"))
    failures.check(any(text.startswith(f"The first instruction that differs is {first.split()[0]}:") for text in texts), f"the first other instruction is not told: {texts[:6]}")
    differ = int(pictures.split(" differ at ")[1].split()[0].replace(",", ""))
    failures.check(any(f" differ at {differ:,} pixels" in text for text in texts), f"how many pixels differ is not told: {texts[:6]}")
    marked, others = page.evaluate(MARKED)
    found = page.evaluate("JSON.parse(document.querySelector('#data').textContent).difference.pixels")
    failures.check(0 < others <= found <= differ and marked == found, f"{others} pixels have another colour, {found} are said to differ, {marked} are marked, {differ} differ in any way")
    page.evaluate("document.dispatchEvent(new CustomEvent('pixel', {detail: [20, 20]}))")
    shown = page.evaluate("[...document.querySelectorAll('.shows')].map(element => element.textContent)")
    failures.check(len(shown) == 2 and all(text.startswith("pixel 20,20 shows") for text in shown), f"not both are asked: {shown}")
    check_looks(page, failures)


def main():
    csgsim = os.path.abspath(sys.argv[1])
    chromium = browser.find()
    if chromium is None:
        print("skipped: there is no Chromium here; ./setup.sh report-test installs it")
        return 77
    failures = pages_test.Failures()
    page = browser.Browser(chromium)
    with tempfile.TemporaryDirectory() as folder:
        try:
            for words in CASES:
                failures.where = " ".join(words)
                os.chdir(SOURCE)
                check_run(page, csgsim, words, folder, failures)
            check_keys(page, csgsim, CASES[-1], failures)
            check_pointer(page, failures)
            check_looks(page, failures)
            check_instructions(page, csgsim, folder, failures)
            check_two(page, csgsim, folder, failures)
            pages_test.check_quiet(page, failures, harmless=["willReadFrequently"])  # it is the test that reads
        finally:
            page.close()
    print(f"{len(CASES)} runs, {failures.count} failures")
    return 1 if failures.count else 0


if __name__ == "__main__":
    sys.exit(main())
