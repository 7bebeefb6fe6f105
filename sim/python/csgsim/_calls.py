"""The calls; each does the same as the command of that name."""

import os
import sys
import warnings

from . import _csgsim
from ._errors import CsgsimWarning
from ._results import Drawing, Program, Story
from ._words import python_name_of, words_of

_TEXT_NAME = "text.csg"


def warned(result, lines):
    """Issues the warnings, attributed to the first caller outside this package, and returns the result."""
    if lines:
        folder = os.path.dirname(__file__)
        level, frame = 1, sys._getframe()
        while frame.f_back and os.path.dirname(frame.f_code.co_filename) == folder:
            level, frame = level + 1, frame.f_back
        for line in lines:
            warnings.warn(line, CsgsimWarning, stacklevel=level)
    return result


def _model(model, text):
    """Returns the operands of a command that takes a model."""
    if model is None and text is None:
        raise TypeError("name a model's file, or pass the model's text as text=")
    return [_TEXT_NAME if model is None else os.fspath(model)]


def render(model=None, /, *, text=None, **options):
    """Draws a model on a machine and counts its clocks, like `csgsim render`.

    `model` names a file: .csg, an OpenSCAD source .scad, which OpenSCAD evaluates, commands, .jan, or a mesh. With
    `text`, the model is that text; `model` is then its name in messages, whose ending selects the kind of model and
    whose folder is searched for imports. Options are named as on the command line, see `options("render")`; options that name files
    write them.

    >>> drawing = csgsim.render("part.csg", size=(512, 512), z_bits=16, machine="pixel-planes-5")
    >>> drawing = csgsim.render(text="sphere(10);", set={"alu.bits": 2})
    """
    words = words_of("render", options)
    return Drawing(warned(*_csgsim.render(_model(model, text), words, text)))


def compile(model=None, /, *, text=None, **options):
    """Compiles a model into a Program, like `csgsim compile`. Model, text and options are as for render.

    >>> len(csgsim.compile("part.csg", strategy="list"))
    """
    words = words_of("compile", options)
    return Program(warned(*_csgsim.compile(_model(model, text), words, text)))


def run(program, /, **options):
    """Runs a Program, or a Program file, like `csgsim run`. The picture is the same as from render.

    >>> csgsim.run(csgsim.compile("part.csg"), level="reference").stats["clocks"]
    """
    words = words_of("run", options)
    operand, native = _program(program)
    return Drawing(warned(*_csgsim.run(operand, words, native)))


def _program(program):
    """Returns the operand that names the Program, and the Program itself unless it is a file."""
    if isinstance(program, Program):
        return ["program.csgt"], program._native
    return [os.fspath(program)], None


def explain(subject=None, /, *, text=None, **options):
    """Explains what a pixel of a model, its text or a Program shows, like `csgsim explain`.

    >>> story = csgsim.explain("part.csg", pixel=(344, 389), why_not="p2")
    >>> story["owner"], print(story.text)
    """
    words = words_of("explain", options)
    operand, native = _program(subject) if isinstance(subject, Program) else (_model(subject, text), None)
    keys, text_of_story, lines = _csgsim.explain(operand, words, text, native)
    return warned(Story(keys, text_of_story), lines)


def study(name, /, *operands, **options):
    """Runs a study and returns the content of its JSON file. `studies()` lists the studies, `options(name)` their
    options. Nothing is stored, unless `output` names a folder, where an interrupted study continues.

    >>> csgsim.study("advise", "part.csg", max_wrong_pixels=0)["chosen"]
    """
    words = words_of(name, options)
    return warned(*_csgsim.study(name, [os.fspath(one) for one in operands], words))


def sweep(*models, **options):
    """Measures the benefit of memory bits, like `csgsim sweep`: a dictionary per point.

    docs/settings.md#columns-of-studies explains the keys.

    >>> rows = csgsim.sweep("part.csg", strategy=["stack", "list"], z_bits=[16, 20])
    >>> min(rows, key=lambda row: row["clocks"])["strategy"]
    """
    return study("sweep", *models, **options)["points"]


def compare(model, /, **options):
    """Compares machines on a model, like `csgsim compare`: a dictionary per machine and variation.

    >>> for row in csgsim.compare("part.csg", fragments="none", sides="none"):
    ...     print(row["machine"], row["clocks"], row["frames_per_second"])
    """
    return study("compare", model, **options)["points"]


def accuracy(model, /, **options):
    """Measures the cost of accuracy in clocks, like `csgsim accuracy`: a dictionary per knob and value.

    >>> [row["wrong"] for row in csgsim.accuracy("part.csg", views=1) if row["knob"] == "z-bits"]
    """
    return study("accuracy", model, **options)["points"]


def studies():
    """Returns the names of all studies.

    >>> "sweep" in csgsim.studies()
    True
    """
    return _csgsim.studies()


def options(command, /):
    """Returns the options of a call: a dictionary per option, with its `name`, the kind of value it `takes`, its
    `default` and its `meaning`. Values are given as numbers, texts, paths or sequences of these.

    >>> [row["name"] for row in csgsim.options("render")][:3]
    ['machine', 'memory_bits', 'size']
    """
    rows = []
    for row in _csgsim.options(command):
        if not row.pop("is_operand"):
            default = row["default"]
            several = row["takes"] == "texts"
            rows.append({**row, "name": python_name_of(row["name"]),
                         "default": default if several else default[0] if default else None})
    return rows
