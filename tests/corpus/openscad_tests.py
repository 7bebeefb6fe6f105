#!/usr/bin/env python3
"""Compares csgsim's depth pictures of OpenSCAD's own tests and examples with OpenSCAD's meshes; exits with 1 if an
outcome differs from the listed one.

    openscad_tests.py CHECKOUT [--csgsim build/release/csgsim]      all of tests/data/scad and examples in a checkout of OpenSCAD
    openscad_tests.py CHECKOUT 3D/features/minkowski                models with these words in their path

The checkout is GPL and not part of csgsim: git clone --depth 1 https://github.com/openscad/openscad. It is copied, so
that files written next to the models stay out of it. openscad_tests.toml lists every model whose outcome is not "right"
or "nothing in both", with the reason; a listed model with another outcome fails as well. Models that OpenSCAD itself
does not evaluate, or not in time, are counted and not checked. Needs openscad 2021.01 and numpy."""
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
FOLDERS = ("tests/data/scad", "examples")  # folders of models
COPIED = ("tests/data", "examples")  # folders to copy, including imports
EXPECTED = ("right", "nothing in both")
NOT_JUDGED = ("not evaluated", "no mesh in time")
COLUMNS = "%-72s %-18s %s"
NOT_READ_AGAIN = re.compile(r"[\[ ](inf|-inf|nan|-nan)\b")
LONGEST = 200  # maximum length of a reason in characters


@dataclass
class Outcome:
    """The outcome of a model: a keyword, and a reason."""
    kind: str
    said: str = ""


def openscad(words, folder, limit, text=None):
    """Exit code, None after a time-out, and output. The time is processor time, so that a busy computer checks equally
    many."""
    run = subprocess.run(["prlimit", f"--cpu={limit}", "openscad", *map(str, words)], cwd=folder, input=text, capture_output=True, encoding="utf-8",
                         errors="replace", check=False)
    return None if run.returncode in (-signal.SIGKILL, -signal.SIGXCPU) else run.returncode, run.stderr


def complaint(said):
    """OpenSCAD's first error message, otherwise its last line."""
    lines = [line for line in said.splitlines() if line.strip()]
    errors = [line for line in lines if line.startswith("ERROR")]
    return (errors or lines[-1:] or [""])[0][:LONGEST]


def evaluated(source, limit):
    """The .csg next to the source, or the reason why there is none. An existing one is kept, since models may be
    random."""
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
    """OpenSCAD's triangles, flat models as plates of thickness 1 about z = 0; no triangles for an empty model."""
    triangles: np.ndarray
    error: str = ""  # OpenSCAD's error, after which its mesh may be incomplete
    in_time: bool = True


def made(csg, limit):
    """A mesh file and OpenSCAD's output; no file for an empty model, no output after a time-out."""
    text = csg.read_text(encoding="utf-8")
    base = str(csg.with_suffix("")) + "-" + hashlib.sha256(text.encode()).hexdigest()[:16]
    stl, told = Path(base + ".stl"), Path(base + ".said")
    if not told.exists():
        # OpenSCAD writes inf and nan, but does not read them.
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
    """csgsim's drawings in both projections, with their cameras. An empty model is seen like a small one."""
    seen = triangles if len(triangles) else np.array([[[-10.0, -10, -10], [10, 10, 10], [10, -10, 10]]])
    options = ["--imports-from", str(arguments.work), "--memory-bits", "512", *arguments.option]
    for projection in mesh_depth.PROJECTIONS:
        view = (mesh_depth.camera(seen, projection), projection)
        yield view, render(arguments.csgsim, csg, view, arguments.size, options)


def compared(arguments, triangles, view, picture):
    """Errors in a picture of a mesh."""
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
    """Compares the drawings of a model with its mesh."""
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
    """The reason why an outcome differs from the listed one; empty if it does not."""
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
    parser.add_argument("--limit", type=int, default=60, help="limit of OpenSCAD's processor seconds for each step of a model")
    parser.add_argument("--work", type=Path, default=Path(tempfile.gettempdir()) / "csgsim-openscad-tests", help="folder for the copy, .csg files and meshes")
    parser.add_argument("--option", action="append", default=[], help="further arguments of csgsim; repeat for each")
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
        print(f"{len(failures)} models have another outcome than listed in {LIST.name}", file=sys.stderr)
    return 1 if failures or missing else 0


if __name__ == "__main__":
    sys.exit(main())
