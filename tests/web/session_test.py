#!/usr/bin/env python3
"""csgsim.wasm in node gives the answers of csgsim view: session_test.py CSGSIM SOURCE SITE. Exit code 77 without SITE
or node."""

import base64
import itertools
import pathlib
import shutil
import struct
import subprocess
import sys
import unittest
import zlib

CSGSIM, SOURCE, SITE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
sys.path.insert(0, str(SOURCE / "tests/view"))

from server import Server  # noqa: E402
from web_page import Answering  # noqa: E402

CARBURETTOR = {"camera": "220,-255,135,2,0,5"}
FIGURE = {"camera": "42,-38,41,10,5.5,2"}
SHADOWS = ["effects.shadows.on=true", "effects.depth_cue.on=true"]
REQUESTS = [
    ("thesis_fig_2_3", FIGURE),
    ("carburettor", CARBURETTOR),
    ("carburettor", {**CARBURETTOR, "set": SHADOWS, "memory-bits": "300", "size": "256x256"}),
    ("carburettor", {**CARBURETTOR, "machine": "pixel-planes-5", "size": "256x256"}),
    ("thesis_fig_2_3", {**FIGURE, "machine": "pixel-square", "size": "128x128"}),
    ("molecule", {"camera": "300,-400,250,0,0,0", "view-all": True, "machine": "pixel-powers", "size": "128x128"}),
]


def pixels_of(url):
    """Width, height and bytes of a PNG with the filter sub, as sent to the page."""
    file = base64.b64decode(url.removeprefix("data:image/png;base64,"))
    width, height = struct.unpack(">II", file[16:24])
    length, = struct.unpack(">I", file[33:37])
    filtered = zlib.decompress(file[41:41 + length])
    pixels = bytearray()
    for row in (filtered[y * (3 * width + 1):(y + 1) * (3 * width + 1)] for y in range(height)):
        assert row[0] == 1
        sums = [itertools.accumulate(row[1 + channel::3], lambda a, b: a + b & 255) for channel in range(3)]
        pixels += bytes(itertools.chain.from_iterable(zip(*sums)))
    return width, height, bytes(pixels)


def rendered(command):
    """Width, height and bytes of the picture drawn by the command that the page shows."""
    words = command.replace("csgsim", str(CSGSIM), 1) + " --progress none -o picture.ppm"
    ppm = subprocess.run(["bash", "-c", f"cd $(mktemp -d) && {words.replace('tests/', str(SOURCE) + '/tests/')} >/dev/null && cat picture.ppm && rm -r $PWD"],
                         check=True, capture_output=True).stdout
    _, size, _, pixels = ppm.split(b"\n", 3)
    return *map(int, size.split()), pixels


def without(value, *keys):
    """The value without times, and without pictures, whose files are compressed differently."""
    if isinstance(value, dict):
        return {key: without(each, *keys) for key, each in value.items() if key not in keys}
    return [without(each, *keys) for each in value] if isinstance(value, list) else value


class Session(unittest.TestCase):
    def both(self, model):
        """A native server, and csgsim.wasm in node."""
        file = f"tests/models/{model}"
        server = Server(CSGSIM, file, cwd=SOURCE)
        self.addCleanup(server.stop)
        answering = Answering(SITE, file, (SOURCE / file).read_text())
        self.addCleanup(answering.stop)
        self.assertEqual(answering.begun[0], 200, answering.begun)
        return server, answering

    def check_same(self, both, question, request):
        (status, expected), (other, told) = (one.post(question, request) for one in both)
        self.assertEqual((other, without(told, "picture", "seconds")), (status, without(expected, "picture", "seconds")), question)
        return told

    def test_pictures_counts_and_stories_equal_those_of_the_native_program(self):
        for model, knobs in REQUESTS:
            with self.subTest(model=model, knobs=knobs):
                both = self.both(model + ".csg")
                request = {"knobs": knobs}
                drawn = self.check_same(both, "draw", request)
                self.assertEqual(pixels_of(drawn["picture"]), rendered(drawn["command"]))
                at = f"{drawn['width'] // 2},{drawn['height'] // 2}"
                self.assertGreater(len(self.check_same(both, "explain", {**request, "pixel": at, "why_not": "p1"})["text"]), 100)

    def test_instants_trees_verdicts_and_comparisons_equal_those_of_the_native_program(self):
        both = self.both("carburettor.csg")
        request = {"knobs": {**CARBURETTOR, "size": "128x128"}}
        for number in (0, 100, 5000, 10 ** 9):
            self.check_same(both, "instant", {**request, "number": number, "field": "Z1", "tinted": True})
        self.check_same(both, "instant", {**request, "primitive": 3, "field": "", "tinted": False})
        for question in ("tree", "verdict", "advice"):
            self.check_same(both, question, request)
        self.check_same(both, "two", {"a": request, "b": {"knobs": {**request["knobs"], "z-bits": "8"}}})

    def test_draws_an_edited_source_and_rejects_a_wrong_source(self):
        both = self.both("thesis_fig_2_3.csg")
        self.check_same(both, "draw", {"knobs": {"size": "64x64"}, "source": "cube(size=[20,20,20],center=true);"})
        for source in ("cube(", "sphere(r=;", "cube(size=[20,20,20]);\nnothing();", 'import(file="a.amf");'):
            status, told = both[1].post("draw", {"knobs": {}, "source": source})
            self.assertEqual(status, 422, source)
            self.assertTrue(told["error"], source)
        self.check_same(both, "draw", {"knobs": {"machine": "pixel-planes-6"}})
        self.check_same(both, "draw", {"knobs": {"z-bits": "99"}})

    def test_rejects_missing_features_and_names_an_alternative(self):
        _, answering = self.both("thesis_fig_2_3.csg")
        for question, request, told in (("lanes", {}, "csgsim view"), ("wave", {"pixel": "1,1", "window": "i0:i4"}, "csgsim view"),
                                     ("draw", {"source": 'text(text="A");'}, "text()"), ("draw", {"source": 'import(file="a.stl");'}, "a.stl")):
            status, answer = answering.post(question, {"knobs": {}, **request})
            self.assertEqual(status, 422, answer)
            self.assertIn(told, answer["error"])
        scad = Answering(SITE, "part.scad", "cube(3);")
        self.addCleanup(scad.stop)
        status, answer = scad.post("draw", {"knobs": {}})
        self.assertEqual(status, 422)
        self.assertIn("export the model as .csg", answer["error"])

    def test_the_report_of_a_drawing_is_an_html_page(self):
        _, answering = self.both("thesis_fig_2_3.csg")
        answering.post("draw", {"knobs": {"size": "64x64"}})
        status, page = answering.send({"question": "report"})
        self.assertEqual(status, 200)
        self.assertTrue(page.startswith("<!DOCTYPE html>"))

    def test_reports_too_little_memory_and_continues(self):
        _, answering = self.both("thesis_fig_2_3.csg")
        self.assertEqual(answering.post("draw", {"knobs": {"size": "16384x16384"}}), (422, {"error": "there is not enough memory; use a smaller picture or model"}))
        self.assertEqual(answering.post("draw", {"knobs": {"size": "64x64"}})[0], 200)


if __name__ == "__main__":
    if not (SITE / "csgsim.wasm").exists() or not shutil.which("node"):
        print("the page or node is missing; run ./setup.sh web")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
