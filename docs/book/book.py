#!/usr/bin/env python3
"""Builds a site and a PDF from README.md and the pages of docs/, in the order of docs/book/order.toml.

    docs/book/book.py site OUT    OUT/index.html and its files, by Sphinx
    docs/book/book.py pdf OUT     OUT.pdf of the site in OUT, by WeasyPrint"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

import paper
import search
from order import parts

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
LINK = re.compile(r"(?P<before>\]\(|src=\")(?P<path>[^)#\s\":]+)(?P<after>[)#\"])")
FENCE = re.compile(r"^\s*```")


def is_page(path):
    return path == "README.md" or path.startswith("docs/") and path.endswith(".md")


def place(path):
    """The path of a file in the site's source; files other than pages and pictures are copied to files/."""
    if path == "README.md":
        return "index.md"
    if is_page(path) or path.startswith("docs/pictures/"):
        return path.removeprefix("docs/")
    return f"files/{path}" + (".txt" if path.endswith(".md") else "")


class Source:
    """The site's source: pages with the links of the site."""

    def __init__(self, folder):
        self.folder = folder

    def link(self, page, target):
        """The link from a page to a file of the repository; a file that is not a page is copied."""
        path = os.path.normpath(os.path.join(os.path.dirname(page), target))
        if not is_page(path) and (ROOT / path).is_file():
            there = self.folder / place(path)
            there.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / path, there)
        return os.path.relpath(place(path), os.path.dirname(place(page)) or ".")

    def text(self, page):
        """The page with links to other files rewritten, except in code, and with one title: further ones become headings."""
        lines, fenced, has_title = [], False, False
        for line in (ROOT / page).read_text(encoding="utf-8").splitlines():
            fenced ^= bool(FENCE.match(line))
            if not fenced and not line.startswith("    "):
                line = LINK.sub(lambda found: found["before"] + self.link(page, found["path"]) + found["after"], line)
            if not fenced and line.startswith("# "):
                line, has_title = "#" * has_title + line, True
            lines.append(line)
        return "\n".join(lines) + "\n"

    def write(self, page, more=""):
        there = self.folder / place(page)
        there.parent.mkdir(parents=True, exist_ok=True)
        there.write_text(self.text(page) + more, encoding="utf-8")


def contents():
    """The table of contents for Sphinx, shown in the sidebar."""
    text = ""
    for name, pages in parts():
        rows = "\n".join(f"{title} <{place(path).removesuffix('.md')}>" for path, title, _ in pages)
        text += f"\n```{{toctree}}\n:hidden:\n:caption: {name}\n\n{rows}\n```\n"
    return text


def site(out):
    """Builds the site; a warning of Sphinx is an error."""
    folder = out.with_name(out.name + "-source")
    for stale in (folder, out):
        shutil.rmtree(stale, ignore_errors=True)
    source = Source(folder)
    source.write("README.md", contents())
    for _, pages in parts():
        for path, _, _ in pages:
            source.write(path)
    shutil.copytree(HERE, folder / "book", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.move(folder / "book/conf.py", folder / "conf.py")
    subprocess.run(["/usr/bin/python3", "-m", "sphinx", "-q", "-W", "--keep-going", "-b", "html", folder, out], check=True)
    shutil.rmtree(out / ".doctrees", ignore_errors=True)
    repair_theme(out / "_static")
    search.write(out, [(place(path).removesuffix(".md") + ".html", title, subject.replace("`", "")) for _, rows in parts() for path, title, subject in rows])


def repair_theme(static):
    """Makes Debian's furo work from file://: its script is a module of two files, and its style imports a file of a server. Also
    adds the missing colours for a system-wide dark setting."""
    script, style = static / "scripts/furo.js", static / "styles/furo.css"
    text = (static / "scripts/gumshoe-patched.js").read_text(encoding="utf-8") + script.read_text(encoding="utf-8")
    script.write_text(re.sub(r"^import .*\n", "", text, flags=re.MULTILINE), encoding="utf-8")
    text = re.sub(r"@import [^;]*;", "", style.read_text(encoding="utf-8"))
    dark = re.search(r'body\[data-theme="dark"\] \{([^}]*--color-background-primary[^}]*)\}', text)[1]
    text += f'@media (prefers-color-scheme: dark) {{ body:not([data-theme="light"]) {{ {dark} }} }}\n'
    style.write_text(text, encoding="utf-8")


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in ("site", "pdf"):
        sys.exit(__doc__)
    out = pathlib.Path(sys.argv[2]).resolve()
    if sys.argv[1] == "site":
        site(out)
    else:
        paper.make(out, [(name, [(place(path), title) for path, title, _ in pages]) for name, pages in parts()])


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as error:
        sys.exit(f"book.py: Sphinx ended with {error.returncode}")
