"""Helpers for the tests of the Python module: results of the command line for comparison."""

import json
import os
import pathlib
import subprocess
import tempfile

CSGSIM = None  # path of the program, an argument of tests/python/*_test.py
SOURCE = None  # the repository
FOLDER = None  # working directory of commands


def begin(program, source, below="."):
    """Must be called first. Removes the preloaded sanitizer runtime: programs started by the tests contain their
    own."""
    os.environ.pop("LD_PRELOAD", None)
    global CSGSIM, SOURCE, FOLDER  # pylint: disable=global-statement
    CSGSIM, SOURCE = pathlib.Path(program).resolve(), pathlib.Path(source).resolve()
    FOLDER = SOURCE / below


def words(options):
    """Options as arguments of a command line: z_bits in Python is --z-bits there."""
    for name, value in options.items():
        for each in value if isinstance(value, list) else [value]:
            yield f"--{name.replace('_', '-')}"
            if each is not True:
                yield str(each)


def command(*operands, **options):
    """Runs csgsim."""
    line = [CSGSIM, *operands, *words(options)]
    return subprocess.run(line, cwd=FOLDER, check=False, text=True, capture_output=True)


def done(*operands, **options):
    """Runs a command that must succeed and returns its output."""
    ended = command(*operands, **options)
    if ended.returncode != 0:
        raise AssertionError(f"{operands} {options}: {ended.stderr}")
    return ended.stdout


def stats(*operands, **options):
    """The stats of --stats, and the bytes of the picture."""
    with tempfile.TemporaryDirectory() as folder:
        file, picture = pathlib.Path(folder, "stats.json"), pathlib.Path(folder, "picture.png")
        done(*operands, **options, stats=file, output=picture, progress="none")
        return json.loads(file.read_text(encoding="utf-8")), picture.read_bytes()


def study(name, *operands, **options):
    """The JSON file of a study."""
    with tempfile.TemporaryDirectory() as folder:
        done(name, *operands, **options, output=folder, no_plots=True, progress="none")
        return json.loads(pathlib.Path(folder, f"{name}.json").read_text(encoding="utf-8"))


def without_time(value):
    """The value without wall times, which differ from run to run."""
    if isinstance(value, dict):
        return {key: without_time(each) for key, each in value.items() if not key.startswith("wall_seconds")}
    return [without_time(each) for each in value] if isinstance(value, list) else value


def without_build(rows):
    """Rows of a study without the build that measured them, as program and module differ in it."""
    return [{key: value for key, value in row.items() if key != "csgsim"} for row in without_time(rows)]
