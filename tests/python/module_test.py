#!/usr/bin/env python3
"""Compares the Python module with the command line: module_test.py CSGSIM SOURCE [NAMES...]"""

import importlib.util
import json
import math
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import textwrap
import threading
import time
import unittest
import unittest.mock
import warnings

import numpy

import csgsim
import exr
import support

support.begin(*sys.argv[1:3])
os.chdir(support.SOURCE)

FIGURE = "tests/models/thesis_fig_2_3.csg"
CARBURETTOR = "tests/models/carburettor.csg"
SMALL = {"size": "64x48", "camera": "30,-40,25,0,0,2"}
RENDERS = [
    SMALL,
    {**SMALL, "machine": "pixel-planes-5", "threads": 2},
    {**SMALL, "machine": "scan-line", "projection": "perspective"},
    {**SMALL, "strategy": "bits", "z_bits": 16, "set": ["alu.bits=4"], "snap": True},
    {**SMALL, "level": "reference", "check": True},
    {**SMALL, "level": "cycle"},
    {**SMALL, "tolerance": "0.5px", "advice": True},
]
NOT_OF_CALLS = ("frames", "orbit", "cameras", "quiet", "verbose", "output", "stats")  # only of the command line or this test


def same_run(stats):
    """The stats without entries that depend on program or module and on output places."""
    stats = support.without_time(stats)
    configuration = stats["configuration"]
    for key in ("command", "version"):
        del configuration[key]
    configuration["options"] = {key: value for key, value in configuration["options"].items() if key not in NOT_OF_CALLS}
    return stats


def same_page(text):
    """The data and the other lines of a run's page, without entries that depend on program or module."""
    before, data, after = re.split(r'(?<=id="data">)(.*?)(?=</script>)', text, maxsplit=1)
    names_run = re.compile(r"id=command|/configuration/(command|version|options/(" + "|".join(NOT_OF_CALLS) + "))\"")
    return same_run(json.loads(data)), [line for line in (before + after).split("\n") if not names_run.search(line)]


