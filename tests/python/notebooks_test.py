#!/usr/bin/env python3
"""Runs the notebooks and compares their numbers with the command line: notebooks_test.py CSGSIM SOURCE [nbconvert]"""

import contextlib
import importlib.util
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy

import exr
import support

support.begin(*sys.argv[1:3], below="docs/notebooks")
FOLDER = support.FOLDER
BRACKET = "../../tests/corpus/parts/bracket.csg"
FIGURE = "../../tests/models/thesis_fig_2_3.csg"
CARBURETTOR = "../../tests/models/carburettor.csg"
VIEW = {"size": "256x256", "camera": "220,-255,135,2,0,5"}


def cells(name):
    """The sources of a notebook's code cells, and whether it contains outputs."""
    notebook = json.loads((FOLDER / f"{name}.ipynb").read_text(encoding="utf-8"))
    code = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    return ["".join(cell["source"]) for cell in code], any(cell["outputs"] or cell["execution_count"] for cell in code)


def carried_out(name):
    """Runs the cells; returns the names that they define, and their output."""
    names, printed = {"__name__": "__main__"}, io.StringIO()
    os.chdir(FOLDER)
    with contextlib.redirect_stdout(printed):
        for source in cells(name)[0]:
            exec(compile(source, f"{name}.ipynb", "exec"), names)  # pylint: disable=exec-used
    return names, printed.getvalue()


def owners(*operands, **options):
    """The owner of each pixel, as written by --owner."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "owner.exr")
        support.done("render", *operands, **options, owner=file)
        return exr.read(file.read_bytes())


class Notebooks(unittest.TestCase):
    """Each of the tasks of docs/view.md."""

    def test_notebooks_contain_no_outputs(self):
        for file in FOLDER.glob("*.ipynb"):
            self.assertFalse(cells(file.stem)[1], file.name)

    def test_a_part_on_the_machines_of_the_eighties(self):
        names, printed = carried_out("part")
        stats, picture = support.stats("render", BRACKET)
        self.assertEqual(names["drawing"].png(), picture)
        self.assertEqual(names["stats"]["dearest"], stats["dearest"])
        self.assertIn(f"{stats['clocks']:,} clocks", printed)
        self.assertIn(stats["bound_by"]["sentence"], printed)
        self.assertEqual(names["seen"].sum(), (owners(BRACKET) == stats["dearest"][0]["primitive"]).sum())
        told = support.study("compare", BRACKET, machines="pixel-planes-4,scan-line,pixel-planes-5", fragments="none", sides="none")
        self.assertEqual([row["clocks"] for row in names["machines"]], [row["clocks"] for row in told["points"]])

    def test_trees_and_bits(self):
        names, printed = carried_out("trees_and_bits")
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "figure.csgt")
            support.done("compile", FIGURE, size="8x8", z_bits=8, fraction_bits=0, output=file)
            lines = support.done("disasm", str(file)).splitlines()
        self.assertIn(names["instruction"]["text"], next(line for line in lines if line.endswith("# i8")))
        levels = [-88, -88, -111, -111, -55, -27]  # includes the levels probed in the wave of docs/view.md
        self.assertIn(f"{levels}\n", printed)
        for bits, stats in zip((1, 2, 4, 8), names["alu"]):
            said, _ = support.stats("render", CARBURETTOR, **VIEW, machine=f"pixel-planes-4+alu.bits={bits}")
            self.assertEqual(stats["clocks"], said["clocks"])
        told = support.study("sweep", CARBURETTOR, **VIEW, no_draw=True, stack_bits="3,4,5")
        self.assertEqual(support.without_build(names["memory"]), support.without_build(told["points"]))

    def test_a_wrong_pixel(self):
        names, printed = carried_out("wrong_pixel")
        said = support.done("explain", BRACKET, z_bits=8, pixel="344,389", why_not="p2")
        self.assertIn("\n".join(said.splitlines()[:10]), printed)
        fine = owners(BRACKET)
        numpy.testing.assert_array_equal(names["fine"].owner, fine)
        self.assertEqual(names["enough"][8], (owners(BRACKET, z_bits=8) != fine).sum())
        self.assertEqual(names["enough"][20], 0)


def convert():
    """Runs each notebook in Jupyter; skipped without it."""
    if importlib.util.find_spec("nbconvert") is None or importlib.util.find_spec("ipykernel") is None:
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        for file in sorted(FOLDER.glob("*.ipynb")):
            subprocess.run([sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", "--output-dir", folder, str(file)],
                           check=True)


if __name__ == "__main__":
    if "nbconvert" in sys.argv[3:]:
        convert()
    else:
        unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
