#!/usr/bin/env python3
"""Checks the site of docs/book: it builds without a warning, its links and files exist, and its search finds pages.
Skips (77) without Sphinx."""

import html.parser
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

from runs import ROOT

BOOK = ROOT / "docs/book/book.py"
PYTHON = "/usr/bin/python3"  # Debian's Python, which finds Debian's Sphinx
MODULES = "import sphinx, furo, myst_parser"

sys.path.insert(0, str(BOOK.parent))
import order  # pylint: disable=wrong-import-position


class Names(html.parser.HTMLParser):
    """The links, loaded files and anchors of an HTML page."""

    def __init__(self, path):
        super().__init__()
        self.links, self.loaded, self.anchors = [], [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        self.anchors.update(attributes[key] for key in ("id", "name") if attributes.get(key))
        if tag == "a" and attributes.get("href"):
            self.links.append(attributes["href"])
        elif tag == "link" and attributes.get("rel") != "search" or tag in ("script", "img", "iframe", "source"):
            self.loaded += [attributes[key] for key in ("href", "src") if attributes.get(key)]


def is_elsewhere(target):
    return re.match(r"[a-z]+:|//", target) is not None


class Site(unittest.TestCase):
    """One site for all cases, because a build takes some ten seconds."""

    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory(prefix="csgsim-site-")
        cls.folder = pathlib.Path(cls.scratch.name) / "site"
        cls.built = subprocess.run([PYTHON, BOOK, "site", cls.folder], capture_output=True, text=True, check=False)
        cls.pages = {path: Names(path) for path in sorted(cls.folder.rglob("*.html"))}

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_builds_without_a_warning(self):
        self.assertEqual((self.built.returncode, self.built.stdout, self.built.stderr), (0, "", ""))

    def test_has_every_page_that_the_book_lists(self):
        for _, rows in order.parts():
            for path, _, _ in rows:
                page = self.folder / path.removeprefix("docs/").replace(".md", ".html")
                self.assertIn(page, self.pages)
        self.assertIn(self.folder / "index.html", self.pages)

    def test_links_lead_to_a_page_and_an_anchor(self):
        wrong = []
        for page, names in self.pages.items():
            for target in names.links:
                path, _, anchor = urllib.parse.unquote(target).partition("#")
                there = (page.parent / path.partition("?")[0]).resolve() if path else page
                if is_elsewhere(target):
                    continue
                if not there.is_file() or anchor and there in self.pages and anchor not in self.pages[there].anchors:
                    wrong.append(f"{page.relative_to(self.folder)}: {target}")
        self.assertEqual(wrong, [])

    def test_loads_only_existing_local_files(self):
        for page, names in self.pages.items():
            for target in names.loaded:
                self.assertFalse(is_elsewhere(target), f"{page}: {target}")
                self.assertTrue((page.parent / urllib.parse.unquote(target).partition("?")[0]).is_file(), f"{page}: {target}")
        for sheet in self.folder.rglob("*.css"):
            text = re.sub(r"/\*.*?\*/", "", sheet.read_text(encoding="utf-8"), flags=re.DOTALL)
            self.assertEqual(re.findall(r"""@import[^;]*|url\(["']?(?:https?:|/)[^)]*""", text), [], sheet.name)

    def test_scripts_are_not_modules(self):
        """Browsers load no modules from file://, from where the site may be read."""
        script = (self.folder / "_static/scripts/furo.js").read_text(encoding="utf-8")
        self.assertIn("Gumshoe", script)
        self.assertEqual(re.findall(r"(?m)^(?:import|export)\b.*", script), [])

    def test_the_search_index_lists_the_page_of_a_word(self):
        index = (self.folder / "searchindex.js").read_text(encoding="utf-8")
        index = json.loads(re.sub(r"(?<=[{,])(\w+):", r'"\1":', index.removeprefix("Search.setIndex(").rstrip(" );\n")))
        for word, page in (("multipli", "lessons"), ("quadric", "shapes"), ("kunii", None)):
            found = index["terms"].get(word, [])
            names = [index["docnames"][number] for number in (found if isinstance(found, list) else [found])]
            self.assertEqual(page in names, page is not None, f"{word}: {names}")

    def test_search_lists_the_main_page_of_a_subject_first(self):
        if shutil.which("node") is None:
            self.skipTest("there is no node")
        wanted = {"shadows": "effects.html", "pixel-planes-5": "machines/pixel-planes.html", "--z-bits": "command-line.html",
                  "alu.bits": "machines/pixel-planes.html", "quadrics": "numbers.html", "security": "install.html", "rerun": "settings.html", "kunii": None}
        script = (f"{(self.folder / '_static/search-data.js').read_text(encoding='utf-8')}\n"
                  f"const {{ search }} = require({json.dumps(str(self.folder / '_static/search.js'))});\n"
                  f"console.log(JSON.stringify({json.dumps(list(wanted))}.map((query) => search(pages, query).map((one) => one.page.path)[0] || null)));")
        found = subprocess.run(["node", "-"], input=script, capture_output=True, text=True, check=True).stdout
        self.assertEqual(dict(zip(wanted, json.loads(found))), wanted)


if __name__ == "__main__":
    if subprocess.run([PYTHON, "-c", MODULES], capture_output=True, check=False).returncode != 0:
        print("Sphinx with furo and myst-parser is not installed; run ./setup.sh site")
        sys.exit(77)
    unittest.main()
