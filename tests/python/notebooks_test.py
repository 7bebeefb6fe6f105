#!/usr/bin/env python3
"""Runs the notebooks and compares their outputs and numbers with those stored and with the command line:
notebooks_test.py CSGSIM SOURCE [nbconvert | write]

`write` stores the outputs in the notebooks, after a change of csgsim or of a notebook."""

import ast
import base64
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


def read(name):
    return json.loads((FOLDER / f"{name}.ipynb").read_text(encoding="utf-8"))


def lines(text):
    """A text as a notebook stores it."""
    return text.splitlines(keepends=True)


def displayed(value, number):
    """The output of a cell that ends with a value, as Jupyter stores it."""
    data = {"text/plain": lines(repr(value))}
    if hasattr(value, "_repr_png_"):
        data["image/png"] = base64.b64encode(value._repr_png_()).decode("ascii") + "\n"  # pylint: disable=protected-access
    return {"data": data, "execution_count": number, "metadata": {}, "output_type": "execute_result"}


def executed(source, number, names):
    """Runs a cell; returns its outputs."""
    tree = ast.parse(source)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    printed, value = io.StringIO(), None
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, "cell", "exec"), names)  # pylint: disable=exec-used
        if last is not None:
            value = eval(compile(ast.Expression(last.value), "cell", "eval"), names)  # pylint: disable=eval-used
    outputs = []
    if printed.getvalue():
        outputs.append({"name": "stdout", "output_type": "stream", "text": lines(printed.getvalue())})
    if value is not None:
        outputs.append(displayed(value, number))
    return outputs


def run(name):
    """Runs a notebook; returns the notebook with its outputs, and the names that it defines."""
    notebook, names, number = read(name), {"__name__": "__main__"}, 0
    os.chdir(FOLDER)
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            number += 1
            cell["outputs"] = executed("".join(cell["source"]), number, names)
            cell["execution_count"] = number
    return notebook, names


def write():
    """Stores the outputs of all notebooks."""
    for file in sorted(FOLDER.glob("*.ipynb")):
        notebook, _ = run(file.stem)
        file.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


def printed_by(notebook):
    """All that the cells print."""
    outputs = [output for cell in notebook["cells"] for output in cell.get("outputs", [])]
    return "".join("".join(output["text"]) for output in outputs if output["output_type"] == "stream")


def carried_out(name):
    """Runs the cells; returns the names that they define, and their output. The outputs must be the stored ones."""
    notebook, names = run(name)
    for cell, stored in zip(notebook["cells"], read(name)["cells"]):
        if cell != stored:
            raise AssertionError(f"{name}.ipynb: the stored output of a cell is outdated; run notebooks_test.py CSGSIM SOURCE write:"
                                 f"\n{''.join(cell['source'])}")
    return names, printed_by(notebook)


def owners(*operands, **options):
    """The owner of each pixel, as written by --owner."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "owner.exr")
        support.done("render", *operands, **options, owner=file)
        return exr.read(file.read_bytes())


class Notebooks(unittest.TestCase):
    """Each of the tasks of docs/view.md."""

    def test_notebook_part_shows_the_results_of_the_commands(self):
        names, printed = carried_out("part")
        stats, picture = support.stats("render", BRACKET)
        self.assertEqual(names["drawing"].png(), picture)
        self.assertEqual(names["stats"]["dearest"], stats["dearest"])
        self.assertIn(f"{stats['clocks']:,} clocks", printed)
        self.assertIn(stats["bound_by"]["sentence"], printed)
        self.assertEqual(names["seen"].sum(), (owners(BRACKET) == stats["dearest"][0]["primitive"]).sum())
        told = support.study("compare", BRACKET, machines="pixel-planes-4,scan-line,pixel-planes-5", fragments="none", sides="none")
        self.assertEqual([row["clocks"] for row in names["machines"]], [row["clocks"] for row in told["points"]])

    def test_notebook_trees_and_bits_shows_the_results_of_the_commands(self):
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

    def test_notebook_wrong_pixel_shows_the_results_of_the_commands(self):
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
    elif "write" in sys.argv[3:]:
        write()
    else:
        unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