class Pictures(unittest.TestCase):
    """Pictures, counts and Programs."""

    def test_pictures_and_stats_equal_those_of_render(self):
        for options in RENDERS:
            with self.subTest(options=options):
                stats, picture = support.stats("render", FIGURE, **options)
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore", csgsim.CsgsimWarning)
                    drawing = csgsim.render(FIGURE, **options, progress="none")
                self.assertEqual(drawing.png(), picture)
                self.assertEqual(list(drawing.stats), list(stats))
                self.assertEqual(same_run(drawing.stats), same_run(stats))

    def test_rerun_accepts_a_stats_dictionary_as_file(self):
        drawing = csgsim.render(FIGURE, **SMALL)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "stats.json")
            file.write_text(json.dumps(drawing.stats), encoding="utf-8")
            ended = support.command("rerun", str(file), anyway=True)
            self.assertEqual(ended.returncode, 0, ended.stderr)

    def test_depths_and_owners_equal_those_of_the_files(self):
        for surface in ("nearest", "opaque"):
            options = {**SMALL, "surface": surface, "set": ["lights.0.direction=0,0,-1"]}
            with tempfile.TemporaryDirectory() as folder:
                depth, owner = pathlib.Path(folder, "depth.exr"), pathlib.Path(folder, "owner.exr")
                support.done("render", FIGURE, **options, depth=depth, owner=owner)
                drawing = csgsim.render(FIGURE, **options)
                numpy.testing.assert_array_equal(drawing.depth.astype(numpy.float32), exr.read(depth.read_bytes()))
                numpy.testing.assert_array_equal(drawing.owner, exr.read(owner.read_bytes()))
        self.assertEqual((drawing.picture.shape, drawing.picture.dtype), ((48, 64, 3), numpy.uint8))
        numpy.testing.assert_array_equal(drawing.owner == -1, numpy.isinf(drawing.depth))
        self.assertTrue((drawing.owner >= 0).any() and (drawing.owner == -1).any())
        self.assertLess(drawing.owner.max(), len(drawing.program.primitives))

    def test_writes_files_as_render_does(self):
        _, picture = support.stats("render", FIGURE, **SMALL)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "picture.png")
            csgsim.render(FIGURE, **SMALL, output=file)
            self.assertEqual(file.read_bytes(), picture)

    def test_a_report_equals_that_of_the_command_render(self):
        """Includes the half-spaces of the model, which stories of pixels name."""
        pages = []
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "page.html")
            for draw in (lambda **options: support.done("render", FIGURE, **options), lambda **options: csgsim.render(FIGURE, **options)):
                draw(**SMALL, progress="none", report=file)
                pages.append(same_page(file.read_text(encoding="utf-8")))
        self.assertEqual(*pages)

    def test_options_accept_numbers_texts_paths_sequences_mappings_and_machines(self):
        said = support.without_time(csgsim.render(FIGURE, **SMALL, set=["alu.bits=2"], z_bits="16").stats)
        machine = csgsim.Machine("pixel-planes-4", **{"alu.bits": 2})
        for options in ({"size": (64, 48), "camera": (30, -40, 25, 0, 0, 2), "set": {"alu.bits": 2}, "z_bits": 16},
                        {"size": numpy.array([64, 48]), "camera": [30.0, -40, 25, 0, 0, 2], "machine": machine,
                         "z_bits": numpy.int64(16), "check": False, "near": None}):
            stats = support.without_time(csgsim.render(pathlib.Path(FIGURE), **options).stats)
            del stats["configuration"], stats["knobs"]
            self.assertEqual(stats, {key: value for key, value in said.items() if key in stats})

    def test_draws_a_text_as_the_file_that_contains_it(self):
        text = pathlib.Path(FIGURE).read_text(encoding="utf-8")
        stats, picture = support.stats("render", FIGURE, **SMALL)
        drawing = csgsim.render(FIGURE, text=text, **SMALL, progress="none")
        self.assertEqual(drawing.png(), picture)
        self.assertEqual(same_run(drawing.stats), same_run(stats))
        unnamed = csgsim.render(text=text, **SMALL)
        self.assertEqual(unnamed.png(), picture)
        self.assertEqual(unnamed.stats["configuration"]["model"]["hash"], stats["configuration"]["model"]["hash"])

    def test_evaluates_openscad_source_with_the_openscad_on_the_path(self):
        with tempfile.TemporaryDirectory() as folder:
            openscad = pathlib.Path(folder, "openscad")
            openscad.write_text("#!/bin/sh\necho 'WARNING: kept' >&2\nn=10\n"
                                "for word; do case $word in n=*) n=${word#n=};; esac; done\n"
                                "echo \"cube(size = [$n, 10, 10], center = true);\"\n", encoding="utf-8")
            openscad.chmod(0o755)
            path = os.environ["PATH"]
            os.environ["PATH"] = f"{folder}:{path}"
            try:
                with self.assertWarnsRegex(csgsim.CsgsimWarning, "openscad: WARNING: kept") as warned:
                    drawing = csgsim.render("part.scad", text="cube(10, center = true);", size="32x32")
                    narrow = csgsim.render("part.scad", text="cube(n);", define={"n": 5}, size="32x32")
            finally:
                os.environ["PATH"] = path
        self.assertEqual(warned.filename, __file__)
        self.assertEqual(drawing.png(), csgsim.render(text="cube(size = 10, center = true);", size="32x32").png())
        self.assertEqual(narrow.png(), csgsim.render(text="cube(size = [5, 10, 10], center = true);", size="32x32").png())

    def test_compiles_saves_and_runs_programs_as_the_commands_do(self):
        program = csgsim.compile(FIGURE, **SMALL, z_bits=16)
        drawing = csgsim.render(FIGURE, **SMALL, z_bits=16)
        with tempfile.TemporaryDirectory() as folder:
            file, own, text = (pathlib.Path(folder, name) for name in ("a.csgt", "b.csgt", "c.txt"))
            support.done("compile", FIGURE, **SMALL, z_bits=16, output=file)
            program.save(own)
            program.save(text, text=True)
            self.assertEqual(own.read_bytes(), file.read_bytes())
            self.assertEqual(text.read_text(encoding="utf-8"), support.done("disasm", str(file)))
            self.assertEqual(program.text(), text.read_text(encoding="utf-8"))
            stats, picture = support.stats("run", str(file))
            for same in (program, file, csgsim.Program.load(file), csgsim.Program.load(text), drawing.program):
                run = csgsim.run(same)
                self.assertEqual(run.png(), picture)
                for told in (run.stats, stats):
                    told.pop("configuration", None)
                self.assertEqual(support.without_time(run.stats), support.without_time(stats))

    def test_instruction_rows_of_a_program_equal_the_lines_of_its_text(self):
        program = csgsim.compile(FIGURE, **SMALL)
        lines = [line for line in program.text().splitlines() if line.startswith("  ")]
        rows = program.instructions
        self.assertEqual((len(program), len(rows)), (len(lines), len(lines)))
        for number, (row, line) in enumerate(zip(rows, lines)):
            words, origin = line.split(";")
            self.assertEqual((row["instruction"], row["text"], row["name"]), (number, words.strip(), words.split()[0]))
            said = [row["purpose"], row["primitive"], row["against"] and f"against {row['against']}"]
            self.assertTrue(origin.split("#")[0].strip().startswith(" ".join(each for each in said if each)))
        stats = csgsim.run(program).stats
        self.assertEqual(sum(row["clocks"] for row in rows), sum(one["clocks"] for one in stats["instructions"]["by_name"].values()))
        self.assertEqual(program.memory, stats["memory"]["memory_map"])
        self.assertEqual((program.size, program.memory_bits), ((64, 48), stats["memory"]["memory_bits"]))
        self.assertEqual(program.primitives, [one["name"] for one in stats["by_primitive"] if "name" in one])
        self.assertEqual(program.machine.name, "pixel-planes-4")


