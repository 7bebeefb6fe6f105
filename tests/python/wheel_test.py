#!/usr/bin/env python3
"""Builds the wheel from a build folder, without a network, and uses it in a virtual environment: wheel_test.py BUILD
SOURCE"""

import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import zipfile

BUILD, SOURCE = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
# The modules for text and for formats other than PNG are loaded on demand.
PROGRAM = """
import csgsim, pathlib, sys
assert pathlib.Path(csgsim.__file__).is_relative_to(sys.prefix), csgsim.__file__
print(csgsim.__version__, csgsim.render(text='text("a");', size=(16, 16), output='a.tif'))
assert pathlib.Path('a.tif').stat().st_size > 0
"""


def run(folder, *words, **variables):
    """Runs a program in a folder, without paths of the build; it must succeed."""
    environment = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "LD_LIBRARY_PATH")}
    done = subprocess.run([str(word) for word in words], cwd=folder, check=False, text=True, capture_output=True,
                          env={**environment, **variables})
    if done.returncode != 0:
        sys.exit(f"{words}: {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def main():
    absent = [name for name in ("pip", "setuptools", "wheel", "venv", "ensurepip") if importlib.util.find_spec(name) is None]
    if absent:
        print("missing in Python:", *absent)
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run(SOURCE, sys.executable, "-m", "pip", "wheel", "--no-build-isolation", "--no-deps", "--no-index", "--wheel-dir", folder, ".",
            CSGSIM_BUILD=str(BUILD))
        wheel, = folder.glob("csgsim-*.whl")
        names = zipfile.ZipFile(wheel).namelist()
        for file in ("__init__.py", "__init__.pyi", "py.typed", "csgsim_pictures.so", "csgsim_text.so"):
            assert f"csgsim/{file}" in names, (file, names)
        # This Python may have numpy in its user's or the system's folders.
        run(folder, sys.executable, "-m", "venv", "--system-site-packages", "env")
        run(folder, "env/bin/python", "-m", "pip", "install", "--no-deps", "--no-index", wheel)
        print(wheel.name, run(folder, "env/bin/python", "-c", PROGRAM))


main()
