#!/usr/bin/env python3
"""Configures csgsim without each of its parts, compiles the files that then differ, and checks the report of missing
libraries.

  options_test.py CMAKE COMPILER"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CMAKE, COMPILER = sys.argv[1:3]
# For each option: a target that only it builds; and the file, with its library, that reports the missing part.
PARTS = {"TEXT": ("csgsim_text_module", "host/flat/CMakeFiles/csgsim_flat.dir/text.cpp.o"),
         "PICTURES": ("csgsim_pictures_module", "sim/pictures/CMakeFiles/csgsim_pictures.dir/module_loader.cpp.o"),
         "VIEWER": ("csgsim_viewer_module", "sim/viewer/CMakeFiles/csgsim_viewer.dir/serve.cpp.o"),
         "CONVERT": ("csgsim_convert", "sim/app/CMakeFiles/csgsim.dir/main.cpp.o"),
         "PYTHON": ("csgsim_python", None)}


class Options(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.build = pathlib.Path(folder.name)

    def configure(self, *options):
        return subprocess.run([CMAKE, "-S", ROOT, "-B", self.build, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={COMPILER}", *options],
                              capture_output=True, text=True)

    def targets(self):
        rules = (self.build / "build.ninja").read_text()
        return set(re.findall(r"^build (csgsim_\w+): phony", rules, re.M)) | set(re.findall(r"cmake_object_order_depends_target_(\w+)", rules))

    def test_each_part_can_be_left_out(self):
        self.assertEqual(self.configure().returncode, 0)
        everything = self.targets()
        for part, (target, file) in PARTS.items():
            with self.subTest(part):
                self.assertIn(target, everything)
                done = self.configure(f"-DCSGSIM_{part}=OFF")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertNotIn(target, self.targets())
                if file:
                    subprocess.run(["ninja", "-C", self.build, file], check=True, capture_output=True)
                self.assertEqual(self.configure(f"-DCSGSIM_{part}=ON").returncode, 0)

    def test_the_default_build_is_a_release_without_tests(self):
        self.assertEqual(self.configure().returncode, 0)
        cache = (self.build / "CMakeCache.txt").read_text()
        self.assertIn("CMAKE_BUILD_TYPE:STRING=Release\n", cache)
        self.assertIn("CSGSIM_BUILD_TESTS:BOOL=OFF\n", cache)

    def test_missing_libraries_are_reported_together(self):
        off = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}={{}}" for name in ("pegtl", "fmt", "pybind11")]
        refused = self.configure(*(option.format("ON") for option in off))
        self.assertNotEqual(refused.returncode, 0)
        said = " ".join(refused.stderr.split())
        self.assertIn("csgsim needs the following, which was not found: PEGTL, fmt, pybind11.", said)
        self.assertRegex(said, r"(install|add|--needed) \S*(pegtl|PEGTL)\S* \S*fmt\S* \S*pybind11")
        self.assertIn("-DCSGSIM_PYTHON=OFF", said)
        self.assertEqual(self.configure(*(option.format("OFF") for option in off)).returncode, 0)

    def test_rejects_a_build_of_the_tests_without_a_part(self):
        refused = self.configure("-DCSGSIM_BUILD_TESTS=ON", "-DCSGSIM_TEXT=OFF")
        self.assertNotEqual(refused.returncode, 0)
        self.assertIn("-DCSGSIM_TEXT=ON", " ".join(refused.stderr.split()))
        self.configure("-DCSGSIM_BUILD_TESTS=OFF", "-DCSGSIM_TEXT=ON")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
