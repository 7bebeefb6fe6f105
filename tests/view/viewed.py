"""The page of csgsim view in a headless Chromium, for tests."""

import contextlib
import json
import subprocess
import time

import browser


TOO_WIDE = """[...document.body.querySelectorAll('*')].filter(element => {
  const box = element.getBoundingClientRect();
  return box.width > 0 && box.right > innerWidth + 1 && !element.closest('.scroll, .told');
}).map(element => element.outerHTML.slice(0, 120))"""


@contextlib.contextmanager
def viewed(chromium, server, csgsim, folder):
    """The page of a server, open in a separate window. Ends both afterwards."""
    page = browser.Browser(chromium)
    try:
        page.window(1280, 900)
        yield Viewed(page, csgsim, folder)
    finally:
        page.close()
        server.stop()


class Viewed:
    """An open page, which counts failed checks."""

    def __init__(self, page, csgsim, folder):
        self.page = page
        self.csgsim = csgsim
        self.folder = folder
        self.failures = 0

    def open(self, server):
        self.page.window(1280, 900)
        self.page.send("Page.navigate", url=server.address)
        self.until("window.drawnPictures > 0 && document.getElementById('picture').naturalWidth > 0")
        self.settled()

    def check(self, holds, what):
        if not holds:
            self.failures += 1
            print("FAILED:", what)

    def evaluate(self, expression):
        return self.page.evaluate(expression)

    def until(self, expression, seconds=60):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if self.page.evaluate(expression):
                return
            time.sleep(0.02)
        raise RuntimeError(f"timeout waiting for: {expression}; {self.page.problems}")

    def settled(self):
        """Waits until all requests are answered and shown."""
        self.until("window.isAtRest()")

    def text(self, name):
        return self.page.evaluate(f"document.getElementById('{name}').textContent")

    def set(self, name, value, event="input"):
        self.page.evaluate(f"(() => {{ const e = document.getElementById('{name}'); e.value = {json.dumps(value)};"
                           f" e.dispatchEvent(new Event('{event}', {{bubbles: true}})); }})()")

    def click(self, selector):
        self.page.evaluate(f"document.querySelector({json.dumps(selector)}).click()")

    def after(self, counter, act):
        """Performs an action, and waits until a counter of the page has increased."""
        before = self.page.evaluate(f"window.{counter} || 0")
        act()
        self.until(f"(window.{counter} || 0) > {before}")
        self.settled()

    def counts(self):
        return dict(self.page.evaluate("[...document.querySelectorAll('#counts tr')].map(row => [row.cells[0].textContent, row.cells[1].textContent])"))

    def run(self, *words, **options):
        return subprocess.run([self.csgsim, *words], cwd=self.folder, check=True, text=True, capture_output=True, **options).stdout

    def stats_of_command(self):
        """The stats of the command that the page shows."""
        words = self.text("command").replace("csgsim", str(self.csgsim), 1) + " --stats - --progress none"
        return json.loads(subprocess.run(["bash", "-c", words], cwd=self.folder, check=True, text=True, capture_output=True).stdout)

    def check_same(self, what):
        stats = self.stats_of_command()
        rows = self.counts()
        self.check(rows["clocks until drawn"] == f"{stats['clocks']:,}", f"{what}: clocks {rows} {stats['clocks']}")
        self.check(rows["instructions"] == f"{stats['instructions']['total']:,}", f"{what}: instructions")
        for name, clocks in self.page.evaluate("[...document.querySelectorAll('#bill tr')].map(row => [row.cells[0].textContent, row.cells[1].textContent])"):
            self.check(clocks == f"{stats['by_purpose'][name.replace(' ', '_')]['clocks']:,}", f"{what}: {name}")

    def too_wide(self):
        """Elements that extend beyond the right edge of the window."""
        return self.page.evaluate(TOO_WIDE)

    def edit_the_source(self):
        """Enters another model, an incorrect one, and the first again."""
        source = self.evaluate("document.getElementById('source').value")
        self.set("source", "cube(size=[20,20,20],center=true);")
        self.settled()
        self.check(self.counts()["primitives, half-spaces"] == "1, 6", f"the edited source is drawn: {self.counts()}")
        self.set("source", "cube(size=[20,20,20],center=true);\nsphere(r=;")
        self.until("!document.getElementById('error').hidden")
        self.check(self.evaluate("document.getElementById('source').selectionStart === document.getElementById('source').selectionEnd"), "nothing is selected")
        self.check(self.evaluate("document.getElementById('fault-line').textContent") == "2", "the line of the error is marked")
        self.check("line 2" in self.text("fault-told"), "the line of the error is stated: " + self.text("fault-told"))
        self.set("source", source)
        self.until("document.getElementById('error').hidden")
        self.check(self.evaluate("document.getElementById('fault').hidden && document.getElementById('fault-line').hidden"), "no error is marked")
        self.settled()

    def types_through_errors(self):
        """Types slowly enough that each prefix is drawn or rejected: text and caret must be as typed."""
        source = self.evaluate("document.getElementById('source').value")
        typed = "cube(size=[20,20,20],center=true);\nsphere(r=12,$fn=24);\n"
        self.set("source", "")
        self.evaluate("document.getElementById('source').focus()")
        errors = 0
        for number, character in enumerate(typed):
            if character == "\n":
                self.page.send("Input.dispatchKeyEvent", type="char", text="\r")
            else:
                self.page.send("Input.dispatchKeyEvent", type="char", text=character)
            # Types some keys faster than they are drawn, and others only after the answer.
            if number % 3 == 0:
                time.sleep(0.3)
                self.settled()
                errors += self.evaluate("document.getElementById('fault-line').hidden ? 0 : 1")
            at = self.evaluate("(() => { const s = document.getElementById('source'); return [s.value, s.selectionStart, s.selectionEnd]; })()")
            if at != [typed[:number + 1], number + 1, number + 1]:
                self.check(False, f"typed text and caret are kept: {at}")
                break
        self.check(errors > 5, f"errors were marked meanwhile: {errors}")
        self.settled()
        self.check(self.counts()["primitives, half-spaces"].startswith("2, "), f"the typed text is drawn: {self.counts()}")
        self.set("source", source)
        self.settled()

    def jumps_to_an_error_when_asked(self):
        source = self.evaluate("document.getElementById('source').value")
        self.set("source", "cube(size=[20,20,20],center=true);\n\tsphere(r=;\n")
        self.until("!document.getElementById('fault-told').hidden")
        self.settled()
        at = self.evaluate("(() => { const f = document.getElementById('fault').getBoundingClientRect(), s = document.getElementById('source').getBoundingClientRect();"
                           " return [f.left - s.left, f.width, f.top - s.top, f.height]; })()")
        self.check(at[0] > 40 and at[1] > 4 and 10 < at[2] < 60 and at[3] > 10, f"the mark is under the second line: {at}")
        self.click("#fault-told")
        begin = self.evaluate("document.getElementById('source').selectionStart")
        self.check(begin > 35 and begin == self.evaluate("document.getElementById('source').selectionEnd"), f"a click on the message selects its place: {begin}")
        self.set("source", source)
        self.settled()
