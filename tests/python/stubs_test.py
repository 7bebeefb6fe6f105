#!/usr/bin/env python3
"""Checks that the typed stubs match the module: stubs_test.py SOURCE [mypy]"""

import ast
import importlib.util
import inspect
import os
import pathlib
import re
import subprocess
import sys
import unittest

import csgsim

SOURCE = pathlib.Path(sys.argv[1]).resolve() / "sim/python/csgsim"
STUB = ast.parse((SOURCE / "__init__.pyi").read_text(encoding="utf-8"))
BODY = {node.name: node for node in STUB.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
OPTIONS = {"render": "RenderOptions", "compile": "ModelOptions", "run": "RunOptions", "explain": "ExplainOptions",
           "sweep": "SweepOptions", "compare": "CompareOptions", "accuracy": "AccuracyOptions"}
TYPES = {"flag": "bool", "whole number": "int", "number": "float", "text": "Text", "texts": "Texts"}


def parameters_of(function):
    """Name, kind and presence of a default for the parameters of a stub's function."""
    arguments = function.args
    plain = [*arguments.posonlyargs, *arguments.args]
    defaults = [False] * (len(plain) - len(arguments.defaults)) + [True] * len(arguments.defaults)
    for argument, default in zip(plain, defaults):
        kind = "POSITIONAL_ONLY" if argument in arguments.posonlyargs else "POSITIONAL_OR_KEYWORD"
        yield argument.arg, kind, default
    if arguments.vararg:
        yield arguments.vararg.arg, "VAR_POSITIONAL", False
    for argument, default in zip(arguments.kwonlyargs, arguments.kw_defaults):
        yield argument.arg, "KEYWORD_ONLY", default is not None
    if arguments.kwarg:
        yield arguments.kwarg.arg, "VAR_KEYWORD", False


def parameters_in(function):
    """Name, kind and presence of a default for the parameters of the module's function."""
    for parameter in inspect.signature(function).parameters.values():
        yield parameter.name, parameter.kind.name, parameter.default is not inspect.Parameter.empty


def options_in(name):
    """Types of options by name, for a class of the stub and its bases."""
    if name not in BODY:
        return {}
    options = {}
    for base in BODY[name].bases:
        options.update(options_in(base.id))
    options.update((node.target.id, ast.unparse(node.annotation)) for node in BODY[name].body if isinstance(node, ast.AnnAssign))
    return options


def own(kind):
    """Public members that a class of the module defines itself."""
    return {name: value for name, value in vars(kind).items()
            if callable(value) or isinstance(value, (property, classmethod)) if not re.match(r"_[a-z]|__(class|hash|module|dict|weak)", name)}


def bound(value):
    return value.__func__ if isinstance(value, classmethod) else value


class Stubs(unittest.TestCase):
    """Names, signatures, options and examples."""

    def test_the_stubs_declare_exactly_the_public_names_of_the_module(self):
        public = {name for name in BODY if not name.startswith("_") and name not in OPTIONS.values()}
        self.assertEqual(sorted(public), sorted(csgsim.__all__))
        self.assertEqual(sorted(csgsim.__all__), csgsim.__all__)

    def test_functions_have_the_parameters_of_the_module(self):
        for name, node in BODY.items():
            if isinstance(node, ast.FunctionDef):
                self.assertEqual(list(parameters_of(node)), list(parameters_in(getattr(csgsim, name))), name)

    def test_classes_have_the_members_of_the_module(self):
        for name in ("Drawing", "Error", "Machine", "Program", "Story", "UsageError"):
            members = {node.name: node for node in BODY[name].body if isinstance(node, ast.FunctionDef)}
            self.assertEqual(sorted(members), sorted(own(getattr(csgsim, name))), name)
            for member, value in own(getattr(csgsim, name)).items():
                is_property = any(isinstance(each, ast.Name) and each.id == "property" for each in members[member].decorator_list)
                self.assertEqual(is_property, isinstance(value, property), f"{name}.{member}")
                if not is_property:
                    self.assertEqual(list(parameters_of(members[member])), list(parameters_in(bound(value))), f"{name}.{member}")

    def test_declared_attributes_equal_those_of_the_objects(self):
        drawing = csgsim.render(text="cube(size = 1);", size="8x8")
        for thing in (drawing, csgsim.Machine("scan-line"), csgsim.explain(drawing.program, pixel=(4, 4))):
            name = type(thing).__name__
            said = [node.target.id for node in BODY[name].body if isinstance(node, ast.AnnAssign)]
            self.assertEqual(sorted(said), sorted(each for each in vars(thing) if not each.startswith("_")), name)
        figure = [node.target.id for node in BODY["Figure"].body if isinstance(node, ast.AnnAssign)]
        self.assertEqual(tuple(figure), csgsim.Figure._fields)

    def test_options_and_types_equal_those_of_the_commands(self):
        for command, name in OPTIONS.items():
            self.assertEqual(options_in(name), {row["name"]: TYPES[row["takes"]] for row in csgsim.options(command)}, name)
            self.assertIn(f"Unpack[{name}]", ast.unparse(BODY[command]))

    def test_every_public_name_has_a_docstring_with_an_example(self):
        for name in csgsim.__all__:
            self.assertIn(">>> ", inspect.getdoc(getattr(csgsim, name)), name)
        self.assertTrue((pathlib.Path(csgsim.__file__).parent / "py.typed").exists())


RIGHT = """
import csgsim
drawing = csgsim.render("a.csg", z_bits=16, size=(8, 8), machine=csgsim.Machine("scan-line"), set={"alu.bits": 2})
height: int = drawing.picture.shape[0]
rows: list[dict[str, object]] = csgsim.sweep("a.csg", strategy=["stack", "list"])
"""
WRONG = 'import csgsim\ncsgsim.render("a.csg", z_bitz=16)\n'


def mypy(program):
    """mypy's output for a program. Until 1.7, mypy checks option types by name only on request."""
    environment = dict(os.environ, MYPYPATH=str(SOURCE.parent), MYPY_CACHE_DIR=os.devnull)
    return subprocess.run([sys.executable, "-m", "mypy", "--strict", "--enable-incomplete-feature=Unpack", "-c", program],
                          check=False, text=True, capture_output=True, env=environment)


def check_types():
    """mypy accepts a correct use of the module and rejects a wrong one; skipped without mypy."""
    if importlib.util.find_spec("mypy") is None:
        sys.exit(77)
    right, wrong = mypy(RIGHT), mypy(WRONG)
    print(right.stdout, wrong.stdout)
    sys.exit(right.returncode != 0 or wrong.returncode == 0 or "z_bitz" not in wrong.stdout)


if __name__ == "__main__":
    if "mypy" in sys.argv[2:]:
        check_types()
    unittest.main(argv=sys.argv[:1], verbosity=2)
