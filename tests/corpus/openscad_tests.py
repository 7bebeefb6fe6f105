#!/usr/bin/env python3
"""Holds csgsim's depth pictures of OpenSCAD's own tests and examples against OpenSCAD's meshes; exits with 1 where the outcome is not the listed one.

    openscad_tests.py CHECKOUT [--csgsim build/release/csgsim]      all of tests/data/scad and examples in a checkout of OpenSCAD
    openscad_tests.py CHECKOUT 3D/features/minkowski                those whose path has these words

The checkout is GPL and not part of csgsim: git clone --depth 1 https://github.com/openscad/openscad. It is copied, so that what is written
beside the models stays out of it. openscad_tests.toml lists every model whose outcome is not "right" or "nothing in both", and why; a model
that is listed and has another outcome fails as well. Models that OpenSCAD itself does not evaluate, or not in time, are counted and not judged.
Needs openscad 2021.01 and numpy."""
import argparse
import collections
import hashlib
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import tomllib
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import mesh_depth
from drawn import render
from judge import difference

LIST = Path(__file__).with_suffix(".toml")
FOLDERS = ("tests/data/scad", "examples")  # of models
COPIED = ("tests/data", "examples")  # with what they import
EXPECTED = ("right", "nothing in both")
NOT_JUDGED = ("not evaluated", "no mesh in time")
COLUMNS = "%-72s %-18s %s"
NOT_READ_AGAIN = re.compile(r"[\[ ](inf|-inf|nan|-nan)\b")
LONGEST = 200  # of what is said of a model, in characters


@dataclass
class Outcome:
    """What came of a model: a word for it, and what there is to say."""
    kind: str
    said: str = ""


def openscad(words, folder, limit, text=None):
    """Exit code, None when time ran out, and what was said. The time is the processor's, so that a busy machine judges as many models."""
    run = subprocess.run(["prlimit", f"--cpu={limit}", "openscad", *map(str, words)], cwd=folder, input=text, capture_output=True, encoding="utf-8",
                         errors="replace", check=False)
    return None if run.returncode in (-signal.SIGKILL, -signal.SIGXCPU) else run.returncode, run.stderr


def complaint(said):
    """The first error that OpenSCAD tells of, else its last line."""
    lines = [line for line in said.splitlines() if line.strip()]
    errors = [line for line in lines if line.startswith("ERROR")]
    return (errors or lines[-1:] or [""])[0][:LONGEST]


def evaluated(source, limit):
    """The .csg beside the source, or why there is none. A kept one stays, since models may be random."""
    csg = source.with_suffix(".csg")
    if csg.exists():
        return csg, ""
    fresh = source.with_suffix(".fresh.csg")
    code, said = openscad(["-o", fresh, source], source.parent, limit)
    if code != 0:
        return None, complaint(said) if code is not None else f"not evaluated in {limit} s"
    fresh.rename(csg)
    return csg, ""


@dataclass
class Mesh:
    """Triangles as OpenSCAD makes them, flat models as plates of thickness 1 about z = 0; no triangles where it makes nothing."""
    triangles: np.ndarray
    error: str = ""  # of OpenSCAD's, with which what it draws need not be what the model says
    in_time: bool = True


def made(csg, limit):
    """A mesh file and what OpenSCAD said; no file where it makes nothing, no words where time ran out."""
    text = csg.read_text(encoding="utf-8")
    base = str(csg.with_suffix("")) + "-" + hashlib.sha256(text.encode()).hexdigest()[:16]
    stl, told = Path(base + ".stl"), Path(base + ".said")
    if not told.exists():
        # OpenSCAD writes inf and nan, and does not read them again.
        model = csg.with_suffix(".scad").name if NOT_READ_AGAIN.search(text) else "-"
        code, said = openscad(["--export-format", "asciistl", "-o", stl, model], csg.parent, limit, text)
        if code == 1 and "not a 3D object" in said:
            code, said = openscad(["--export-format", "asciistl", "-o", stl, "-"], csg.parent, limit,
                                  "linear_extrude(height = 1, center = true) {" + text + "}")
        if code is None:
            return None, None
        told.write_text(said, encoding="utf-8")
    return stl if stl.exists() else None, told.read_text(encoding="utf-8")


def mesh(csg, limit):
    stl, said = made(csg, limit)
    nothing = np.zeros((0, 3, 3))
    if said is None:
        return Mesh(nothing, in_time=False)
    triangles = mesh_depth.load_stl(stl) if stl else nothing
    errors = [line for line in said.splitlines() if line.startswith("ERROR")]
    return Mesh(triangles[np.isfinite(triangles).all(axis=(1, 2))], errors[0][:LONGEST] if errors else "")


