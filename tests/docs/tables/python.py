"""Output of the code in docs/python.md, run in a single Python process with the module."""

import re
import shlex

from runs import ROOT

PAGE = "docs/python.md"
DRIVER = """
import contextlib, sys
names = {}
for number, source in enumerate(sys.argv[2:]):
    with open(f"{sys.argv[1]}/{number}.txt", "w", encoding="utf-8") as file, contextlib.redirect_stdout(file):
        exec(source, names)
"""


def sources():
    """The page's blocks of Python, in order."""
    return re.findall(r"^```python\n(.*?)^```$", (ROOT / PAGE).read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)


def printed(figures, number):
    """The output of a block of the page."""
    command = shlex.join([str(figures.runs.build / "python/python3"), "-c", DRIVER])
    folder = figures.runs.run(f'{command} "$OUT" {shlex.join(sources())}').folder
    return "```\n" + (folder / f"{number}.txt").read_text(encoding="utf-8") + "```"
