#!/usr/bin/env python3
"""Regenerates the generated content of the pages: every entry of docs/manifest.

    tests/docs/make.py BUILD            generates everything and prints the changes
    tests/docs/make.py BUILD --check    generates what is exact and fast, and fails if a page differs; writes nothing
    tests/docs/make.py BUILD --twice    generates what is exact twice, and fails if the bytes differ; writes nothing

BUILD is a folder with csgsim in it. --page, --kind and --entry choose entries; --exact omits measured entries, --short
slow ones."""

import argparse
import difflib
import importlib
import pathlib
import sys

import manifest
import pages
from figures import Figures
from runs import ROOT, Failed, Runs


class Names(dict):
    """Names of expressions; definitions of the page's manifest are evaluated on first use."""

    def __init__(self, known, let):
        super().__init__({name: value for name, value in known.items() if name not in let})
        self.let = let

    def __missing__(self, name):
        if name not in self.let:
            raise KeyError(name)
        self[name] = eval(self.let[name], self, self)  # pylint: disable=eval-used
        return self[name]


class Maker:
    """Generates entries into texts and pictures that are kept in memory."""

    def __init__(self, build):
        self.figures = Figures(Runs(build))
        self.made = {}  # bytes by path
        self.wrong = []

    def file(self, path):
        if path not in self.made:
            self.made[path] = (ROOT / path).read_bytes() if (ROOT / path).exists() else b""
        return self.made[path]

    def make(self, page, entry):
        names = Names(self.figures.names(), page.let)
        try:
            getattr(self, entry.kind)(entry, names)
        except (Failed, pages.Missing, ValueError, KeyError, AttributeError, SyntaxError, NameError, TypeError, OSError) as error:
            self.wrong.append(f"{entry}: {type(error).__name__}: {error}")

    def table(self, entry):
        name, *arguments = entry.keys["table"].split()
        module, function = name.split(".")
        return getattr(importlib.import_module(f"tables.{module}"), function)(self.figures, *arguments)

    def block(self, entry, _):
        body = self.table(entry) if "table" in entry.keys else self.figures.runs.run(entry.keys["command"]).printed
        text = pages.with_block(self.file(entry.page).decode(), entry.keys["name"], body)
        self.made[entry.page] = text.encode()

    def sentence(self, entry, names):
        text = self.file(entry.page).decode()
        for words in entry.keys.get("words", []):
            text = pages.with_numbers(text, words, names)
        self.made[entry.page] = text.encode()
        for claim in entry.keys.get("holds", []):
            if not eval(claim, names, names):  # pylint: disable=eval-used
                self.wrong.append(f"{entry.page}: this claim no longer holds: {claim}")

    def picture(self, entry, _):
        folder = self.table(entry) if "table" in entry.keys else self.figures.runs.run(entry.keys["command"]).folder
        for path in entry.keys["files"]:
            self.made[path] = (folder / pathlib.Path(path).name).read_bytes()

    def script(self, entry, _):
        """Runs a script that writes its page itself: the page is restored afterwards, and the result is kept."""
        before = (ROOT / entry.page).read_bytes()
        try:
            self.figures.runs.run(entry.keys["command"])
            made = (ROOT / entry.page).read_bytes()
        finally:
            (ROOT / entry.page).write_bytes(before)
        text = self.file(entry.page).decode()
        for begin in entry.keys["begin"]:
            first, last = pages.part_span(made.decode(), begin, entry.keys["end"])
            text = pages.with_part(text, begin, entry.keys["end"], made.decode()[first:last])
        self.made[entry.page] = text.encode()

    def changed(self):
        return {path: made for path, made in sorted(self.made.items())
                if not (ROOT / path).exists() or (ROOT / path).read_bytes() != made}


def difference(path, made):
    """Changed lines of a text, or a note about a changed picture."""
    if pathlib.Path(path).suffix not in (".md", ".svg"):
        return [f"{path}: another picture"]
    before = (ROOT / path).read_text(encoding="utf-8").splitlines() if (ROOT / path).exists() else []
    if path.endswith(".svg"):
        return [f"{path}: another plot"]
    return list(difflib.unified_diff(before, made.decode().splitlines(), path, path, "before", "now", 0, ""))


def made_by(build, chosen):
    maker = Maker(build)
    for page, entry in chosen:
        maker.make(page, entry)
    return maker


def choose(options):
    for page in manifest.read():
        for entry in page.entries:
            if options.page and options.page not in entry.page:
                continue
            if options.entry and options.entry not in str(entry):
                continue
            if options.kind and entry.kind not in options.kind.split(","):
                continue
            if (options.check or options.twice or options.exact) and not entry.is_exact:
                continue
            if (options.check or options.short) and entry.is_long:
                continue
            yield page, entry


def twice(build, chosen):
    first, second = made_by(build, chosen), made_by(build, chosen)
    differ = [path for path in first.made if first.made[path] != second.made.get(path)]
    for path in differ:
        print(f"{path} differs between two runs")
    return first.wrong + second.wrong, differ


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    for flag in ("--check", "--twice", "--exact", "--short"):
        parser.add_argument(flag, action="store_true")
    parser.add_argument("--page")
    parser.add_argument("--kind")
    parser.add_argument("--entry")
    options = parser.parse_args()
    chosen = list(choose(options))
    if not chosen:
        sys.exit("make.py: no entry matches")
    if options.twice:
        wrong, differ = twice(options.build, chosen)
    else:
        maker = made_by(options.build, chosen)
        wrong, differ = maker.wrong, maker.changed()
        for path, made in differ.items():
            print("\n".join(difference(path, made)))
            if not options.check:
                (ROOT / path).write_bytes(made)
    for each in wrong:
        print(each, file=sys.stderr)
    print(f"{len(chosen)} entries, {len(differ)} files differ, {len(wrong)} errors")
    if wrong or (differ and (options.check or options.twice)):
        sys.exit("make.py: if the change is intended, run ./setup.sh docs" if options.check else 1)


if __name__ == "__main__":
    main()
