"""What the scripts of this folder share: commands that they run, and where things are."""

import json
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
MODELS = ROOT / "tests/models"
SKIPPED = 77  # exit code of a test that cannot run here


def attempt(command, folder=None):
    """What comes of a command, whatever that is: `returncode`, `stdout`, `stderr`."""
    return subprocess.run(command, cwd=folder, capture_output=True, text=True)


def stop(why):
    sys.exit(f"{pathlib.Path(sys.argv[0]).name}: {why}")


def run(command, folder=None):
    """The same of a command that has to succeed: if it does not, the script ends with what it said."""
    done = attempt(command, folder)
    if done.returncode != 0:
        stop(f"{' '.join(map(str, command))}:\n{done.stdout}{done.stderr}")
    return done


def plant(folder, fault):
    """Builds a fault of hw/rtl/faults.vh, by number or by macro, into a design's own copy of the modules, in place of any other."""
    none = "FAULT(NUMBER) 1'b0"
    text = (ROOT / "hw/rtl/faults.vh").read_text()
    if none not in text:
        stop(f"faults.vh has no {none}")
    (folder / "rtl/faults.vh").write_text(text.replace(none, f"FAULT(NUMBER) (NUMBER == {fault})"))


def designed(csgsim, machine, words, folder):
    """Writes a design, and what csgsim's clocked level draws, csgsim.ppm. Returns its stats."""
    run([csgsim, "rtl", machine, *words, "-o", folder, "--quiet"])
    run([csgsim, "render", *words, "--machine", machine, "--level", "cycle", "-o", folder / "csgsim.ppm", "--stats",
         folder / "csgsim.json", "--quiet"])
    return json.loads((folder / "csgsim.json").read_text())


def existing(path):
    """For argparse: a file that is there."""
    return pathlib.Path(path).resolve(strict=True)


def skip_without(programs):
    """Ends the script where one of them is not installed."""
    missing = [program for program in programs if not shutil.which(program)]
    if missing:
        print(f"there is no {missing[0]}; ./setup.sh test installs it")
        sys.exit(SKIPPED)
