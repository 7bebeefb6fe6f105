"""The calls; each does the same as the command of that name.

Units, everywhere: times in seconds, and in clocks of the machine where a key says clocks; lengths and depths in model
units; sizes in pixels; memory in bits per pixel; rates per second; `share` and `utilization` as fractions of 1.
docs/settings.md has the unit of each key.
"""

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
    whose folder is searched for imports. Options are named as on the command line, see `options("render")`; options
    that name files write them. Sizes are in pixels, `camera` is in model units, and `z_bits` and `memory_bits` are bits
    per pixel; the drawing's `stats` have `clocks` of the machine and `simulated_seconds`.

    >>> drawing = csgsim.render("part.csg", size=(512, 512), z_bits=16, machine="pixel-planes-5")
    >>> drawing = csgsim.render(text="sphere(10);", set={"alu.bits": 2})
    """
    words = words_of("render", options)
    return Drawing(warned(*_csgsim.render(_model(model, text), words, text)))


def compile(model=None, /, *, text=None, **options):
    """Compiles a model into a Program, like `csgsim compile`. Model, text and options are as for render. The length of
    a Program is its number of instructions.

    >>> len(csgsim.compile("part.csg", strategy="list"))
    """
    words = words_of("compile", options)
    return Program(warned(*_csgsim.compile(_model(model, text), words, text)))


def run(program, /, **options):
    """Runs a Program, or a Program file, like `csgsim run`. The picture is the same as from render, and so are the units
    of its counts: `clocks` of the machine and `simulated_seconds`.

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
    """Explains what a pixel of a model, its text or a Program shows, like `csgsim explain`. `pixel` is column and row,
    from 0 at the upper left. Depths of the story are in depth steps, and times in clocks of the machine.

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

    `clocks` are the machine's until the picture is drawn, `simulated_seconds` the same in seconds; `memory_bits`,
    `z_bits`, `stack_bits` and `classification_bits` are bits per pixel; `frames_per_second` is a rate.
    docs/settings.md#columns-of-studies explains all keys.

    >>> rows = csgsim.sweep("part.csg", strategy=["stack", "list"], z_bits=[16, 20])
    >>> min(rows, key=lambda row: row["clocks"])["strategy"]
    """
    return study("sweep", *models, **options)["points"]


def compare(model, /, **options):
    """Compares machines on a model, like `csgsim compare`: a dictionary per machine and variation.

    `clocks` are those of the row's machine, and differ in length: compare `simulated_seconds`. `frames_per_second` is a
    rate, `machine_memory_bits` are the bits of the whole machine, and sizes are in pixels.

    >>> for row in csgsim.compare("part.csg", fragments="none", sides="none"):
    ...     print(row["machine"], row["clocks"], row["frames_per_second"])
    """
    return study("compare", model, **options)["points"]


def accuracy(model, /, **options):
    """Measures the cost of accuracy in clocks, like `csgsim accuracy`: a dictionary per knob and value.

    `wrong` and `covered` count pixels, `depth_max` is in model units and `depth_max_steps` in depth steps,
    `used_bits` are bits per pixel, and `simulated_seconds` are seconds of the machine.

    >>> [row["wrong"] for row in csgsim.accuracy("part.csg", views=1) if row["knob"] == "z-bits"]
    """
    return study("accuracy", model, **options)["points"]


def data_frame(result, table="points"):
    """Returns a study's result, or its rows, as a pandas DataFrame with a row per point. It needs pandas.

    `result` is what `study`, `sweep`, `compare` or `accuracy` returned; `table` names another list of the study's
    result, such as "front" of `advise`. The columns are the keys of the rows, with their units in their names (clocks,
    seconds, bits); a dictionary in a row becomes a column for each of its keys, as in `seconds.mc68000.all`. The frame's
    `attrs["study"]` is the command of the study.

    >>> frame = csgsim.data_frame(csgsim.sweep("part.csg", z_bits=[16, 20]))
    >>> frame.groupby("strategy")["clocks"].min()
    >>> csgsim.data_frame(csgsim.study("advise", "part.csg"), "front")
    """
    try:
        import pandas
    except ImportError as error:
        raise ImportError("data_frame() needs pandas: apt install python3-pandas, or pip install pandas") from error
    rows = result
    if isinstance(result, dict):
        rows = result.get(table)
        if not isinstance(rows, list):
            tables = [key for key, value in result.items() if isinstance(value, list)]
            raise KeyError(f"the result has no table '{table}'; it has {', '.join(tables)}")
    frame = pandas.json_normalize(list(rows))
    if isinstance(result, dict):
        frame.attrs["study"] = result["study"]
    return frame


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
