#!/usr/bin/env python3
"""Every room of hw, host and sim has judges, and every judge is a test that is built."""

import re
import unittest
from pathlib import Path

from judges import BY_CASE, JUDGES_OF, target_of

ROOT = Path(__file__).resolve().parents[2]


# Judged by tests/python, of which there is no program that mutations could be built into.
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
    def test_every_room_has_judges_and_no_other(self):
        self.assertEqual(rooms() - WITHOUT_JUDGES, set(JUDGES_OF))

    def test_every_judge_is_built(self):
        known = targets()
        asked = {judge for judges in JUDGES_OF.values() for judge in judges} | BY_CASE
        self.assertEqual({judge for judge in asked if target_of(judge) not in known}, set())


if __name__ == "__main__":
    unittest.main()
