"""csgsim: a clock-accurate simulator of the logic-enhanced frame buffers of the 1980s that draw CSG models.

>>> import csgsim
>>> drawing = csgsim.render("part.csg", z_bits=16)
>>> drawing.stats["clocks"], drawing.picture.shape

Each call does the same as the command of that name, with options of the same names: docs/python.md.
"""

from ._calls import accuracy, compare, compile, data_frame, explain, options, render, run, studies, study, sweep
from ._csgsim import version as _version
from ._errors import CsgsimWarning, Error, UsageError
from ._machine import Figure, Machine, machines
from ._results import Drawing, Program, Story

__version__ = _version()
__all__ = ["CsgsimWarning", "Drawing", "Error", "Figure", "Machine", "Program", "Story", "UsageError", "accuracy",
           "compare", "compile", "data_frame", "explain", "machines", "options", "render", "run", "studies", "study", "sweep"]

for _one in (accuracy, compare, compile, data_frame, explain, machines, options, render, run, studies, study, sweep):
    _one.__module__ = "csgsim"
del _one
