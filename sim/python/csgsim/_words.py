"""Conversion of Python values to the texts of the command line."""

import functools
import keyword
import numbers
import os
from collections.abc import Iterable, Mapping

from . import _csgsim
from ._machine import Machine


def text_of(value):
    """Converts a value to one text; the parts of a sequence are separated by commas."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return value
    if isinstance(value, Machine):
        return value.spelt
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, Iterable):
        return ",".join(text_of(one) for one in value)
    raise TypeError(f"{value!r} is not a text, number, path, machine or sequence of these")


def texts_of(value):
    """Converts a value of a repeatable option to several texts: `{"alu.bits": 2}` becomes `["alu.bits=2"]`."""
    if isinstance(value, Mapping):
        return [f"{key}={text_of(one)}" for key, one in value.items()]
    if isinstance(value, (str, bytes)):
        return [value]
    return [text_of(one) for one in value]


@functools.cache
def _takes(command):
    return {row["name"]: row["takes"] for row in _csgsim.options(command)}


def python_name_of(name):
    """An option's name in Python; keywords get an underscore, as in `with_`."""
    return name.replace("-", "_") + "_" * keyword.iskeyword(name)


def words_of(command, options):
    """Returns pairs of an option's name and its text on the command line, which is None for a flag. Options with the
    value None or False are left out."""
    words = []
    for python_name, value in options.items():
        name = python_name.removesuffix("_").replace("_", "-")
        takes = _takes(command).get(name, "text")
        if value is None or (takes == "flag" and value is False):
            continue
        if takes == "flag" and value is True:
            words.append((name, None))
        elif takes == "texts":
            words.extend((name, text) for text in texts_of(value))
        else:
            words.append((name, text_of(value)))
    return words