class Reports(unittest.TestCase):
    """Stories, studies, machines, options."""

    def test_stories_equal_those_of_explain(self):
        for subject, options in ((FIGURE, {**SMALL, "pixel": "30,24", "why_not": "p1"}), (FIGURE, {**SMALL, "point": "0,0,2"}),
                                 ("traces/thesis_fig_2_3.csgt", {"pixel": "200,300"})):
            said = support.done("explain", subject, **options)
            told = json.loads(support.done("explain", subject, **options, json="-"))
            story = csgsim.explain(subject, **options)
            self.assertEqual((story, story.text), (told, said))
        program = csgsim.Program.load("traces/thesis_fig_2_3.csgt")
        self.assertEqual(csgsim.explain(program, pixel=(200, 300)), told)

    def test_rows_of_studies_equal_those_of_their_files(self):
        for name, options in (("sweep", {"strategy": "stack,list", "z_bits": "16,20"}),
                              ("compare", {"machines": "pixel-planes-4,scan-line", "fragments": "none", "sides": "none"}),
                              ("accuracy", {"views": 1})):
            with self.subTest(study=name):
                told = support.study(name, FIGURE, size="64x48", **options)
                rows = getattr(csgsim, name)(FIGURE, size="64x48", **options, progress="none")
                self.assertEqual(support.without_build(rows), support.without_build(told["points"]))
                self.assertGreater(len(rows), 1)

    @unittest.skipIf(importlib.util.find_spec("pandas") is None, "pandas is missing")
    def test_results_of_studies_become_data_frames(self):
        rows = csgsim.sweep(FIGURE, **SMALL, z_bits=[16, 20], strategy="stack")
        frame = csgsim.data_frame(rows)
        self.assertEqual(frame["clocks"].tolist(), [row["clocks"] for row in rows])
        self.assertEqual(set(frame.columns), set(rows[0]))
        result = csgsim.study("classify", FIGURE, size=(16, 16))
        frame = csgsim.data_frame(result)
        self.assertEqual((len(frame), frame.attrs["study"]), (len(result["points"]), result["study"]))
        processor = next(iter(result["points"][0]["seconds"]))
        self.assertEqual(frame[f"seconds.{processor}.all"][0], result["points"][0]["seconds"][processor]["all"])
        with self.assertRaisesRegex(KeyError, "no table 'front'; it has points"):
            csgsim.data_frame(result, "front")

    def test_data_frame_without_pandas_raises_an_error_that_names_the_package(self):
        with unittest.mock.patch.dict(sys.modules, {"pandas": None}):
            with self.assertRaisesRegex(ImportError, "apt install python3-pandas"):
                csgsim.data_frame([])

    def test_every_study_has_options_and_study_runs_one_by_name(self):
        self.assertEqual(csgsim.studies(), [name for name in csgsim.studies() if csgsim.options(name)])
        self.assertIn("advise", csgsim.studies())
        told = support.study("subdivide", FIGURE, size="64x48", subdivisions="2")
        asked = csgsim.study("subdivide", FIGURE, size="64x48", subdivisions=2)
        self.assertEqual(list(asked), list(told))
        self.assertEqual(support.without_build(asked["points"]), support.without_build(told["points"]))

    def test_a_study_in_a_folder_reuses_measured_points(self):
        with tempfile.TemporaryDirectory() as folder:
            first = csgsim.sweep(FIGURE, size="32x32", strategy="stack", output=folder, no_plots=True)
            both = csgsim.sweep(FIGURE, size="32x32", strategy=["stack", "list"], output=folder, no_plots=True)
            self.assertEqual(both[0], first[0])
            kept = json.loads(pathlib.Path(folder, "sweep.json").read_text(encoding="utf-8"))
            self.assertEqual(kept["points"], both)

    def test_machines_have_the_parameters_of_the_manual(self):
        listed = support.done("manual", "machines", "all")
        for machine in csgsim.machines():
            self.assertIn(f"{machine.name}\n  {machine.description}\n", listed)
            for figure in machine.figures.values():
                self.assertIn(f"  {figure.key:<26}{figure.value:>12} {figure.unit:<22}{figure.provenance:<10} {figure.source}\n", listed)
                if figure.range:
                    low, high, reason = figure.range
                    self.assertLessEqual(low, high)
                    self.assertIn(f"{f'{low} to {high}':>40} {figure.unit:<22}{'range':<10} {reason}\n", listed)
        wide = csgsim.Machine("pixel-planes-4", **{"alu.bits": 2})
        self.assertEqual(wide.figures["alu.bits"][1:4], (2, "bits", "assumed"))
        self.assertIsNone(csgsim.Machine("pixel-planes-4", **{"link.latency": 9}).figures["link.latency"].range)
        self.assertEqual(csgsim.render(FIGURE, **SMALL, machine=wide).stats["machine"]["alu_bits"], 2)
        from_file = csgsim.Machine("hw/machines/scan-line.toml")
        self.assertEqual(from_file, csgsim.Machine("scan-line"))

    def test_options_equal_those_of_help(self):
        for command in ("render", "compile", "run", "explain", *csgsim.studies()):
            page = support.done(command, "--help")
            for option in csgsim.options(command):
                self.assertIn("--" + option["name"].removesuffix("_").replace("_", "-"), page)


