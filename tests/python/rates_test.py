#!/usr/bin/env python3
"""Checks that render, run, compare, sweep, corpus, the page of view and the Python module report equal frame rates for
the same model and machine: rates_test.py CSGSIM SOURCE"""

import os
import pathlib
import re
import sys
import tempfile
import unittest

import csgsim
import support

support.begin(*sys.argv[1:3])
os.chdir(support.SOURCE)
sys.path.insert(0, str(support.SOURCE / "tests/view"))

import server  # noqa: E402

MODEL = "tests/models/thesis_fig_2_3.csg"
SIZE, CAMERA = "64x48", "30,-40,25,0,0,2"
RATES = ("frames_per_second", "hosted_frames_per_second")
MACHINES = ("pixel-planes-4", "pixel-planes-4+host.processor=ideal", "pixel-planes-4+scan_out.buffers=2+array.memory_bits=128",
            "scan-line", "pixel-square", "pixel-planes-5", "multi-processor", "digital-bit-serial-ddr4")


def rates_of(row):
    return tuple(row[name] for name in RATES)


class Rates(unittest.TestCase):
    """Frame rates of one model and machine, from every place that reports them."""

    @classmethod
    def setUpClass(cls):
        cls.viewed = server.Server(support.CSGSIM, MODEL)

    @classmethod
    def tearDownClass(cls):
        cls.viewed.stop()

    def points(self, machine):
        """The point of each study."""
        given = {"machines": machine, "size": SIZE, "camera": CAMERA, "progress": "none"}
        yield csgsim.compare(MODEL, **given, fragments="none", sides="none")[0]
        given |= {"curves": "facets", "strategy": ["stack"]}
        yield from csgsim.sweep(MODEL, **given)
        yield from csgsim.sweep(MODEL, **given, no_draw=True)

    def test_studies_view_and_run_report_the_frame_rates_of_render(self):
        for machine in MACHINES:
            given = {"machine": machine, "size": SIZE, "camera": CAMERA, "curves": "facets"}
            with self.subTest(machine=machine), tempfile.TemporaryDirectory() as folder:
                stats, _ = support.stats("render", MODEL, **given)
                rates = rates_of(stats)
                hz = stats["machine"]["clock_hz"]
                self.assertAlmostEqual(rates[0] * stats["interval_clocks"] / hz, 1, places=12)
                self.assertAlmostEqual(rates[1] * max(stats["interval_clocks"], stats["host_clocks"]) / hz, 1, places=12)
                for point in self.points(machine):
                    self.assertEqual(rates_of(point), rates)
                self.assertEqual(rates_of(csgsim.render(MODEL, **given, progress="none").stats), rates)
                status, answer = self.viewed.post("draw", {"knobs": given})
                self.assertEqual(status, 200, answer)
                self.assertEqual(rates_of(answer["stats"]), rates)
                program = pathlib.Path(folder) / "p.csgt"
                support.done("compile", MODEL, "-o", str(program), **given)
                ran, _ = support.stats("run", str(program))
                self.assertEqual(rates_of(ran), rates)
                printed = support.done("render", MODEL, **given)
                shown = re.search(r"^shown +at ([0-9.,e-]+) frames/s", printed, re.MULTILINE)
                self.assertAlmostEqual(float(shown[1].replace(",", "")) / rates[0], 1, places=3)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
