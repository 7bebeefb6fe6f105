"""The calls: each does what the command of its name does."""

import os
import sys
import warnings

from . import _csgsim
from ._errors import CsgsimWarning
from ._results import Drawing, Program, Story
from ._words import python_name_of, words_of

_TEXT_NAME = "text.csg"


def warned(result, lines):
    """The result, after its warnings, which name the first line outside this package."""
    if lines:
        folder = os.path.dirname(__file__)
        level, frame = 1, sys._getframe()
        while frame.f_back and os.path.dirname(frame.f_code.co_filename) == folder:
            level, frame = level + 1, frame.f_back
        for line in lines:
            warnings.warn(line, CsgsimWarning, stacklevel=level)
    return result


def _model(model, text):
    """The operands of a command that takes a model."""
    if model is None and text is None:
        raise TypeError("name a model's file, or give the model itself by text=")
    return [_TEXT_NAME if model is None else os.fspath(model)]


def render(model=None, /, *, text=None, **options):
    """Draws a model on a machine and counts what it takes, as `csgsim render` does.

    `model` names a file: .csg, OpenSCAD's source .scad, which OpenSCAD evaluates, or commands, .jan. With `text` the
    model is that, and `model` its name in messages, whose ending tells what it is and whose folder has its imports.
    Options are named as on the command line, `options("render")` lists them; those that name files write them.

    >>> drawing = csgsim.render("part.csg", size=(512, 512), z_bits=16, machine="pixel-planes-5")
    >>> drawing = csgsim.render(text="sphere(10);", set={"alu.bits": 2})
    """
    words = words_of("render", options)
    return Drawing(warned(*_csgsim.render(_model(model, text), words, text)))


def compile(model=None, /, *, text=None, **options):
    """Compiles a model into a Program, as `csgsim compile` does; model, text and options are as render has them.

    >>> len(csgsim.compile("part.csg", strategy="list"))
    """
    words = words_of("compile", options)
    return Program(warned(*_csgsim.compile(_model(model, text), words, text)))


def run(program, /, **options):
    """Runs a Program, or a Program file, as `csgsim run` does. The picture is that of its render.

    >>> csgsim.run(csgsim.compile("part.csg"), level="reference").stats["clocks"]
    """
    words = words_of("run", options)
    operand, native = _program(program)
    return Drawing(warned(*_csgsim.run(operand, words, native)))


def _program(program):
    """The operand that names it, and the Program if it is one."""
    if isinstance(program, Program):
        return ["program.csgt"], program._native
    return [os.fspath(program)], None


def explain(subject=None, /, *, text=None, **options):
    """Tells why a pixel shows what it shows, as `csgsim explain` does: of a model, named or a text, or of a Program.

    >>> story = csgsim.explain("part.csg", pixel=(344, 389), why_not="p2")
    >>> story["owner"], print(story.text)
    """
    words = words_of("explain", options)
    operand, native = _program(subject) if isinstance(subject, Program) else (_model(subject, text), None)
    keys, words_told, lines = _csgsim.explain(operand, words, text, native)
    return warned(Story(keys, words_told), lines)


def study(name, /, *operands, **options):
    """All that a study tells, as its JSON file has it. `studies()` lists them, `options(name)` what each takes. Nothing
    is kept, unless `output` names a folder, where an interrupted study goes on.

    >>> csgsim.study("advise", "part.csg", max_wrong_pixels=0)["chosen"]
    """
    words = words_of(name, options)
    return warned(*_csgsim.study(name, [os.fspath(one) for one in operands], words))


def sweep(*models, **options):
    """What memory bits buy, as `csgsim sweep`: a dictionary a point. Keys are explained in docs/settings.md#columns-of-studies.

    >>> rows = csgsim.sweep("part.csg", strategy=["stack", "list"], z_bits=[16, 20])
    >>> min(rows, key=lambda row: row["clocks"])["strategy"]
    """
    return study("sweep", *models, **options)["points"]


def compare(model, /, **options):
    """A model on several machines, as `csgsim compare`: a dictionary a machine and what it was turned to.

    >>> for row in csgsim.compare("part.csg", fragments="none", sides="none"):
    ...     print(row["machine"], row["clocks"], row["frames_per_second"])
    """
    return study("compare", model, **options)["points"]


def accuracy(model, /, **options):
    """What accuracy costs in clocks, as `csgsim accuracy`: a dictionary a knob and its value.

    >>> [row["wrong"] for row in csgsim.accuracy("part.csg", views=1) if row["knob"] == "z-bits"]
    """
    return study("accuracy", model, **options)["points"]


def studies():
    """The names of all studies.

    >>> "sweep" in csgsim.studies()
    True
    """
    return _csgsim.studies()


def options(command, /):
    """What a call takes: a dictionary an option, with its `name`, what it `takes`, its `default` and `meaning`. The
    values of an option are given as numbers, texts, paths or sequences of these.

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
