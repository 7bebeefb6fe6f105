#!/usr/bin/env python3
"""Every folder of hw, host and sim has judges, every judge is a built test, and options select the requested
folders."""

import re
import shutil
import tempfile
import unittest
from pathlib import Path

import mutants
import mutate
from judges import BY_CASE, JUDGES_OF, Judges, target_of

ROOT = Path(__file__).resolve().parents[2]


# Judged by tests/python; mutations cannot be built into a test program.
WITHOUT_JUDGES = {"sim/python"}


def rooms():
    folders = [folder for top in ("hw", "host", "sim") for folder in (ROOT / top).rglob("*") if folder.is_dir()]
    return {str(folder.relative_to(ROOT)) for folder in folders if any(folder.glob("*.cpp"))}


def targets():
    texts = [file.read_text() for file in (ROOT / "tests").rglob("*") if file.name == "CMakeLists.txt" or file.suffix == ".cmake"]
    words = "\n".join(texts)
    named = {f"test_{name}" for name in re.findall(r"csgsim_test\(\s*(\w+)", words)}
    levels = {f"lockstep_{level}" for level in ("cycle", "functional")}
    return named | levels | set(re.findall(r"add_executable\(((?:lockstep|test)_\w+)", words))


class Rooms(unittest.TestCase):
    def test_exactly_the_rooms_that_are_not_exempt_have_judges(self):
        self.assertEqual(rooms() - WITHOUT_JUDGES, set(JUDGES_OF))

    def test_every_judge_is_a_cmake_target(self):
        known = targets()
        asked = {judge for judges in JUDGES_OF.values() for judge in judges} | BY_CASE
        self.assertEqual({judge for judge in asked if target_of(judge) not in known}, set())


class Survivors(unittest.TestCase):
    def test_every_path_in_the_list_of_survivors_exists(self):
        text = (ROOT / "tests/mutation/survivors.md").read_text(encoding="utf-8")
        paths = re.findall(r"`((?:hw|host|sim|tests|traces|docs)/[\w./-]*\w)", text)
        self.assertGreater(len(paths), 50)
        self.assertEqual({path for path in paths if not (ROOT / path).exists()}, set())


class Choice(unittest.TestCase):
    def test_count_is_shared_among_rooms_and_per_room_applies_to_each(self):
        self.assertEqual(mutate.shares(mutate.parsed(["--count", "8"]), 3), [3, 3, 2])
        self.assertEqual(mutate.shares(mutate.parsed(["--per-room", "10"]), 3), [10, 10, 10])

    def test_rooms_are_chosen_by_name_or_pattern(self):
        self.assertEqual(mutate.rooms_in([]), list(JUDGES_OF))
        self.assertEqual(mutate.rooms_in(["host/view", "sim/software/t*"]),
                         ["host/view", "sim/software/tracing", "sim/software/traversals", "sim/software/tree"])
        with self.assertRaises(SystemExit):
            mutate.rooms_in(["host/views"])

    def test_the_table_counts_mutants_by_room_and_in_total(self):
        rows = [{"room": room, "result": result} for room, result in (
            ("host/view", "failed"), ("host/view", "timeout"), ("host/view", "survived"), ("host/view", "uncompilable"),
            ("host/csg", "failed"))]
        self.assertEqual(mutate.table(rows, ["host/view", "host/csg", "hw/isa"]).splitlines()[2:], [
            "| `host/view` | 3 | 2 | 1 | 1 | 67 |", "| `host/csg` | 1 | 1 | 0 | 0 | 100 |", "| `hw/isa` | 0 | 0 | 0 | 0 | - |",
            "| all | 4 | 3 | 1 | 1 | 75 |"])

    def test_the_same_seed_chooses_the_same_mutants_in_any_copy_of_the_tree(self):
        files = mutants.files_of(ROOT, "sim/lockstep")
        with tempfile.TemporaryDirectory() as folder:
            for file in files:
                (Path(folder) / file).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(ROOT / file, Path(folder) / file)
            here = mutants.in_random_order(ROOT, files, 4)
            self.assertEqual(here, mutants.in_random_order(Path(folder), files, 4))
            self.assertNotEqual(here, mutants.in_random_order(ROOT, files, 5))

    def test_detects_a_build_folder_of_another_source_tree(self):
        with tempfile.TemporaryDirectory() as folder:
            build = Path(folder)
            self.assertFalse(Judges(ROOT, build, 1).is_of_another_tree())
            (build / "CMakeCache.txt").write_text(f"A:STRING=1\nCMAKE_HOME_DIRECTORY:INTERNAL={ROOT}\n")
            self.assertFalse(Judges(ROOT, build, 1).is_of_another_tree())
            (build / "CMakeCache.txt").write_text(f"A:STRING=1\nCMAKE_HOME_DIRECTORY:INTERNAL={ROOT}2\n")
            self.assertTrue(Judges(ROOT, build, 1).is_of_another_tree())


if __name__ == "__main__":
    unittest.main()
