#!/usr/bin/env python3
"""./setup.sh on systems with other package managers: it names the packages of cmake/packages.txt and never prints
"not found" for a command. The managers are stand-ins on a PATH that has only the tools that every system has."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAMS = {"apt": "apt-get", "dnf": "dnf", "pacman": "pacman", "zypper": "zypper", "apk": "apk", "brew": "brew"}
QUERIES = {"dnf": "rpm", "zypper": "rpm"}  # the program that lists what is installed, if it is another one
COMMON = ("sh", "awk", "sed", "tr", "id", "dirname", "cat", "grep", "env", "basename")
GROUPS = ("build", "pictures", "convert", "text")


def rows():
    """The rows of packages.txt as lists of words: those of systems, and those of packages."""
    words = [line.split() for line in (ROOT / "cmake/packages.txt").read_text().splitlines() if line and not line.startswith("#")]
    return [row for row in words if row[0] == "system"], [row for row in words if row[0] != "system"]


SYSTEMS, PACKAGES = rows()
MANAGERS = [row[1] for row in SYSTEMS]


def names_of(manager, groups):
    cells = [row[2 + MANAGERS.index(manager)] for row in PACKAGES if row[0] in groups]
    return [name for cell in cells if cell != "-" for name in cell.split(",")]


class Setup(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        for name in COMMON:
            (self.path / name).symlink_to(shutil.which(name))

    def stand_in(self, name, text="exit 1"):
        file = self.path / name
        file.write_text(f"#!/bin/sh\n{text}\n")
        file.chmod(0o755)

    def setup(self, *words, **variables):
        return subprocess.run(["sh", ROOT / "setup.sh", *words], env={"PATH": str(self.path), **variables}, capture_output=True, text=True)

    def test_rows_have_a_column_for_each_manager_and_no_need_is_listed_twice(self):
        self.assertEqual(MANAGERS, list(PROGRAMS))
        for row in SYSTEMS:
            self.assertEqual(len(row), 6, row)
            self.assertIn(row[2], ("tested", "untested", "unsupported"))
            self.assertEqual(row[5] == "-", row[2] != "unsupported", row)
        for row in PACKAGES:
            self.assertEqual(len(row), 2 + len(MANAGERS), row)
        needs = [row[1] for row in PACKAGES]
        self.assertEqual(len(needs), len(set(needs)))

    def test_packages_prints_the_packages_of_the_table(self):
        for manager in MANAGERS:
            with self.subTest(manager):
                printed = self.setup("packages", manager)
                self.assertEqual(printed.returncode, 0, printed.stderr)
                self.assertEqual(printed.stdout.split(), names_of(manager, GROUPS))

    def test_packages_rejects_an_unknown_manager(self):
        refused = self.setup("packages", "emerge")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("name apt, dnf, pacman, zypper, apk or brew", refused.stderr)

    def test_build_prints_the_command_that_installs_missing_packages_on_each_system(self):
        for system in SYSTEMS[1:]:
            manager = system[1]
            with self.subTest(manager):
                self.setUp()
                self.stand_in(PROGRAMS[manager])
                if manager in QUERIES:
                    self.stand_in(QUERIES[manager])
                refused = self.setup("build")
                self.assertEqual(refused.returncode, 1, refused.stderr)
                lines = refused.stderr.splitlines()
                command = ("" if manager == "brew" else "sudo ") + system[4].replace("_", " ")
                offered = next(line for line in lines if command in line)
                self.assertEqual(set(offered.split(command)[1].split()), set(names_of(manager, (*GROUPS, "python"))))
                self.assertNotIn("not found", refused.stderr)
                self.assertEqual("cannot run" in refused.stderr, system[2] == "unsupported")

    def test_only_missing_packages_are_named(self):
        self.stand_in("dnf")
        self.stand_in("rpm", 'case "$*" in *glm-devel*) exit 1 ;; esac; exit 0')
        refused = self.setup("build")
        self.assertIn("  sudo dnf install glm-devel\n", refused.stderr)

    def test_without_a_known_manager_the_needs_are_named(self):
        refused = self.setup("build")
        self.assertEqual(refused.returncode, 1)
        self.assertIn("SystemC", refused.stderr)
        self.assertNotIn("not found", refused.stderr)

    def test_csgsim_skip_packages_omits_the_check_for_packages(self):
        self.stand_in("cmake", "echo configured; exit 7")
        self.stand_in("dnf")
        self.stand_in("rpm")
        done = self.setup("package", CSGSIM_SKIP_PACKAGES="1")
        self.assertEqual((done.returncode, done.stdout), (7, "configured\n"))


if __name__ == "__main__":
    unittest.main()