class Errors(unittest.TestCase):
    """Errors, warnings and options that do not apply to Python."""

    def refused(self, kind, message, call, *arguments, **options):
        with self.assertRaises(kind) as raised:
            call(*arguments, **options)
        self.assertIn(message, str(raised.exception))
        return raised.exception

    def test_errors_equal_those_of_the_command_line(self):
        for subject, options in (("nowhere.csg", {}), (FIGURE, {"machine": "pixel-plane"}), (FIGURE, {"z_bits": 99}),
                                 (FIGURE, {"z_bitz": 16}), (FIGURE, {"strategy": "stak"}), (FIGURE, {"memory_bits": 8}),
                                 (FIGURE, {"set": ["alu.bitz=2"]}), ("traces/thesis_fig_2_3.csgt", {})):
            ended = support.command("render", subject, **options)
            self.assertIn(ended.returncode, (1, 2))
            error = self.refused(csgsim.Error, "", csgsim.render, subject, **options)
            self.assertEqual(isinstance(error, csgsim.UsageError), ended.returncode == 2)
            without_help = lambda text: text.removesuffix(" see csgsim render --help").removesuffix(";")
            told = "csgsim: " * isinstance(error, csgsim.UsageError) + without_help(str(error))
            self.assertEqual(told, without_help(ended.stderr.rstrip("\n")))

    def test_errors_state_file_line_and_column(self):
        error = self.refused(csgsim.Error, "part.csg:2:", csgsim.render, "part.csg", text="cube(1);\nsphere(oops);")
        self.assertEqual((error.file, error.line), ("part.csg", 2))
        self.assertGreater(error.column, 1)
        self.assertIsNone(self.refused(csgsim.Error, "z-bits", csgsim.render, FIGURE, z_bits=99).line)

    def test_rejects_unknown_machines_programs_and_studies_by_name(self):
        self.refused(csgsim.Error, "pixel-planes-4", csgsim.Machine, "pixel-planes-3")
        self.refused(csgsim.Error, "alu.bits", csgsim.Machine, "pixel-planes-4", **{"alu.bitz": 2})
        self.refused(csgsim.Error, "that is a model", csgsim.Program.load, FIGURE)
        self.refused(csgsim.UsageError, "'sweeps'", csgsim.study, "sweeps", FIGURE)
        self.refused(csgsim.UsageError, "'view'", csgsim.options, "view")
        self.refused(TypeError, "name a model", csgsim.render)
        self.refused(TypeError, "is not a text", csgsim.render, FIGURE, size=object())

    def test_rejects_options_of_the_command_line_only_and_zero_bytes(self):
        self.refused(csgsim.UsageError, "--help", csgsim.render, FIGURE, help=True)
        self.refused(csgsim.UsageError, "zero byte", csgsim.render, FIGURE, size="8x8\0x9")
        self.refused(csgsim.UsageError, "zero byte", csgsim.render, f"{FIGURE}\0.csg")
        self.refused(csgsim.Error, "zero byte", csgsim.Program.load, f"{FIGURE}\0.csgt")
        self.refused(csgsim.UsageError, "--output", csgsim.render, FIGURE, output="-")
        self.refused(csgsim.UsageError, "--quiet", csgsim.sweep, FIGURE, quiet=True)
        self.refused(csgsim.UsageError, "--shard", csgsim.sweep, FIGURE, shard="1/2")

    def test_prints_nothing_and_issues_python_warnings(self):
        script = textwrap.dedent(f"""
            import csgsim, warnings
            warnings.simplefilter("error")
            csgsim.render({FIGURE!r}, tolerance="0.5px", size="32x32", max_wrong_pixels=5)
            csgsim.sweep({FIGURE!r}, strategy="stack", size="32x32")
            csgsim.render({FIGURE!r}, size="32x32", projection="perspective", near=0.0001)
            """)
        ended = subprocess.run([sys.executable, "-c", script], check=False, text=True, capture_output=True)
        self.assertEqual(ended.stdout, "")
        self.assertIn("CsgsimWarning: warning: one depth step at the far end", ended.stderr.splitlines()[-1])

    def test_rejects_a_second_clocked_machine_in_a_process(self):
        csgsim.render(FIGURE, size="16x16", level="cycle")
        csgsim.render(FIGURE, size="16x16", level="cycle")
        self.refused(csgsim.Error, "a separate process", csgsim.render, FIGURE, size="16x16", level="cycle", machine="scan-line")


