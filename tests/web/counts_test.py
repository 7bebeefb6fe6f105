#!/usr/bin/env python3
"""Draws models of tests/models and tests/corpus with csgsim.wasm in node: counts must equal those of the command shown.

counts_test.py CSGSIM SOURCE SITE [WORDS...]: WORDS select models by a word in their path. Exit code 77 without SITE or
node. Prints differences and rejected models."""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

from web_page import Answering

CSGSIM, SOURCE, SITE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
KNOBS = {"size": "256x256", "view-all": True}
# Error texts for features that the page lacks, and for models without a picture.
REFUSED = ("this page does not include", "cannot read files", "there is no solid in it")


def counts_of(value, path=""):
    """All leaves of the JSON by path, except those that describe the run instead of the machine."""
    if isinstance(value, (dict, list)):
        items = value.items() if isinstance(value, dict) else enumerate(value)
        return {where: leaf for key, each in items if key not in ("configuration", "wall_seconds", "rerun", "accuracy")
                for where, leaf in counts_of(each, f"{path}.{key}" if path else str(key)).items()}
    return {path: value}


def native(command, folder):
    """The stats of the native program."""
    words = command.replace("csgsim", str(CSGSIM), 1)
    subprocess.run(["bash", "-c", f"cd {SOURCE} && {words} --progress none -o {folder}/picture.png --stats {folder}/stats.json"], check=True, capture_output=True)
    return json.loads((folder / "stats.json").read_text())


def main():
    folder = tempfile.TemporaryDirectory()
    models = sorted(file for room in ("models", "corpus") for kind in ("csg", "jan") for file in (SOURCE / "tests" / room).rglob(f"*.{kind}"))
    models = [file for file in models if not sys.argv[4:] or any(word in str(file) for word in sys.argv[4:])]
    answering = Answering(SITE, "none.csg", "cube(1);")
    same = refused = 0
    failed = []
    for file in models:
        name = str(file.relative_to(SOURCE))
        answering.send({"begin": [name, file.read_text(), {}]})
        status, told = answering.post("draw", {"knobs": KNOBS})
        if status != 200:
            is_meant = any(words in told["error"] for words in REFUSED)
            refused += is_meant
            failed += [] if is_meant else [name]
            print(f"{name}: {told['error']}")
            continue
        here, there = (counts_of(stats) for stats in (native(told["command"], pathlib.Path(folder.name)), told["stats"]))
        differ = {key: (here.get(key), there.get(key)) for key in sorted(here.keys() & there.keys()) if here[key] != there[key]}
        differ |= {key: (here.get(key), there.get(key)) for key in here.keys() ^ there.keys()}
        for key, (one, other) in differ.items():
            print(f"{name}: {key} {one} here, {other} in WebAssembly")
        failed += [name] if differ else []
        same += not differ
    answering.stop()
    folder.cleanup()
    print(f"{same} of {len(models)} models take the same counts, {refused} are refused, {len(failed)} differ: {' '.join(failed)}")
    return 1 if failed or not same else 0


if __name__ == "__main__":
    if not (SITE / "csgsim.wasm").exists() or not shutil.which("node"):
        print("the page or node is missing; run ./setup.sh web")
        sys.exit(77)
    sys.exit(main())
