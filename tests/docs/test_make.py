#!/usr/bin/env python3
"""Tests of the page generator, with separate pages and commands."""

import pathlib
import tempfile
import unittest

import coverage
import make
import manifest
import markdown
import pages
from runs import Failed, Runs

PAGE = "# P\n\nIt takes 1,234 clocks and 5.0\nms.\n\n<!-- made: a -->\n| 1 |\n<!-- end -->\n\nThat is all.\n"


class Blocks(unittest.TestCase):
    def test_replaces_a_block_and_keeps_the_rest(self):
        self.assertEqual(pages.with_block(PAGE, "a", "| 2 |\n| 3 |\n"), PAGE.replace("| 1 |", "| 2 |\n| 3 |"))

    def test_fills_an_empty_block(self):
        empty = PAGE.replace("| 1 |\n", "")
        self.assertEqual(pages.with_block(empty, "a", "| 1 |"), PAGE)

    def test_making_a_block_twice_changes_nothing(self):
        once = pages.with_block(PAGE, "a", "| 2 |\n")
        self.assertEqual(pages.with_block(once, "a", "| 2 |\n"), once)

    def test_reports_a_missing_block(self):
        with self.assertRaisesRegex(pages.Missing, "'b' occurs 0 times"):
            pages.with_block(PAGE, "b", "")


class Sentences(unittest.TestCase):
    WORDS = "It takes {clocks:,} clocks and {clocks / 1000:.1f} ms"

    def test_replaces_numbers_by_expressions_across_a_line_break(self):
        made = pages.with_numbers(PAGE, self.WORDS, {"clocks": 2345678})
        self.assertIn("It takes 2,345,678 clocks and 2345.7\nms.", made)

    def test_reports_words_that_the_page_lacks(self):
        with self.assertRaisesRegex(pages.Missing, "0 times"):
            pages.with_numbers(PAGE, "It costs {clocks} clocks", {"clocks": 1})

    def test_treats_pattern_characters_in_words_literally(self):
        self.assertEqual(pages.with_numbers("a (b) | 3 |", "a (b) | {n} |", {"n": 4}), "a (b) | 4 |")


class Made(unittest.TestCase):
    def maker(self):
        maker = make.Maker("/nowhere")
        maker.made["P.md"] = PAGE.encode()
        return maker

    def entry(self, kind, **keys):
        return manifest.Entry(kind, "P.md", keys)

    def test_fills_a_block_with_a_commands_output(self):
        maker = self.maker()
        maker.make(manifest.Page("P.md", {}), self.entry("block", name="a", command="echo '| 7 |'"))
        self.assertEqual((maker.wrong, maker.made["P.md"].decode()), ([], PAGE.replace("| 1 |", "| 7 |")))

    def test_a_stale_number_makes_the_page_differ(self):
        maker = self.maker()
        page = manifest.Page("P.md", {"clocks": "1200 + 35"})
        maker.make(page, self.entry("sentence", words=["takes {clocks:,} clocks"]))
        self.assertIn("takes 1,235 clocks", maker.made["P.md"].decode())
        self.assertEqual(list(maker.changed()), ["P.md"])

    def test_reports_a_failing_command_with_its_message(self):
        maker = self.maker()
        maker.make(manifest.Page("P.md", {}), self.entry("block", name="a", command="echo no such thing >&2; false"))
        self.assertIn("no such thing", maker.wrong[0])

    def test_reports_a_false_claim(self):
        maker = self.maker()
        maker.make(manifest.Page("P.md", {"n": "3"}), self.entry("sentence", holds=["n > 2", "n > 3"]))
        self.assertEqual(maker.wrong, ["P.md: this claim no longer holds: n > 3"])

    def test_runs_the_same_command_once(self):
        runs = Runs("/nowhere")
        self.assertIs(runs.run("date +%N"), runs.run("date +%N"))

    def test_reports_a_failure_within_a_pipe(self):
        with self.assertRaises(Failed):
            Runs("/nowhere").run("false | cat")


class Manifests(unittest.TestCase):
    def wrong(self, text):
        with tempfile.TemporaryDirectory(dir=manifest.ROOT / "build") as folder:
            path = pathlib.Path(folder) / "p.toml"
            path.write_text(text, encoding="utf-8")
            with self.assertRaises(manifest.Wrong) as caught:
                manifest.read_page(path)
        return str(caught.exception)

    def test_rejects_unknown_keys_and_pages(self):
        self.assertIn("no key 'tabel'", self.wrong('page = "README.md"\n[[block]]\nname = "a"\ntabel = "b"\n'))
        self.assertIn("there is no page", self.wrong('page = "nowhere.md"\n'))
        self.assertIn("there is no 'blocks'", self.wrong('page = "README.md"\n[[blocks]]\nname = "a"\n'))

    def test_rejects_an_allowed_number_without_a_known_kind_of_reason(self):
        self.assertIn("'reason' that begins", self.wrong('page = "README.md"\n[[allowed]]\nnear = "a"\nreason = "so"\n'))


class Commands(unittest.TestCase):
    def test_a_failing_script_does_not_affect_the_next(self):
        made = Runs(".")
        with self.assertRaises(Failed):
            made.run("echo lost > $OUT/a; false")
        self.assertEqual(made.run("ls $OUT; echo b").printed, "b\n")

    def test_runs_a_script_once(self):
        made = Runs(".")
        self.assertIs(made.run("date +%N"), made.run("date +%N"))


class Coverage(unittest.TestCase):
    def found(self, text, page=None):
        return [(each.text, each.reason) for each in coverage.numbers("P.md", page, text)]

    def test_finds_numbers_that_look_measured(self):
        text = "In 1985 it took 12,345 of 17 clocks, 3 %, 65536 and 4 pages; `9999` and [this](a-1234.md).\n\n    csgsim --size 12345\n"
        self.assertEqual([number for number, _ in self.found(text)], ["12,345", "17", "3", "65536"])

    def test_ignores_numbers_that_a_block_or_sentence_generates(self):
        page = manifest.Page("P.md", {}, [manifest.Entry("sentence", "P.md", {"words": ["takes {a} clocks and {b} ms"]})])
        self.assertEqual(self.found(PAGE.replace("| 1 |", "| 5,000 |")), [("1,234", ""), ("5.0", "")][:1])
        self.assertEqual(self.found(PAGE, page), [])

    def test_a_number_in_an_allowed_section_has_its_reason(self):
        page = manifest.Page("P.md", {}, [], [{"section": "P", "reason": "definition: so"}])
        self.assertEqual(self.found(PAGE, page)[0], ("1,234", "definition: so"))


class Markdown(unittest.TestCase):
    def test_repeated_headings_have_numbered_anchors_and_code_has_none(self):
        text = "# What a `wire` is, once\n## A\n## A\n```\n# no heading\n```\n"
        self.assertEqual(markdown.anchors(text), {"what-a-wire-is-once", "a", "a-1"})

    def test_ignores_links_in_code(self):
        self.assertEqual([to for _, to in markdown.links("[a](b.md) `[c](d.md)` ![e](f.png)\n\n    [g](h.md)\n")], ["b.md", "f.png"])


if __name__ == "__main__":
    unittest.main()
