#!/usr/bin/env python3
"""Writes references/: small depth pictures of OpenSCAD's mesh of each model, for computers without openscad.

    references.py [MODEL ...]      the named models, or all of them; the others stay unchanged

references/NAME.png has 16-bit grey values, the perspective picture above the orthographic one: 0 is background, 1 is
not checked, the others are depths from `near` to `far`. references/views.txt has a line per picture: name, projection,
eye and centre, near, far, and the mesh's diagonal. A pixel is not checked if the mesh is ambiguous within 1/64 pixel of
its centre: in coverage, or in depths that jump by more than a thousandth of the diagonal, or that are so steep that
they differ by 1/200. Every other pixel must be correct."""
import struct
import sys
import tempfile
import zlib
from pathlib import Path

import numpy as np

import mesh_depth
import meshes

SIZE = 96
NEAR_EDGE = 1 / 64
CORNERS = ((-1, -1), (1, 1), (-1, 1), (1, -1))  # around a pixel's centre; opposite corners are adjacent
FOLDER = meshes.CORPUS / "references"
NOTHING, UNJUDGED, FIRST, LAST = 0, 1, 2, 65535


def write_png(path, values):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    height, width = values.shape
    rows = b"".join(b"\x02" + row.tobytes() for row in differences(values))
    header = struct.pack(">IIBBBBB", width, height, 16, 0, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def differences(values):
    """PNG's filter 2: every byte minus the one above it, modulo 256."""
    octets = values.astype(">u2").view(np.uint8).reshape(len(values), -1)
    above = np.vstack([np.zeros_like(octets[:1]), octets[:-1]])
    return octets - above


def reference(triangles, projection, camera=None, size=SIZE):
    """The picture's values, and its line of views.txt without the name. The default camera shows the whole mesh."""
    camera, diagonal = camera or mesh_depth.camera(triangles, projection), mesh_depth.diagonal(triangles)
    picture = mesh_depth.depth(triangles, camera, projection, size)
    around = np.stack([mesh_depth.depth(triangles, camera, projection, size, (x * NEAR_EDGE, y * NEAR_EDGE)) for x, y in CORNERS])
    covered = np.isfinite(picture)
    with np.errstate(invalid="ignore"):
        jumps = np.abs(around[:2].sum(axis=0) - 2 * picture) + np.abs(around[2:].sum(axis=0) - 2 * picture) > diagonal / 1000
        steep = np.abs(around - picture).max(axis=0) > diagonal / 200
    unsure = ~(np.isfinite(around) == covered).all(axis=0) | jumps | steep
    near, far = float(picture[covered].min()), float(picture[covered].max())
    steps = np.rint((np.where(covered, picture, near) - near) / max(far - near, 1e-12) * (LAST - FIRST)) + FIRST
    values = np.where(unsure, UNJUDGED, np.where(covered, steps, NOTHING)).astype(np.uint16)
    return values, " ".join([projection, *(f"{x:.4f}" for x in camera), repr(near), repr(far), repr(diagonal)])


def main():
    FOLDER.mkdir(exist_ok=True)
    views = FOLDER / "views.txt"
    lines = {}
    for line in views.read_text(encoding="utf-8").splitlines() if views.exists() else []:
        lines[tuple(line.split()[:2])] = line
    known = {model.stem for model in meshes.models()}
    for model in meshes.models(sys.argv[1:]):
        triangles = meshes.mesh(model, Path(tempfile.gettempdir()) / "csgsim-corpus")
        pictures = []
        for projection in mesh_depth.PROJECTIONS:
            values, view = reference(triangles, projection)
            pictures.append(values)
            lines[model.stem, projection] = f"{model.stem} {view}"
        write_png(FOLDER / f"{model.stem}.png", np.vstack(pictures))
    for picture in FOLDER.glob("*.png"):
        if picture.stem not in known:
            picture.unlink()
    views.write_text("".join(lines[key] + "\n" for key in sorted(lines) if key[0] in known), encoding="utf-8")


if __name__ == "__main__":
    main()
