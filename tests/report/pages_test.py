"""Opens pages of csgsim --report in a headless Chromium: with a pointer, with keys alone, in a wide and in a narrow
window, light and dark, and without scripts.

Usage: pages_test.py CSGSIM SOURCE_FOLDER. Exit code 77 without Chromium."""

import base64
import json
import os
import re
import subprocess
import sys
import tempfile

import browser

WIDE, NARROW = 1280, 390

# Each table cell that names the place of its value in the stats, as [pointer, text].
CELLS = "[...document.querySelectorAll('[data-at]')].map(cell => [cell.dataset.at, cell.textContent, cell.title])"

# Elements that extend beyond the window, except inside boxes that scroll or hide them.
TOO_WIDE = """[...document.body.querySelectorAll('*')].filter(element => {
  const box = element.getBoundingClientRect();
  return box.width > 0 && box.right > innerWidth + 1 && !element.closest('.scroll, .told, svg');
}).map(element => element.outerHTML.slice(0, 120))"""

PALETTE = """['page', 'text', 'faint', 'link', 'mark', ...Array.from({length: 8}, (_, i) => 's' + i)].map(
  name => getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim())"""

# The outline of each mark and each part of a bar, as #rrggbb.
OUTLINES = """[...document.querySelectorAll('.marks .pt > :not(title), .fills .pt > :not(title)')].map(mark => '#' + getComputedStyle(mark).stroke.match(/\\d+/g).map(
  part => Number(part).toString(16).padStart(2, '0')).join(''))"""


class Failures:
    def __init__(self):
        self.count = 0
        self.where = ""

    def check(self, holds, what):
        if not holds:
            self.count += 1
            print(f"FAILED, {self.where}: {what}")


def value_at(data, pointer):
    for part in pointer.split("/")[1:]:
        part = part.replace("~1", "/").replace("~0", "~")
        data = data[int(part)] if isinstance(data, list) else data[part]
    return data


def number_in(text):
    return float(re.sub(r"[ ,%]", "", text))


def same_number(text, title, value):
    if isinstance(value, int):
        return text.replace(",", "") == str(value)
    if title:
        return float(title) == value
    shown = number_in(text)
    return abs(shown / 100 - value) <= 0.0005 + 1e-9 if "%" in text else shown == value


def check_numbers(page, stats, least, failures):
    cells = page.evaluate(CELLS)
    numbers = 0
    for pointer, text, title in cells:
        value = value_at(stats, pointer)
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            continue
        numbers += 1
        failures.check(same_number(text, title, value), f"{pointer} is {value} and is shown as {text!r} ({title!r})")
    failures.check(numbers >= least, f"only {numbers} numbers of the stats are shown")


def check_windows(page, failures):
    for width in (WIDE, NARROW):
        for dark in (False, True):
            page.window(width, 900, dark)
            failures.check(page.evaluate("document.documentElement.scrollWidth") <= width, f"scrolls sideways at {width}")
            for element in page.evaluate(TOO_WIDE):
                failures.check(False, f"wider than {width} pixels: {element}")