class LongWork(unittest.TestCase):
    """Long work does not block other threads, and ends at Ctrl-C."""

    def interrupted(self, call, *arguments, **options):
        """Seconds from Ctrl-C until KeyboardInterrupt is raised."""
        sent = []

        def send():
            sent.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)

        timer = threading.Timer(0.5, send)
        timer.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                call(*arguments, **options)
            return time.monotonic() - sent[0]
        finally:
            timer.cancel()

    def test_ctrl_c_interrupts_runs_and_studies(self):
        large = {"size": "2048x2048", "camera": "220,-255,135,2,0,5"}
        self.assertLess(self.interrupted(csgsim.render, CARBURETTOR, level="reference"), 20)
        self.assertLess(self.interrupted(csgsim.sweep, CARBURETTOR, **large), 20)
        self.assertEqual(csgsim.render(FIGURE, **SMALL).png(), support.stats("render", FIGURE, **SMALL)[1])

    def test_other_threads_draw_the_same_picture_while_the_main_thread_continues(self):
        usual = csgsim.render(FIGURE, **SMALL).png()
        drawn, turns = [], 0
        levels = ("functional", "functional", "cycle", "cycle")
        threads = [threading.Thread(target=lambda level=level: drawn.append(csgsim.render(FIGURE, **SMALL, level=level).png()))
                   for level in levels]
        for thread in threads:
            thread.start()
        while any(thread.is_alive() for thread in threads):
            turns += 1
            time.sleep(0.001)
        self.assertGreater(turns, 1)
        self.assertEqual(drawn, [usual] * len(levels))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