def drawn_views(arguments, csg, triangles):
    """What csgsim draws in both projections, and where from. A model of no triangles is looked at from where a small one would be."""
    seen = triangles if len(triangles) else np.array([[[-10.0, -10, -10], [10, 10, 10], [10, -10, 10]]])
    options = ["--imports-from", str(arguments.work), "--memory-bits", "512", *arguments.option]
    for projection in mesh_depth.PROJECTIONS:
        view = (mesh_depth.camera(seen, projection), projection)
        yield view, render(arguments.csgsim, csg, view, arguments.size, options)


def compared(arguments, triangles, view, picture):
    """What is wrong with a picture of a mesh."""
    expected = mesh_depth.depth(triangles, *view, arguments.size)
    silhouette, covered, wrong = difference(picture, expected, mesh_depth.diagonal(triangles))
    faults = [f"{silhouette} of the silhouette"] if silhouette * 512 * 512 > 4 * arguments.size ** 2 else []
    return faults + ([f"{wrong} of {covered} depths"] if wrong * 2000 > covered else [])


def judged(arguments, source):
    csg, why = evaluated(source, arguments.limit)
    if csg is None:
        return Outcome("not evaluated", why)
    expected = mesh(csg, arguments.limit)
    if not expected.in_time:
        return Outcome("no mesh in time", f"more than {arguments.limit} s")
    return against(arguments, csg, expected)


def against(arguments, csg, expected):
    """Holds what is drawn of a model against its mesh."""
    triangles, note = expected.triangles, f" ({expected.error})" if expected.error else ""
    faults = []
    for view, drawn in drawn_views(arguments, csg, triangles):
        if not drawn:
            message = drawn.said.splitlines()[-1].removeprefix(f"{csg}:") if drawn.said else f"exit code {drawn.code}"
            return Outcome("refused" if len(triangles) else "nothing in both", message[:LONGEST] + note)
        if not len(triangles):
            count = int(np.isfinite(drawn.depth).sum())
            faults += [f"{view[1]}: {count} pixels of what OpenSCAD leaves empty"] if count else []
        else:
            faults += [f"{view[1]}: {fault}" for fault in compared(arguments, triangles, view, drawn.depth)]
    if faults:
        return Outcome("differs", "; ".join(faults) + note)
    return Outcome("right" if len(triangles) else "nothing in both", note.strip())


def models(work, words):
    files = [file for folder in FOLDERS for file in sorted((work / folder).rglob("*.scad"))]
    chosen = [file for file in files if not words or any(word in str(file.relative_to(work)) for word in words)]
    if not chosen:
        raise SystemExit(f"no models in {' or '.join(FOLDERS)} below {work}" + (f" have {' or '.join(words)} in their paths" if words else ""))
    return chosen


def copied(checkout, work):
    for folder in COPIED:
        if not (checkout / folder).is_dir():
            raise SystemExit(f"{checkout} has no {folder}; name a checkout of OpenSCAD: git clone --depth 1 https://github.com/openscad/openscad")
        shutil.copytree(checkout / folder, work / folder, dirs_exist_ok=True)


def listed():
    """Outcome and reason by name."""
    table = tomllib.loads(LIST.read_text(encoding="utf-8"))
    return {name: (kind, why) for kind, names in table.items() for name, why in names.items()}


def unlike(outcome, entry):
    """Why an outcome is not the listed one; nothing if it is."""
    if outcome.kind in NOT_JUDGED:
        return ""
    if entry is None:
        return "" if outcome.kind in EXPECTED else "not listed"
    return "" if entry[0] == outcome.kind else f"listed as: {entry[0]}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("checkout", type=Path)
    parser.add_argument("--csgsim", default=str(LIST.parents[2] / "build/release/csgsim"))
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--limit", type=int, default=60, help="seconds of the processor that OpenSCAD may take for each step of a model")
    parser.add_argument("--work", type=Path, default=Path(tempfile.gettempdir()) / "csgsim-openscad-tests", help="where the copy, .csg files and meshes are kept")
    parser.add_argument("--option", action="append", default=[], help="more for csgsim, once for each word")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("words", nargs="*")
    arguments = parser.parse_intermixed_args()
    copied(arguments.checkout, arguments.work)
    sources, known = models(arguments.work, arguments.words), listed()
    counts, failures = collections.Counter(), []
    with ThreadPoolExecutor(arguments.jobs) as pool:
        for source, outcome in zip(sources, pool.map(lambda source: judged(arguments, source), sources)):
            name = str(source.relative_to(arguments.work))
            counts[outcome.kind] += 1
            fault = unlike(outcome, known.pop(name, None))
            failures += [name] if fault else []
            print(COLUMNS % (name, outcome.kind, "; ".join(filter(None, [fault and "WRONG: " + fault, outcome.said]))), flush=True)
    missing = [] if arguments.words else sorted(known)
    print("; ".join(f"{kind}: {count}" for kind, count in counts.most_common()))
    for name in missing:
        print(f"listed, but not in the checkout: {name}", file=sys.stderr)
    if failures:
        print(f"{len(failures)} models have another outcome than {LIST.name} says", file=sys.stderr)
    return 1 if failures or missing else 0


if __name__ == "__main__":
    sys.exit(main())