def luminance(colour):
    channels = [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def lightness(colour):
    y = luminance(colour)
    return 116 * y ** (1 / 3) - 16 if y > 0.008856 else 903.3 * y


def contrast(a, b):
    low, high = sorted((luminance(a), luminance(b)))
    return (high + 0.05) / (low + 0.05)


def check_colours(page, failures):
    """Contrast required by WCAG 2.1: of texts, of the focus, and of marks by their outlines. Series differ in grey."""
    for dark in (False, True):
        page.window(WIDE, 900, dark)
        ground, text, faint, link, focus, *series = page.evaluate(PALETTE)
        for colour in (text, faint, link):
            failures.check(contrast(colour, ground) >= 4.5, f"{colour} on {ground}: contrast below 4.5")
        for colour in {focus, *page.evaluate(OUTLINES)}:
            failures.check(contrast(colour, ground) >= 3, f"{colour} on {ground}: contrast below 3")
        greys = sorted(lightness(colour) for colour in series)
        gap = min(b - a for a, b in zip(greys, greys[1:]))
        failures.check(gap >= 6, f"two series differ by {gap:.1f} in lightness only, dark: {dark}")


def focused(page, what):
    return page.evaluate(f"document.activeElement.matches({json.dumps(what)})")


def tab_to(page, what, failures):
    """Presses Tab until a matching element has the focus, which must be visible."""
    for _ in range(80):
        page.press("Tab")
        if focused(page, what):
            seen = page.evaluate("getComputedStyle(document.activeElement).outlineStyle") != "none"
            failures.check(seen, f"{what} does not show that it has the focus")
            return True
    failures.check(False, f"the tab key does not reach {what}")
    return False


def check_keys_of_render(page, stats, failures):
    dearest = sorted(stats["by_primitive"], key=lambda one: -one["clocks"])
    if tab_to(page, "tr[data-p] button", failures):
        page.press("Enter")
        told = page.evaluate("document.querySelector('.price').textContent")
        failures.check(f"{dearest[0]['clocks']:,}" in told, f"the cost of the most expensive primitive is not shown: {told!r}")
        page.press("ArrowDown")
        told = page.evaluate("document.querySelector('#told').textContent")
        failures.check(f"clocks {dearest[1]['clocks']:,}" in told, f"the next primitive is not shown: {told!r}")
    if tab_to(page, "input[type=range]", failures):
        page.press("Home")
        first = page.evaluate("document.querySelector('.state').textContent")
        failures.check("0 instructions" in first, f"Home does not go to the first step: {first!r}")
        page.press("ArrowRight")
        page.press("ArrowRight")
        failures.check("Step 2 of" in page.evaluate("document.querySelector('.state').textContent"), "arrow keys do not step")
        page.press("End")
        last = page.evaluate("document.querySelector('.state').textContent")
        every = stats["instructions"]["total"] + stats["instructions"]["skipped"]
        failures.check(f"{every:,} instructions" in last, f"End does not go to the last step: {last!r}")


DRAWN_DIFFERENCE = """(async () => {
  const image = document.querySelector('.shown img');
  await image.decode();
  const canvas = document.createElement('canvas');
  canvas.width = image.naturalWidth;
  canvas.height = image.naturalHeight;
  const context = canvas.getContext('2d');
  context.drawImage(image, 0, 0);
  document.querySelector('.drawing input[type=checkbox]').click();
  const drawn = document.querySelector('.drawing canvas').getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
  const picture = context.getImageData(0, 0, canvas.width, canvas.height).data;
  return picture.reduce((sum, value, i) => sum + (value === drawn[i] ? 0 : 1), 0);
})()"""


def check_pointer_of_render(page, stats, failures):
    failures.check(page.evaluate(DRAWN_DIFFERENCE) == 0, "the last step of the drawing differs from the picture")
    x, y = page.evaluate("""(() => {
      scrollTo(0, 0);
      const box = document.querySelector('.stage canvas').getBoundingClientRect();
      return [box.left + box.width / 2, box.top + box.height / 2];
    })()""")
    page.point(x, y, click=True)
    chosen = page.evaluate("Number(document.querySelector('tr.chosen')?.dataset.p ?? -1)")
    failures.check(chosen >= 0, "a click on the picture selects no primitive")
    if chosen >= 0:
        told = page.evaluate("document.querySelector('.price').textContent")
        failures.check(f"{stats['by_primitive'][chosen]['clocks']:,}" in told, f"the cost of another primitive is shown: {told!r}")
    failures.check(page.evaluate("!document.querySelector('.tip').hidden"), "pointing at the picture shows no tooltip")


# Texts of a plot that overlap or leave it, with the installed fonts, and marks that leave it.
MISPLACED = """[...document.querySelectorAll('svg.plot')].flatMap(svg => {
  const frame = svg.getBoundingClientRect();
  const isOut = box => box.left < frame.left - 1 || box.right > frame.right + 1 || box.top < frame.top - 1 || box.bottom > frame.bottom + 1;
  const texts = [...svg.querySelectorAll('text')].map(text => [text.textContent, text.getBoundingClientRect()]);
  const meet = (a, b) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1;
  const marks = [...svg.querySelectorAll('.pt')].map(mark => ['a mark', mark.getBoundingClientRect()]);
  return [...texts, ...marks].filter(([_, box]) => isOut(box)).map(([text]) => text + ' leaves the plot').concat(
    texts.flatMap(([text, box], i) => texts.slice(0, i).filter(([_, other]) => meet(box, other)).map(([other]) => text + ' is over ' + other)));
})"""


def check_plots(page, failures):
    """Each plot is visible as a whole, if necessary by scrolling; its texts are separate, and it is readable without
    colours."""
    for width in (WIDE, NARROW):
        page.window(width, 900)
        for problem in page.evaluate(MISPLACED):
            failures.check(False, f"{problem}, at {width} pixels")
        small = page.evaluate("Math.min(...[...document.querySelectorAll('svg.plot')].map(svg => svg.getScreenCTM().a * 14))")
        failures.check(small >= 10, f"letters of a plot are {small:.1f} pixels high at {width}")
        failures.check(page.evaluate("[...document.querySelectorAll('svg.plot')].every(svg => svg.closest('.scroll').scrollWidth >= svg.getBoundingClientRect().width - 1)"),
                       f"what of a plot is beside the window cannot be scrolled to at {width}")
    failures.check(page.evaluate("document.querySelectorAll('svg.plot .pt').length") > 0, "no plot has a mark")
    failures.check(page.evaluate("[...document.querySelectorAll('svg.plot')].every(svg => svg.getAttribute('aria-label') && svg.getAttribute('role'))"),
                   "a plot without a text for screen readers")
    page.window(WIDE, 900)


# The share by which the PNG and the SVG of a plot differ, 0 to 1, in fields of 8 x 8 pixels, so that the shapes of
# letters do not matter.
PICTURE_DIFFERENCE = """(async (png, svg) => {
  const fields = async url => {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = document.createElement('canvas');
    canvas.width = Math.ceil(image.naturalWidth / 8);
    canvas.height = Math.ceil(image.naturalHeight / 8);
    const context = canvas.getContext('2d');
    context.imageSmoothingQuality = 'high';
    context.drawImage(image, 0, 0, canvas.width, canvas.height);
    return [image.naturalWidth, image.naturalHeight, ...context.getImageData(0, 0, canvas.width, canvas.height).data];
  };
  const [a, b] = [await fields(png), await fields(svg)];
  if (a.length !== b.length || a[0] !== b[0] || a[1] !== b[1]) return 1;
  let ink = 0;
  let differs = 0;
  for (let i = 2; i < a.length; ++i) {
    ink += Math.max(255 - a[i], 255 - b[i]);
    differs += Math.max(0, Math.abs(a[i] - b[i]) - 24);
  }
  return differs / ink;
})"""


def data_url(path, kind):
    with open(path, "rb") as file:
        return f"data:image/{kind};base64,{base64.b64encode(file.read()).decode()}"


def check_files_of_plots(page, folder, failures):
    """gnuplot's picture of each plot equals that of its SVG, and of no other plot's."""
    names = sorted(name[:-4] for name in os.listdir(folder) if name.endswith(".svg"))
    failures.check(len(names) >= 2, "fewer than two plots are drawn")

    def difference(one, other):
        urls = json.dumps([data_url(os.path.join(folder, one + ".png"), "png"), data_url(os.path.join(folder, other + ".svg"), "svg+xml")])
        return page.evaluate(f"{PICTURE_DIFFERENCE}(...{urls})")

    for i, name in enumerate(names):
        own, others = difference(name, name), difference(name, names[i - 1])
        failures.check(own < 0.2, f"{name}.png and {name}.svg differ by {own:.3f}")
        failures.check(others > 1.5 * own, f"{name}.png is as close to {names[i - 1]}.svg ({others:.3f}) as to its own ({own:.3f})")


def check_keys_of_plots(page, failures):
    if tab_to(page, "svg.plot", failures):
        titles = page.evaluate("document.activeElement.closest('figure').querySelectorAll('tbody tr').length")
        failures.check(titles > 0, "a plot has no table of values")
        page.press("ArrowRight")
        told = page.evaluate("document.querySelector('#told').textContent")
        failures.check(told != "" and told in page.evaluate("document.querySelector('.tip').textContent"), "a point does not show its values")


def check_without_scripts(page, path, least, failures):
    page.send("Emulation.setScriptExecutionDisabled", value=True)
    page.send("Page.navigate", url="file://" + os.path.abspath(path))
    while page.evaluate("document.readyState") != "complete":
        pass
    has_pictures = not page.evaluate("document.title").startswith("Cost of many models")
    is_study = page.evaluate("document.querySelectorAll('figure.plots').length") > 0
    for what in ("table", "h2", *(["img"] if has_pictures else []), *(["svg.plot .pt title"] if is_study else [])):
        failures.check(page.evaluate(f"document.querySelectorAll('{what}').length") > 0, f"without scripts there is no {what}")
    failures.check(page.evaluate("document.querySelectorAll('[data-at]').length") >= least, "without scripts there are fewer numbers")
    page.send("Emulation.setScriptExecutionDisabled", value=False)


def check_names(page, failures):
    """Texts for screen readers."""
    failures.check(page.evaluate("[...document.images].every(image => image.alt)"), "an image without alternative text")
    failures.check(page.evaluate("[...document.querySelectorAll('table')].every(table => table.tHead && table.querySelector('th[scope=col]'))"),
                   "a table without headers")
    failures.check(page.evaluate("new Set([...document.querySelectorAll('[id]')].map(one => one.id)).size === document.querySelectorAll('[id]').length"),
                   "two elements with the same id")


def check_quiet(page, failures, harmless=()):
    """The page requests nothing from elsewhere, and the console has only problems with a harmless word."""
    elsewhere = [url for url in page.requests if not url.startswith(("file:", "data:"))]
    failures.check(not elsewhere, f"the page requests {elsewhere}")
    for problem in page.problems:
        failures.check(any(word in problem for word in harmless), problem)


def main():
    csgsim, source = (os.path.abspath(argument) for argument in sys.argv[1:3])
    chromium = browser.find()
    if chromium is None:
        print("skipped: Chromium is not installed; run ./setup.sh report-test")
        return 77
    model = os.path.join(source, "tests/models/carburettor.csg")
    view = [model, "--camera", "220,-255,135,2,0,5"]
    small = view + ["--size", "64x64"]
    pages = [("render", ["render", *view, "--stats", "render.json"], "render.json"),
             ("render of parts", ["render", *small, "--machine", "pixel-square", "--stats", "parts.json"], "parts.json"),
             ("sweep", ["sweep", *small, "--stack-bits", "3..5", "--pruning", "all,none", "-o", "."], "sweep.json"),
             ("accuracy", ["accuracy", *small, "--views", "1", "--no-plots", "-o", "."], "accuracy.json"),
             ("compare", ["compare", *small, "--machines", "pixel-planes-4,scan-line", "--sides", "32", "--fragments", "8", "--no-plots", "-o", "."], "compare.json"),
             ("advise", ["advise", *small, "--z-bits", "12,16,20", "--fraction-bits", "2,6", "--alu-bits", "1,4", "--no-plots", "-o", "."], "advise.json"),
             ("corpus", ["corpus", *small, os.path.join(source, "tests/models/old_example011.csg"), "--machines", "pixel-planes-4,scan-line", "--no-plots", "-o", "."], "corpus.json"),
             ("effects", ["effects", *small, "--scene", os.path.join(source, "tests/scenes/depth_cue.toml"), "--memory-bits", "128", "-o", "."], "effects.json")]
    failures = Failures()
    with tempfile.TemporaryDirectory() as folder:
        page = browser.Browser(chromium)
        try:
            for name, words, file in pages:
                failures.where = name
                subprocess.run([csgsim, *words, "--report", "page.html"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
                path = os.path.join(folder, "page.html")
                with open(os.path.join(folder, file), encoding="utf-8") as opened:
                    stats = json.load(opened)
                page.window(WIDE, 900)
                page.open(path)
                least = 20 if name.startswith("render") else 8
                check_numbers(page, stats, least, failures)
                check_names(page, failures)
                if name.startswith("render"):
                    check_keys_of_render(page, stats, failures)
                    check_pointer_of_render(page, stats, failures)
                else:
                    check_keys_of_plots(page, failures)
                    check_plots(page, failures)
                if name == "sweep":
                    check_files_of_plots(page, folder, failures)
                check_windows(page, failures)
                check_colours(page, failures)
                check_without_scripts(page, path, least, failures)
                check_quiet(page, failures)
                page.problems.clear()
        finally:
            page.close()
    print(f"{len(pages)} pages, {failures.count} failures")
    return 1 if failures.count else 0


if __name__ == "__main__":
    sys.exit(main())
