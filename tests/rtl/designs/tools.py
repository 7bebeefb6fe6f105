"""Helpers shared by the scripts of this folder: running commands, and paths."""

import json
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
MODELS = ROOT / "tests/models"
SKIPPED = 77  # exit code of a test that cannot run here


def attempt(command, folder=None):
    """Runs a command, which may fail, and returns its `returncode`, `stdout` and `stderr`."""
    return subprocess.run(command, cwd=folder, capture_output=True, text=True)


def stop(why):
    sys.exit(f"{pathlib.Path(sys.argv[0]).name}: {why}")


def run(command, folder=None):
    """Runs a command that must succeed; otherwise the script ends with its output."""
    done = attempt(command, folder)
    if done.returncode != 0:
        stop(f"{' '.join(map(str, command))}:\n{done.stdout}{done.stderr}")
    return done


def plant(folder, fault):
    """Activates a fault of hw/rtl/faults.vh, by number or macro, in a design's copy of the modules, replacing any
    other."""
    none = "FAULT(NUMBER) 1'b0"
    text = (ROOT / "hw/rtl/faults.vh").read_text()
    if none not in text:
        stop(f"faults.vh has no {none}")
    (folder / "rtl/faults.vh").write_text(text.replace(none, f"FAULT(NUMBER) (NUMBER == {fault})"))


def designed(csgsim, machine, words, folder):
    """Writes a design, and the picture of csgsim's clocked level, csgsim.ppm. Returns its stats."""
    run([csgsim, "rtl", machine, *words, "-o", folder, "--quiet"])
    run([csgsim, "render", *words, "--machine", machine, "--level", "cycle", "-o", folder / "csgsim.ppm", "--stats",
         folder / "csgsim.json", "--quiet"])
    return json.loads((folder / "csgsim.json").read_text())


def existing(path):
    """The path of an existing file, for argparse."""
    return pathlib.Path(path).resolve(strict=True)


def skip_without(programs):
    """Ends the script if one of the programs is not installed."""
    missing = [program for program in programs if not shutil.which(program)]
    if missing:
        print(f"{missing[0]} is not installed; run ./setup.sh test")
        sys.exit(SKIPPED)
