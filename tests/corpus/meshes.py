"""OpenSCAD's meshes of the corpus, generated on demand and kept in a folder."""
import hashlib
import re
import subprocess
from pathlib import Path

import numpy as np

import mesh_depth

CORPUS = Path(__file__).resolve().parent
DATA = CORPUS / "data"


def models(names=()):
    """The named .csg files, or all of the corpus in order."""
    files = sorted(CORPUS.glob("*.csg")) + sorted((CORPUS / "parts").glob("*.csg"))
    if names:
        files += sorted((CORPUS / "large").glob("*.csg"))
    chosen = [file for file in files if not names or file.stem in names]
    missing = set(names) - {file.stem for file in chosen}
    if missing:
        raise SystemExit(f"unknown model: {', '.join(sorted(missing))}")
    return chosen


def refused():
    """Models that csgsim does not draw yet, with a reason each."""
    lines = (CORPUS / "refused.txt").read_text(encoding="utf-8").splitlines()
    return {name: reason for name, _, reason in (line.partition(": ") for line in lines if line and not line.startswith("#"))}


def fingerprint(file):
    text = file.read_bytes()
    sum_of = hashlib.sha256(text)
    for data in sorted(DATA.iterdir()):
        if data.name.encode() in text:
            sum_of.update(data.read_bytes())
    return sum_of.hexdigest()[:16]


def openscad(text, folder, stl):
    run = subprocess.run(["openscad", "--export-format", "asciistl", "-o", str(stl), "-"], input=text, cwd=folder,
                         capture_output=True, text=True, check=False)
    return run.returncode, run.stderr


def mesh(file, folder):
    """OpenSCAD's triangles of the model; flat models are plates of thickness 1 about z = 0, as OpenSCAD shows them."""
    folder.mkdir(parents=True, exist_ok=True)
    stl = folder / f"{file.stem}-{fingerprint(file)}.stl"
    if not stl.exists():
        text = file.read_text(encoding="utf-8")
        fresh = stl.with_suffix(".part.stl")
        code, said = openscad(text, file.parent, fresh)
        if code != 0 and "not a 3D object" in said:
            code, said = openscad("linear_extrude(height = 1, center = true) {" + text + "}", file.parent, fresh)
        if code != 0:
            raise SystemExit(f"{file}: openscad failed:\n{said}")
        fresh.rename(stl)
    return mesh_depth.load_stl(stl)


HEAD = re.compile(r'\s*([%#!*]*\s*[a-z_0-9]+\((?:"(?:\\.|[^"\\])*"|[^"{};])*\))\s*([{;])', re.S)
UNITES = re.compile(r"(group|union|color|multmatrix|render)\(")


def parts(text, at=0, around=""):
    """Splits the text of a .csg file into the children of its unions, each within its transforms. Ends at a closing
    brace."""
    found = []
    while head := HEAD.match(text, at):
        node, at = head[1], head.end()
        if head[2] == ";":
            found.append(around + node + ";" + "}" * around.count("{"))
            continue
        inner, end = parts(text, at, around + node + "{")
        found += inner if UNITES.match(node) else [around + node + "{" + text[at:end - 1] + "}" + "}" * around.count("{")]
        at = end
    closing = text.find("}", at)
    return found, closing + 1 if closing >= 0 else len(text)


def mesh_apart(file, folder):
    """Triangles of each child of the model's unions: the nearest of them gives the union's depth without evaluating
    it."""
    folder.mkdir(parents=True, exist_ok=True)
    kept = folder / f"{file.stem}-{fingerprint(file)}.npz"
    if not kept.exists():
        stl = folder / f"{file.stem}.part.stl"
        pieces = []
        for part in parts(file.read_text(encoding="utf-8"))[0]:
            code, said = openscad(part, file.parent, stl)
            if code == 0:
                pieces.append(mesh_depth.load_stl(stl))
            elif "object is empty" not in said:
                raise SystemExit(f"{file}: openscad failed:\n{said}")
        np.savez_compressed(kept, triangles=np.concatenate(pieces))
    return np.load(kept)["triangles"]
