"""What the tests of the Python module share: the command line's own answers, to hold the module's against."""

import json
import os
import pathlib
import subprocess
import tempfile

CSGSIM = None  # the program, which tests/python/*_test.py are given
SOURCE = None  # the repository
FOLDER = None  # where commands run


def begin(program, source, below="."):
    """To be called first. Programs that the tests start have the runtime of their sanitizers in them."""
    os.environ.pop("LD_PRELOAD", None)
    global CSGSIM, SOURCE, FOLDER  # pylint: disable=global-statement
    CSGSIM, SOURCE = pathlib.Path(program).resolve(), pathlib.Path(source).resolve()
    FOLDER = SOURCE / below


def words(options):
    """Options as words of a command line: what Python calls z_bits is --z-bits there."""
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
    """The same of a command that has to end well."""
    ended = command(*operands, **options)
    if ended.returncode != 0:
        raise AssertionError(f"{operands} {options}: {ended.stderr}")
    return ended.stdout


def stats(*operands, **options):
    """What --stats writes, and the bytes of the picture."""
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
    """Without what differs from run to run: wall times."""
    if isinstance(value, dict):
        return {key: without_time(each) for key, each in value.items() if not key.startswith("wall_seconds")}
    return [without_time(each) for each in value] if isinstance(value, list) else value


def without_build(rows):
    """Rows of a study without which build has measured them: program and module are two."""
    return [{key: value for key, value in row.items() if key != "csgsim"} for row in without_time(rows)]
