#!/usr/bin/env python3
"""Tests of the tables: their calls of csgsim, and their citations."""

import re
import unittest

from figures import MODELS, Figures
from runs import ROOT, Record
from tables import comparison, host, machine, today

NUMBERS = ("clocks", "interval_clocks", "host_clocks", "host_model_clocks", "pixel_operations", "processors", "processor_clocks", "machine_memory_bits", "halfspaces")
RATES = ("simulated_seconds", "frames_per_second", "hosted_frames_per_second", "frame_joules", "utilisation")


class Compared:
    """Answers `csgsim compare` without running it: a point for each named machine, and a record of the commands."""

    def __init__(self):
        self.commands = []

    def run(self, command):
        self.commands.append(command)
        return self

    def json(self, _):
        named = re.search(r"--machines (\S+)", self.commands[-1])
        machines = named[1].split(",") if named else comparison.MACHINES
        return Record(points=[Record(machine=name, width=512, fragments=0.0, **dict.fromkeys(NUMBERS, 1), **dict.fromkeys(RATES, 1.0)) for name in machines])


def model_of(command):
    """The arguments of the model in a command."""
    known = [words for words in MODELS.values() if words in command]
    return known[0] if known else re.search(r"tests/\S+\.csg", command)[0]


class Comparisons(unittest.TestCase):
    TABLES = (today.models, today.corpus, today.lacking, today.ways, today.limits, today.exact, today.times, host.hosts, host.exact, comparison.machines)

    def test_rows_of_a_model_come_from_a_single_call_of_compare(self):
        for table in self.TABLES:
            with self.subTest(table=f"{table.__module__}.{table.__name__}"):
                runs = Compared()
                table(Figures(runs))
                commands = set(runs.commands)
                self.assertEqual({command.split()[:2] == ["csgsim", "compare"] for command in commands}, {True})
                models = [model_of(command) for command in commands]
                self.assertEqual(len(models), len(set(models)))
                self.assertEqual(len({command.replace(model_of(command), "MODEL") for command in commands}), 1)

    def test_tables_of_a_page_show_the_same_frames(self):
        runs = Compared()
        for table in (today.models, today.lacking, today.ways, today.limits, today.times):
            table(Figures(runs))
        self.assertEqual(len(set(runs.commands)), len(today.THESIS_MODELS))

    def test_a_command_for_several_machines_states_how_it_draws_curves(self):
        any_machine = re.compile(r'--machine (\{|" ?\+)')
        lines = [(path.name, line) for folder, name in (("tests/docs/tables", "*.py"), ("docs/manifest", "*.toml"))
                 for path in sorted((ROOT / folder).glob(name)) for line in path.read_text(encoding="utf-8").splitlines()]
        for name, line in lines:
            if any_machine.search(line):
                with self.subTest(file=name, line=line):
                    self.assertIn("--curves", line)


class Sources(unittest.TestCase):
    def test_replaces_the_key_of_the_thesis_by_words(self):
        for source, words in (
                ("the processor on which the programs of Jansen 1987 ran", "the processor on which the programs of the thesis ran"),
                ("one of the three that Jansen 1987, section 7.4.2, names; it", "one of the three that thesis 7.4.2 names; it"),
                ("the simulation of Jansen 1987, section 7.4.3, has 256", "the simulation of thesis 7.4.3 has 256"),
                ("no effect: Jansen 1987, section 7.4.3, simulated one", "no effect: thesis 7.4.3 simulated one"),
                ("than 4, as in Jansen 1987, section 7.4.2, for the models", "than 4, as in thesis 7.4.2, for the models"),
                ("Jansen 1987, sections 7.4.1 and 7.4.3: arrays", "thesis 7.4.1 and 7.4.3: arrays"),
                ("Jansen 1987, table 7.3: the total", "thesis table 7.3: the total"),
                ("one stands in Jansen 1987, fig. 7.3", "one stands in thesis fig. 7.3"),
                ("with the host (Jansen 1987, section 7.2.2)", "with the host (thesis 7.2.2)")):
            self.assertEqual(machine.in_words_of_pages(source), words)

    def test_turns_an_x_between_numbers_into_a_times_sign(self):
        self.assertEqual(machine.in_words_of_pages("squares of 8 x 8 or 16 x 16 pixels"), "squares of 8 × 8 or 16 × 16 pixels")
        self.assertEqual(machine.in_words_of_pages("rows hold x and y"), "rows hold x and y")
        self.assertEqual(machine.in_words_of_pages("(4 x 70 clocks)"), "(4 × 70 clocks)")

    def test_sources_of_machines_have_no_fragments_of_citations(self):
        for path in sorted((ROOT / "hw/machines").glob("*.toml")):
            for line in machine.figures(None, path.stem).splitlines():
                self.assertNotRegex(line, r"(of|on|that|by) thesis (?!\d|fig|table)|thesis [\d.]+, (?!for)[a-z]|× (and|or|in)\b")


if __name__ == "__main__":
    unittest.main()
