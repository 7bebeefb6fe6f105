#!/usr/bin/env python3
"""Citations: each one in a machine file, a page or a manual text is a key of docs/references.md, and each key is
cited."""

import re
import tomllib
import unittest

import markdown
from runs import ROOT

PAGE = "docs/references.md"
NAME = r"[A-Z][A-Za-zé'-]+"
# An author or authors with a year: "Roth 1982", "Kay and Kajiya 1986", "Fuchs et al. 1985", and forms to be rejected.
CITATION = re.compile(rf"{NAME}(?:, {NAME})*(?:,? and {NAME}|,? and others| et al\.)?,? (?:SIGGRAPH )?(?:19|20)\d\d(?![\d.])")
# Words before a year that are no authors.
OTHER = re.compile(r"\b(?:OpenSCAD|Delft|Technology|Handbook|Manual|January|February|March|April|May|June|July|August|"
                   r"September|October|November|December|At|In|Of|RFC|Since|SVG|ISO|C\+\+),? (?:19|20)\d\d")
SECTIONS = ("host/effects/*.cpp", "host/emit/*.cpp", "sim/software/**/*.cpp")


def works():
    """The rows of the bibliography."""
    return [row for _, row in markdown.rows(markdown.read(PAGE)) if row[0] != "key" and not row[0].startswith("---")]


def keys():
    """The keys of the bibliography, in its order."""
    return [row[0] for row in works()]


def values(table):
    """All texts of a TOML table."""
    if isinstance(table, dict):
        for value in table.values():
            yield from values(value)
    elif isinstance(table, str):
        yield table


def cited():
    """Pairs of file and text that may cite works."""
    for path in sorted(ROOT.glob("hw/*/*.toml")):
        text = path.read_text(encoding="utf-8")
        comments = [line for line in text.splitlines() if line.startswith("#")]
        for value in [" ".join(comments).replace("# ", ""), *values(tomllib.loads(text))]:
            yield path.relative_to(ROOT), value
    for path in markdown.files():
        if path != PAGE and not path.startswith("tests/"):
            yield path, " ".join(markdown.read(path).split())
    for pattern in SECTIONS:
        for path in sorted(ROOT.glob(pattern)):
            rows = re.findall(r"\.(?:technique|source)\s*=\s*((?:\"(?:[^\"\\\\]|\\\\.)*\"\s*)+)", path.read_text(encoding="utf-8"))
            for row in rows:
                yield path.relative_to(ROOT), re.sub(r'"\s*"', "", row)


class References(unittest.TestCase):
    def test_every_citation_is_a_key(self):
        known, wrong = set(keys()), []
        for path, text in cited():
            for key in sorted(known, key=len, reverse=True):
                text = text.replace(key, "")
            wrong += [f"{path}: {found}" for found in CITATION.findall(OTHER.sub("", text))]
        self.assertEqual(wrong, [], f"write a citation as its key in {PAGE}, or add the work there")

    def test_every_key_is_cited(self):
        text = "\n".join(text for _, text in cited())
        self.assertEqual([key for key in keys() if key not in text], [])

    def test_keys_are_sorted_and_unique(self):
        self.assertEqual(keys(), sorted(set(keys()), key=str.lower))

    def test_dois_are_links(self):
        for row in works():
            if row[4] != "–":
                doi, link = re.fullmatch(r"\[(10\.\d{4,5}/\S+)\]\(https://doi\.org/(\S+)\)", row[4]).groups()
                self.assertEqual(link.replace("%28", "(").replace("%29", ")"), doi, row[0])

    def test_citations_in_other_forms_are_detected(self):
        for text in ("Fuchs, Poulton et al. 1985", "Sato and others 1985", "Crow, SIGGRAPH 1977", "Nobody 1999", "Roth, 1982"):
            self.assertTrue(CITATION.search(text), text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
