"""Runs the commands behind the numbers of the pages, each once."""

import csv
import json
import os
import pathlib
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Record(dict):
    """A JSON object whose keys are also attributes."""

    def __getattr__(self, name):
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"there is no key '{name}'; there are {', '.join(self)}") from None


class Failed(Exception):
    """Raised for a failing command, with its output."""


class Run:
    """The output of a command, and the folder that it wrote to, $OUT."""

    def __init__(self, printed, folder):
        self.printed = printed
        self.folder = folder

    def json(self, name):
        return json.loads((self.folder / name).read_text(encoding="utf-8"), object_hook=Record)

    def csv(self, name):
        with open(self.folder / name, newline="", encoding="utf-8") as file:
            return [Record(row) for row in csv.DictReader(file)]


class Runs:
    """Runs commands in bash, in the repository's root with the build folder on the PATH."""

    def __init__(self, build):
        self.build = pathlib.Path(build).resolve()
        self._scratch = tempfile.TemporaryDirectory(prefix="csgsim-docs-")
        self._done = {}
        self._folders = 0

    def run(self, command):
        if command not in self._done:
            self._done[command] = self._run(command)
        return self._done[command]

    def __len__(self):
        return len(self._done)

    def _run(self, command):
        folder = pathlib.Path(self._scratch.name) / str(self._folders)
        self._folders += 1
        folder.mkdir()
        environment = dict(os.environ, OUT=str(folder), LC_ALL="C.UTF-8",
                           FONTCONFIG_FILE=str(ROOT / "tests/support/fonts.conf"), PATH=f"{self.build}:{os.environ['PATH']}")
        done = subprocess.run(["bash", "-e", "-o", "pipefail", "-c", command], cwd=ROOT, env=environment, text=True,
                              stdin=subprocess.DEVNULL, capture_output=True, check=False)
        if done.returncode != 0:
            raise Failed(f"'{command}' ended with {done.returncode}: {done.stderr.strip()}")
        return Run(done.stdout, folder)
