#!/usr/bin/env python3
"""Follows the three paths of README.md as typed, in a scratch folder like build/try: paths_test.py BUILD"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import check
import markdown
from runs import ROOT

BUILD = pathlib.Path(sys.argv[1]).resolve()
LINKS = ("docs", "hw", "tests", "traces")
# What each path leaves behind, by its heading.
RESULTS = {"Students": ["figure.png"], "Architects": ["machines/compare.csv"],
           "OpenSCAD users": ["bracket.png", "bracket.stl"]}


def commands(heading):
    """The commands of a path, without those that need OpenSCAD if it is missing."""
    section = markdown.read("README.md").split(f"\n### {heading}\n")[1].split("\n#")[0]
    (_, block), = check.command_blocks(section)
    if not shutil.which("openscad"):
        block = re.sub(r"^.*\.scad .*\n", "", block, flags=re.MULTILINE)
    return block


def state():
    """The repository's untracked and changed files."""
    done = subprocess.run(["git", "status", "--porcelain"], cwd=ROOT, check=False, text=True, capture_output=True)
    return done.stdout


class Paths(unittest.TestCase):
    """Each path."""

    def follow(self, shell, heading):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for link in LINKS:
                (folder / link).symlink_to(ROOT / link)
            environment = {**os.environ, "PATH": f"{BUILD}:{os.environ['PATH']}", "HOME": name}
            done = subprocess.run([shell, "-c", commands(heading)], cwd=folder, env=environment, check=False, text=True,
                                  capture_output=True)
            self.assertEqual((done.returncode, done.stderr), (0, ""), heading)
            self.assertTrue(done.stdout)
            for result in RESULTS[heading]:
                self.assertGreater((folder / result).stat().st_size, 0, result)

    def test_every_path_of_the_readme_has_expected_results(self):
        found = re.findall(r"^### (.*)$", markdown.read("README.md").split("\n## Three paths\n")[1].split("\n## ")[0], re.MULTILINE)
        self.assertEqual(found, list(RESULTS))

    def test_each_path_ends_in_a_result_and_leaves_the_repository_as_it_was(self):
        before = state()
        for heading in RESULTS:
            self.follow("sh", heading)
        self.assertEqual(state(), before)

    @unittest.skipUnless(shutil.which("fish"), "fish is missing")
    def test_the_first_path_gives_its_results_in_fish(self):
        self.follow("fish", "Students")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
